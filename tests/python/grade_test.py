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

    def test_sizes_by_formula_function_and_image(self):
        formula = ball(size_field="0.311 + 0.17*x")
        self.assertEqual(certet.check(formula).failures, [])
        self.assertGreater(len(formula.tets), len(ball(grade=3).tets))
        self.assertLess(len(formula.tets), len(ball().tets))
        seen = []

        def sizes(points):
            seen.append(points)
            return 0.311 + 0.17 * points[:, 0]

        self.assertEqual(ball(size_field=sizes).checksum, formula.checksum)
        self.assertLess(np.linalg.norm(np.concatenate(seen), axis=1).max(), 1)
        x = np.linspace(-1.2, 1.2, 5)
        image = np.broadcast_to((0.311 + 0.17 * x)[:, None, None], (5, 5, 5)).copy()
        mesh = ball(size_field=(image, 0.6, (-1.2,) * 3))
        self.assertEqual(mesh.checksum, formula.checksum)
        turned = (image.transpose(1, 0, 2), 0.6, (-1.2,) * 3, [[0, 1, 0], [1, 0, 0], [0, 0, 1]])
        self.assertEqual(ball(size_field=turned).checksum, formula.checksum)
        self.assertEqual(ball(size_field="9", grade=2).checksum, ball(grade=2).checksum)

    def test_sizes_that_are_refused(self):
        image = np.full((3, 3, 3), 0.2)
        for field, words in (("-1", "is -1 at"), (lambda p: np.zeros(len(p)), "function, is 0 at"),
                             (lambda p: p, "numbers for"), ((image, 0.1, (0, 0, 0)), "does not cover"),
                             (image, "size_field is"), (0.2, "size_field is"), ("x +", "formula")):
            with self.assertRaisesRegex(ValueError, words):
                ball(size_field=field)
        with self.assertRaises(ZeroDivisionError):
            ball(size_field=lambda points: 1 / 0)

    def test_what_is_refused(self):
        for options in ({"size_field": "1", "optimise": True}, {"grade": 4}, {"grade": -1}, {"grade": 1, "optimise": True},
                        {"grade": 1, "features": 30}):
            with self.assertRaises(ValueError):
                ball(**options)


if __name__ == "__main__":
    unittest.main()
