"""DICOM of several frames in one file, segmentations, and slopes that differ from
slice to slice."""

import unittest

import vtu
from program import ProgramTest

try:
    import numpy
    import pydicom
    from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
    from pydicom.uid import ExplicitVRLittleEndian, ImplicitVRLittleEndian, RLELossless
    from scans import volume, write_series
except ImportError as missing:  # libraries that only these tests need
    raise unittest.SkipTest(str(missing)) from missing

USAGE, BAD_INPUT = 2, 3
SIZE, SPACING, ORIGIN = (9, 7, 6), (0.5, 1, 2), (11, -23, 5)
CT, SEGMENTATION = "1.2.840.10008.5.1.4.1.1.2.1", "1.2.840.10008.5.1.4.1.1.66.4"
AXIAL, TURNED = (1, 0, 0, 0, 1, 0), (0.6, 0.8, 0, 0, 0, -1)


def lopsided(i, j, k):
    """No symmetry of the grid keeps it; every slice and row is another."""
    return 3 if 10 * k + 2 * j + i < 40 else 5 if i > 6 else 0


VOXELS = volume(SIZE, lopsided)  # by [k, j, i]
COUNTS = {v: int((VOXELS == v).sum()) for v in (3, 5)}


def group(**elements):
    """A sequence of one item."""
    item = Dataset()
    for name, value in elements.items():
        setattr(item, name, value)
    return [item]


def dataset(path, pixels, kind=CT, bits=16, syntax=ExplicitVRLittleEndian):
    """`pixels` are by [frame, row, column]."""
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = kind, "1.2.3.1"
    meta.TransferSyntaxUID = syntax if syntax == ImplicitVRLittleEndian else ExplicitVRLittleEndian
    data = FileDataset(str(path), {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian, data.is_implicit_VR = True, syntax == ImplicitVRLittleEndian
    data.SOPClassUID, data.SOPInstanceUID = kind, "1.2.3.1"
    data.StudyInstanceUID, data.SeriesInstanceUID, data.Modality = "1.2", "1.2.3", "CT"
    data.NumberOfFrames, data.Rows, data.Columns = pixels.shape
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.BitsAllocated = data.BitsStored = bits
    data.HighBit, data.PixelRepresentation = bits - 1, int(bits == 16)
    if bits == 1:
        packed = numpy.packbits(pixels.flatten().astype("uint8"), bitorder="little").tobytes()
        data.PixelData = packed + b"\0" * (len(packed) % 2)
    else:
        data.PixelData = pixels.astype("<i2" if bits == 16 else "u1").tobytes() + (
            b"\0" if bits == 8 and pixels.size % 2 else b"")
    return data


def frame_position(along, orientation=AXIAL, origin=ORIGIN):
    normal = numpy.cross(orientation[:3], orientation[3:])
    return [round(float(o + along * n), 6) for o, n in zip(origin, normal)]


def describe(data, alongs, orientation=AXIAL, scales=None, segments=None):
    """Functional groups: a place along the normal for each frame."""
    shared = Dataset()
    shared.PlaneOrientationSequence = group(ImageOrientationPatient=list(orientation))
    shared.PixelMeasuresSequence = group(PixelSpacing=[SPACING[1], SPACING[0]],
                                         SliceThickness=SPACING[2],
                                         SpacingBetweenSlices=SPACING[2])
    data.SharedFunctionalGroupsSequence = [shared]
    frames = []
    for n, along in enumerate(alongs):
        frame = Dataset()
        frame.PlanePositionSequence = group(
            ImagePositionPatient=frame_position(along, orientation))
        if scales:
            frame.PixelValueTransformationSequence = group(
                RescaleSlope=scales[n][0], RescaleIntercept=scales[n][1], RescaleType="US")
        if segments:
            frame.SegmentIdentificationSequence = group(ReferencedSegmentNumber=segments[n])
        frames.append(frame)
    data.PerFrameFunctionalGroupsSequence = frames
    return data


def segmentation(path, masks, alongs, segments, names, kind="BINARY", bits=1, **settings):
    data = dataset(path, numpy.array(masks), SEGMENTATION, bits, **settings)
    data.Modality, data.SegmentationType = "SEG", kind
    if kind == "FRACTIONAL":
        data.MaximumFractionalValue, data.SegmentationFractionalType = 200, "PROBABILITY"
    data.SegmentSequence = [
        group(SegmentNumber=n + 1, SegmentLabel=name)[0] for n, name in enumerate(names)]
    return describe(data, alongs, segments=segments)


class FramesTest(ProgramTest):
    def save(self, data, name="scan.dcm", packed=False):
        if packed:
            data.compress(RLELossless)
        data.save_as(str(self.folder / name), write_like_original=False)

    def voxels(self, file="scan.dcm", *options):
        report = self.mesh(file, *options, "--dry-run")
        return {r["label"]: r["voxels"] for r in report["regions"]}, report

    def refused(self, status, *words, options=(), file="scan.dcm"):
        self.assert_fails(status, [file, *words], "mesh", file, *options, "-o", "a.vtu")

    def assert_as_series(self, file="scan.dcm", orientation=AXIAL):
        """The same mesh as that of the slices as a series of single files."""
        write_series(self.folder / "series", VOXELS, spacing=SPACING, origin=ORIGIN,
                     orientation=orientation)
        self.mesh("series", "-o", "series.vtu")
        self.mesh(file, "-o", "frames.vtu")
        self.assertEqual(vtu.numbers(self.folder / "series.vtu", "label"),
                         vtu.numbers(self.folder / "frames.vtu", "label"))
        one, two = (numpy.array(vtu.points(self.folder / f)) for f in ("series.vtu", "frames.vtu"))
        self.assertLess(abs(one - two).max(), 1e-4)


class Enhanced(FramesTest):
    alongs = [2.0 * k for k in range(6)]

    def test_same_as_a_series(self):
        order = [3, 0, 5, 1, 4, 2]
        for settings in ({}, {"syntax": ImplicitVRLittleEndian}, {"packed": True}):
            packed = settings.pop("packed", False)
            for turn in (AXIAL, TURNED):
                with self.subTest(settings, turn=turn, packed=packed):
                    data = dataset("scan.dcm", VOXELS[order], **settings)
                    self.save(describe(data, [2.0 * k for k in order], turn), packed=packed)
                    self.assert_as_series(orientation=turn)

    def test_alone_in_a_folder(self):
        (self.folder / "scan").mkdir()
        self.save(describe(dataset("a", VOXELS), self.alongs), "scan/1.dcm")
        self.assertEqual(self.voxels("scan")[0], COUNTS)

    def test_scale_of_each_frame(self):
        scales = [(1 + 0.5 * k, 10 * k - 30) for k in range(6)]
        self.save(describe(dataset("a", VOXELS), self.alongs, scales=scales))
        values = numpy.array([a * v + b for v, (a, b) in zip(VOXELS, scales)])
        for level in (-20.25, 0.25, 9.75):
            self.assertEqual(self.voxels("scan.dcm", f"--iso={level}")[0],
                             {0: (values > level).sum()})

    def test_scale_of_all_frames(self):
        data = dataset("a", VOXELS * 300)
        data.SharedFunctionalGroupsSequence = []
        describe(data, self.alongs)
        data.SharedFunctionalGroupsSequence[0].PixelValueTransformationSequence = group(
            RescaleSlope=1, RescaleIntercept=-1024, RescaleType="HU")
        self.save(data)
        self.assertEqual(self.voxels("scan.dcm", "--iso", "0")[0],
                         {0: (VOXELS * 300 > 1024).sum()})

    def test_without_groups(self):
        for told, note in (({"SpacingBetweenSlices": 2}, False), ({"SliceThickness": 2}, True),
                           ({"GridFrameOffsetVector": self.alongs}, False)):
            data = dataset("a", VOXELS)
            data.PixelSpacing, data.ImageOrientationPatient = [1, 0.5], list(TURNED)
            data.ImagePositionPatient = list(ORIGIN)
            for name, value in told.items():
                setattr(data, name, value)
            self.save(data)
            with self.subTest(told):
                self.assert_as_series(orientation=TURNED)
                notes = self.voxels()[1]["input"]["notes"]
                self.assertEqual(any("thickness" in n for n in notes), note)

    def test_dose_has_its_own_scale(self):
        data = dataset("a", VOXELS)
        data.PixelSpacing, data.ImageOrientationPatient = [1, 0.5], list(AXIAL)
        data.ImagePositionPatient, data.GridFrameOffsetVector = list(ORIGIN), self.alongs
        data.DoseGridScaling = "0.25"
        self.save(data)
        self.assertEqual(self.voxels("scan.dcm", "--iso", "1.1")[0], {0: COUNTS[5]})

    def test_one_of_several_volumes(self):
        other = VOXELS * (VOXELS == 3)
        both = numpy.stack([VOXELS, other], axis=1).reshape(12, 7, 9)
        self.save(describe(dataset("a", both), [2.0 * (k // 2) for k in range(12)]))
        self.refused(BAD_INPUT, "2 volumes", "--volume N, from 0 to 1")
        self.assertEqual(self.voxels("scan.dcm", "--volume", 0)[0], COUNTS)
        self.assertEqual(self.voxels("scan.dcm", "--volume", 1)[0], {3: COUNTS[3]})
        self.refused(USAGE, "no volume 2", options=["--volume", 2])

    def test_uncounted_frames(self):
        """GDCM's reader of images ends the program there."""
        data = dataset("a", VOXELS[:1])
        del data.NumberOfFrames
        data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.481.2"
        data.PixelSpacing, data.ImageOrientationPatient = [1, 0.5], list(AXIAL)
        data.ImagePositionPatient, data.GridFrameOffsetVector = list(ORIGIN), self.alongs
        data.FrameIncrementPointer = 0x3004000c
        (self.folder / "scan").mkdir()
        for name in ("scan.dcm", "scan/1.dcm"):
            self.save(data, name)
            self.refused(BAD_INPUT, "offsets", file=name.split("/")[0])
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID = "1.2.3.2"
        self.save(data, "scan/2.dcm")
        self.refused(BAD_INPUT, "several frames", file="scan")

    def test_what_is_no_volume(self):
        def changed(change):
            data = describe(dataset("a", VOXELS), self.alongs)
            change(data, data.PerFrameFunctionalGroupsSequence)
            return data

        def several(data, frames):
            frames[2].PlaneOrientationSequence = group(ImageOrientationPatient=list(TURNED))

        def aside(data, frames):
            frames[2].PlanePositionSequence = group(ImagePositionPatient=[12, -23, 9])

        def gap(data, frames):
            frames[5].PlanePositionSequence = group(ImagePositionPatient=[11, -23, 19])

        def lost(data, frames):
            del frames[1].PlanePositionSequence

        def few(data, frames):
            del data.PerFrameFunctionalGroupsSequence[-1]

        def times(data, frames):
            data.FrameIncrementPointer, data.FrameTime = 0x00181063, 40

        def tiles(data, frames):
            data.TotalPixelMatrixColumns = 18

        def short(data, frames):
            data.PixelData = data.PixelData[:-2]

        for change, word in ((several, "directions"), (aside, "straight"), (gap, "missing"),
                             (lost, "position"), (few, "5 frames"), (times, "times"),
                             (tiles, "tiles"), (short, "truncated")):
            self.save(changed(change))
            with self.subTest(word):
                self.refused(BAD_INPUT, word)


class Segmentation(FramesTest):
    """Frames of 63 bits, so that they begin within bytes."""

    def parts(self):
        """Masks of the labels 3 and 5 in the slices where there is any."""
        found = [(VOXELS[k] == v, 2.0 * k, n + 1) for n, v in enumerate((3, 5)) for k in range(6)
                 if (VOXELS[k] == v).any()]
        return [list(part) for part in zip(*found)]

    def test_segments_become_labels(self):
        for settings in ({}, {"syntax": ImplicitVRLittleEndian}):
            self.save(segmentation("a", *self.parts(), ["left part", "right"], **settings))
            found, report = self.voxels()
            self.assertEqual(found, {1: COUNTS[3], 2: COUNTS[5]})
            self.assertEqual([r["name"] for r in report["regions"]], ["left part", "right"])
            self.assertEqual(report["input"]["notes"], [])

    def test_same_place_as_a_series(self):
        masks, alongs, segments = self.parts()
        self.save(segmentation("a", masks, alongs, segments, ["a", "b"]))
        write_series(self.folder / "series", (VOXELS > 0) * 1, spacing=SPACING, origin=ORIGIN)
        # The series has one label; by the paper's method several are not cut apart.
        self.mesh("series", "-o", "series.vtu", "--method", "paper")
        self.mesh("scan.dcm", "-o", "frames.vtu", "--method", "paper")
        one, two = (numpy.array(vtu.points(self.folder / f)) for f in ("series.vtu", "frames.vtu"))
        self.assertLess(abs(one - two).max(), 1e-4)

    def test_overlaps_are_counted(self):
        masks, alongs, segments = self.parts()
        whole = [VOXELS[k] > 0 for k in range(6)]
        self.save(segmentation("a", whole + masks, [2.0 * k for k in range(6)] + alongs,
                               [3] * 6 + segments, ["left", "right", "all"]))
        found, report = self.voxels()
        self.assertEqual(found, {3: sum(COUNTS.values())})
        self.assertEqual(report["input"]["notes"], [
            "segments overlap, where the later one wins: 'all' covers 'left' in "
            f"{COUNTS[3]} voxels",
            "segments overlap, where the later one wins: 'all' covers 'right' in "
            f"{COUNTS[5]} voxels"])

    def test_fractions(self):
        masks, alongs, segments = self.parts()
        fractions = [numpy.where(m, 100, 99) for m in masks]
        self.save(segmentation("a", fractions, alongs, segments, ["a", "b"], "FRACTIONAL", 8))
        found, report = self.voxels()
        self.assertEqual(found, {1: COUNTS[3], 2: COUNTS[5]})
        self.assertIn("half", report["input"]["notes"][0])

    def test_label_map(self):
        data = segmentation("a", numpy.select([VOXELS == 3, VOXELS == 5], [2, 1]),
                            [2.0 * k for k in range(6)], [0] * 6, ["five", "three"], "LABELMAP", 8)
        self.save(data)
        found, report = self.voxels()
        self.assertEqual(found, {2: COUNTS[3], 1: COUNTS[5]})
        self.assertEqual([r["name"] for r in report["regions"]], ["five", "three"])

    def test_empty_slices_may_be_left_out(self):
        masks = [VOXELS[k] > 0 for k in (0, 1, 5)]
        self.save(segmentation("a", masks, [0.0, 2.0, 10.0], [1, 1, 1], ["a"]))
        self.assertEqual(self.voxels()[0], {1: int(sum(m.sum() for m in masks))})
        self.save(segmentation("a", masks, [0.0, 2.0, 9.0], [1, 1, 1], ["a"]))
        self.refused(BAD_INPUT, "equally spaced")

    def test_unknown_segment(self):
        masks, alongs, _ = self.parts()
        self.save(segmentation("a", masks, alongs, [7] * len(masks), ["a"]))
        self.refused(BAD_INPUT, "segment 7")


class SlopesOfSlices(FramesTest):
    """As PET has them: each slice uses all of its 16 bits."""

    def test_values_are_of_one_scale(self):
        write_series(self.folder / "scan", VOXELS, spacing=SPACING, origin=ORIGIN)
        scales = {}
        for n, path in enumerate(sorted((self.folder / "scan").iterdir())):
            data = pydicom.dcmread(path)
            slope, intercept = ((1, 0), (0.25, 0), (2, -3), (1.5, 1), (1, 70000), (3, 0))[n]
            data.RescaleSlope, data.RescaleIntercept = slope, intercept
            data.save_as(path)
            scales[round((data.ImagePositionPatient[2] - ORIGIN[2]) / 2)] = (slope, intercept)
        values = numpy.array([scales[k][0] * v + scales[k][1] for k, v in enumerate(VOXELS)])
        for level in (-2.5, 0.6, 4.9, 9, 60000):
            with self.subTest(level):
                self.assertEqual(self.voxels("scan", f"--iso={level}")[0],
                                 {0: (values > level).sum()})

    def test_slopes_of_magnetic_resonance(self):
        """There the standard knows of none, but scanners write them."""
        write_series(self.folder / "scan", VOXELS, spacing=SPACING, origin=ORIGIN)
        for path in (self.folder / "scan").iterdir():
            data = pydicom.dcmread(path)
            data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.4"
            data.Modality, data.RescaleSlope = "MR", 1.5
            data.save_as(path)
        self.assertEqual(self.voxels("scan", "--iso=5.5")[0], {0: (1.5 * VOXELS > 5.5).sum()})


if __name__ == "__main__":
    unittest.main()
