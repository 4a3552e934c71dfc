"""Meshes far from the origin, where numbers are far apart: what a file cannot hold is not
written, and rounding alone is no fault."""

import json
import struct
import unittest

import vtu
from images import IDENTITY, voxels, write_nrrd
from program import ProgramTest

WRITE_FAILED = 6
SIZE = (12, 11, 10)
# A rotation with numbers that are no round ones.
TURNED = ((0.36, 0.48, -0.8), (-0.8, 0.6, 0.0), (0.48, 0.64, 0.6))
# Too far for single precision: the origin, and the size of a voxel.
FAR = ((1e6, 0.01), (1e9, 1), (1, 1e-9), (-1e6, 0.01))


def ball(i, j, k):
    return 5 if (i - 5.6) ** 2 + (j - 5.2) ** 2 + (k - 4.4) ** 2 < 16 else 0


def triangles(path):
    """Of a binary STL: triples of points."""
    data = path.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    return [tuple(struct.unpack_from("<3f", data, 84 + 50 * t + 12 * corner)
                  for corner in (1, 2, 3)) for t in range(count)]


def is_flat(triangle):
    a, b, c = triangle
    u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
    return not any(u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3))


class FarTest(ProgramTest):
    def image(self, origin, voxel, axes=IDENTITY, name="a.nrrd"):
        steps = [[voxel * x for x in axis] for axis in axes]
        write_nrrd(self.folder / name, SIZE, voxels(SIZE, ball), directions=steps,
                   origin=(origin, origin, -origin))


class SinglePrecision(FarTest):
    WORDS = ["cannot write 's.stl'", "single precision", "triangles would be flat or turned",
             ".ply", "--origin 0"]

    def test_a_surface_that_collapses_is_not_written(self):
        for origin, voxel in FAR:
            with self.subTest(origin=origin, voxel=voxel):
                self.image(origin, voxel)
                self.assert_fails(WRITE_FAILED, self.WORDS, "mesh", "a.nrrd", "-o", "s.stl")
                self.mesh("a.nrrd", "-o", "s.ply")
                self.mesh("a.nrrd", "-o", "s.vtu")
                self.assert_fails(WRITE_FAILED, self.WORDS, "convert", "s.vtu", "s.stl")

    def test_near_the_origin_it_is(self):
        for origin, voxel in ((0, 1), (100, 0.5), (0, 1e-30), (0, 1e30), (1000, 1)):
            self.image(origin, voxel)
            report = self.mesh("a.nrrd", "-o", "s.stl")
            self.assertEqual(report["output"]["origin"], [0, 0, 0])
            self.assertFalse(any(map(is_flat, triangles(self.folder / "s.stl"))))

    def test_relative_to_the_lattice(self):
        for origin, voxel in FAR:
            with self.subTest(origin=origin, voxel=voxel):
                self.image(origin, voxel)
                report = self.mesh("a.nrrd", "-o", "s.stl", "--origin", "0")
                self.assertTrue(report["guarantee"]["holds"])
                found = triangles(self.folder / "s.stl")
                self.assertFalse(any(map(is_flat, found)))
                shift = report["output"]["origin"]
                for axis, sign in enumerate((1, 1, -1)):
                    # The solid is within the image, and the origin of the lattice near it.
                    self.assertLess(abs(shift[axis] - sign * origin), 12.001 * voxel)
                    reached = [abs(p[axis]) for triangle in found for p in triangle]
                    self.assertLess(max(reached), 20 * voxel)
                self.mesh("a.nrrd", "-o", "w.vtu")
                self.mesh("a.nrrd", "-o", "o.vtu", "--origin", "0")
                for near, world in zip(vtu.points(self.folder / "o.vtu"),
                                       vtu.points(self.folder / "w.vtu")):
                    for axis in range(3):
                        self.assertAlmostEqual(near[axis] + shift[axis], world[axis],
                                               delta=4e-16 * abs(origin))

    def test_the_table_tells_the_origin(self):
        self.image(1e6, 0.01)
        run = self.run_certet("mesh", "a.nrrd", "-o", "s.stl", "--origin", "0")
        self.assertRegex(run.stdout, r"\norigin +0 in the output is \(1000000(\.\d+)?, ")
        run = self.run_certet("mesh", "a.nrrd", "-o", "s.vtu")
        self.assertNotRegex(run.stdout, r"\norigin ")
        self.assert_fails(2, ["--origin"], "mesh", "a.nrrd", "-o", "s.stl", "--origin", "5")

    def test_convert_moves_exactly(self):
        for origin, voxel in FAR:
            self.image(origin, voxel)
            self.mesh("a.nrrd", "-o", "a.vtu")
            run = self.run_certet("convert", "a.vtu", "b.vtu", "--origin", "0", "--json", "-")
            self.assertEqual(run.returncode, 0, run.stderr)
            shift = json.loads(run.stdout)["output"]["origin"]
            points = vtu.points(self.folder / "b.vtu")
            self.assertEqual([tuple(c + s for c, s in zip(p, shift)) for p in points],
                             [tuple(p) for p in vtu.points(self.folder / "a.vtu")])
            self.assertLess(max(abs(c) for p in points for c in p), 12 * voxel)
            run = self.run_certet("convert", "a.vtu", "s.stl", "--origin", "0")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("origin ", run.stdout)
            self.assertFalse(any(map(is_flat, triangles(self.folder / "s.stl"))))


class Bounds(FarTest):
    """The midpoint method attains its bounds: any rounding crosses them."""

    def judged(self, *arguments):
        report = self.mesh("a.nrrd", "--cuts", "midpoint", "-o", "m.vtu", *arguments)
        (self.folder / "m.json").write_text(json.dumps(report))
        self.assertTrue(report["guarantee"]["holds"])
        angles = report["dihedral"]
        self.assertAlmostEqual(angles["lattice_min"], 30, delta=1e-9)
        self.assertAlmostEqual(angles["lattice_max"], 135, delta=1e-9)
        self.assertLess(abs(angles["min"] - 30), angles["rounding"] + 1e-9)
        self.assertLess(abs(angles["max"] - 135), angles["rounding"] + 1e-9)
        run = self.run_certet("check", "m.vtu", "--run", "m.json", "--min-angle", "30",
                              "--max-angle", "135")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return angles

    def test_rounding_is_no_fault(self):
        crossed = 0
        for axes in (IDENTITY, TURNED):
            for origin, voxel in ((0, 1), (1e6, 0.01), (1e9, 1), (1, 1e-9), (0, 1e-30), (0, 1e30),
                                  (1e-22, 1e-30), (1e38, 1e30)):
                with self.subTest(origin=origin, voxel=voxel, axes=axes):
                    self.image(origin, voxel, axes)
                    crossed += self.judged()["min"] < 30 - 1e-6
        self.assertGreater(crossed, 2, "rounding crossed the bounds nowhere: no test at all")

    def test_what_doubles_cannot_hold_is_not_written(self):
        words = ["cannot write 'm.vtu'", "double precision", "--origin 0"]
        # Origins where the angles keep away from the bounds.
        keep_away = {"paper": (1e12,), "embedded": (1e12, 1)}
        for method in ("midpoint", "paper", "embedded"):
            for origin, voxel in ((1e12, 0.01), (1, 1e-15), (1e16, 1)):
                with self.subTest(origin=origin, voxel=voxel, method=method):
                    if origin in keep_away.get(method, ()):
                        continue
                    self.image(origin, voxel)
                    self.assert_fails(WRITE_FAILED, words, "mesh", "a.nrrd", "--method", method,
                                      "-o", "m.vtu")
                    if method == "midpoint":
                        self.judged("--origin", "0")


if __name__ == "__main__":
    unittest.main()
