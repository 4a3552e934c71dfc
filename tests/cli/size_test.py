"""Sizes as a fraction of the solid, and by the number of tetrahedra."""

import unittest

from images import voxels, write_nrrd
from program import TORUS, ProgramTest


class RelativeSize(ProgramTest):
    def test_formula(self):
        report = self.mesh(*TORUS, "--rel-size", "0.05", "-o", "t.vtu")
        self.assertAlmostEqual(report["lattice"]["size"], 0.05 * 3, places=12)

    def test_shape(self):
        report = self.mesh("--shape", "torus:1,0.4", "--rel-size", "0.05", "-o", "t.vtu")
        self.assertAlmostEqual(report["lattice"]["size"], 0.05 * 2.8, places=12)
        report = self.mesh("--shape", "torus:1,0.4", "--bounds=0,0,-9,1,9,9", "--rel-size",
                           "0.05", "-o", "t.vtu")
        self.assertAlmostEqual(report["lattice"]["size"], 0.05 * 1.4, places=12)

    def test_labels(self):
        """By the box of the voxels chosen, along the image's axes."""
        values = voxels((20, 12, 10), lambda i, j, k: int(2 <= i < 10 and 3 <= j < 9))
        for directions in (((0.5, 0, 0), (0, 1, 0), (0, 0, 0.25)),
                           ((0.3, 0.4, 0), (-0.8, 0.6, 0), (0, 0, 0.25))):
            write_nrrd(self.folder / "a.nrrd", (20, 12, 10), values, directions=directions)
            report = self.mesh("a.nrrd", "--rel-size", "0.1", "-o", "a.vtu")
            self.assertAlmostEqual(report["lattice"]["size"], 0.1 * 6, places=9)

    def test_level(self):
        """A level's solid reaches into the voxels around those above it."""
        values = voxels((20, 12, 10), lambda i, j, k: int(2 <= i < 12 and 3 <= j < 9) * 5)
        write_nrrd(self.folder / "a.nrrd", (20, 12, 10), values)
        report = self.mesh("a.nrrd", "--iso", "2", "--rel-size", "0.1", "-o", "a.vtu")
        self.assertAlmostEqual(report["lattice"]["size"], 0.1 * 12, places=9)

    def test_same_as_that_size(self):
        one = self.mesh(*TORUS, "--rel-size", "0.03125", "-o", "t.vtu")
        two = self.mesh(*TORUS, "--size", "0.09375", "-o", "t.vtu")
        self.assertEqual(one["mesh"], two["mesh"])


class TargetTets(ProgramTest):
    def assert_finds(self, target, *source, within=0.02):
        report = self.mesh(*source, "--target-tets", target, "-o", "t.vtu")
        tets = report["mesh"]["tets"]
        self.assertLessEqual(abs(tets - target), within * target, tets)
        self.assertEqual(report["lattice"]["target_tets"], target)
        self.assertLessEqual(report["lattice"]["tries"], 12)
        again = self.mesh(*source, "--size", repr(report["lattice"]["size"]), "-o", "t.vtu")
        self.assertEqual(report["mesh"], again["mesh"])
        self.assertNotIn("target_tets", again["lattice"])
        return report

    def test_formula(self):
        for target in (20_000, 1_000_000):
            with self.subTest(target):
                self.assert_finds(target, *TORUS)
        self.assert_finds(1_000, *TORUS, within=0.2)  # there are few meshes so small

    def test_shape(self):
        # Where a layer of cells comes in its counts go from 105,000 to 93,000 at once.
        self.assert_finds(100_000, "--shape", "gyroid:1,0.2", within=0.03)

    def test_thin_shape_that_coarse_lattices_miss(self):
        report = self.assert_finds(1_000_000, "--shape", "box:1,1,0.02")
        self.assertGreater(report["lattice"]["tries"], 2)

    def test_labels(self):
        values = voxels((30, 31, 32), lambda i, j, k: 1 + int(i > 15)
                        if (i - 15) ** 2 + (j - 15) ** 2 + (k - 16) ** 2 < 150 else 0)
        write_nrrd(self.folder / "a.nrrd", (30, 31, 32), values)
        for arguments in ((), ("--iso", "0.5")):
            with self.subTest(arguments):
                self.assert_finds(100_000, "a.nrrd", *arguments)

    def test_nearest_where_there_is_no_such_mesh(self):
        report = self.mesh("--shape", "sphere:1", "--target-tets", "1", "-o", "t.vtu")
        self.assertGreater(report["mesh"]["tets"], 0)
        self.assertLess(report["mesh"]["tets"], 200)

    def test_threads_and_table(self):
        sizes = {self.mesh(*TORUS, "--target-tets", "30000", "--threads", threads, "--dry-run")
                 ["lattice"]["size"] for threads in (1, 2, 3)}
        self.assertEqual(len(sizes), 1)
        run = self.run_certet("mesh", *TORUS, "--target-tets", "30000", "--dry-run")
        self.assertIn("target     30,000 tetrahedra", run.stdout)


if __name__ == "__main__":
    unittest.main()
