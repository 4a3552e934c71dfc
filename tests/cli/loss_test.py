"""What a mesh loses of a solid, and the size that is named for it."""

import math
import os
import re
import subprocess
import unittest

import images
import surface_defects as defects
import surfaces
from program import ProgramTest

EMPTY = 4
BOX = "-1.5,-1.5,-1.5,1.5,1.5,1.5"
# By the paper's rule thin parts vanish, where the default keeps them.
PAPER = ("--method", "paper")
SHELL = "abs(sqrt(x^2+y^2+z^2)-1)-0.02"
WRITE_VOLUMES = os.environ.get("CERTET_WRITE_VOLUMES", "")


def plate(thickness):
    return defects.turned(surfaces.cube((0, 0, 0), (1, 1, thickness)))


class LossTest(ProgramTest):
    def assert_told(self, volume, *source):
        """A warning with the true share of the volume, and a size that holds what it promises."""
        report = self.mesh(*source, "-o", "a.vtu")
        self.assertEqual(len(report["warnings"]), 1, report["warnings"])
        told = re.fullmatch(r"the mesh has ([0-9.]+) % of the volume of '.*', \S+ of (about )?"
                            r"([0-9.e+-]+); --size ([0-9.e+-]+) has ([0-9.]+) % of it, in "
                            r"([0-9,]+) tetrahedra", report["warnings"][0])
        self.assertIsNotNone(told, report["warnings"])
        share, _, solid, size, kept, tets = told.groups()
        self.assertAlmostEqual(float(solid), volume, delta=0.01 * volume)
        self.assertAlmostEqual(float(share), 100 * report["mesh"]["volume"] / volume, delta=1.5)
        self.assert_keeps(volume, size, kept, tets, *source)

    def assert_keeps(self, volume, size, kept, tets, *source):
        without = [o for n, o in enumerate(source) if "--size" not in source[max(n - 1, 0):n + 1]]
        again = self.mesh(*without, "--size", size, "-o", "b.vtu")
        self.assertEqual(again["warnings"], [])
        self.assertAlmostEqual(again["mesh"]["tets"], int(tets.replace(",", "")),
                               delta=0.001 * again["mesh"]["tets"])
        self.assertAlmostEqual(float(kept), 100 * again["mesh"]["volume"] / volume, delta=1)
        self.assertAlmostEqual(again["mesh"]["volume"], volume, delta=0.04 * volume)

    def assert_empty(self, volume, *source):
        """Nothing is inside, and the sentence has a size at which it is."""
        run = self.run_certet("mesh", *source, "-o", "a.vtu")
        self.assertEqual(run.returncode, EMPTY, run.stderr)
        told = re.search(r"; --size (\S+) has ([0-9.]+) % of it, in ([0-9,]+) tetrahedra\n\Z",
                         run.stderr)
        self.assertIsNotNone(told, run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)
        self.assert_keeps(volume, *told.groups(), *source)


class Shapes(LossTest):
    def test_thin_ones(self):
        self.assert_told(0.01, "--shape", "box:1,1,0.01")
        self.assert_told(2 * math.pi ** 2 * 0.02 ** 2, "--shape", "torus:1,0.02", "--size", "0.04")

    def test_vanished_ones(self):
        torus = 2 * math.pi ** 2 * 1e-4
        self.assert_empty(torus, "--shape", "torus:1,0.01", *PAPER)
        self.assert_told(torus, "--shape", "torus:1,0.01")
        self.assert_told(math.pi * 1e-4, "--shape", "cylinder:0.01,1")

    def test_thick_ones_are_not_told(self):
        for shape in ("sphere:1", "torus:1,0.4", "box:1,2,3", "cylinder:1,2", "gyroid:1,0.2"):
            for cuts in ("bisect", "midpoint"):
                with self.subTest(shape=shape, cuts=cuts):
                    report = self.mesh("--shape", shape, "--cuts", cuts, "-o", "a.vtu")
                    self.assertEqual(report["warnings"], [])


class Formulas(LossTest):
    def test_thin_shell(self):
        volume = 4 / 3 * math.pi * (1.02 ** 3 - 0.98 ** 3)
        self.assert_told(volume, "--expr", SHELL, "--bounds", BOX)

    def test_vanished_shell(self):
        volume = 4 / 3 * math.pi * (1.01 ** 3 - 0.99 ** 3)
        shell = ("--expr", SHELL.replace("0.02", "0.01"), "--bounds", BOX)
        self.assert_empty(volume, *shell, *PAPER)
        self.assert_told(volume, *shell)

    def test_nothing_at_any_size(self):
        run = self.run_certet("mesh", "--expr", "x^2+1", "--bounds", BOX, "-o", "a.vtu")
        self.assertEqual(run.returncode, EMPTY)
        self.assertIn("keeps any of it", run.stderr)
        self.assertNotIn("--size", run.stderr)


class Surfaces(LossTest):
    def write(self, surface):
        (self.folder / "a.obj").write_bytes(surfaces.obj(surface))
        run = self.run_certet("mesh", "a.obj", "--dry-run")
        if "not built in" in run.stderr:
            self.skipTest("without assimp")
        return surfaces.volume(surface)

    def test_default_follows_thin_parts(self):
        for surface in (plate(0.03), plate(0.01),
                        defects.turned(surfaces.torus(1, 0.02, 96, 24))):
            volume = self.write(surface)
            report = self.mesh("a.obj", "-o", "a.vtu")
            self.assertAlmostEqual(report["mesh"]["volume"], volume, delta=0.02 * volume)
            self.assertEqual(report["warnings"], [])
            self.assertIn("thick", report["input"]["notes"][0])
            asked = self.mesh("a.obj", "--size", repr(report["lattice"]["size"]), "-o", "b.vtu")
            self.assertEqual(asked["mesh"], report["mesh"])
            self.assertEqual(asked["input"]["notes"], [])

    def test_default_of_thick_ones_is_a_64th(self):
        for surface, side in ((surfaces.cube(), 1), (surfaces.torus(), 2.8),
                              (surfaces.sphere(), 2)):
            self.write(surface)
            report = self.mesh("a.obj", "-o", "a.vtu")
            self.assertAlmostEqual(report["lattice"]["size"], side / 64, delta=1e-6)
            self.assertEqual(report["warnings"] + report["input"]["notes"], [])

    def test_default_has_a_limit_that_is_said(self):
        self.write(plate(0.003))
        report = self.mesh("a.obj", "-o", "a.vtu")
        self.assertIn("4 million tetrahedra", report["input"]["notes"][0])
        self.assertLess(report["mesh"]["tets"], 5e6)

    def test_loss_is_told(self):
        volume = self.write(plate(0.02))
        self.assert_told(volume, "a.obj", "--size", "0.025", *PAPER)
        self.assert_empty(volume, "a.obj", "--size", "0.04", *PAPER)
        self.assertEqual(self.mesh("a.obj", "--size", "0.025", "-o", "a.vtu")["warnings"], [])

    def test_solids_that_overlap_have_the_volume_of_their_union(self):
        """Two plates, one through the other, and one within a thicker one."""
        cross = surfaces.join(surfaces.cube((0, 0, 0), (1, 1, 0.02)),
                              surfaces.cube((0, 0.49, -0.5), (1, 0.51, 0.52)))
        self.write(defects.turned(cross))
        self.assert_told(0.02 + 1 * 0.02 * 1.02 - 0.02 * 0.02, "a.obj", "--size", "0.025", *PAPER)
        within = surfaces.join(surfaces.cube((0, 0, 0), (1, 1, 0.02)),
                               surfaces.cube((0.1, 0.1, 0.005), (0.9, 0.9, 0.015)))
        self.write(defects.turned(within))
        self.assert_told(0.02, "a.obj", "--size", "0.025", *PAPER)


@unittest.skipUnless(WRITE_VOLUMES, "without OpenVDB")
class Volumes(LossTest):
    def setUp(self):
        super().setUp()
        subprocess.run([WRITE_VOLUMES, self.folder], check=True)

    def test_ball(self):
        """Told of a lattice hardly finer than the ball; the default is the voxels'."""
        report = self.mesh("ball.vdb", "-o", "a.vtu")
        self.assertEqual(report["warnings"], [])
        self.assert_told(4 / 3 * math.pi * 8, "ball.vdb", "--size", "1.5")


class Images(LossTest):
    """Labels have the volume of their voxels, levels that of the interpolated image."""

    SIZE = (20, 20, 40)

    def write(self, value, kind="B", spacing=1.0):
        images.write_nrrd(self.folder / "a.nrrd", self.SIZE, images.voxels(self.SIZE, value), kind,
                          ((1, 0, 0), (0, 1, 0), (0, 0, spacing)))

    def test_vanished_vessel(self):
        self.write(lambda i, j, k: int(i == 10 and j == 10 and 5 <= k < 35), spacing=1.1)
        self.assert_empty(33, "a.nrrd", *PAPER)

    def test_thin_vessel(self):
        self.write(lambda i, j, k: int(i == 10 and j == 10 and 5 <= k < 35), spacing=1.1)
        self.assert_told(33, "a.nrrd", "--guarantee", "embedding")

    def test_thin_shell_of_a_level(self):
        def shell(i, j, k):
            return 1 - abs(math.dist((i, j, k), (9.5, 9.5, 19.5)) - 7)
        self.write(shell, "f")
        # The volume above the level between the voxels, sampled finely; 865 were they dense.
        self.assert_told(844.5, "a.nrrd", "--iso", "0.3", "--size", "2")

    def test_solid_ones_are_not_told(self):
        self.write(lambda i, j, k: int(2 <= i < 18 and 2 <= j < 18 and 5 <= k < 35))
        self.assertEqual(self.mesh("a.nrrd", "-o", "a.vtu")["warnings"], [])


if __name__ == "__main__":
    unittest.main()
