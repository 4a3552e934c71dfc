"""Meshes to files and images, and back; and whether they are what they should be."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _certet
from ._meshes import FileMesh, Mesh, inner
from ._results import CheckReport, Interface, Patch, Quality
from ._warn import warn


def write(mesh: Mesh | FileMesh, file: str | os.PathLike[str], format: str | None = None) -> None:
    """Writes a mesh, in world coordinates, as `certet mesh` does: with its regions, their names and
    the patches of its boundary where the format has them.

    Parameters
    ----------
    format : a name that `certet mesh --format` knows (default: by the extension)

    Warns of labels that do not keep their numbers: in .msh those that are not positive.

    Raises
    ------
    ValueError : an unknown format, a file that cannot be written, a mesh that doubles cannot hold
        where it lies
    """
    warn(_certet.write(inner(mesh), file, format))


def read(file: str | os.PathLike[str]) -> FileMesh:
    """Reads a .vtu, .mesh, .meshb or .msh file.

    Raises
    ------
    ValueError : a file that cannot be read, or is not what it should be
    """
    return FileMesh(_certet.read(file))


def check(mesh: Mesh | FileMesh) -> CheckReport:
    """Verifies a mesh anew, from its points and tetrahedra alone: conforming, closed, positive,
    every point used, finite and by itself."""
    return CheckReport(**_certet.check(inner(mesh)))


def interfaces(mesh: Mesh | FileMesh) -> list[Interface]:
    """Where labels touch; `mesh.interfaces()` is the same."""
    return mesh.interfaces()


def patches(mesh: Mesh | FileMesh) -> list[Patch]:
    """The patches of the boundary; `mesh.patches()` is the same."""
    return mesh.patches()


def quality(mesh: Mesh | FileMesh) -> Quality:
    """Measures every tetrahedron of a mesh; `mesh.quality()` is the same."""
    inner(mesh)
    return mesh.quality()


def voxelise(
    mesh: Mesh | FileMesh,
    *,
    like: ArrayLike | None = None,
    shape: Sequence[int] | None = None,
    spacing: float | Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike | None = None,
) -> NDArray[np.int32]:
    """Makes an image of a mesh's labels: shape (nx, ny, nz), its first index runs fastest.

    Each voxel has the label of the tetrahedron that holds its centre, which is
    `origin + direction @ (spacing * (i, j, k))`, and 0 where none does; a mesh without labels has
    label 1.  Points are rounded to 2^-20 voxels, from there on all is exact: a centre on a face,
    edge or corner belongs to where a step along the first axis leads or, if that stays on it,
    along the second, or the third.

    Parameters
    ----------
    like : an array that has the image's shape, such as the one that was meshed
    shape : three whole numbers, in the place of `like`
    spacing : 3 numbers, in world units, or one for all
    origin : 3 numbers, in world units
    direction : shape (3, 3), orthonormal (default: identity)

    Warns of a mesh that overlaps itself, that holds no centre, or has a region 0.

    Raises
    ------
    ValueError : an impossible geometry, a mesh with points that are not there or not finite
    MemoryError : more than 2^18 voxels along an axis, or than the memory has room for
    """
    if (like is None) == (shape is None):
        raise ValueError("voxelise takes either like, an array, or shape, three whole numbers")
    size = _arguments.shape(np.shape(like) if like is not None else shape)
    labels, doubts = _certet.voxelise(
        inner(mesh), size, _arguments.three("spacing", spacing, one_will_do=True),
        _arguments.three("origin", origin), _arguments.direction(direction))
    warn(doubts)
    return labels
