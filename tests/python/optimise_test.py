"""Vertices that move for better angles, in Python."""

import copy
import pathlib
import pickle
import tempfile
import unittest

import certet
import numpy as np


def ball(**options):
    return certet.mesh_function(lambda p: np.sqrt((p**2).sum(1)) - 1,
                                ((-1.1,) * 3, (1.1,) * 3), 0.1, **options)


class Optimise(unittest.TestCase):
    def test_angles_grow(self):
        before, after = ball(), ball(optimise=True)
        self.assertIsNone(before.optimised)
        told = after.optimised
        self.assertEqual(told.goal, 25)
        self.assertGreater(told.moved_on_surface, 0)
        self.assertGreater(told.short_before, told.short_after)
        np.testing.assert_array_equal(before.tets, after.tets)
        moved = np.any(before.positions != after.positions, axis=1)
        self.assertEqual(moved.sum(), told.moved)
        old, new = certet.quality(before), certet.quality(after)
        self.assertGreater(new.min_dihedral, old.min_dihedral)
        self.assertLessEqual(new.max_dihedral, old.max_dihedral)
        self.assertTrue(new.holds)

    def test_a_goal_and_threads(self):
        one, two = ball(optimise=20, threads=1), ball(optimise=20, threads=2)
        self.assertEqual(one.optimised.goal, 20)
        self.assertEqual(one.checksum, two.checksum)

    def test_labels(self):
        voxels = np.zeros((14, 12, 10), np.uint8)
        voxels[2:12, 2:10, 2:8] = 1
        voxels[6:9, 4:8, 3:8] = 7
        before, after = certet.mesh_image(voxels), certet.mesh_image(voxels, optimise=True)
        np.testing.assert_array_equal(before.labels, after.labels)
        self.assertGreater(after.optimised.moved, 0)

    def test_copies_and_files(self):
        mesh = ball(optimise=True, order=2, curved=True)
        for other in (copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
            self.assertEqual(other.optimised, mesh.optimised)
            self.assertEqual(other.checksum, mesh.checksum)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.vtu"
            certet.write(mesh, file)
            np.testing.assert_array_equal(certet.read(file).points, mesh.points)

    def test_refused(self):
        for angle in (0, -1, 61, float("nan")):
            with self.assertRaisesRegex(ValueError, "optimise"):
                ball(optimise=angle)
        with self.assertRaisesRegex(ValueError, "middles of edges"):
            ball(optimise=True, method="midpoint")


if __name__ == "__main__":
    unittest.main()
