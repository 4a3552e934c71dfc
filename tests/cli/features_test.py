"""Vertices that move onto sharp edges, by --features."""

import math
import unittest

from program import ProgramTest


def prism(polygon, height):
    """An STL of what is above a polygon around 0, anticlockwise."""
    n = len(polygon)
    points = [(x, y, z) for z in (0, height) for x, y in polygon] + [(0, 0, 0), (0, 0, height)]
    triangles = []
    for i in range(n):
        j = (i + 1) % n
        triangles += [(i, j, j + n), (i, j + n, i + n), (2 * n, j, i), (2 * n + 1, i + n, j + n)]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex %.9g %.9g %.9g\n" % points[p] for p in triangle)
        + "endloop\nendfacet\n" for triangle in triangles)
    return f"solid part\n{facets}endsolid part\n"


def circle(radius, sides):
    return [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides))
            for i in range(sides)]


BOX = prism([(-1, -0.8), (1, -0.8), (1, 0.8), (-1, 0.8)], 1.3)


class Features(ProgramTest):
    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def test_a_box_is_kept_by_itself(self):
        self.write("box.stl", BOX)
        after = self.mesh("box.stl", "--size", "0.17", "-o", "after.vtu")
        told = after["features"]
        self.assertEqual((told["asked"], told["chosen"]), ("auto", 40))
        self.assertIn("drawn", told["why"])
        self.assertEqual((told["corners"], told["kept_corners"]), (8, 8))
        self.assertAlmostEqual(told["length"], 4 * (2 + 1.6 + 1.3), places=5)
        self.assertAlmostEqual(told["followed_percent"], 100)
        self.assertAlmostEqual(told["kept_percent"], 100)
        self.assertLess(told["greatest_distance_edges"], 1e-4)
        self.assertAlmostEqual(after["mesh"]["volume"], 2 * 1.6 * 1.3, delta=1e-4)
        self.assertEqual(after["guarantee"]["angles"], "checked")
        self.assertTrue(after["guarantee"]["holds"])
        self.assertEqual(after["warnings"], [])
        self.assertIn("features", after["seconds"])
        checked = self.check("after.vtu")
        self.assertEqual(checked["mesh"]["checksum"], after["mesh"]["file_checksum"])

        off = self.mesh("box.stl", "--size", "0.17", "-o", "off.vtu", "--features", "off")
        self.assertEqual(off["features"], {"asked": "off", "chosen": "off", "why": "as asked"})
        self.assertNotIn("angles", off["guarantee"])
        self.assertNotIn("features", off["seconds"])
        self.assertLess(off["mesh"]["volume"], 0.995 * 2 * 1.6 * 1.3)
        for key in ("points", "tets", "pieces"):
            self.assertEqual(after["mesh"][key], off["mesh"][key])

    def test_shapes(self):
        for shape, corners in (("box:1,1.2,0.7", 8), ("cylinder:1,1.4", 0)):
            told = self.mesh("--shape", shape, "--size", "0.15", "-o", "a.vtu")["features"]
            self.assertEqual(told["chosen"], 40)
            self.assertEqual(told["kept_corners"], corners)
            self.assertAlmostEqual(told["followed_percent"], 100)
        for shape in ("sphere:1", "torus:1,0.4"):
            report = self.mesh("--shape", shape, "--size", "0.2", "-o", "a.vtu")
            self.assertEqual(report["features"]["chosen"], "off")
            self.assertNotIn("moved", report["features"])

    def test_a_round_thing_has_none(self):
        """A ball of small triangles is no part that somebody drew."""
        self.mesh("--shape", "sphere:1", "--size", "0.1", "-o", "ball.stl")
        report = self.mesh("ball.stl", "--size", "0.2", "-o", "a.vtu")
        self.assertEqual(report["features"]["chosen"], "off")
        self.assertGreater(report["features"]["flat"], 0.5)

    def test_an_angle(self):
        self.write("prism.stl", prism(circle(1, 12), 1))  # 30 degrees between its sides
        by_default = self.mesh("prism.stl", "--size", "0.2", "-o", "a.vtu", "--features", "40")
        all_edges = self.mesh("prism.stl", "--size", "0.2", "-o", "b.vtu", "--features", "25")
        self.assertEqual(by_default["features"]["corners"], 0)
        self.assertEqual(all_edges["features"]["corners"], 24)
        self.assertGreater(all_edges["features"]["length"], by_default["features"]["length"] + 11)
        self.assertEqual(all_edges["features"]["asked"], "25")

    def test_what_is_not_kept_is_warned_of(self):
        """Of a plate's rim the edges are nearer to each other than the lattice's."""
        self.write("plate.stl", prism([(-1, -1), (1, -1), (1, 1), (-1, 1)], 0.04))
        report = self.mesh("plate.stl", "--size", "0.2", "-o", "a.vtu")
        told = report["features"]
        self.assertLess(told["followed_percent"], 100)
        self.assertTrue(any("of the length of the sharp edges" in w for w in report["warnings"]))
        self.assertTrue(report["guarantee"]["holds"])

    def kept(self, *arguments, length, corners):
        """What is told of a solid whose edges have a known length."""
        report = self.mesh(*arguments, "-o", "a.vtu", "--features", "40")
        told = report["features"]
        self.assertEqual((told["chosen"], told["why"]), (40, "as asked"))
        self.assertAlmostEqual(told["length"] / length, 1, delta=2e-3)
        self.assertEqual((told["corners"], told["kept_corners"]), (corners, corners))
        self.assertGreater(told["followed_percent"], 97)
        self.assertEqual(report["guarantee"]["angles"], "checked")
        self.assertTrue(report["guarantee"]["holds"])
        self.check("a.vtu")
        off = self.mesh(*arguments, "-o", "b.vtu")  # auto: nothing is known beforehand
        self.assertEqual(off["features"]["chosen"], "off")
        self.assertNotIn("moved", off["features"])

    def test_a_duct_has_its_rims(self):
        """The box's faces that a formula leaves are openings, flat and round."""
        for formula, length, corners in (("hypot(x,y)-0.25", 0, 0), ("0.25-hypot(x,y)", 12, 8)):
            self.kept(f"--expr={formula}", "--bounds=-0.5,-0.5,-0.5,0.5,0.5,0.5", "--size", "0.0625",
                      length=length + math.pi, corners=corners)
            truth = math.pi / 16 if corners == 0 else 1 - math.pi / 16
            area = {}
            for name, options in (("before", ()), ("after", ("--features", "40"))):
                report = self.mesh(f"--expr={formula}", "--bounds=-0.5,-0.5,-0.5,0.5,0.5,0.5",
                                   "--size", "0.0625", "-o", "c.msh", *options)
                area[name] = [patch["area"] for patch in report["patches"]
                              if patch["name"] == "zmax"][0]
            self.assertLess(abs(area["after"] / truth - 1), 0.006)
            self.assertGreater(abs(area["before"] / truth - 1), 0.02)

    def test_parts_meet_in_edges(self):
        """A box from which a cylinder is taken, what two balls share, and a formula's half spaces."""
        self.kept("--shape", "box:2,2,1", "--subtract", "cylinder:0.5,3", "--size", "0.1",
                  length=4 * (2 + 2 + 1) + 2 * math.pi, corners=8)
        self.kept("--expr=max(abs(x)-0.6,max(abs(y)-0.5,abs(z)-0.4))", "--bounds=-1,-1,-1,1,1,1",
                  "--size", "0.07", length=12, corners=8)
        self.kept("--expr=max(hypot(x-0.3,y,z),hypot(x+0.3,y,z))-0.6", "--bounds=-1,-1,-1,1,1,1",
                  "--size", "0.08", length=2 * math.pi * math.sqrt(0.27), corners=0)

    def test_nothing_is_sharp(self):
        told = self.mesh("--shape", "torus:1,0.4", "--size", "0.2", "-o", "a.vtu", "--features",
                         "30")["features"]
        self.assertEqual((told["length"], told["moved"]), (0, 0))

    def test_the_table_says_what_was_chosen(self):
        self.write("box.stl", BOX)
        run = self.run_certet("mesh", "box.stl", "--size", "0.17", "-o", "a.vtu")
        self.assertRegex(run.stdout, r"(?m)^features +edges of more than 40°, the surface is one that")
        self.assertRegex(run.stdout, r"(?m)^ +vertices on 8 of 8 corners, and along 100.00 % of")
        self.assertRegex(run.stdout, r"(?m)^checked +\d+\.\d+° to")
        run = self.run_certet("mesh", "box.stl", "--size", "0.17", "-o", "a.vtu", "--features", "off")
        self.assertRegex(run.stdout, r"(?m)^features +off: as asked")

    def test_threads_and_formats(self):
        self.write("box.stl", BOX)
        for extension in ("vtu", "msh", "stl"):
            files = [f"{n}.{extension}" for n in (1, 2, 3)]
            for threads, file in zip((1, 2, 4), files):
                self.mesh("box.stl", "--size", "0.2", "-o", file, "--threads", threads)
            one = (self.folder / files[0]).read_bytes()
            for file in files[1:]:
                self.assertEqual((self.folder / file).read_bytes(), one)

    def test_with_others(self):
        """Better angles first, ten nodes after."""
        self.write("box.stl", BOX)
        report = self.mesh("box.stl", "--size", "0.2", "-o", "a.vtu", "--optimise", "--order", "2")
        self.assertAlmostEqual(report["features"]["followed_percent"], 100)
        self.assertIn("optimised", report)
        self.check("a.vtu")

    def test_a_dry_run_moves_nothing(self):
        self.write("box.stl", BOX)
        told = self.mesh("box.stl", "--size", "0.2", "--dry-run")["features"]
        self.assertEqual(told["chosen"], 40)
        self.assertNotIn("moved", told)

    def test_refused(self):
        self.write("box.stl", BOX)
        for angle in ("0", "-3", "0.5", "180", "sharp"):
            self.assert_fails(2, ["--features"], "mesh", "box.stl", "-o", "a.vtu",
                              f"--features={angle}")
        self.assert_fails(2, ["--features", "midpoint"], "mesh", "box.stl", "-o", "a.vtu",
                          "--features", "30", "--method", "midpoint")
        self.assertEqual(self.mesh("box.stl", "--size", "0.2", "-o", "a.vtu", "--method",
                                   "midpoint")["features"]["chosen"], "off")

    def test_memory(self):
        """Where it does not suffice vertices stay, unless they were to move."""
        self.write("box.stl", BOX)
        few = ("box.stl", "--size", "0.02", "-o", "a.vtu", "--max-memory", "60M")
        told = self.mesh(*few)["features"]
        self.assertEqual(told["chosen"], "off")
        self.assertIn("memory", told["why"])
        self.assert_fails(5, ["to keep sharp edges needs"], "mesh", *few, "--features", "40")


if __name__ == "__main__":
    unittest.main()
