"""Segmentations of 3D Slicer as tetrahedra, in Slicer's own coordinates.

    from certet.slicer import mesh_segments, unstructured_grid
    mesh = mesh_segments(slicer.util.arrayFromVolume(labelmap), matrix, ["bone", "marrow"])
    grid = unstructured_grid(mesh)

Nothing of Slicer is imported, and of VTK only where a function gives an object of it; so all of this
runs, and is tested, without Slicer.  Slicer's arrays have the axes k, j, i, its matrix goes from
i, j, k to RAS in mm, and so are the points of the mesh.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import FileMesh, Mesh, mesh_image

__all__ = ["mesh_segments", "surface", "unstructured_grid"]

# The faces of a positive tetrahedron, anticlockwise seen from outside.
_FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def mesh_segments(
    labelmap: ArrayLike,
    ijk_to_ras: ArrayLike | None = None,
    names: Mapping[int, str] | Sequence[str] = (),
    **options: Any,
) -> Mesh:
    """Meshes the segments of a labelmap.

    Parameters
    ----------
    labelmap : shape (nk, nj, ni), as `slicer.util.arrayFromVolume` gives it: whole numbers, 0 outside
    ijk_to_ras : shape (4, 4), as `vtkMRMLVolumeNode.GetIJKToRASMatrix` has it: a
        `vtkMatrix4x4` or an array (default: identity)
    names : of segments, by their labels, or of labels 1, 2, … in this order
    options : those of `certet.mesh_image`, but for spacing, origin and direction; sizes in mm

    Returns
    -------
    A `Mesh` with points in RAS, labels as they were, and `names`.

    Raises
    ------
    ValueError : an array without three axes, a matrix that shears or is flat; as `mesh_image`
    MemoryError : as `mesh_image`
    """
    voxels = np.asanyarray(labelmap)
    if voxels.ndim != 3:
        raise ValueError(f"a labelmap has the three axes k, j and i, not {voxels.ndim}")
    for place in ("spacing", "origin", "direction"):
        if place in options:
            raise ValueError(f"{place} is what ijk_to_ras tells")
    spacing, direction, origin = _placed(_matrix(ijk_to_ras))
    merges: dict[Any, int | str] = {**_by_label(names), **(options.pop("merge", None) or {})}
    return mesh_image(voxels.transpose(), spacing=spacing, origin=origin, direction=direction,
                      merge=merges or None, **options)


def unstructured_grid(mesh: Mesh | FileMesh) -> Any:
    """A `vtkUnstructuredGrid` of the tetrahedra, with four or ten nodes each, for
    `vtkMRMLModelNode.SetAndObserveMesh`; cell data `label`, where there are labels.

    Raises
    ------
    ImportError : without VTK
    """
    from vtkmodules.vtkCommonDataModel import (VTK_QUADRATIC_TETRA, VTK_TETRA,
                                               vtkUnstructuredGrid)

    points, cells = mesh.points, mesh.tets
    if mesh.middles is not None and mesh.middle_points is not None:
        cells = np.hstack([cells, len(points) + mesh.middles])
        points = np.vstack([points, mesh.middle_points])
    grid = vtkUnstructuredGrid()
    grid.SetPoints(_vtk_points(points))
    grid.SetCells(VTK_TETRA if cells.shape[1] == 4 else VTK_QUADRATIC_TETRA, _vtk_cells(cells))
    if mesh.labels is not None:
        grid.GetCellData().SetScalars(_vtk_array(mesh.labels, "label"))
    return grid


def surface(mesh: Mesh | FileMesh, label: int | None = None) -> Any:
    """A `vtkPolyData` of the triangles around one segment, or around all tetrahedra, facing
    outwards, for `vtkMRMLModelNode.SetAndObservePolyData`.

    Raises
    ------
    ValueError : a label that the mesh has not
    ImportError : without VTK
    """
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    triangles = _boundary(_chosen(mesh, label))
    used, corners = np.unique(triangles, return_inverse=True)
    data = vtkPolyData()
    data.SetPoints(_vtk_points(mesh.points[used]))
    data.SetPolys(_vtk_cells(corners.reshape(-1, 3)))
    return data


def _matrix(ijk_to_ras: Any) -> NDArray[np.float64]:
    if ijk_to_ras is None:
        return np.eye(4)
    if hasattr(ijk_to_ras, "GetElement"):
        ijk_to_ras = [[ijk_to_ras.GetElement(i, j) for j in range(4)] for i in range(4)]
    matrix = np.asarray(ijk_to_ras, float)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or \
            not np.array_equal(matrix[3], (0, 0, 0, 1)):
        raise ValueError("ijk_to_ras is four rows of four numbers, the last 0, 0, 0, 1")
    return matrix


def _placed(matrix: NDArray[np.float64]) -> tuple[list[float], list[list[float]], list[float]]:
    """Spacing, direction and origin."""
    spacing = np.linalg.norm(matrix[:3, :3], axis=0)
    if not (spacing > 0).all():
        raise ValueError("ijk_to_ras is flat along an axis")
    direction = matrix[:3, :3] / spacing
    if np.abs(direction.T @ direction - np.eye(3)).max() > 1e-4:
        raise ValueError("ijk_to_ras shears: resample the labelmap, for its axes are not at right angles")
    return spacing.tolist(), direction.tolist(), matrix[:3, 3].tolist()


def _by_label(names: Mapping[int, str] | Sequence[str]) -> dict[int, str]:
    if isinstance(names, str):
        raise ValueError("names is a list of names, or a dictionary of them by their labels")
    if isinstance(names, Mapping):
        return dict(names)
    return dict(enumerate(names, start=1))


def _chosen(mesh: Mesh | FileMesh, label: int | None) -> NDArray[Any]:
    """The tetrahedra of a label, or all."""
    if label is None:
        return mesh.tets
    found = np.zeros(0, bool) if mesh.labels is None else mesh.labels == label
    if not found.any():
        raise ValueError(f"the mesh has no label {label}")
    return mesh.tets[found]


def _boundary(tets: NDArray[Any]) -> NDArray[Any]:
    """The faces that one tetrahedron alone has."""
    faces = np.concatenate([tets[:, face] for face in _FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True,
                                return_counts=True)
    return faces[np.sort(first[count == 1])]


def _vtk_array(values: NDArray[Any], name: str = "") -> Any:
    """A copy, which VTK owns."""
    from vtkmodules.util.numpy_support import numpy_to_vtk

    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    if name:
        array.SetName(name)
    return array


def _vtk_points(points: NDArray[np.float64]) -> Any:
    from vtkmodules.vtkCommonCore import vtkPoints

    made = vtkPoints()
    made.SetData(_vtk_array(points))
    return made


def _vtk_cells(cells: NDArray[Any]) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray

    count, nodes = cells.shape
    made = vtkCellArray()
    made.SetData(numpy_to_vtkIdTypeArray(np.arange(0, nodes * (count + 1), nodes, np.int64), deep=True),
                 numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, np.int64).ravel(), deep=True))
    return made
