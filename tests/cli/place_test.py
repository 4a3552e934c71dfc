"""Which way the axes of the output go, and its unit of length."""

import json
import pathlib
import struct
import unittest

import vtu
from images import voxels, write_meta, write_nifti, write_nrrd
from program import ProgramTest

try:
    import nibabel
    import numpy
except ImportError as missing:  # libraries that only these tests need
    raise unittest.SkipTest(str(missing)) from missing

USAGE = 2
SIZE = (9, 7, 6)


def lopsided(i, j, k):
    return 3 if 10 * k + 2 * j + i < 40 else 5 if i > 6 else 0


class Place(ProgramTest):
    def nifti(self, name="a.nii"):
        """Oblique, with an offset."""
        affine = numpy.array([[0, -2, 0, 30], [1.5, 0, 0, -40], [0, 0, 3, 7], [0, 0, 0, 1.0]])
        array = numpy.array(voxels(SIZE, lopsided), "int16").reshape(SIZE[::-1]).T
        nibabel.save(nibabel.Nifti1Image(array, affine), self.folder / name)

    def points(self, *options, file="a.nii"):
        report = self.mesh(file, "-o", "a.vtu", *options)
        return report, numpy.array(vtu.points(self.folder / "a.vtu")).reshape(-1, 3)


class Frame(Place):
    def test_nifti(self):
        """In RAS the points are where nibabel's affine has the voxels."""
        self.nifti()
        report, usual = self.points()
        self.assertEqual(report["output"]["frame"], "lps")
        for frame in ("ras", "input"):
            told, ras = self.points("--frame", frame)
            self.assertEqual(told["output"]["frame"], "ras")
            self.assertEqual(told["mesh"]["checksum"], report["mesh"]["checksum"])
            self.assertTrue(numpy.array_equal(ras, usual * (-1, -1, 1)))
        image = nibabel.load(self.folder / "a.nii")
        filled = numpy.argwhere(image.get_fdata() > 0)
        centres = nibabel.affines.apply_affine(image.affine, filled)
        half = numpy.abs(image.affine[:3, :3]).sum(1) / 2
        for end, sign in ((numpy.min, -1), (numpy.max, 1)):
            self.assertTrue(numpy.allclose(end(ras, 0), end(centres, 0) + sign * half, atol=0.8))
        self.assertTrue(numpy.array_equal(self.points("--frame", "lps")[1], usual))
        self.assertTrue(self.check("a.vtu")["ok"])

    def test_who_says_what(self):
        self.nifti()
        values = voxels(SIZE, lopsided)
        write_meta(self.folder / "a.mha", SIZE, values)
        write_nrrd(self.folder / "a.nrrd", SIZE, values)
        data = (self.folder / "a.nrrd").read_bytes()
        (self.folder / "r.nrrd").write_bytes(data.replace(b"left-posterior", b"right-anterior", 1))
        (self.folder / "n.nrrd").write_bytes(
            data.replace(b"space: left-posterior-superior\n", b"space dimension: 3\n", 1))
        for file, usual, own in (("a.nii", "lps", "ras"), ("a.mha", "lps", "lps"),
                                 ("a.nrrd", "lps", "lps"), ("r.nrrd", "lps", "ras"),
                                 ("n.nrrd", "input", "input")):
            with self.subTest(file):
                self.assertEqual(self.points(file=file)[0]["output"]["frame"], usual)
                report, _ = self.points("--frame", "input", file=file)
                self.assertEqual(report["output"]["frame"], own)
        same = self.points("--frame", "input", file="r.nrrd")[1]
        plain = self.points(file="a.nrrd")[1]
        self.assertTrue(numpy.array_equal(same.max(0), plain.max(0)))
        self.assert_fails(USAGE, ["n.nrrd", "axes"], "mesh", "n.nrrd", "--frame", "ras", "-o", "b.vtu")
        self.assert_fails(USAGE, ["--frame", "image"], "mesh", "--shape", "sphere:1", "--frame", "ras",
                          "-o", "b.vtu")

    def test_files_and_table_say_it(self):
        self.nifti()
        for options, space in (((), "LPS"), (("--frame", "ras"), "RAS")):
            for name, place in (("a.vtu", f"<!-- SPACE={space} -->"), ("a.stl", f"certet SPACE={space}\0"),
                                ("a.ply", f"\ncomment SPACE={space}\n")):
                run = self.run_certet("mesh", "a.nii", "-o", name, *options)
                self.assertIn(f"frame      {space}: x to the", run.stdout)
                self.assertIn(place.encode(), (self.folder / name).read_bytes()[:300])
            self.run_certet("convert", "a.vtu", "b.ply")
            self.run_certet("mesh", "a.nii", "-o", "a.ply", *options)
            self.assertEqual((self.folder / "b.ply").read_bytes(), (self.folder / "a.ply").read_bytes())
            self.assertEqual((self.folder / "a.stl").stat().st_size,
                             84 + 50 * struct.unpack_from("<I", (self.folder / "a.stl").read_bytes(), 80)[0])
            if options == ():
                self.mesh("a.nii", "-o", "z.vtu", "--compress")
                self.run_certet("convert", "z.vtu", "c.ply")
                self.assertEqual((self.folder / "c.ply").read_bytes(), (self.folder / "a.ply").read_bytes())


class Scale(Place):
    def test_images(self):
        self.nifti()
        report, points = self.points()
        told, metres = self.points("--scale", "0.001")
        self.assertTrue(numpy.allclose(metres, points / 1000, rtol=1e-15, atol=1e-18))
        self.assertEqual(told["mesh"]["checksum"], report["mesh"]["checksum"])
        self.assertEqual(told["output"]["scale"], 0.001)
        self.assertAlmostEqual(told["mesh"]["volume"] * 1e9 / report["mesh"]["volume"], 1, places=12)
        for one, other in zip(told["regions"], report["regions"]):
            self.assertAlmostEqual(one["volume"] * 1e9 / other["volume"], 1, places=12)
            self.assertAlmostEqual(one["voxel_volume"] * 1e9 / other["voxel_volume"], 1, places=12)
        self.assertEqual(told["lattice"], report["lattice"])
        (self.folder / "r.json").write_text(json.dumps(told))
        run = self.run_certet("check", "a.vtu", "--run", "r.json", "--json", "-")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertAlmostEqual(json.loads(run.stdout)["mesh"]["volume"] / told["mesh"]["volume"], 1, places=9)

    def test_with_the_other_placings(self):
        self.nifti()
        points = self.points()[1]
        both = self.points("--frame", "ras", "--scale", "1000")[1]
        self.assertTrue(numpy.allclose(both, points * (-1000, -1000, 1000), rtol=1e-14))
        report, near = self.points("--frame", "ras", "--scale", "1000", "--origin", "0")
        self.assertTrue(numpy.allclose(near + report["output"]["origin"], both, rtol=1e-12))

    def test_the_volume_is_compared_before(self):
        """No warning of a loss, whatever the scale."""
        for scale in ("0.001", "1000"):
            report = self.mesh("--shape", "sphere:1", "--size", "0.2", "--scale", scale, "-o", "a.vtu")
            self.assertEqual(report["warnings"], [])
            self.assertAlmostEqual(report["mesh"]["volume"] / float(scale) ** 3, 4.15, delta=0.1)

    def test_convert(self):
        for shape in (("--shape", "box:1,2,3", "--size", "0.5"), ("a.nii",)):
            if shape == ("a.nii",):
                self.nifti()
            self.mesh(*shape, "-o", "a.vtu")
            points = numpy.array(vtu.points(self.folder / "a.vtu"))
            run = self.run_certet("convert", "a.vtu", "b.vtu", "--scale", "0.001", "--json", "-")
            self.assertEqual(json.loads(run.stdout)["output"]["scale"], 0.001)
            self.assertTrue(numpy.array_equal(numpy.array(vtu.points(self.folder / "b.vtu")), points * 0.001))

    def test_refusals(self):
        for scale in ("0", "-1", "nan", "mm"):
            self.assert_fails(USAGE, ["--scale"], "mesh", "--shape", "sphere:1", f"--scale={scale}",
                              "-o", "a.vtu")
        self.mesh("--shape", "sphere:1", "-o", "a.vtu", "--size", "0.5")
        self.assert_fails(USAGE, ["--scale"], "convert", "a.vtu", "b.vtu", "--scale=0")


if __name__ == "__main__":
    unittest.main()
