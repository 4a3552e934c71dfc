"""The patches of the boundary, as arrays, and names for them."""

import copy
import math
import pathlib
import pickle
import tempfile
import unittest

import certet
import numpy as np


def cut_ball(**options):
    return certet.mesh(lambda p: (p**2).sum(1) - 1, bounds=((-2, -2, -0.5), (2, 2, 2)), size=0.2,
                       **options)


def area(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


class Patches(unittest.TestCase):
    def test_they_are_the_boundary(self):
        mesh = cut_ball()
        patches = mesh.patches()
        self.assertEqual([p.name for p in patches], ["surface", "zmin"])
        self.assertEqual([p.name for p in certet.patches(mesh)], ["surface", "zmin"])
        for patch in patches:
            self.assertEqual(patch.triangles.dtype, np.uint64)
            self.assertAlmostEqual(patch.area, area(mesh.points, patch.triangles), places=9)
        # Without the triangles along the rim, which have a corner on the ball.
        disk = 0.75 * math.pi
        self.assertLess(patches[1].area, disk)
        self.assertGreater(patches[1].area, disk - 0.2 * 2 * math.pi * math.sqrt(0.75))
        self.assertLess(np.abs(mesh.points[patches[1].triangles][:, :, 2] + 0.5).max(), 1e-4)
        # All together they are closed, and look outwards: the volume is that of the mesh.
        corners = mesh.points[np.concatenate([p.triangles for p in patches])]
        volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
        self.assertAlmostEqual(volume, mesh.quality().volume, places=9)

    def test_arrays_outlive_the_mesh(self):
        mesh = cut_ball()
        kept = mesh.patches()[1].triangles
        again = kept.copy()
        del mesh
        np.testing.assert_array_equal(kept, again)

    def test_names(self):
        mesh = cut_ball()
        before = {p.name: p.triangles for p in mesh.patches()}
        mesh.name_patches({"floor": "zmin", "wall": "surface", "top": ("z", 1)})
        named = {p.name: p.triangles for p in mesh.patches()}
        self.assertEqual(list(named), ["floor", "wall", "top"])
        np.testing.assert_array_equal(named["floor"], before["zmin"])
        self.assertTrue((np.abs(mesh.points[named["top"]][:, :, 2] - 1) <= 0.1).all())
        self.assertEqual(len(named["wall"]) + len(named["top"]), len(before["surface"]))
        for other in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh)):
            self.assertEqual([p.name for p in other.patches()], list(named))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.msh"
            certet.write(mesh, file)
            back = certet.read(file)
            for mesh_of_file in (back, pickle.loads(pickle.dumps(back))):
                self.assertEqual({p.name for p in mesh_of_file.patches()}, set(named))
                for patch in mesh_of_file.patches():
                    np.testing.assert_array_equal(patch.triangles, named[patch.name])

    def test_what_is_refused_changes_nothing(self):
        mesh = cut_ball()
        for where, words in (({"a": "zmin", "b": "xmax"}, "no patch 'xmax'"),
                             ({"a": ("z", 3)}, "z:3"), ({"a": ("w", 3)}, "w:3"),
                             ({"1": "zmin"}, "letter"), ({"a": 5}, "an axis and a coordinate"),
                             ({"a": ("z", math.nan)}, "finite"), (["a"], "dict"),
                             ({"surface": "zmin"}, "surface")):
            with self.assertRaisesRegex(ValueError, words):
                mesh.name_patches(where)
            self.assertEqual([p.name for p in mesh.patches()], ["surface", "zmin"])

    def test_all_sides_of_an_image(self):
        mesh = certet.mesh(np.ones((6, 7, 8), np.uint8), spacing=(1, 2, 3))
        self.assertEqual([p.name for p in mesh.patches() if p.name != "surface"],
                         ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"])


if __name__ == "__main__":
    unittest.main()
