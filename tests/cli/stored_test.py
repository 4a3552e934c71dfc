"""Images as programs store them: values by slope and intercept, labels as floating
point numbers, several volumes, headers apart from their voxels.  NIfTI is written by
NiBabel, which shares no code with the program's reader, and says what is right."""

import gzip
import struct
import unittest

import vtu
from images import voxels, write_meta, write_nrrd, write_plain_nrrd
from program import ProgramTest

try:
    import nibabel
    import numpy
except ImportError as missing:  # libraries that only these tests need
    raise unittest.SkipTest(str(missing)) from missing

USAGE, BAD_INPUT, EMPTY = 2, 3, 4
SIZE = (9, 7, 6)
TURNED = numpy.array([[0, -2, 0, 11], [1.5, 0, 0, -23], [0, 0, 3, 5], [0, 0, 0, 1.0]])


def lopsided(kind="int16", size=SIZE):
    """No symmetry of the grid keeps it; by [i, j, k]."""
    i, j, k = numpy.indices(size)
    return numpy.where(10 * k + 2 * j + i < 40, 3, numpy.where(i > 6, 5, 0)).astype(kind)


class StoredTest(ProgramTest):
    def refused(self, status, *words, file="a.nii", options=()):
        self.assert_fails(status, [file, *words], "mesh", file, *options, "-o", "a.vtu")

    def voxels(self, file, *options):
        """How many voxels each label has, or are above the level; and the report."""
        report = self.mesh(file, *options, "--dry-run")
        return {r["label"]: r["voxels"] for r in report["regions"]}, report

    def nifti(self, array, affine=None, kind=nibabel.Nifti1Image, file="a.nii", scale=None):
        image = kind(array, numpy.diag([1.5, 2, 3, 1]) if affine is None else affine)
        image.header.set_xyzt_units("mm")
        nibabel.save(image, self.folder / file)
        path = self.folder / file
        if scale:
            data = bytearray(path.read_bytes())
            second = kind is nibabel.Nifti2Image
            struct.pack_into("<2d" if second else "<2f", data, 176 if second else 112, *scale)
            path.write_bytes(data)
        return nibabel.load(path)

    def box(self, array, affine):
        """Of the voxels that are not 0, their outer faces; x to the left, y to the back."""
        low = [min(c) - 0.5 for c in numpy.nonzero(array)]
        high = [max(c) + 0.5 for c in numpy.nonzero(array)]
        corners = numpy.array([[(low, high)[n >> a & 1][a] for a in range(3)] + [1]
                               for n in range(8)])
        world = (corners @ affine.T)[:, :3] * (-1, -1, 1)
        return world.min(axis=0), world.max(axis=0)

    def assert_placed(self, file, array, affine, *options):
        """The mesh lies where the voxels are, to a third of one."""
        self.mesh(file, *options, "-o", "placed.vtu")
        points = numpy.array(vtu.points(self.folder / "placed.vtu"))
        spacing = numpy.abs(affine[:3, :3]).max()
        for found, right in zip((points.min(axis=0), points.max(axis=0)),
                                self.box(array, affine)):
            self.assertLess(numpy.abs(found - right).max(), 0.34 * spacing)


class Scaled(StoredTest):
    def test_values_by_slope_and_intercept(self):
        for kind in ("uint8", "int16", "uint16", "int32", "float32"):
            for scale in ((1, -1024), (1 / 255, 0), (2, 0), (0.5, 100)):
                for image in (nibabel.Nifti1Image, nibabel.Nifti2Image):
                    with self.subTest(kind, scale=scale, image=image):
                        stored = lopsided(kind) * 40
                        values = self.nifti(stored, kind=image, scale=scale).get_fdata()
                        level = float(values.min() + 0.51 * (values.max() - values.min()))
                        found, _ = self.voxels("a.nii", "--iso", f"{level:.6f}")
                        self.assertEqual(found, {0: (values > level).sum()})

    def test_whole_values_are_labels(self):
        self.nifti(lopsided("uint8"), scale=(2, -1))
        found, _ = self.voxels("a.nii", "--labels", "5,9")
        self.assertEqual(found, {5: (lopsided() == 3).sum(), 9: (lopsided() == 5).sum()})

    def test_no_slope_is_none(self):
        for scale in ((0, 7), (float("nan"), 0)):
            self.nifti(lopsided(), scale=scale)
            self.assertEqual(set(self.voxels("a.nii")[0]), {3, 5})

    def test_length_by_the_stored_type(self):
        self.nifti(lopsided("uint8"), scale=(0.5, 0))
        path = self.folder / "a.nii"
        path.write_bytes(path.read_bytes()[:-1])
        self.refused(BAD_INPUT, "truncated", options=["--iso", "0.5"])


class FloatLabels(StoredTest):
    def test_whole_ones_are_labels(self):
        right = {3: (lopsided() == 3).sum(), 5: (lopsided() == 5).sum()}
        for kind in ("float32", "float64"):
            self.nifti(lopsided(kind))
            self.assertEqual(self.voxels("a.nii")[0], right)
            write_nrrd(self.folder / "a.nrrd", SIZE, lopsided(kind).flatten("F"), kind[5] == "3" and "f" or "d")
            self.assertEqual(self.voxels("a.nrrd")[0], right)

    def test_others_are_counted(self):
        array = lopsided("float32")
        array[4, 5, 2] = array[1, 6, 4] = 2.5
        self.nifti(array)
        self.refused(USAGE, "2 voxels", "not whole numbers", "(4, 5, 2)", "2.5", "--iso")

    def test_nan_and_infinite(self):
        for wrong, words in ((numpy.nan, ["NaN", "--nan"]), (numpy.inf, ["infinite"]),
                             (-numpy.inf, ["infinite"]), (2.0 ** 40, ["32 bits"])):
            for count in (1, 2):
                array = lopsided("float32")
                array[8, 2, 3] = wrong
                if count == 2:
                    array[0, 0, 4] = wrong
                self.nifti(array)
                with self.subTest(wrong, count=count):
                    self.refused(BAD_INPUT, f"{count} voxel", "(8, 2, 3)", *words)
                    if abs(wrong) != 2.0 ** 40:
                        self.refused(BAD_INPUT, f"{count} voxel", "(8, 2, 3)", *words,
                                     options=["--iso", "1"])

    def test_nan_as_a_label_or_a_value(self):
        array = lopsided("float32")
        array[8, 2, 3] = numpy.nan
        self.nifti(array)
        threes = (array == 3).sum()
        found, report = self.voxels("a.nii", "--nan", 3)
        self.assertEqual(found[3], threes + 1)
        self.assertIn("1 voxel is NaN and was read as 3", report["input"]["notes"])
        self.assertEqual(self.voxels("a.nii", "--nan", 0)[0][3], threes)
        self.assertEqual(self.voxels("a.nii", "--nan=-1000.5", "--iso", 2)[0],
                         {0: (array > 2).sum()})
        self.assert_fails(USAGE, ["--nan"], "mesh", "a.nii", "--nan", "1.5", "-o", "a.vtu")

    def test_gray_values_without_a_level(self):
        noise = (numpy.arange(8000) * 7919 % 301).reshape(20, 20, 20).astype("int16")
        smooth = numpy.indices((12, 12, 12)).sum(axis=0).astype("int16") // 6  # few labels, each in one piece
        for array, warned in ((noise, True), (smooth, False)):
            self.nifti(array)
            report = self.voxels("a.nii")[1]
            self.assertEqual(any("--iso" in w for w in report["warnings"]), warned)
            report = self.voxels("a.nii", "--iso", "2")[1]
            self.assertFalse(any("gray" in w for w in report["warnings"]))


class Placed(StoredTest):
    def test_versions_and_pairs(self):
        for kind, file in ((nibabel.Nifti1Image, "a.nii"), (nibabel.Nifti1Image, "a.nii.gz"),
                           (nibabel.Nifti2Image, "a.nii"), (nibabel.Nifti2Image, "a.nii.gz"),
                           (nibabel.Nifti1Pair, "p.img"), (nibabel.Nifti2Pair, "p.img"),
                           (nibabel.Nifti1Pair, "p.img.gz")):
            with self.subTest(file, kind=kind):
                self.nifti(lopsided(), TURNED, kind, file)
                self.assert_placed(file, lopsided(), TURNED)
                if file == "p.img":
                    self.assert_placed("p.hdr", lopsided(), TURNED)

    def test_other_byte_order(self):
        image = nibabel.Nifti1Image(lopsided().astype(">i2"), TURNED,
                                    nibabel.Nifti1Header(endianness=">"))
        nibabel.save(image, self.folder / "a.nii")
        self.assertEqual((self.folder / "a.nii").read_bytes()[:4], b"\0\0\1\x5c")
        self.assert_placed("a.nii", lopsided(), TURNED)

    def test_mirrored_quaternions(self):
        for signs in ((-1, 1, 1), (1, -1, -1), (-1, -1, -1)):
            image = nibabel.Nifti1Image(lopsided(), None)
            affine = TURNED @ numpy.diag([*signs, 1])
            image.set_qform(affine, 1)
            nibabel.save(image, self.folder / "a.nii")
            with self.subTest(signs):
                self.assert_placed("a.nii", lopsided(), affine)

    def test_forms_that_disagree(self):
        image = nibabel.Nifti1Image(lopsided(), TURNED)
        moved = TURNED.copy()
        moved[:3, 3] += (0, 4, 3)
        for codes, taken, note in (((1, 1), TURNED, True), ((1, 0), moved, False),
                                   ((0, 2), TURNED, False)):
            image.set_qform(moved, codes[0])
            image.set_sform(TURNED, codes[1])
            nibabel.save(image, self.folder / "a.nii")
            with self.subTest(codes):
                self.assert_placed("a.nii", lopsided(), taken)
                notes = self.voxels("a.nii")[1]["input"]["notes"]
                self.assertEqual(notes, ["the file's qform and sform disagree, by up to 5 mm; "
                                         "the sform was taken"] if note else [])

    def test_no_form(self):
        image = nibabel.Nifti1Image(lopsided(), None)
        image.header.set_zooms((1.5, 2, 3))
        nibabel.save(image, self.folder / "a.nii")
        self.assertIn("place", self.voxels("a.nii")[1]["input"]["notes"][0])
        self.assert_placed("a.nii", lopsided(), numpy.diag([-1.5, -2, 3, 1]))
        image = nibabel.AnalyzeImage(lopsided(), None)
        image.header.set_zooms((1.5, 2, 3))
        nibabel.save(image, self.folder / "old.img")
        self.assertIn("ANALYZE", self.voxels("old.hdr")[1]["input"]["notes"][0])
        self.assert_placed("old.img", lopsided(), numpy.diag([-1.5, -2, 3, 1]))

    def test_micrometres(self):
        image = nibabel.Nifti1Image(lopsided(), numpy.diag([1500, 2000, 3000, 1]))
        image.header.set_xyzt_units("micron")
        nibabel.save(image, self.folder / "a.nii")
        self.assert_placed("a.nii", lopsided(), numpy.diag([1.5, 2, 3, 1]))

    def test_shear(self):
        sheared = TURNED.copy()
        sheared[0, 0] = 0.4
        self.nifti(lopsided(), sheared)
        self.refused(BAD_INPUT, "shear", "first and second", "104.9 degrees")
        write_nrrd(self.folder / "a.nrrd", SIZE, lopsided().flatten("F"),
                   directions=((2, 0.5, 0), (0, 1, 0), (0, 0, 1)))
        self.refused(BAD_INPUT, "shear", file="a.nrrd")


class Names(StoredTest):
    """Files whose names say something else than they hold, or that lack a part."""

    def test_plain_file_named_gz(self):
        self.nifti(lopsided(), TURNED)
        (self.folder / "b.nii.gz").write_bytes((self.folder / "a.nii").read_bytes())
        (self.folder / "c.nii").write_bytes(gzip.compress((self.folder / "a.nii").read_bytes()))
        for file, words in (("b.nii.gz", "not packed"), ("c.nii", "packed by gzip")):
            self.assert_placed(file, lopsided(), TURNED)
            self.assertIn(words, self.voxels(file)[1]["input"]["notes"][0])

    def test_missing_voxels(self):
        self.nifti(lopsided(), TURNED, nibabel.Nifti1Pair, "p.img")
        (self.folder / "p.img").unlink()
        self.refused(BAD_INPUT, "missing", "p.img", file="p.hdr")
        write_meta(self.folder / "a.mhd", SIZE, [])
        for place in ("gone.raw", "LIST\none.raw\ntwo.raw", "gone%03d.raw 1 6 1"):
            text = (self.folder / "a.mhd").read_text().replace("LOCAL", place)
            (self.folder / "b.mhd").write_text(text)
            with self.subTest(place):
                self.refused(BAD_INPUT, file="b.mhd")
        self.refused(BAD_INPUT, "missing", "gone001.raw", file="b.mhd")
        write_plain_nrrd(self.folder / "a.nrrd", SIZE)
        head = (self.folder / "a.nrrd").read_bytes().split(b"\n\n")[0].decode()
        for place, missing in (("gone.raw", "gone.raw"), ("gone%02d.raw 1 6 1", "gone01.raw"),
                               ("LIST\none.raw\ntwo.raw", "one.raw")):
            (self.folder / "b.nhdr").write_text(f"{head}\ndata file: {place}\n")
            with self.subTest(place):
                self.refused(BAD_INPUT, "missing", missing, file="b.nhdr")

    def test_formats_that_are_not_read(self):
        for name, begins, words in (
                ("a.inr", b"#INRIMAGE-4#{\nXDIM=4\n", "INR"), ("a.mnc", b"CDF\1" + bytes(9), "MINC"),
                ("a.mgz", gzip.compress(bytes(300)), "FreeSurfer"), ("a.png", b"\x89PNG\r\n", "PNG")):
            (self.folder / name).write_bytes(begins)
            self.refused(BAD_INPUT, words, "not supported", file=name)


class Volumes(StoredTest):
    """One of several; the others are other images."""

    def setUp(self):
        super().setUp()
        self.all = [lopsided(), lopsided() * (numpy.indices(SIZE)[0] < 4), numpy.ones(SIZE, "int16")]
        self.right = [{int(v): int((a == v).sum()) for v in numpy.unique(a) if v} for a in self.all]

    def assert_volumes(self, file, count=3):
        self.refused(BAD_INPUT, f"--volume N, from 0 to {count - 1}", file=file)
        for n in range(count):
            self.assertEqual(self.voxels(file, "--volume", n)[0], self.right[n])
        self.refused(USAGE, f"no volume {count}", file=file, options=["--volume", count])

    def test_nifti(self):
        for kind in (nibabel.Nifti1Image, nibabel.Nifti2Image):
            for file in ("a.nii", "a.nii.gz"):
                self.nifti(numpy.stack(self.all, axis=3), kind=kind, file=file)
                self.assert_volumes(file)

    def test_nrrd_lists(self):
        last = numpy.concatenate([a.flatten("F") for a in self.all])
        first = numpy.stack([a.flatten("F") for a in self.all], axis=1).flatten()
        head = ("NRRD0004\ntype: short\ndimension: 4\nspace: left-posterior-superior\n"
                "space origin: (0,0,0)\nendian: little\nencoding: raw\n")
        for sizes, kinds, directions, data in (
                ("9 7 6 3", "domain domain domain list", "(1,0,0) (0,1,0) (0,0,1) none", last),
                ("3 9 7 6", "list domain domain domain", "none (1,0,0) (0,1,0) (0,0,1)", first),
                ("3 9 7 6", "vector domain domain domain", "none (1,0,0) (0,1,0) (0,0,1)", first)):
            text = f"{head}sizes: {sizes}\nkinds: {kinds}\nspace directions: {directions}\n\n"
            (self.folder / "a.nrrd").write_bytes(text.encode() + data.astype("<i2").tobytes())
            with self.subTest(kinds):
                self.assert_volumes("a.nrrd")

    def test_meta(self):
        write_meta(self.folder / "a.mha", SIZE,
                   numpy.stack([a.flatten("F") for a in self.all], axis=1).flatten(), channels=3)
        self.assert_volumes("a.mha")
        matrix = numpy.eye(4, dtype=int).tolist()
        write_meta(self.folder / "a.mha", (*SIZE, 3),
                   numpy.concatenate([a.flatten("F") for a in self.all]), matrix=matrix,
                   spacing=(1, 1, 1, 1))
        path = self.folder / "a.mha"
        path.write_bytes(path.read_bytes().replace(b"Offset = 0 0 0", b"Offset = 0 0 0 0"))
        self.assert_volumes("a.mha")

    def test_one_is_number_0(self):
        self.nifti(self.all[0])
        self.assertEqual(self.voxels("a.nii", "--volume", 0)[0], self.right[0])
        self.refused(USAGE, "no volume 1", options=["--volume", 1])


class Layers(StoredTest):
    """Segments of 3D Slicer, in one layer or several."""

    def segments(self, layers, segments, kind="uint8"):
        """`layers` by [i, j, k]; a segment is (layer, value, name)."""
        array = numpy.stack([a.flatten("F") for a in layers], axis=1)
        several = len(layers) > 1
        head = (f"NRRD0004\ntype: {kind}\ndimension: {3 + several}\n"
                f"space: left-posterior-superior\nsizes: {f'{len(layers)} ' * several}9 7 6\n"
                f"kinds: {'list ' * several}domain domain domain\n"
                f"space directions: {'none ' * several}(1,0,0) (0,1,0) (0,0,1)\n"
                "space origin: (0,0,0)\nendian: little\nencoding: gzip\n")
        for n, (layer, value, name) in enumerate(segments):
            head += (f"Segment{n}_Color:=0.5 0.6 0.7\nSegment{n}_ID:=Segment_{n + 1}\n"
                     f"Segment{n}_LabelValue:={value}\nSegment{n}_Layer:={layer}\n")
            head += f"Segment{n}_Name:={name}\n" if name else ""
        (self.folder / "a.seg.nrrd").write_bytes(
            head.encode() + b"\n" + gzip.compress(array.astype(kind).tobytes()))

    def read(self):
        found, report = self.voxels("a.seg.nrrd")
        return (found, {r["label"]: r.get("name") for r in report["regions"]},
                report["input"]["notes"])

    def test_one_layer(self):
        self.segments([lopsided()], [(0, 3, "left part"), (0, 5, None)])
        found, names, notes = self.read()
        self.assertEqual(found, {3: (lopsided() == 3).sum(), 5: (lopsided() == 5).sum()})
        self.assertEqual((names, notes), ({3: "left part", 5: "Segment_2"}, []))

    def test_the_later_segment_wins(self):
        one, other = lopsided(), numpy.indices(SIZE)[0]  # values of both are all different
        two = numpy.where(other > 4, 9, 0)
        both = int(((one == 5) & (two == 9)).sum())
        self.segments([one, two], [(0, 3, "a"), (1, 9, "b"), (0, 5, "c")])
        found, names, notes = self.read()
        threes = (one == 3) & (two == 0)
        self.assertEqual(found, {3: threes.sum(), 5: (one == 5).sum(),
                                 9: ((two == 9) & (one != 5)).sum()})
        self.assertEqual(names, {3: "a", 9: "b", 5: "c"})
        self.assertEqual(notes, [
            f"segments overlap, where the later one wins: 'b' covers 'a' in "
            f"{((one == 3) & (two == 9)).sum()} voxels",
            f"segments overlap, where the later one wins: 'c' covers 'b' in {both} voxels"])

    def test_values_that_layers_share(self):
        """As Slicer writes them: each layer begins with 1."""
        one, two = (lopsided() == 3) * 1, (lopsided() == 5) * 1
        self.segments([one, two], [(0, 1, "three"), (1, 1, "five")], "int16")
        found, names, notes = self.read()
        self.assertEqual(found, {1: one.sum(), 2: two.sum()})
        self.assertEqual(names, {1: "three", 2: "five"})
        self.assertIn("numbers from 1", notes[0])

    def test_values_without_a_segment(self):
        one, two = (lopsided() == 3) * 1, (lopsided() > 0) * 1
        self.segments([one, two], [(0, 1, "three")])
        found, names, notes = self.read()
        self.assertEqual(found, {1: one.sum(), 2: (lopsided() == 5).sum()})
        self.assertEqual(names, {1: "three", 2: None})
        self.assertIn("value 1 of layer 1 is label 2", notes[0])
        self.assertIn("'three' covers label 2 in", notes[1])

    def test_one_layer_of_several(self):
        self.segments([lopsided(), lopsided() // 3], [(0, 3, "a"), (1, 1, "b")])
        found, report = self.voxels("a.seg.nrrd", "--volume", 1)
        self.assertEqual(found, {1: (lopsided() > 0).sum()})
        self.assertEqual(report["regions"][0]["name"], "b")

    def test_names_are_in_the_mesh(self):
        self.segments([lopsided()], [(0, 3, "left part"), (0, 5, "right")])
        (self.folder / "names.txt").write_text("5 other\n")
        self.mesh("a.seg.nrrd", "-o", "a.msh")
        self.assertIn('3 3 "left part"', (self.folder / "a.msh").read_text(errors="replace"))
        self.mesh("a.seg.nrrd", "--label-names", "names.txt", "-o", "a.msh")
        text = (self.folder / "a.msh").read_text(errors="replace")
        self.assertIn('3 3 "left part"', text)
        self.assertIn('3 5 "other"', text)


class MetaVoxels(StoredTest):
    """The ways in which a MetaImage says where its voxels are."""

    def setUp(self):
        super().setUp()
        self.right = {3: (lopsided() == 3).sum(), 5: (lopsided() == 5).sum()}
        self.data = lopsided().astype("<i2").tobytes("F")

    def meta(self, *changes, packed=False, name="a.mha", data=None):
        write_meta(self.folder / name, SIZE, lopsided().flatten("F"), packed=packed)
        whole = (self.folder / name).read_bytes()
        for before, after in changes:
            self.assertIn(before, whole)
            whole = whole.replace(before, after, 1)
        if data is not None:
            whole = whole.split(b"ElementDataFile")[0] + data
        (self.folder / name).write_bytes(whole)

    def assert_read(self, name="a.mha"):
        self.assertEqual(self.voxels(name)[0], self.right)

    def test_packed_without_its_size(self):
        self.meta(packed=True)
        for _ in range(3):
            self.assert_read()
        path = self.folder / "a.mha"
        path.write_bytes(path.read_bytes()[:-9])
        self.refused(BAD_INPUT, "truncated", file="a.mha")

    def test_other_byte_order(self):
        for key in (b"BinaryDataByteOrderMSB", b"ElementByteOrderMSB"):
            self.meta((b"BinaryDataByteOrderMSB = False", key + b" = True"),
                      data=b"ElementDataFile = LOCAL\n" + lopsided().astype(">i2").tobytes("F"))
            self.assert_read()

    def test_text(self):
        numbers = " ".join(map(str, lopsided().flatten("F"))).encode()
        for data, read in ((numbers, True), (numbers[:-4], False), (numbers[:-1] + b"x", False)):
            self.meta((b"BinaryData = True", b"BinaryData = False"),
                      data=b"ElementDataFile = LOCAL\n" + data)
            if read:
                self.assert_read()
            else:
                self.refused(BAD_INPUT, file="a.mha")

    def test_other_files(self):
        pages = [self.data[n * 126:(n + 1) * 126] for n in range(6)]
        for n, page in enumerate(pages):
            (self.folder / f"page{n + 1:02}.raw").write_bytes(page)
        (self.folder / "all.raw").write_bytes(self.data)
        (self.folder / "behind.raw").write_bytes(b"head" + self.data)
        listed = "\n".join(f"page{n + 1:02}.raw" for n in range(6))
        for place, skip in (("all.raw", None), (f"LIST\n{listed}", None), (f"LIST 2\n{listed}", None),
                            ("page%02d.raw 1 6 1", None), ("behind.raw", 4), ("behind.raw", -1)):
            more = f"HeaderSize = {skip}\n" if skip else ""
            self.meta(name="a.mhd", data=f"{more}ElementDataFile = {place}\n".encode())
            with self.subTest(place, skip=skip):
                self.assert_read("a.mhd")
        self.meta(name="a.mhd", data=b"ElementDataFile = page%02d.raw 1 5 1\n")
        self.refused(BAD_INPUT, "5 files", file="a.mhd")
        (self.folder / "page04.raw").write_bytes(pages[3][:-1])
        self.meta(name="a.mhd", data=b"ElementDataFile = page%02d.raw 1 6 1\n")
        self.assert_fails(BAD_INPUT, ["page04.raw", "truncated"], "mesh", "a.mhd", "-o", "a.vtu")


if __name__ == "__main__":
    unittest.main()
