"""Segmentations as 3D Slicer has them, without Slicer: axes k, j, i and a matrix to RAS."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import certet
import numpy as np
from certet.slicer import mesh_segments, surface, unstructured_grid

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonMath import vtkMatrix4x4
    from vtkmodules.vtkFiltersCore import vtkMassProperties
    from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
except ImportError:
    vtk_to_numpy = None

# Of a scan as Slicer loads it: i to the left, j to the back, k up, oblique, not isotropic.
TURN = 0.3
MATRIX = np.array([[-0.8 * np.cos(TURN), 1.1 * np.sin(TURN), 0, 40],
                   [-0.8 * np.sin(TURN), -1.1 * np.cos(TURN), 0, -30],
                   [0, 0, 1.5, 700],
                   [0, 0, 0, 1]])
NAMES = ["bone", "marrow"]


def segments():
    """Two boxes of different sizes, none of them alike along two axes; shape (nk, nj, ni)."""
    labels = np.zeros((10, 14, 18), np.uint8)
    labels[2:8, 3:11, 2:9] = 1
    labels[2:6, 3:9, 9:15] = 2
    return labels


def centres(labels, label):
    """The mean of a segment's voxels, in RAS, by Slicer's own convention."""
    k, j, i = np.nonzero(labels == label)
    return (MATRIX @ [i.mean(), j.mean(), k.mean(), 1])[:3]


def volume(mesh, label):
    p = mesh.points[mesh.tets[mesh.labels == label]]
    return np.linalg.det(p[:, 1:] - p[:, :1]).sum() / 6


def centroid(mesh, label):
    p = mesh.points[mesh.tets[mesh.labels == label]]
    weights = np.linalg.det(p[:, 1:] - p[:, :1])
    return (p.mean(1) * weights[:, None]).sum(0) / weights.sum()


class Segments(unittest.TestCase):
    def assert_in_place(self, mesh, labels):
        """A hundredth of a voxel is what smooth corners move of a centroid; another order of axes
        moves it by voxels."""
        for label in (1, 2):
            np.testing.assert_allclose(centroid(mesh, label), centres(labels, label), atol=0.2)
            voxel = abs(np.linalg.det(MATRIX[:3, :3]))
            self.assertAlmostEqual(volume(mesh, label) / voxel / (labels == label).sum(), 1,
                                   delta=0.05)

    def test_points_are_where_slicer_has_them(self):
        labels = segments()
        mesh = mesh_segments(labels, MATRIX, NAMES)
        self.assert_in_place(mesh, labels)
        self.assertEqual(set(mesh.labels), {1, 2})
        self.assertEqual(mesh.names, {1: "bone", 2: "marrow"})
        self.assertEqual(certet.check(mesh).failures, [])

    def test_planted_axes_and_signs_are_noticed(self):
        """The axes the other way round, and LPS for RAS."""
        labels = segments()
        lps = np.diag([-1, -1, 1, 1]) @ MATRIX
        for array, matrix in ((labels.transpose(), MATRIX), (labels, lps), (labels, MATRIX.T)):
            with self.assertRaises((AssertionError, ValueError)):
                self.assert_in_place(mesh_segments(array, matrix), labels)

    def test_names_by_label(self):
        mesh = mesh_segments(segments(), names={2: "marrow"})
        self.assertEqual(mesh.names.get(2), "marrow")
        self.assertNotIn(1, mesh.names)

    def test_segments_without_voxels(self):
        """They have names and no region."""
        mesh = mesh_segments(segments(), MATRIX, [*NAMES, "nail"])
        self.assertEqual((set(mesh.labels), mesh.names[2]), ({1, 2}, "marrow"))

    def test_names_go_into_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.msh"
            certet.write(mesh_segments(segments(), MATRIX, NAMES), file)
            self.assertEqual(certet.read(file).names, {1: "bone", 2: "marrow"})

    def test_options_are_those_of_images(self):
        with self.assertWarnsRegex(certet.LossWarning, "of the volume") as told:
            mesh = mesh_segments(segments(), MATRIX, labels=2, method="midpoint", order=2)
        self.assertEqual(pathlib.Path(told.filename).name, "slicer_test.py")
        self.assertEqual((set(mesh.labels), mesh.method, mesh.order), ({2}, "midpoint", 2))

    def test_what_is_refused(self):
        sheared = MATRIX.copy()
        sheared[0, 1] += 0.4
        flat = MATRIX.copy()
        flat[:3, 2] = 0
        for words, arguments, options in (
                ("three axes", (segments()[0],), {}), ("shears", (segments(), sheared), {}),
                ("flat", (segments(), flat), {}), ("four rows", (segments(), np.eye(3)), {}),
                ("four rows", (segments(), np.full((4, 4), np.nan)), {}),
                ("a list of names", (segments(), MATRIX, "bone"), {}),
                ("ijk_to_ras tells", (segments(), MATRIX), {"spacing": 1})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                mesh_segments(*arguments, **options)

    def test_neither_slicer_nor_vtk_is_loaded_with_it(self):
        loaded = ("import sys, certet.slicer; "
                  "sys.exit(any(m.split('.')[0] in ('slicer', 'vtk', 'vtkmodules') for m in sys.modules))")
        self.assertEqual(subprocess.run([sys.executable, "-c", loaded]).returncode, 0)


@unittest.skipIf(vtk_to_numpy is None, "VTK was not found")
class Vtk(unittest.TestCase):
    def test_a_matrix_of_vtk(self):
        matrix = vtkMatrix4x4()
        for i in range(4):
            for j in range(4):
                matrix.SetElement(i, j, MATRIX[i, j])
        self.assertEqual(mesh_segments(segments(), matrix).checksum,
                         mesh_segments(segments(), MATRIX).checksum)

    def test_grid(self):
        for order, kind in ((1, 10), (2, 24)):
            mesh = mesh_segments(segments(), MATRIX, order=order)
            grid = unstructured_grid(mesh)
            self.assertEqual(set(vtk_to_numpy(grid.GetCellTypesArray())), {kind})
            self.assertEqual(grid.GetNumberOfCells(), len(mesh.tets))
            np.testing.assert_array_equal(
                vtk_to_numpy(grid.GetCellData().GetArray("label")), mesh.labels)
            cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
            cells = cells.reshape(len(mesh.tets), -1)
            np.testing.assert_array_equal(cells[:, :4], mesh.tets)
            points = vtk_to_numpy(grid.GetPoints().GetData())
            np.testing.assert_array_equal(points[:len(mesh.points)], mesh.points)
            measured = vtkMeshQuality()
            measured.SetInputData(grid)
            measured.SetTetQualityMeasureToVolume()
            measured.Update()
            if order == 1:
                volumes = vtk_to_numpy(measured.GetOutput().GetCellData().GetArray("Quality"))
                self.assertAlmostEqual(volumes.sum(), mesh.quality().volume, places=6)
            else:
                ends = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]
                for place, pair in enumerate(ends):
                    np.testing.assert_allclose(points[cells[:, 4 + place]],
                                               points[cells[:, pair]].mean(1), atol=1e-9)

    def test_grid_outlives_the_mesh(self):
        mesh = mesh_segments(segments(), MATRIX)
        copy = mesh.points.copy()
        grid = unstructured_grid(mesh)
        del mesh
        np.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), copy)

    def test_surface(self):
        """Closed and facing outwards: VTK finds the volume of the tetrahedra in it."""
        mesh = mesh_segments(segments(), MATRIX)
        for label in (1, 2, None):
            measured = vtkMassProperties()
            measured.SetInputData(surface(mesh, label))
            measured.Update()
            expected = mesh.quality().volume if label is None else volume(mesh, label)
            self.assertAlmostEqual(measured.GetVolume() / expected, 1, places=6)
        with self.assertRaisesRegex(ValueError, "no label 3"):
            surface(mesh, 3)

    def test_surface_faces_outwards(self):
        mesh = mesh_segments(segments(), MATRIX)
        data = surface(mesh, 1)
        points = vtk_to_numpy(data.GetPoints().GetData())
        corners = points[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        corners = corners - centroid(mesh, 1)
        self.assertAlmostEqual(np.linalg.det(corners).sum() / 6, volume(mesh, 1), places=6)


if __name__ == "__main__":
    unittest.main()
