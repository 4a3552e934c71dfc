"""How far meshes are from their shapes, as the program tells it."""

import json
import math
import unittest

import surfaces
from images import voxels, write_nrrd
from program import TORUS, ProgramTest
from surface_program import SurfaceProgramTest


class Distances(ProgramTest):
    def test_of_a_ball(self):
        """In the table and in the JSON; the other keys and the mesh are as without it."""
        ball = ["--shape", "sphere:1", "--size", "0.1", "-o", "ball.vtu"]
        plain = self.mesh(*ball)
        report = self.mesh(*ball, "--distance")
        self.assertEqual(report["mesh"]["checksum"], plain["mesh"]["checksum"])
        self.assertNotIn("distance", plain)
        self.assertNotIn("distance", plain["seconds"])
        self.assertIn("distance", report["seconds"])
        distance = report["distance"]
        self.assertEqual(distance["edge"], 0.1)
        self.assertFalse(distance["exact"])
        for way in ("to_shape", "to_mesh"):
            one = distance[way]
            self.assertLess(0, one["rms"])
            self.assertLess(one["rms"], one["greatest"])
            self.assertLess(one["greatest"], 0.004)
            self.assertAlmostEqual(one["greatest_edges"], one["greatest"] / 0.1)
            self.assertAlmostEqual(one["rms_edges"], one["rms"] / 0.1)
            self.assertAlmostEqual(math.hypot(*one["at"]), 1, delta=0.005)
        self.assertAlmostEqual(abs(math.hypot(*distance["to_shape"]["at"]) - 1),
                               distance["to_shape"]["greatest"], delta=1e-4)
        run = self.run_certet("mesh", *ball, "--distance")
        self.assertRegex(run.stdout, r"distance   mesh to shape: greatest 0\.0\d+ edges \(0\.00\d+\) at ")
        self.assertRegex(run.stdout, r"           shape to mesh: greatest ")

    def test_the_same_for_any_number_of_threads_and_without_an_output(self):
        found = [self.mesh(*TORUS, "--size", "0.1", "--distance", *more)["distance"]
                 for more in (["--threads", "1", "-o", "a.vtu"], ["--threads", "3", "-o", "a.vtu"],
                              ["--dry-run"])]
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])
        self.assertEqual(found[0]["against"], "where the formula changes its sign")

    def test_places_are_those_of_the_output(self):
        plain = self.mesh(*TORUS, "--size", "0.1", "--distance", "-o", "a.vtu")["distance"]
        scaled = self.mesh(*TORUS, "--size", "0.1", "--distance", "--scale", "1000", "-o", "b.vtu")["distance"]
        self.assertEqual(plain["to_shape"]["greatest"], scaled["to_shape"]["greatest"])
        for a, b in zip(plain["to_shape"]["at"], scaled["to_shape"]["at"]):
            self.assertAlmostEqual(1000 * a, b, places=6)

    def test_labels(self):
        """Smooth or not, the mesh is near to what was meshed, inner walls too."""
        def label(*voxel):
            radius = math.dist(voxel, (11.5, 11.5, 11.5))
            return (radius < 9) + (radius < 5)
        size = (24, 24, 24)
        write_nrrd(self.folder / "labels.nrrd", size, voxels(size, label))
        for more, surface in ((["--smooth", "0"], "the faces of voxels"),
                              ([], "where the greatest of the labels' smooth fields changes")):
            with self.subTest(more):
                distance = self.mesh("labels.nrrd", "-o", "l.vtu", "--distance", *more)["distance"]
                self.assertEqual(distance["against"], surface)
                self.assertLess(distance["to_shape"]["greatest"], 0.5)
                self.assertLess(distance["to_mesh"]["greatest"], 0.9)
        found = self.against("l.vtu", "labels.nrrd")
        self.assertLess(found["to_shape"]["greatest"], 0.5)
        # Against one label alone the inner wall is near, and the outer one is not.
        self.assertGreater(self.against("l.vtu", "labels.nrrd@labels=2")["to_shape"]["greatest"], 3)

    def against(self, file, shape, *more):
        run = self.run_certet("check", file, "--against", shape, "--json", "-", *more)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)["distance"]

    def test_check_finds_a_shift(self):
        """Planted: the mesh is that of a ball elsewhere."""
        self.mesh("--shape", "sphere:1", "--size", "0.1", "-o", "ball.vtu")
        ball = "x^2 + y^2 + z^2 - 1"
        self.assertLess(self.against("ball.vtu", ball)["to_shape"]["greatest"], 0.004)
        self.assertLess(self.against("ball.vtu", "sphere:1")["to_mesh"]["greatest"], 0.004)
        for way in ("to_shape", "to_mesh"):
            shifted = self.against("ball.vtu", "(x - 0.2)^2 + y^2 + z^2 - 1")[way]
            self.assertAlmostEqual(shifted["greatest"], 0.2, delta=0.005)
            self.assertAlmostEqual(abs(shifted["at"][0]), 1, delta=0.35)

    def test_check_knows_the_edge_of_a_run(self):
        self.mesh("--shape", "sphere:1", "--size", "0.125", "-o", "ball.vtu", "--distance")
        run = self.run_certet("mesh", "--shape", "sphere:1", "--size", "0.125", "-o", "ball.vtu",
                              "--distance", "--json", "run.json")
        self.assertEqual(run.returncode, 0, run.stderr)
        told = json.loads((self.folder / "run.json").read_text())["distance"]
        again = self.against("ball.vtu", "sphere:1", "--run", "run.json")
        self.assertEqual(again["edge"], 0.125)
        for way in ("to_shape", "to_mesh"):
            self.assertAlmostEqual(again[way]["greatest"], told[way]["greatest"], places=5)
            self.assertEqual(again[way]["points"], told[way]["points"])

    def test_report(self):
        self.run_certet("mesh", "--shape", "sphere:1", "--size", "0.2", "-o", "ball.vtu", "--json", "plain.json")
        self.run_certet("mesh", "--shape", "sphere:1", "--size", "0.2", "-o", "ball.vtu", "--distance",
                        "--json", "run.json")
        pages = {}
        for name, more in (("run", ["--run", "run.json"]), ("against", ["--against", "sphere:1"]),
                           ("plain", ["--run", "plain.json"])):
            run = self.run_certet("report", "ball.vtu", "-o", f"{name}.html", *more)
            self.assertEqual(run.returncode, 0, run.stderr)
            pages[name] = (self.folder / f"{name}.html").read_text()
        for name in ("run", "against"):
            self.assertRegex(pages[name], r"mesh to shape.*greatest 0\.\d+ edges")
            self.assertIn("shape to mesh", pages[name])
        self.assertNotIn("mesh to shape", pages["plain"])

    def test_what_cannot_be(self):
        self.mesh("--shape", "sphere:1", "--size", "0.2", "-o", "ball.vtu")
        self.assert_fails(3, ["nothing.stl"], "check", "ball.vtu", "--against", "nothing.stl")
        self.assert_fails(2, ["sphere"], "check", "ball.vtu", "--against", "sphere:-1")
        self.assert_fails(4, ["no surface"], "check", "ball.vtu", "--against", "x^2 + 1")


class DistancesOfSurfaces(SurfaceProgramTest):
    def test_are_exact(self):
        (self.folder / "cube.stl").write_bytes(surfaces.stl(surfaces.cube()))
        distance = self.mesh("cube.stl", "--size", "0.07", "-o", "c.vtu", "--distance",
                             "--features", "off")["distance"]
        self.assertTrue(distance["exact"])
        self.assertEqual(distance["against"], "its triangles, exactly")
        # A corner of the cube is cut off, which the shape sees best.
        at = distance["to_mesh"]["at"]
        for c in at:
            self.assertTrue(min(abs(c), abs(c - 1)) < 0.05, at)
        run = self.run_certet("check", "c.vtu", "--against", "cube.stl", "--json", "-")
        again = json.loads(run.stdout)["distance"]
        self.assertTrue(again["exact"])
        self.assertAlmostEqual(again["to_mesh"]["greatest"], distance["to_mesh"]["greatest"], places=4)
        self.assertAlmostEqual(again["to_shape"]["greatest"], distance["to_shape"]["greatest"], places=4)

    def test_sharp_edges_leave_nothing(self):
        (self.folder / "cube.stl").write_bytes(surfaces.stl(surfaces.cube()))
        distance = self.mesh("cube.stl", "--size", "0.07", "-o", "c.vtu", "--distance")["distance"]
        for way in ("to_shape", "to_mesh"):
            self.assertLess(distance[way]["greatest_edges"], 1e-4)

    def test_one_that_is_elsewhere(self):
        """Planted: the mesh is of a cube that is longer by a quarter."""
        (self.folder / "cube.stl").write_bytes(surfaces.stl(surfaces.cube()))
        (self.folder / "long.stl").write_bytes(surfaces.stl(surfaces.cube(high=(1.25, 1, 1))))
        self.mesh("long.stl", "--size", "0.0625", "-o", "l.vtu")
        run = self.run_certet("check", "l.vtu", "--against", "cube.stl", "--json", "-")
        found = json.loads(run.stdout)["distance"]
        self.assertAlmostEqual(found["to_shape"]["greatest"], 0.25, delta=0.01)
        self.assertAlmostEqual(found["to_mesh"]["greatest"], 0.25, delta=0.04)


if __name__ == "__main__":
    unittest.main()
