"""Tetrahedra of ten nodes in Python: arrays, files, copies, and what is refused."""

import copy
import math
import pathlib
import pickle
import tempfile
import unittest

import certet
import numpy as np
from read_back import read_back

EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))


def ball(**options):
    return certet.mesh_function(lambda p: np.sqrt((p**2).sum(1)) - 1,
                                ((-1.1,) * 3, (1.1,) * 3), 0.3, **options)


def ends(mesh, edge):
    i, j = EDGES[edge]
    return mesh.points[mesh.tets[:, i]], mesh.points[mesh.tets[:, j]]


class Order(unittest.TestCase):
    def test_straight(self):
        linear, mesh = ball(), ball(order=2)
        self.assertEqual((linear.order, mesh.order), (1, 2))
        self.assertIsNone(linear.middles)
        self.assertIsNone(linear.middle_points)
        self.assertIsNone(mesh.curve)
        np.testing.assert_array_equal(linear.points, mesh.points)
        self.assertEqual(linear.checksum, mesh.checksum)
        for e in range(6):
            a, b = ends(mesh, e)
            np.testing.assert_allclose(mesh.middle_points[mesh.middles[:, e]], (a + b) / 2,
                                       atol=1e-14)
        self.assertEqual(len(np.unique(mesh.middles)), len(mesh.middle_points))

    def test_curved(self):
        mesh = ball(order=2, curved=True)
        told = mesh.curve
        self.assertGreater(told.moved, 0)
        self.assertGreaterEqual(told.least_jacobian, 0.25)
        radii = []
        for e in range(6):
            a, b = ends(mesh, e)
            nodes = mesh.middle_points[mesh.middles[:, e]]
            radii.extend(np.linalg.norm(nodes[np.abs(nodes - (a + b) / 2).max(1) > 1e-9], axis=1))
        np.testing.assert_allclose(radii, 1, atol=1e-5)

    def test_solids(self):
        """Alone, and several; the weaker one's surfaces as well as the stronger one's."""
        one = certet.mesh(certet.Solid("sphere:1"), size=0.3, order=2, curved=True)
        self.assertEqual(one.curve.moved + one.curve.on_surface, one.curve.edges)
        solids = {"ball": "sphere:1", "rod": "cylinder:0.5,3"}
        for options in ({}, {"priority": ["ball"]}):
            several = certet.mesh(solids, size=0.15, order=2, curved=True, **options)
            self.assertLess(several.curve.far, several.curve.moved / 10)

    def test_files(self):
        mesh = ball(order=2, curved=True)
        for read in read_back(self, mesh, ("a.vtu", "a.msh", "a.mesh", "a.meshb")):
            np.testing.assert_array_equal(read.points, mesh.points)
            np.testing.assert_array_equal(read.middle_points, mesh.middle_points)
            np.testing.assert_array_equal(read.middles, mesh.middles)
            self.assertEqual(certet.check(read).failures, [])
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(ValueError, "ten nodes"):
                certet.write(mesh, pathlib.Path(folder) / "a.stl")

    def test_copies(self):
        for options in ({"order": 2}, {"order": 2, "curved": True}):
            mesh = ball(**options)
            for other in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh)):
                np.testing.assert_array_equal(other.middle_points, mesh.middle_points)
                np.testing.assert_array_equal(other.middles, mesh.middles)
                self.assertEqual(other.curve, mesh.curve)

    def test_refusals(self):
        for options in ({"order": 3}, {"curved": True},
                        {"order": 2, "curved": True, "method": "midpoint"}):
            with self.assertRaises(ValueError):
                ball(**options)

    def test_meshio(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("meshio was not found")
        mesh = ball(order=2)
        block = mesh.to_meshio().cells[0]
        self.assertEqual(block.type, "tetra10")
        self.assertEqual(block.data.shape, (len(mesh.tets), 10))

    def test_volume(self):
        """The doorstep's own words: nearer by an order, by a sum of its own."""
        corners = ball(order=2)
        p = corners.points[corners.tets]
        straight = np.linalg.det(p[:, 1:] - p[:, :1]).sum() / 6
        self.assertLess(straight, 4 / 3 * math.pi)


if __name__ == "__main__":
    unittest.main()
