"""Graded interiors, in Python."""

import unittest

import certet
import numpy as np


def ball(**options):
    return certet.mesh_function(lambda p: np.sqrt((p**2).sum(1)) - 1,
                                ((-1.1,) * 3, (1.1,) * 3), 0.08, **options)


class Grade(unittest.TestCase):
    def test_fewer_tetrahedra_of_the_same_volume(self):
        before = ball()
        volume = certet.quality(before).volume
        last = len(before.tets)
        for levels in (1, 2, 3):
            after = ball(grade=levels)
            self.assertLessEqual(len(after.tets), last)
            last = len(after.tets)
            self.assertAlmostEqual(certet.quality(after).volume, volume, delta=1e-12)
            self.assertEqual(certet.check(after).failures, [])
            self.assertTrue(certet.quality(after).holds)
        self.assertEqual(ball(grade=0).checksum, before.checksum)

    def test_labels(self):
        voxels = np.ones((40, 36, 36), np.uint8)
        voxels[20:] = 2
        before = certet.mesh_image(voxels)
        after = certet.mesh_image(voxels, grade=2)
        self.assertLess(len(after.tets), len(before.tets))
        self.assertEqual(set(np.unique(after.labels)), {1, 2})
        self.assertEqual(certet.check(after).failures, [])

    def test_what_is_refused(self):
        for options in ({"grade": 4}, {"grade": -1}, {"grade": 1, "optimise": True},
                        {"grade": 1, "features": 30}):
            with self.assertRaises(ValueError):
                ball(**options)


if __name__ == "__main__":
    unittest.main()
