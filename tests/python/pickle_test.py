"""Meshes are pickled and copied whole."""

import copy
import pathlib
import pickle
import tempfile
import unittest
import warnings

import certet
import numpy as np


def meshes():
    voxels = np.ones((8, 9, 10), np.int16)
    voxels[4:] = -7
    turned = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    yield certet.mesh_image(voxels, spacing=(1, 2, 3), origin=(5, 6, 7), direction=turned,
                            merge={-7: "marrow"})
    yield certet.mesh_function(lambda p: (p**2).sum(1) - 1, ((-2, -2, 0), (2, 2, 2)), 0.25,
                               method="midpoint")


class Pickled(unittest.TestCase):
    def assert_same(self, one, other):
        for name in ("points", "tets", "labels", "positions", "origin", "axes"):
            if hasattr(one, name):
                np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
        for name in ("names", "size", "method", "notes", "warnings", "checksum"):
            if hasattr(one, name):
                self.assertEqual(getattr(one, name), getattr(other, name))
        self.assertIsNot(one.points, other.points)
        self.assertFalse(np.shares_memory(one.points, other.points))

    def test_meshes(self):
        """Files of a copy have the same bytes: regions, names and patches are kept."""
        for mesh in meshes():
            for again in (pickle.loads(pickle.dumps(mesh)), copy.copy(mesh), copy.deepcopy(mesh)):
                with tempfile.TemporaryDirectory() as folder:
                    files = [pathlib.Path(folder) / name for name in ("a.inp", "b.inp")]
                    certet.write(mesh, files[0])
                    certet.write(again, files[1])
                    self.assertIn(b"zmin", files[0].read_bytes())
                    self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
                if again is not mesh and again._inner is not mesh._inner:
                    self.assert_same(mesh, again)

    def test_meshes_of_files(self):
        warnings.simplefilter("ignore")  # that -7 is no number of a group
        with tempfile.TemporaryDirectory() as folder:
            for mesh in meshes():
                for name in ("a.msh", "a.vtu"):
                    file = pathlib.Path(folder) / name
                    certet.write(mesh, file)
                    read = certet.read(file)
                    again = pickle.loads(pickle.dumps(read))
                    self.assert_same(read, again)
                    certet.write(again, file.with_stem("b"))
                    self.assertEqual(file.with_stem("b").read_bytes(), file.read_bytes())

    def test_damaged(self):
        mesh = next(meshes())
        state = mesh._inner.__getstate__()
        for broken in (state[:-1], ("0 little", *state[1:]), (*state[:1], state[1][:-1], *state[2:])):
            with self.assertRaisesRegex(ValueError, "damaged"):
                type(mesh._inner).__new__(type(mesh._inner)).__setstate__(broken)


if __name__ == "__main__":
    unittest.main()
