"""Vertices that move onto sharp edges, in Python."""

import copy
import pickle
import unittest

import certet
import numpy as np

CORNERS = np.array([(x, y, z) for x in (0, 1.3) for y in (0, 1) for z in (0, 0.8)])
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))]


def box(**options):
    return certet.mesh_surface(CORNERS, TRIANGLES, size=0.13, **options)


class Features(unittest.TestCase):
    def test_a_box_is_kept_by_itself(self):
        before, after = box(features="off"), box()
        self.assertIsNone(before.features.angle)
        told = after.features
        self.assertEqual(told.angle, 40)
        self.assertEqual((told.corners, told.kept_corners), (8, 8))
        self.assertAlmostEqual(told.length, 4 * (1.3 + 1 + 0.8), places=5)
        self.assertAlmostEqual(told.followed_percent, 100)
        np.testing.assert_array_equal(before.tets, after.tets)
        moved = np.any(before.positions != after.positions, axis=1)
        self.assertEqual(moved.sum(), told.moved)
        for corner in CORNERS:
            self.assertLess(np.abs(after.points - corner).max(1).min(), 1e-4)
        quality = certet.quality(after)
        self.assertTrue(quality.holds)
        self.assertAlmostEqual(quality.volume, 1.3 * 0.8, places=4)
        self.assertEqual(after.warnings, [])

    def test_an_angle_and_threads(self):
        self.assertIsNotNone(box(features=91).features.angle)
        self.assertEqual(box(features=91).features.length, 0)
        self.assertEqual(box(features=30, threads=1).checksum, box(features=30, threads=2).checksum)

    def test_others_have_none(self):
        ball = certet.mesh_function(lambda p: (p**2).sum(1) - 1, ((-1.1,) * 3, (1.1,) * 3), 0.2)
        self.assertIsNone(ball.features.angle)
        self.assertIn("no sharp edges are known", ball.features.why)

    def test_parts_meet_in_edges(self):
        """Half a ball, cut off by a plane, and by its bounds."""
        def half(p):
            return np.maximum(np.sqrt((p**2).sum(1)) - 1, p[:, 2])

        for function, bounds in ((half, ((-1.1,) * 3, (1.1,) * 3)),
                                 (lambda p: np.sqrt((p**2).sum(1)) - 1,
                                  ((-1.1, -1.1, -1.1), (1.1, 1.1, 0)))):
            mesh = certet.mesh_function(function, bounds, 0.13, features=40)
            self.assertAlmostEqual(mesh.features.length / (2 * np.pi), 1, delta=1e-3)
            self.assertGreater(mesh.features.followed_percent, 98)
            self.assertEqual(mesh.features.corners, 0)
            self.assertTrue(certet.quality(mesh).holds)
            flat = mesh.points[np.abs(mesh.points[:, 2]) < 1e-5]
            self.assertAlmostEqual(np.hypot(*flat[:, :2].T).max(), 1, delta=1e-4)

    def test_copies(self):
        mesh = box()
        for other in (copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
            self.assertEqual(other.features, mesh.features)
            self.assertEqual(other.checksum, mesh.checksum)

    def test_refused(self):
        for angle in (0, 180, float("nan"), "sharp", None, True):
            with self.assertRaisesRegex(ValueError, "features"):
                box(features=angle)


if __name__ == "__main__":
    unittest.main()
