"""What a mesh loses of a solid, and the size that is named for it."""

import math
import re
import unittest

import images
import surface_defects as defects
import surfaces
from program import ProgramTest
from volumes import WithVolumes

EMPTY = 4
BOX = "-1.5,-1.5,-1.5,1.5,1.5,1.5"
# By the paper's rule thin parts vanish, where the default keeps them.
PAPER = ("--method", "paper")
SHELL = "abs(sqrt(x^2+y^2+z^2)-1)-0.02"


def plate(thickness):
    return defects.turned(surfaces.cube((0, 0, 0), (1, 1, thickness)))


class LossTest(ProgramTest):
    def mesh(self, *arguments):
        """Of what the lattice finds, without what sharp edges add to it and are warned of."""
        return super().mesh(*arguments, "--features", "off")

    def assert_told(self, volume, *source):
        """A warning with the true share of the volume, and a size that holds what it promises."""
        report = self.mesh(*source, "-o", "a.vtu")
        others = [w for w in report["warnings"] if "pieces" in w]
        self.assertEqual(len(report["warnings"]) - len(others), 1, report["warnings"])
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
        self.assertEqual(self.mesh("a.obj", "--size", "0.024", "-o", "a.vtu")["warnings"], [])

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


class Volumes(WithVolumes, LossTest):
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


class Pieces(LossTest):
    """Pieces that the lattice does not find, and a size at which it does."""

    def assert_pieces(self, mesh, shape, *source):
        """A warning with these counts, and a size at which the mesh has the shape's."""
        report = self.mesh(*source, "-o", "a.vtu")
        self.assertEqual(report["mesh"]["pieces"]["by_faces"], mesh)
        told = [w for w in report["warnings"] if "piece" in w]
        self.assertEqual(len(told), 1, report["warnings"])
        self.assertRegex(told[0], rf"\b{mesh} pieces?\b.*, (and .* )?{shape}( in the image)?; ")
        size = re.search(r"--size ([0-9.e-]+)", told[0])
        self.assertIsNotNone(size, told)
        others = [o for n, o in enumerate(source) if "--size" not in source[max(n - 1, 0):n + 1]]
        self.assert_kept(shape, *others, "--size", size[1])
        return told[0]

    def assert_kept(self, shape, *source):
        report = self.mesh(*source, "-o", "b.vtu")
        self.assertEqual(report["mesh"]["pieces"]["by_faces"], shape)
        self.assertEqual(report["warnings"], [])


class PiecesOfSurfaces(Pieces):
    def write(self, *parts):
        (self.folder / "a.obj").write_bytes(surfaces.obj(surfaces.join(*parts)))
        if "not built in" in self.run_certet("mesh", "a.obj", "--dry-run").stderr:
            self.skipTest("without assimp")
        return "a.obj", "--size", "0.25"

    def test_small_ones_beside_a_large_one(self):
        dots = [surfaces.octahedron((2.5, 0.3 + 0.4 * n, 0.6), 0.06) for n in range(3)]
        source = self.write(surfaces.cube((0, 0, 0), (2, 2, 2)), *dots)
        self.assert_pieces(1, 4, *source)
        self.assert_pieces(1, 4, *source, "--method", "paper")

    def test_cavities_are_none_and_what_is_in_them_is(self):
        """A wall around a cavity with a ball, of which the lattice finds nothing."""
        cavity = surfaces.inside_out(surfaces.cube((0.6, 0.6, 0.6), (1.4, 1.4, 1.4)))
        source = self.write(surfaces.cube((0, 0, 0), (2, 2, 2)), cavity,
                            surfaces.octahedron((1.1, 1.05, 0.93), 0.07))
        self.assert_pieces(1, 2, *source)

    def test_parts_that_touch(self):
        """Blocks that share an edge are one piece or two, as the lattice has it."""
        source = self.write(surfaces.cube((0, 0, 0), (1, 1, 1)),
                            surfaces.cube((1, 1, 0), (2, 2, 1)))
        self.assertEqual(self.mesh(*source, "-o", "a.vtu")["warnings"], [])

    def test_parts_that_overlap_are_compared_on_lattices(self):
        source = self.write(surfaces.cube((0, 0, 0), (2, 2, 2)),
                            surfaces.cube((1, 1, 1), (3, 3, 3.1)),
                            surfaces.octahedron((2.6, 0.6, 0.6), 0.1))
        told = self.assert_pieces(1, 2, *source)
        self.assertRegex(told, "its samples at size .* and so have its samples at half of it")

    def test_open_ones(self):
        """Holes of an open surface are closed; a box and one without a lid."""
        points, faces = surfaces.cube((2.7, 0.4, 0.4), (2.8, 0.5, 0.5))
        self.write(surfaces.cube((0, 0, 0), (2, 2, 2)), (points, faces[1:]))
        self.assert_pieces(1, 2, "a.obj", "--repair", "--size", "0.3")


class PiecesOfFormulas(Pieces):
    BALLS = "min(length(x,y,z)-1,length(x-1.5,y-0.33,z-0.21)-0.06)"

    def test_small_ball(self):
        told = self.assert_pieces(1, 2, "--expr", self.BALLS, "--bounds",
                                  "-1.2,-1.2,-1.2,1.8,1.2,1.2", "--size", "0.15")
        self.assertRegex(told, "its samples at size .* and so have its samples at half of it")

    def test_what_is_not_compared_is_said(self):
        """Of a surface that is everywhere finer samples would take longer than the mesh."""
        waves = ("--expr", "sin(20*x)*sin(20*y)*sin(20*z)", "--bounds", "-1,-1,-1,1,1,1",
                 "--size", "0.08", "-o", "a.vtu")
        report = self.mesh(*waves)
        losses = report["losses"]
        self.assertEqual(losses["size"], 0.04)
        self.assertGreater(losses["cells"], report["mesh"]["tets"] / 2)
        self.assertEqual(losses["not_compared"],
                         "pieces were not compared with those of finer samples: at size 0.04 "
                         f"{losses['cells']:,.0f} cells would be looked at")
        self.assertEqual([w for w in report["warnings"] if "compared" in w], [])
        self.assertIn(f"\nlosses     {losses['not_compared']}\n",
                      self.run_certet("mesh", *waves).stdout)

    def test_nothing_is_said_of_what_is_compared_or_known(self):
        for source in (("--expr", self.BALLS, "--bounds", "-1.2,-1.2,-1.2,1.8,1.2,1.2"),
                       ("--shape", "sphere:1")):
            self.assertNotIn("losses", self.mesh(*source, "--size", "0.05", "-o", "a.vtu"))

    def test_resolved_ones_are_not_told(self):
        for size in ("0.05", "0.03"):
            self.assert_kept(2, "--expr", self.BALLS, "--bounds", "-1.2,-1.2,-1.2,1.8,1.2,1.2",
                             "--size", size)


class PiecesOfVolumes(WithVolumes, Pieces):
    def test_small_ball_beside_a_large_one(self):
        self.assertEqual(self.mesh("balls.vdb", "-o", "a.vtu")["warnings"], [])
        self.assert_pieces(1, 2, "balls.vdb", "--size", "1.3")


class PiecesOfImages(Pieces):
    SIZE = (20, 20, 20)

    def write(self, value, kind="f"):
        images.write_nrrd(self.folder / "a.nrrd", self.SIZE, images.voxels(self.SIZE, value), kind)

    def test_peak_between_samples(self):
        """A voxel just above the level, at the size of the voxels."""
        def value(i, j, k):
            if (i, j, k) in ((3, 3, 3), (16, 4, 4), (4, 16, 15)):
                return 1.0
            return 3.0 if 7 <= min(i, j, k) and max(i, j, k) < 15 else 0.0
        self.write(value)
        self.assert_pieces(1, 4, "a.nrrd", "--iso", "0.9")

    def test_smoothed_labels(self):
        """Blocks that smoothing keeps, and a lattice that is too coarse for some."""
        def value(i, j, k):
            corner = all(a in (3, 4, 5, 18, 19, 20) for a in (i, j, k))
            return int(corner or all(8 <= a < 16 for a in (i, j, k)))
        self.SIZE = (24, 24, 24)
        self.write(value, "B")
        self.assert_pieces(1, 9, "a.nrrd", "--method", "paper", "--smooth", "1", "--size", "4")

    def test_what_smoothing_joins_no_size_keeps(self):
        self.write(lambda i, j, k: int(2 <= i < 18 and 2 <= j < 18 and k in range(3, 9)
                                       or 5 < i < 12 and 5 < j < 12 and k in range(11, 16)), "B")
        report = self.mesh("a.nrrd", "--method", "paper", "--smooth", "2", "--size", "1", "-o", "a.vtu")
        told, = [w for w in report["warnings"] if "piece" in w]
        self.assertRegex(told, "1 piece in the mesh, 2 in the image; no size was found that keeps "
                               "them, down to .*; a smaller --smooth may keep them")


if __name__ == "__main__":
    unittest.main()
