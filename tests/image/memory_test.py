"""No reader hands on memory that it did not fill: every format under valgrind, whole,
cut anywhere, and with sizes that lie."""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))

from images import voxels, write_meta, write_nifti, write_nrrd  # noqa: E402

try:
    import numpy
    from frames_test import dataset, describe, segmentation
    from scans import volume, write_series, write_tiff
except (ImportError, unittest.SkipTest) as missing:
    raise unittest.SkipTest(str(missing)) from missing
if shutil.which("valgrind") is None:
    raise unittest.SkipTest("valgrind is not there")

READER = os.environ.get("READ_EVERY_BYTE", "read_every_byte")
if subprocess.run([READER], check=False).returncode == 77:
    raise unittest.SkipTest("no reader of images is built in")
SIZE = (20, 12, 11)
REPORT = 9


def value(i, j, k):
    return (7919 * i + 104729 * j + 31 * k * k) % 251


class Memory(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.values = voxels(SIZE, value)

    def path(self, name):
        return self.folder / name

    def read(self, names, *options):
        """The lines of the reader, and valgrind's status."""
        run = subprocess.run(
            ["valgrind", "-q", f"--error-exitcode={REPORT}", "--track-origins=no",
             "--leak-check=no", READER, *options, *names],
            cwd=self.folder, text=True, capture_output=True, timeout=300)
        lines = re.findall(r"^(read|refused) (.*)$", run.stdout, re.M)
        self.assertEqual(len(lines), len(names), run.stdout[-2000:] + run.stderr[-3000:])
        return lines, run

    def whole_files(self):
        """One of each way to store voxels; none is smaller than its voxels packed."""
        write_meta(self.path("raw.mha"), SIZE, self.values)
        write_meta(self.path("packed.mha"), SIZE, self.values, packed=True)
        write_nifti(self.path("plain.nii"), SIZE, self.values)
        write_nifti(self.path("packed.nii.gz"), SIZE, self.values)
        write_nrrd(self.path("raw.nrrd"), SIZE, self.values)
        write_nrrd(self.path("packed.nrrd"), SIZE, self.values, packed=True)
        for encoding in ("ascii", "hex"):
            head, data = self.path("raw.nrrd").read_bytes().split(b"\n\n", 1)
            text = " ".join(map(str, self.values)).encode() if encoding == "ascii" else data.hex().encode()
            self.path(encoding + ".nrrd").write_bytes(
                head.replace(b"encoding: raw", b"encoding: " + encoding.encode()) + b"\n\n" + text)
        stack = volume(SIZE, value)
        write_tiff(self.path("plain.tif"), stack.astype("uint16"))
        write_tiff(self.path("strips.tif"), stack.astype("uint16"), contiguous=False,
                   rowsperstrip=5, metadata=None)
        write_tiff(self.path("tiles.tif"), stack.astype("uint16"), tile=(16, 16))
        write_tiff(self.path("packed.tif"), stack.astype("uint16"), compression="zlib")
        for name, data in (
                ("frames.dcm", describe(dataset("a", stack), [2.0 * k for k in range(11)])),
                ("segments.dcm", segmentation("a", [stack[k] > 99 for k in range(11)],
                                              [2.0 * k for k in range(11)], [1] * 11, ["a"]))):
            data.save_as(str(self.path(name)), write_like_original=False)
        return sorted(p.name for p in self.folder.iterdir())

    def lying_files(self):
        """Names of files that announce more than they have, or less."""
        names = []
        for name in self.whole_files():
            data = self.path(name).read_bytes()
            for n, length in enumerate((len(data) - 1, len(data) - 60, len(data) * 2 // 3)):
                stem, extensions = name.split(".", 1)
                names.append(f"{stem}-{n}.{extensions}")
                self.path(names[-1]).write_bytes(data[:length])
        packed = self.path("packed.mha").read_bytes()
        short = zlib.compress(b"\1\2" * 300)  # whole, but of fewer voxels
        head = packed[:packed.index(b"LOCAL\n") + 6]
        self.path("short.mha").write_bytes(head + short)
        self.path("told.mha").write_bytes(head.replace(
            b"ElementDataFile", b"CompressedDataSize = %d\nElementDataFile" % len(short)) + short)
        self.path("kinds.mha").write_bytes(packed.replace(b"MET_SHORT", b"MET_FLOAT"))
        self.path("zeros.mha").write_bytes(packed.replace(b"True\nTransform", b"False\nTransform"))
        self.path("short.nii.gz").write_bytes(
            gzip.compress(self.path("plain.nii").read_bytes()[:400]))
        self.path("short.nrrd").write_bytes(
            self.path("packed.nrrd").read_bytes().split(b"\n\n")[0] + b"\n\n" +
            gzip.compress(bytes(100)))
        detached = self.path("raw.mha").read_bytes().split(b"ElementDataFile")[0]
        self.path("part.raw").write_bytes(bytes(99))
        for name, place in (("part.mhd", b"part.raw"), ("list.mhd", b"LIST\n" + b"part.raw\n" * 11),
                            ("numbers.mhd", b"part%02d.raw 1 11 1")):
            self.path(name).write_bytes(detached + b"ElementDataFile = " + place + b"\n")
        self.path("part.nhdr").write_bytes(
            self.path("raw.nrrd").read_bytes().split(b"\n\n")[0] + b"\ndata file: part.raw\n")
        return names + ["short.mha", "told.mha", "kinds.mha", "short.nii.gz", "short.nrrd", "part.mhd",
                        "list.mhd", "numbers.mhd", "part.nhdr"]

    def test_whole_files(self):
        names = self.whole_files()
        write_series(self.folder / "series", volume(SIZE, value))
        lines, run = self.read([*names, "series"])
        self.assertEqual({word for word, _ in lines}, {"read"}, run.stdout)
        self.assertEqual(run.returncode, 0, run.stderr[-3000:])
        right = sum(v != 0 for v in self.values)
        counts = {text.split(": ")[0]: int(text.split(": ")[1]) for _, text in lines}
        counts.pop("segments.dcm")
        self.assertEqual(set(counts.values()), {right}, counts)

    def test_sizes_that_lie(self):
        """Refused, or nothing was lost: what ends behind the last voxel may be cut."""
        names = self.lying_files()
        whole = [n for n in self.whole_files() if re.sub(r"\..*", "", n) + "-0." in " ".join(names)]
        lines, run = self.read(names + whole)
        self.assertEqual(run.returncode, 0, run.stderr[-3000:])
        right = dict(text.split(": ") for _, text in lines[len(names):])
        read = {text.split(": ")[0]: text.split(": ")[1] for word, text in lines[:len(names)]
                if word == "read"}
        for name, count in read.items():
            self.assertEqual(count, right.get(re.sub(r"-\d", "", name)), name)
        self.assertLess(len(read), len(names) // 4, read)

    def test_a_voxel_that_nobody_wrote_is_noticed(self):
        write_meta(self.path("raw.mha"), SIZE, self.values)
        lines, run = self.read(["raw.mha"], "--leave-one-out")
        self.assertEqual(lines[0][0], "read")
        self.assertEqual(run.returncode, REPORT)
        self.assertIn("uninitialised", run.stderr)


if __name__ == "__main__":
    unittest.main()
