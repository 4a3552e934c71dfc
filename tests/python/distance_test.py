"""How far meshes are from solids, measured from Python."""

import pathlib
import tempfile
import unittest

import certet
import numpy as np


def cube(low, high):
    """A closed surface: points and triangles."""
    points = np.array([[high[a] if corner >> a & 1 else low[a] for a in range(3)]
                       for corner in range(8)], float)
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def ball(points):
    return np.linalg.norm(points, axis=1) - 1


BOX = ((-1.2, -1.2, -1.2), (1.2, 1.2, 1.2))


class Distances(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = certet.mesh(certet.Solid("sphere:1"), size=0.1)

    def test_of_a_ball(self):
        found = certet.distance(self.mesh, "sphere:1")
        self.assertEqual(found.edge, 0.1)
        self.assertFalse(found.exact)
        for one in (found.to_shape, found.to_mesh):
            self.assertLess(0, one.rms)
            self.assertLess(one.rms, one.greatest)
            self.assertLess(one.greatest, 0.004)
            self.assertEqual(one.at.shape, (3,))
            self.assertAlmostEqual(np.linalg.norm(one.at), 1, delta=0.005)
            self.assertGreater(one.points, 1000)

    def test_of_a_function_and_threads(self):
        """However the solid is told, and whatever the threads, the figures are alike."""
        by_function = certet.distance(self.mesh, ball, bounds=BOX, threads=1)
        by_solid = certet.distance(self.mesh, certet.Solid(ball, bounds=BOX), threads=3)
        np.testing.assert_array_equal(by_function.to_shape.at, by_solid.to_shape.at)
        self.assertEqual(by_function.to_shape.greatest, by_solid.to_shape.greatest)
        self.assertEqual(by_function.to_mesh[:2], by_solid.to_mesh[:2])
        named = certet.distance(self.mesh, "sphere:1")
        self.assertAlmostEqual(named.to_shape.greatest, by_function.to_shape.greatest, delta=1e-5)

    def test_a_shift(self):
        """Planted: the shape is elsewhere."""
        found = certet.distance(self.mesh, lambda p: ball(p - (0.15, 0, 0)),
                                bounds=(BOX[0], (1.5, 1.2, 1.2)))
        self.assertAlmostEqual(found.to_shape.greatest, 0.15, delta=0.005)
        self.assertAlmostEqual(found.to_mesh.greatest, 0.15, delta=0.005)

    def test_of_a_surface(self):
        mesh = certet.mesh(cube((0, 0, 0), (1, 1, 1)), size=0.07)
        found = certet.distance(mesh, cube((0, 0, 0), (1, 1, 1)))
        self.assertTrue(found.exact)
        self.assertLess(found.to_shape.greatest, 0.035)
        longer = certet.distance(mesh, cube((0, 0, 0), (1.25, 1, 1)))
        self.assertAlmostEqual(longer.to_mesh.greatest, 0.25, delta=0.04)

    def test_of_labels(self):
        """Planted: a wall within that the mesh has elsewhere."""
        x, y, z = np.indices((24, 24, 24)) - 11.5
        radius = np.sqrt(x * x + y * y + z * z)
        labels = (radius < 9) * (1 + (radius < 5)).astype(np.int32)
        other = (radius < 9) * (1 + (radius < 3)).astype(np.int32)
        mesh = certet.mesh(labels)
        self.assertLess(certet.distance(mesh, labels).to_shape.greatest, 0.5)
        self.assertAlmostEqual(certet.distance(mesh, other).to_shape.greatest, 2, delta=0.6)
        # One label's surface is the outer one alone.
        self.assertLess(certet.distance(mesh, labels > 0).to_mesh.greatest, 0.9)

    def test_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "ball.vtu"
            certet.write(self.mesh, file)
            read = certet.distance(certet.read(file), "sphere:1")
        self.assertNotEqual(read.edge, 0.1)  # which a file does not tell
        self.assertAlmostEqual(read.to_shape.greatest,
                               certet.distance(self.mesh, "sphere:1").to_shape.greatest, delta=1e-5)

    def test_what_cannot_be(self):
        for wrong in (lambda: certet.distance(self.mesh, lambda p: np.ones(len(p)), bounds=BOX),
                      lambda: certet.distance("mesh", "sphere:1"),
                      lambda: certet.distance(self.mesh, certet.Solid("sphere:1"), bounds=BOX)):
            with self.assertRaises(ValueError):
                wrong()


if __name__ == "__main__":
    unittest.main()
