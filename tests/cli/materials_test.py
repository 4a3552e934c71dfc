"""Several surfaces, formulas and shapes as the materials of one mesh."""

import math
import struct
import unittest

import surfaces
import vtu
from surface_program import SurfaceProgramTest
from volumes import WithVolumes

USAGE, BAD_INPUT = 2, 3


def read_stl(data):
    """Corners of the triangles of a binary file."""
    (count,) = struct.unpack_from("<I", data, 80)
    numbers = [struct.unpack_from("<9f", data, 84 + 50 * n + 12) for n in range(count)]
    return [(row[:3], row[3:6], row[6:]) for row in numbers]


def area(triangle):
    a, b, c = triangle
    u, v = ([q[i] - a[i] for i in range(3)] for q in (b, c))
    return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]) / 2


class MaterialsTest(SurfaceProgramTest):
    def surface(self, name, surface):
        (self.folder / name).write_bytes(surfaces.stl(surface))
        return name

    def boxes(self):
        """Two that share a wall."""
        return (self.surface("left.stl", surfaces.cube((0, 0, 0), (1, 1, 1))),
                self.surface("right.stl", surfaces.cube((1, 0, 0), (3, 1, 1))))


class Regions(MaterialsTest):
    def test_two_boxes_and_their_wall(self):
        left, right = self.boxes()
        report = self.mesh(left, right, "-o", "a.vtu", "--size", "0.1")
        self.assertEqual(report["input"], {"kind": "materials", "name": "left, right", "notes": []})
        self.assertEqual([(r["label"], r["name"]) for r in report["regions"]],
                         [(1, "left"), (2, "right")])
        for region, volume in zip(report["regions"], (1, 2)):
            self.assertAlmostEqual(region["volume"], volume, delta=0.02)
            self.assertEqual(region["pieces"], 1)
        self.assertEqual(sum(r["tets"] for r in report["regions"]), report["mesh"]["tets"])
        self.assertEqual(report["theorem"], "MaterialDihedralBoundsInDegrees")
        self.assertEqual(report["warnings"], [])
        self.check("a.vtu")
        self.assertEqual(set(vtu.numbers(self.folder / "a.vtu", "label")), {1, 2})

    def test_their_interface_alone(self):
        left, right = self.boxes()
        for choice in ("left,right", "1,2", "right,left"):
            self.mesh(left, right, "-o", "wall.stl", "--size", "0.1", "--surface", choice)
            triangles = read_stl((self.folder / "wall.stl").read_bytes())
            self.assertAlmostEqual(sum(map(area, triangles)), 1, delta=0.2)
            # At its rim, where the outside is too, it may run back by an edge.
            for point in {p for triangle in triangles for p in triangle}:
                at_rim = min(min(abs(x), abs(x - 1)) for x in point[1:]) < 0.05
                self.assertLess(abs(point[0] - 1), 0.11 if at_rim else 0.05, point)

    def test_names_are_in_files_that_have_room_for_them(self):
        left, right = self.boxes()
        for name in ("a.msh", "a.inp", "a.feb", "a.bdf", "a.k", "a.mfem"):
            self.mesh(left, right, "-o", name, "--size", "0.2")
            text = (self.folder / name).read_bytes()
            for word in (b"left", b"right"):
                self.assertIn(word, text, name)

    def test_same_bytes_for_every_thread_count_and_memory(self):
        left, right = self.boxes()
        reports = [self.mesh(left, right, "-o", f"{n}.vtu", "--size", "0.1", *more)
                   for n, more in enumerate((["--threads", "1"], ["--threads", "8"],
                                             ["--max-memory", "3M"]))]
        self.assertEqual(len({r["mesh"]["checksum"] for r in reports}), 1)
        self.assertEqual(len({(self.folder / f"{n}.vtu").read_bytes() for n in range(3)}), 1)

    def test_midpoints_and_the_papers_method(self):
        left, right = self.boxes()
        report = self.mesh(left, right, "-o", "a.vtu", "--size", "0.1", "--method", "midpoint")
        self.assertEqual(report["theorem"], "MaterialMidpointBoundsInDegrees")
        self.check("a.vtu")
        report = self.mesh(left, right, "-o", "a.vtu", "--size", "0.1", "--method", "paper",
                           "--label-pieces")
        self.assertEqual(report["theorem"], "DihedralBounds")
        self.assertEqual([r["pieces"] for r in report["regions"]], [1, 1])
        self.assertAlmostEqual(report["mesh"]["volume"], 3, delta=0.02)

    def test_the_number_of_tetrahedra_is_chosen(self):
        left, right = self.boxes()
        report = self.mesh(left, right, "-o", "a.vtu", "--target-tets", "20000")
        self.assertAlmostEqual(report["mesh"]["tets"], 20000, delta=800)

    def test_relative_size_is_of_all_of_them(self):
        left, right = self.boxes()
        report = self.mesh(left, right, "--dry-run", "--rel-size", "0.1")
        self.assertAlmostEqual(report["lattice"]["size"], 0.3)


class Overlap(MaterialsTest):
    def volumes(self, *arguments):
        report = self.mesh("--material", "ball=sphere:1", "--material", "cube=box:1,1,1",
                           "-o", "a.vtu", "--size", "0.05", *arguments)
        return {r["name"]: r["volume"] for r in report["regions"]}, report

    def test_the_later_one_wins(self):
        volumes, _ = self.volumes()
        self.assertAlmostEqual(volumes["cube"], 1, delta=0.03)
        self.assertAlmostEqual(volumes["ball"], 4 / 3 * math.pi - 1, delta=0.05)

    def test_priority(self):
        volumes, _ = self.volumes("--priority", "cube,ball")
        self.assertAlmostEqual(volumes["cube"], 1, delta=0.03)
        volumes, report = self.volumes("--priority", "ball")
        self.assertEqual(volumes["cube"], 0)
        self.assertAlmostEqual(volumes["ball"], 4 / 3 * math.pi, delta=0.03)
        self.assertEqual(len(report["warnings"]), 1)
        self.assertIn("'cube' is not in the mesh", report["warnings"][0])

    def test_formulas_shapes_and_surfaces_together(self):
        self.surface("shell.stl", surfaces.sphere(2.0))
        report = self.mesh("shell.stl", "--material", "core=x^2+y^2+z^2-1",
                           "--material", "rod=cylinder:0.25,6", "--bounds=-1.5,-1.5,-1.5,1.5,1.5,1.5",
                           "-o", "a.msh", "--size", "0.1")
        self.assertEqual([r["name"] for r in report["regions"]], ["shell", "core", "rod"])
        rod = math.pi * 0.25**2 * 3  # --bounds cut it off
        self.assertAlmostEqual(report["regions"][2]["volume"], rod, delta=0.05 * rod)
        self.assertAlmostEqual(report["regions"][1]["volume"], 4 / 3 * math.pi - rod * 2 / 3,
                               delta=0.1)
        self.check("a.msh")

    def test_a_formula_in_a_file(self):
        (self.folder / "ball.txt").write_text("x^2 + y^2 + z^2 - 1  # the unit ball\n")
        box = ("--bounds=-1.2,-1.2,-1.2,1.2,1.2,1.2", "--size", "0.2", "--dry-run")
        here, there = (self.mesh("--material", f"ball={ball}", "--material", "core=sphere:0.5", *box)
                       for ball in ("x^2 + y^2 + z^2 - 1", "@ball.txt"))
        self.assertEqual(here["mesh"]["tets"], there["mesh"]["tets"])

    def test_a_single_formula_with_a_name(self):
        report = self.mesh("--material", "ball=x^2+y^2+z^2-1",
                           "--bounds=-2,-2,-2,2,2,2", "-o", "a.vtu", "--size", "0.1")
        plain = self.mesh("--expr", "x^2+y^2+z^2-1", "--bounds=-2,-2,-2,2,2,2", "-o", "b.vtu",
                          "--size", "0.1")
        self.assertEqual(report["mesh"]["checksum"], plain["mesh"]["checksum"])
        self.assertEqual(report["regions"][0]["name"], "ball")


class Volumes(WithVolumes, MaterialsTest):
    """A ball of radius 2 around (3, 4, 5), as a level set and as fog."""

    def test_a_volume_and_a_surface(self):
        self.surface("half.stl", surfaces.cube((0, 0, 0), (3, 9, 9)))
        report = self.mesh("half.stl", "ball.vdb", "--size", "0.25", "-o", "a.vtu")
        ball = 4 / 3 * math.pi * 8
        self.assertAlmostEqual(report["regions"][1]["volume"], ball, delta=0.03 * ball)
        self.assertAlmostEqual(report["regions"][0]["volume"], 243 - ball / 2, delta=2)
        self.check("a.vtu")

    def test_what_is_beyond_the_voxels_is_outside(self):
        """At this level the fog is everywhere."""
        self.surface("block.stl", surfaces.cube((-9, -9, -9), (9, 9, 9)))
        report = self.mesh("block.stl", "fog.vdb", "--iso", "-0.5", "--size", "0.5", "-o", "a.vtu")
        self.assertLess(report["regions"][1]["volume"], 4.5**3)
        self.assertGreater(report["regions"][1]["volume"], 3.9**3)


class Warnings(MaterialsTest):
    def test_one_that_is_too_small(self):
        report = self.mesh("--material", "ball=sphere:1", "--material", "grain=sphere:0.001",
                           "-o", "a.vtu", "--size", "0.3")
        self.assertTrue(any("'grain'" in w for w in report["warnings"]), report["warnings"])

    def test_of_a_dry_run_too(self):
        run = self.run_certet("mesh", "--material", "a=sphere:1", "--material", "b=sphere:2",
                              "--dry-run", "--size", "0.2")
        self.assertEqual(run.returncode, 0)
        self.assertIn("'a' is not in the mesh", run.stderr)

    def test_open_surfaces_are_refused_or_repaired(self):
        points, quads = surfaces.cube()
        self.surface("open.stl", (points, quads[:-1]))
        self.surface("ball.stl", surfaces.sphere(0.25))
        self.assert_fails(BAD_INPUT, ["'open.stl'", "--repair"], "mesh", "open.stl", "ball.stl",
                          "-o", "a.vtu")
        report = self.mesh("open.stl", "ball.stl", "--repair", "-o", "a.vtu", "--size", "0.1")
        self.assertIn("open.stl", report["input"]["notes"][0])
        self.assertAlmostEqual(report["mesh"]["volume"], 1 + 7 / 8 * 4 / 3 * math.pi / 64,
                               delta=0.03)


class Refusals(MaterialsTest):
    def refused(self, words, *arguments, status=USAGE):
        self.assert_fails(status, words, "mesh", *arguments, "-o", "out.vtu")

    def test_names(self):
        left, right = self.boxes()
        (self.folder / "other").mkdir()
        self.surface("other/left.stl", surfaces.cube())
        self.refused(["called 'left'", "--material"], left, "other/left.stl")
        self.refused(["called 'left'"], left, "--material", "left=sphere:1")
        self.refused(["--material takes", "'sphere'"], "--material", "sphere")
        self.refused(["--material takes"], "--material", "=sphere:1")
        self.refused(["comma"], "--material", "a,b=sphere:1")

    def test_priority(self):
        left, right = self.boxes()
        self.refused(["no material is called 'top'"], left, right, "--priority", "top")
        self.refused(["'left' twice"], left, right, "--priority", "left,right,left")
        self.refused(["--priority goes with several"], left, "--priority", "left")

    def test_what_cannot_be_one_of_several(self):
        left, right = self.boxes()
        (self.folder / "scan.nrrd").write_bytes(b"")
        self.refused(["'scan.nrrd'"], left, "scan.nrrd", status=BAD_INPUT)
        self.refused(["'scan.nrrd'"], left, "--material", "scan=scan.nrrd", status=BAD_INPUT)
        self.refused(["--bounds"], left, "--material", "a=x^2-1")
        self.refused(["--bounds goes with"], left, right, "--bounds", "0,0,0,1,1,1")
        self.refused(["--labels", "image"], left, right, "--labels", "1")
        self.refused(["--iso", "volume"], left, right, "--iso", "1")
        self.refused(["--repair", "surface"], "--material", "a=sphere:1", "--repair")
        self.refused(["exclude --expr and --shape"], left, right, "--shape", "sphere:1")

    def test_what_cannot_be_read(self):
        left, right = self.boxes()
        self.refused(["'none.stl'"], left, "none.stl", status=BAD_INPUT)
        self.refused(["formula"], "--material", "a=x+", "--bounds", "0,0,0,1,1,1",
                     status=BAD_INPUT)
        self.refused(["'sphere:-1'"], left, "--material", "a=sphere:-1")

    def test_nothing_is_overwritten_that_is_read(self):
        left, right = self.boxes()
        self.assert_fails(USAGE, ["same file", "'right.stl'"], "mesh", left, right, "-o", right)
        self.assert_fails(USAGE, ["same file"], "mesh", left, right, "-o", "a.vtu", "--json", left)


if __name__ == "__main__":
    unittest.main()
