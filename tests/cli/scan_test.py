"""Scans as engineers have them: DICOM series and TIFF stacks."""

import unittest

import vtu
from images import voxels, write_nifti, write_nrrd
from program import ProgramTest

try:
    import numpy
    from scans import (AXIAL, ImplicitVRLittleEndian, RLELossless, volume, write_imagej, write_packed_tiff, write_series, write_slice, write_tiff)
except ImportError as missing:  # libraries that only these tests need
    raise unittest.SkipTest(str(missing)) from missing

USAGE, BAD_INPUT, TOO_LARGE = 2, 3, 5
SIZE, SPACING, ORIGIN = (9, 7, 6), (0.5, 1, 2), (11, -23, 5)


def lopsided(i, j, k):
    """No symmetry of the grid keeps it; every slice and row is another."""
    return 3 if 10 * k + 2 * j + i < 40 else 5 if i > 6 else 0


def box(path):
    points = vtu.points(path)
    return [[f(p[a] for p in points) for a in range(3)] for f in (min, max)]


class ScanTest(ProgramTest):
    def refused(self, status, *words, file="scan", options=()):
        self.assert_fails(status, [file, *words], "mesh", file, *options, "-o", "a.vtu")

    def nrrd(self, directions=None, origin=ORIGIN):
        directions = directions or [tuple(SPACING[a] * (a == r) for r in range(3))
                                    for a in range(3)]
        write_nrrd(self.folder / "a.nrrd", SIZE, voxels(SIZE, lopsided), directions=directions,
                   origin=origin)
        return self.mesh("a.nrrd", "-o", "nrrd.vtu")

    def assert_same_mesh(self, report, name="nrrd.vtu", other="scan.vtu"):
        """The same labels, and points that differ by rounding only."""
        self.check(other)
        for read, rounding in ((lambda file: vtu.numbers(file, "label"), 0),
                               (vtu.points, 1e-4)):
            one, two = (numpy.array(read(self.folder / file)) for file in (name, other))
            self.assertEqual(one.shape, two.shape)
            self.assertLessEqual(abs(one - two).max(), rounding)
        self.assertTrue(report["guarantee"]["holds"])


class Dicom(ScanTest):
    def series(self, **settings):
        write_series(self.folder / "scan", volume(SIZE, lopsided),
                     **{"spacing": SPACING, "origin": ORIGIN, **settings})

    def test_same_place_as_nrrd(self):
        self.nrrd()
        self.series()
        (self.folder / "scan" / "notes.txt").write_text("no image " * 100)
        self.assert_same_mesh(self.mesh("scan", "-o", "scan.vtu"))

    def test_transfer_syntaxes(self):
        self.nrrd()
        for syntax in (ImplicitVRLittleEndian, RLELossless):
            with self.subTest(syntax):
                self.series(syntax=syntax)
                self.assert_same_mesh(self.mesh("scan", "-o", "scan.vtu"))

    def test_runs_that_do_not_fit(self):
        """A byte changed at a time of the voxels of one slice, packed in runs: another mesh, or
        a sentence; GDCM ends the program where runs are not whole."""
        self.series(syntax=RLELossless)
        path = sorted((self.folder / "scan").iterdir())[2]
        data = path.read_bytes()
        refused = 0
        for at in range(data.rindex(b"\xe0\x7f\x10\x00"), len(data)):
            path.write_bytes(data[:at] + bytes([data[at] ^ 0xff]) + data[at + 1:])
            run = self.run_certet("mesh", "scan", "-o", "a.vtu", "--dry-run")
            self.assertIn(run.returncode, (0, BAD_INPUT), (at, run.stderr))
            refused += run.returncode == BAD_INPUT
        self.assertGreater(refused, 64)

    def test_turned_frame(self):
        turned = (0.6, 0.8, 0, 0, 0, -1)
        normal = numpy.cross(turned[:3], turned[3:])
        self.nrrd([tuple(s * float(c) for c in axis) for s, axis in
                   zip(SPACING, (turned[:3], turned[3:], normal))])
        self.series(orientation=turned)
        self.assert_same_mesh(self.mesh("scan", "-o", "scan.vtu"))

    def test_other_scans_are_other_meshes(self):
        """What the comparison must catch: slices by name, spacing or place lost."""
        self.nrrd()
        by_name = volume(SIZE, lambda i, j, k: lopsided(i, j, 5 * k % SIZE[2]))
        for planted in ({"spacing": (0.5, 1, 1)}, {"origin": (11, -23, 7)}, {"voxels": by_name},
                        {"spacing": (1, 0.5, 2)}):
            settings = {"spacing": SPACING, "origin": ORIGIN,
                        "voxels": volume(SIZE, lopsided), **planted}
            write_series(self.folder / "scan", **settings)
            report = self.mesh("scan", "--size", "0.5", "-o", "scan.vtu")
            with self.subTest(planted=list(planted)), self.assertRaises(AssertionError):
                self.assert_same_mesh(report)

    def test_several_series(self):
        self.series(series="1.2.3")
        write_series(self.folder / "scan", volume((4, 4, 4), lambda i, j, k: 1), series="1.2.4")
        self.refused(USAGE, "2 DICOM series", "--series", "1.2.3 (6 files)", "1.2.4 (4 files)")
        self.refused(USAGE, "no DICOM series '9'", "1.2.4", options=["--series", "9"])
        self.nrrd()
        self.assert_same_mesh(self.mesh("scan", "--series", "1.2.3", "-o", "scan.vtu"))

    def test_missing_slice(self):
        self.series(skip=[3])
        self.refused(BAD_INPUT, "gap", "missing", ".dcm")

    def test_unequal_spacing(self):
        self.series(positions=[0, 2, 4, 6.4, 8, 10])
        self.refused(BAD_INPUT, "not equally spaced")

    def test_rounded_positions_are_fine(self):
        self.series(positions=[0, 2.01, 3.99, 6, 8.01, 10])
        self.mesh("scan", "-o", "scan.vtu")

    def test_one_position_twice(self):
        self.series(positions=[0, 2, 4, 4, 6, 8])
        self.refused(BAD_INPUT, "one position")

    def test_slices_that_differ(self):
        pixels = numpy.ones((7, 9), "int16")
        for words, settings in (
                (["size"], {"pixels": numpy.ones((8, 9), "int16")}),
                (["type"], {"pixels": numpy.ones((7, 9), "uint8")}),
                (["direction"], {"orientation": (0, 1, 0, 0, 0, 1)}),
                (["spacings"], {"spacing": (0.5, 0.7)}),
                (["tilted"], {"position": (14, -23, 17)}),
                (["3 numbers"], {"pixels": numpy.ones((7, 9, 3), "uint8"), "samples": 3})):
            with self.subTest(words):
                self.series()
                write_slice(self.folder / "scan" / "z.dcm", **{
                    "pixels": pixels, "position": (11, -23, 17), "spacing": SPACING[:2],
                    **settings})
                self.refused(BAD_INPUT, *words)

    def test_single_file(self):
        write_slice(self.folder / "scan", numpy.ones((7, 9), "int16"), (0, 0, 0))
        self.refused(BAD_INPUT, "folder")

    def test_truncated(self):
        self.series()
        path = sorted((self.folder / "scan").iterdir())[2]
        data = path.read_bytes()
        for length in (len(data) - 40, 700, 300, 140):
            path.write_bytes(data[:length])
            with self.subTest(length):
                self.refused(BAD_INPUT)

    def test_memory(self):
        write_series(self.folder / "scan", volume((90, 90, 8), lambda i, j, k: 1))
        self.refused(TOO_LARGE, "bytes", options=["--max-memory", "100K"])

    def test_series_needs_a_folder(self):
        self.nrrd()
        self.refused(BAD_INPUT, "folder", file="a.nrrd", options=["--series", "1"])


class TiffStack(ScanTest):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "scan.tif"
        self.stack = volume(SIZE, lopsided)

    def assert_as_nrrd(self, options=()):
        self.nrrd(origin=(0, 0, 0))
        report = self.mesh("scan.tif", *options, "-o", "scan.vtu")
        self.assert_same_mesh(report)
        return report

    def test_spacing_by_option(self):
        for kind in ("uint8", "int8", "uint16", "int16", "uint32", "int32"):
            with self.subTest(kind):
                write_tiff(self.path, self.stack.astype(kind))
                report = self.assert_as_nrrd(["--spacing", "0.5,1,2"])
                self.assertEqual(report["input"]["notes"], [])

    def test_packed_tiled_and_big(self):
        for settings in ({"compression": "zlib"}, {"tile": (16, 16)}, {"bigtiff": True},
                         {"byteorder": ">"}, {"rowsperstrip": 2}):
            with self.subTest(settings):
                write_tiff(self.path, self.stack.astype("uint16"), **settings)
                self.assert_as_nrrd(["--spacing", "0.5,1,2"])

    def test_one_two_and_four_bits(self):
        """Rows of 9 voxels do not fill their bytes; as black is 0 or 1."""
        for bits, values, settings in ((1, self.stack == 3, {}),
                                       (1, self.stack == 3, {"photometric": "minisblack"}),
                                       (1, self.stack == 3, {"rowsperstrip": 2}),
                                       (2, self.stack % 4, {}), (4, self.stack, {})):
            with self.subTest(bits, settings=settings):
                if bits == 1:
                    import tifffile
                    tifffile.imwrite(str(self.path), values.astype(bool), **settings)
                else:
                    write_packed_tiff(self.path, values, bits)
                report = self.mesh("scan.tif", "--dry-run")
                self.assertEqual({r["label"]: r["voxels"] for r in report["regions"]},
                                 {int(v): int((values == v).sum()) for v in numpy.unique(values) if v})
                white = settings.get("photometric") != "minisblack" and bits == 1
                self.assertEqual(any("white" in n for n in report["input"]["notes"]), white)

    def test_imagej_spacing(self):
        for unit, scale in (("mm", 1), ("micron", 1000), ("cm", 0.1)):
            with self.subTest(unit):
                write_imagej(self.path, self.stack.astype("uint16"),
                             [scale * s for s in SPACING], unit)
                report = self.assert_as_nrrd(["--size", "0.5"] if unit != "mm" else [])
                self.assertIn("ImageJ", report["input"]["notes"][0])

    def test_no_spacing(self):
        write_tiff(self.path, self.stack.astype("uint8"))
        report = self.mesh("scan.tif", "-o", "scan.vtu")
        self.assertIn("--spacing", report["input"]["notes"][0])
        self.assertEqual(report["lattice"]["size"], 1)

    def test_resolution(self):
        write_tiff(self.path, self.stack.astype("uint8"), resolution=(100, 100),
                   resolutionunit="CENTIMETER")
        report = self.mesh("scan.tif", "-o", "scan.vtu")
        self.assertAlmostEqual(report["lattice"]["size"], 0.1, delta=1e-6)

    def test_level(self):
        write_tiff(self.path, self.stack.astype("float32") + 0.25)
        self.refused(USAGE, "--iso", file="scan.tif")
        self.mesh("scan.tif", "--iso", "2.5", "-o", "scan.vtu")
        self.check("scan.vtu")

    def test_colour_and_four_dimensions(self):
        import tifffile
        tifffile.imwrite(str(self.path), numpy.ones((5, 8, 9, 3), "uint8"), photometric="rgb")
        self.refused(BAD_INPUT, "3 numbers per voxel", file="scan.tif")
        tifffile.imwrite(str(self.path), numpy.ones((2, 3, 8, 9), "uint8"), imagej=True,
                         metadata={"axes": "TZYX"})
        self.refused(BAD_INPUT, "4 dimensions", "frames", file="scan.tif")

    def test_pages_that_differ(self):
        import tifffile
        for other in (numpy.ones((5, 9), "uint8"), numpy.ones((7, 9), "uint16")):
            with tifffile.TiffWriter(str(self.path)) as tiff:
                tiff.write(numpy.ones((7, 9), "uint8"), contiguous=False)
                tiff.write(other, contiguous=False)
            self.refused(BAD_INPUT, "pages that differ", "number 2", file="scan.tif")

    def test_damaged(self):
        write_tiff(self.path, self.stack.astype("uint16"), contiguous=False, metadata=None)
        data = self.path.read_bytes()
        for length in (len(data) - 40, len(data) // 2, 60, 8):
            self.path.write_bytes(data[:length])
            with self.subTest(length):
                self.refused(BAD_INPUT, file="scan.tif")

    def test_memory(self):
        write_tiff(self.path, numpy.ones((50, 50, 50), "uint8"))
        self.refused(TOO_LARGE, "bytes", file="scan.tif", options=["--max-memory", "100K"])

    def test_spacings_that_make_no_sense(self):
        for words in ("1,1", "1,1,0", "1,1,-1", "a,b,c", "1,1,nan"):
            self.refused_usage("--spacing=" + words)
        self.assert_fails(USAGE, ["--spacing"], "mesh", "--shape", "sphere:1", "--spacing",
                          "1,1,1", "-o", "a.vtu")

    def refused_usage(self, option):
        self.assert_fails(USAGE, ["--spacing"], "mesh", "scan.tif", option, "-o", "a.vtu")


class WholeImage(ScanTest):
    """Labels that touch the border on all sides: closed there, angles inside the
    bounds (`check` measures anew, from the file alone)."""

    def test_labels_that_fill_the_image(self):
        full = volume((6, 5, 4), lambda i, j, k: 1 + (i + j + k) % 2)
        write_series(self.folder / "d", full, spacing=(1, 1, 1.5))
        write_series(self.folder / "turned", full, orientation=(0.6, 0.8, 0, -0.8, 0.6, 0))
        write_tiff(self.folder / "t.tif", full.astype("uint8"))
        write_nrrd(self.folder / "n.nrrd", (6, 5, 4), [1] * 120,
                   directions=((0, 1, 0), (1, 0, 0), (0, 0, 1)))
        write_nifti(self.folder / "n.nii", (6, 5, 4), [1] * 120)
        for name in ("d", "turned", "t.tif", "n.nrrd", "n.nii"):
            for cuts, low, high in (("bisect", 9.27, 161.46), ("midpoint", 30, 135)):
                for size in ("1", "0.7"):
                    with self.subTest(name, cuts=cuts, size=size):
                        self.mesh(name, "--cuts", cuts, "--guarantee", "embedding",
                                  "--margin", 1, "--size", size, "-o", "w.vtu")
                        found = self.check("w.vtu")
                        self.assertGreaterEqual(found["dihedral"]["min"], low - 0.01)
                        self.assertLessEqual(found["dihedral"]["max"], high + 0.01)
                        volume_of_all = 120 * (1.5 if name == "d" else 1)
                        self.assertAlmostEqual(found["mesh"]["volume"], volume_of_all,
                                               delta=0.25 * volume_of_all)


if __name__ == "__main__":
    unittest.main()
