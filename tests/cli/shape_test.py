"""What `certet mesh --shape` makes."""

import collections
import itertools
import json
import math
import unittest

import vtu
from program import ProgramTest

VOLUMES = {
    "sphere:1.5": 4 / 3 * math.pi * 1.5 ** 3,
    "torus:1,0.4": 2 * math.pi ** 2 * 0.4 ** 2,
    "box:1,2,3": 6,
    "cylinder:0.5,2": math.pi / 2,
    "gyroid:1,0.2": 8 * 0.7227,  # the share of the space, by summation
    "gyroid:1,0.2,1.5": 1.5 ** 3 * 0.7245,
}


class Shapes(ProgramTest):
    def test_volumes(self):
        for shape, volume in VOLUMES.items():
            with self.subTest(shape):
                report = self.mesh("--shape", shape, "--rel-size", "0.02", "-o", "s.vtu")
                self.assertEqual(report["input"], {"kind": "shape", "name": shape, "notes": []})
                self.assertAlmostEqual(report["mesh"]["volume"], volume, delta=0.02 * volume)
                self.assertTrue(report["guarantee"]["holds"])
                self.check("s.vtu")

    def test_lattice_structures(self):
        """What they fill is that part of their box where the function is small, by summation."""
        steps = 48
        angles = [2 * math.pi * (n + 0.5) / steps for n in range(steps)]
        sines, cosines = [math.sin(a) for a in angles], [math.cos(a) for a in angles]
        functions = {
            "primitive": (3 ** 0.5, lambda s, c: c[0] + c[1] + c[2]),
            "diamond": (3 ** 0.5, lambda s, c: (
                s[0] * s[1] * s[2] + s[0] * c[1] * c[2] + c[0] * s[1] * c[2] + c[0] * c[1] * s[2])),
            "iwp": (27 ** 0.5, lambda s, c: (
                2 * (c[0] * c[1] + c[1] * c[2] + c[2] * c[0]) - 2 * sum(v * v for v in c) + 3)),
            "neovius": (7, lambda s, c: 3 * sum(c) + 4 * c[0] * c[1] * c[2])}
        for name, (steepest, function) in functions.items():
            level = 0.1 * math.pi * steepest
            inside = sum(abs(function([sines[n] for n in at], [cosines[n] for n in at])) < level
                         for at in itertools.product(range(steps), repeat=3))
            with self.subTest(name):
                run = self.run_certet("mesh", "--shape", f"{name}:1,0.1", "--size", "0.05", "-o",
                                      "s.vtu", "--json", "s.json")
                self.assertEqual(run.returncode, 0, run.stderr)
                mesh = json.loads((self.folder / "s.json").read_text())["mesh"]
                self.assertAlmostEqual(mesh["volume_fraction"], inside / steps ** 3, delta=0.01)
                self.assertAlmostEqual(mesh["volume_fraction"], mesh["volume"] / 8, places=12)
                self.assertIn(f"fraction   {100 * mesh['volume_fraction']:.2f} %", run.stdout)
        struts = self.mesh("--shape", "struts:2,0.4", "--size", "0.08", "-o", "s.vtu")["mesh"]
        self.assertAlmostEqual(struts["volume_fraction"],
                               3 * math.pi * 0.2 ** 2 - 8 * 2 ** 0.5 * 0.2 ** 3, delta=0.004)
        self.assertNotIn("volume_fraction", self.mesh("--shape", "sphere:1", "-o", "s.vtu")["mesh"])

    def test_edges_are_full_lengths_and_z_is_the_axis(self):
        for shape, sides in (("box:1,2,3", (1, 2, 3)), ("cylinder:0.5,2", (1, 1, 2)),
                             ("torus:1,0.4", (2.8, 2.8, 0.8))):
            with self.subTest(shape):
                self.mesh("--shape", shape, "-o", "s.vtu")
                points = vtu.points(self.folder / "s.vtu")
                for axis, side in enumerate(sides):
                    low = min(p[axis] for p in points)
                    high = max(p[axis] for p in points)
                    self.assertAlmostEqual(low, -side / 2, delta=0.05)
                    self.assertAlmostEqual(high, side / 2, delta=0.05)

    def test_bounds_cut_it_off(self):
        report = self.mesh("--shape", "sphere:1", "--bounds=-9,0,0,9,9,9", "--size", "0.04",
                           "-o", "s.vtu")
        self.assertAlmostEqual(report["mesh"]["volume"], math.pi / 3, delta=0.03)
        report = self.mesh("--shape", "gyroid:1,0.2", "--bounds", "0,0,0,1,2,3", "--size",
                           "0.05", "-o", "s.vtu")
        self.assertAlmostEqual(report["mesh"]["volume"], 6 * 0.7227, delta=0.1)

    def test_torus_is_as_good_as_by_the_published_rule(self):
        """Least angle and distance to the true surface, of the middles of its triangles, with
        the size: those of the rule by which every vertex moves.  With --method embedded the angle
        is at most a degree less, with key up to 1.6, which is what its diagonals cost on smooth
        shapes; they are nearer to the surface and have a lesser greatest angle."""
        for size, least, greatest, rms in ((0.15, 19.250, 157, 3.562e-3),
                                           (0.08, 18.537, 157, 8.907e-4)):
            for method, less, farther in (("embedded", 1, 1.05), ("key", 1.6, 0.99)):
                with self.subTest(f"{method} {size}"):
                    report = self.mesh("--shape", "torus:1,0.4", "--size", size, "--method", method,
                                       "-o", "s.vtu")
                    self.assertGreater(report["dihedral"]["min"], least - less)
                    self.assertLess(report["dihedral"]["max"], greatest)
                    self.assertLess(self.torus_rms("s.vtu"), farther * rms)

    def torus_rms(self, file):
        """Root mean square distance of the middles of a mesh's triangles from the torus."""
        points = vtu.points(self.folder / file)
        sides = collections.Counter(face for tet in vtu.tets(self.folder / file)
                                    for face in itertools.combinations(sorted(tet), 3))
        squares = []
        for face in (face for face, count in sides.items() if count == 1):
            x, y, z = (sum(points[p][a] for p in face) / 3 for a in range(3))
            squares.append((math.hypot(math.hypot(x, y) - 1, z) - 0.4) ** 2)
        return math.sqrt(sum(squares) / len(squares))

    def test_same_as_its_formula(self):
        """The distance and another function of the same sign give nearly the same."""
        size = ("--size", "0.05")
        shape = self.mesh("--shape", "torus:1,0.4", *size, "-o", "s.vtu")
        formula = self.mesh("--expr", "length(length(x,y)-1,z)-0.4", "--bounds",
                            "-1.4,-1.4,-0.4,1.4,1.4,0.4", *size, "-o", "f.vtu")
        self.assertEqual(shape["lattice"], formula["lattice"])
        self.assertAlmostEqual(shape["mesh"]["volume"], formula["mesh"]["volume"], places=3)

    def test_threads(self):
        for threads in (1, 2, 3):
            self.mesh("--shape", "gyroid:1,0.2", "--size", "0.05", "--threads", threads,
                      "-o", f"{threads}.vtu")
        first = (self.folder / "1.vtu").read_bytes()
        self.assertEqual(first, (self.folder / "2.vtu").read_bytes())
        self.assertEqual(first, (self.folder / "3.vtu").read_bytes())


if __name__ == "__main__":
    unittest.main()
