"""Meshes as voxels."""

import tempfile
import unittest
import warnings
from pathlib import Path

import certet
import numpy as np


def two_balls():
    points = np.moveaxis(np.indices((24, 22, 20)), 0, -1)
    labels = np.zeros(points.shape[:3], np.uint8)
    labels[((points - (9, 10, 10)) ** 2).sum(-1) < 49] = 4
    labels[((points - (15, 11, 9)) ** 2).sum(-1) < 36] = 9
    return labels


def dice(a, b):
    return 2 * (a & b).sum() / (a.sum() + b.sum())


class Voxelise(unittest.TestCase):
    place = {"spacing": (2, 1.5, 1), "origin": (7, -8, 9),
             "direction": ((0, -1, 0), (1, 0, 0), (0, 0, 1))}

    def test_labels_come_back(self):
        labels = two_balls()
        mesh = certet.mesh(labels, **self.place)
        made = certet.voxelise(mesh, like=labels, **self.place)
        self.assertEqual((made.shape, made.dtype), (labels.shape, np.int32))
        self.assertEqual(set(np.unique(made)), {0, 4, 9})
        for label in (4, 9):
            self.assertGreater(dice(made == label, labels == label), 0.98)
        moved = {**self.place, "origin": (70, -8, 9)}
        with self.assertWarnsRegex(UserWarning, "no voxel has its centre in the mesh"):
            self.assertEqual(certet.voxelise(mesh, like=labels, **moved).max(), 0)

    def test_from_a_file_is_the_same(self):
        mesh = certet.mesh(two_balls())
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.vtu"
            certet.write(mesh, file)
            read = certet.read(file)
        shape = {"shape": (48, 44, 40), "spacing": 0.5}
        np.testing.assert_array_equal(certet.voxelise(mesh, **shape), certet.voxelise(read, **shape))

    def test_a_ball(self):
        mesh = certet.mesh(lambda p: (p**2).sum(1) - 1, bounds=((-1.1,) * 3, (1.1,) * 3), size=0.1)
        made = certet.voxelise(mesh, shape=(50, 50, 50), spacing=0.05, origin=(-1.225,) * 3)
        radius = np.sqrt(((np.indices(made.shape) * 0.05 - 1.225) ** 2).sum(0))
        self.assertTrue((made[radius < 0.98] == 1).all())
        self.assertTrue((made[radius > 1.02] == 0).all())

    def test_what_is_refused(self):
        mesh = certet.mesh(two_balls())
        for words, options in (("either like", {}), ("either like", {"like": two_balls(), "shape": (1, 1, 1)}),
                               ("three whole", {"shape": 3}), ("three whole", {"like": np.zeros((3, 3))}),
                               ("positive", {"shape": (3, 0, 3)}), ("whole number", {"shape": (1, 1.5, 1)}),
                               ("spacing", {"shape": (1, 1, 1), "spacing": 0}),
                               ("three numbers", {"shape": (1, 1, 1), "origin": (1, 2)})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                certet.voxelise(mesh, **options)
        with self.assertRaisesRegex(ValueError, "certet.Mesh"):
            certet.voxelise(two_balls(), shape=(1, 1, 1))
        with self.assertRaises(MemoryError):
            certet.voxelise(mesh, shape=(1, 2**19, 1))

    def test_nothing_is_said_of_a_good_mesh(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            certet.voxelise(certet.mesh(two_balls()), shape=(24, 22, 20))


if __name__ == "__main__":
    unittest.main()
