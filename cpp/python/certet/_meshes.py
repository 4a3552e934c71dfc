"""Meshes, made and read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _certet
from ._options import Method
from ._results import (Curve, Dropped, Features, Interface, Optimised, Patch, Pieces, Quality,
                       Warp)


class _MiddleNodes:
    """The middle nodes of tetrahedra, where they have ten nodes."""

    _inner: _certet.Mesh | _certet.FileMesh

    @property
    def middle_points(self) -> NDArray[np.float64] | None:
        """Shape (k, 3): of tetrahedra of ten nodes those in the middle of edges, else None."""
        return self._inner.middle_points

    @property
    def middles(self) -> NDArray[np.uint64] | None:
        """Shape (m, 6): the rows of `middle_points` between the corners 0-1, 1-2, 0-2, 0-3, 1-3 and
        2-3 of each tetrahedron, which is the order of VTK and Abaqus; else None."""
        return self._inner.middles

    @property
    def order(self) -> Literal[1, 2]:
        """2 where tetrahedra have ten nodes."""
        return 1 if self._inner.middles is None else 2


class FileMesh(_MiddleNodes):
    """A mesh as a file holds it.  Its arrays share the memory of the mesh and keep it alive."""

    _inner: _certet.FileMesh

    def __init__(self, inner: _certet.FileMesh) -> None:
        self._inner = inner

    @property
    def points(self) -> NDArray[np.float64]:
        """Shape (n, 3): the file's coordinates."""
        return self._inner.points

    @property
    def tets(self) -> NDArray[np.uint64]:
        """Shape (m, 4): numbers of points."""
        return self._inner.tets

    @property
    def labels(self) -> NDArray[np.int32] | None:
        """Shape (m,): the label of each tetrahedron, where the file has any."""
        return self._inner.labels

    @property
    def names(self) -> dict[int, str]:
        """What labels are called, where the file tells."""
        return self._inner.names

    def quality(self) -> Quality:
        """Measures every tetrahedron, in the file's coordinates."""
        return _quality(self._inner.quality())

    def interfaces(self) -> list[Interface]:
        """Where labels touch, by growing labels: one for each pair of them.  The arrays share
        memory that is theirs alone."""
        return _interfaces(self._inner)

    def patches(self) -> list[Patch]:
        """The patches of the boundary, each of which has triangles: those that the file tells, and
        "surface" for all else.  The arrays share memory that is theirs alone."""
        return [Patch(*one) for one in _certet.patches(self._inner)]

    def pieces(self) -> Pieces:
        """Counts the pieces, by faces and by vertices, of the whole and of each label."""
        return _pieces(self._inner)

    def __repr__(self) -> str:
        return f"<certet.FileMesh of {len(self.points)} points and {len(self.tets)} tetrahedra>"


class Mesh(_MiddleNodes):
    """A finished mesh.  Its arrays share the memory of the mesh and keep it alive."""

    _inner: _certet.Mesh

    def __init__(self, inner: _certet.Mesh) -> None:
        self._inner = inner

    @property
    def points(self) -> NDArray[np.float64]:
        """Shape (n, 3): world coordinates."""
        return self._inner.points

    @property
    def positions(self) -> NDArray[np.int32]:
        """Shape (n, 3): the exact points, in steps (2^17 to a long edge of the lattice).

        A point is `origin + axes @ (size / 2**17 * position)`.
        """
        return self._inner.positions

    @property
    def tets(self) -> NDArray[np.unsignedinteger[Any]]:
        """Shape (m, 4): numbers of points, uint32 or, for more than 2^32 points, uint64.

        det(p1 - p0, p2 - p0, p3 - p0) > 0 for every row.
        """
        return self._inner.tets

    @property
    def labels(self) -> NDArray[np.int32] | None:
        """Shape (m,): the label of each tetrahedron; None but for images of labels and several
        solids."""
        return self._inner.labels

    @property
    def curve(self) -> Curve | None:
        """How many middle nodes are on the surface; None but by curved=True."""
        return None if self._inner.curve is None else Curve(**self._inner.curve)

    @property
    def optimised(self) -> Optimised | None:
        """What became of the vertices that were to move; None but by optimise."""
        return None if self._inner.optimised is None else Optimised(**self._inner.optimised)

    @property
    def dropped(self) -> Dropped | None:
        """The pieces that are not in the mesh; None but by keep."""
        return None if self._inner.dropped is None else Dropped(**self._inner.dropped)

    @property
    def features(self) -> Features:
        """Whether vertices moved onto sharp edges, why, and what became of that."""
        return Features(**self._inner.features)

    @property
    def size(self) -> float:
        """The long edge of the lattice, in world units."""
        return self._inner.size

    @property
    def origin(self) -> NDArray[np.float64]:
        """Shape (3,): where the lattice has its origin."""
        return np.asarray(self._inner.origin)

    @property
    def axes(self) -> NDArray[np.float64]:
        """Shape (3, 3): the rotation from lattice to world."""
        return np.asarray(self._inner.axes)

    @property
    def method(self) -> Method:
        """The method that was used in the end, whose theorem covers the mesh: where "angles"
        would turn over a tetrahedron that is dropped, it is "embedding", and where several
        materials meet, for "key" it is "embedded"."""
        return self._inner.method

    @property
    def guarantee(self) -> Method:
        """The same, under its older name."""
        return self.method

    @property
    def names(self) -> dict[int, str]:
        """What labels are called, where the shape tells; none of an array."""
        return self._inner.names

    @property
    def notes(self) -> list[str]:
        """What was done to a surface so that it bounds a solid, and that pieces were not
        compared with those of finer samples, where that is so; a sentence each."""
        return list(self._inner.notes)

    @property
    def losses(self) -> list[str]:
        """What the mesh has not kept of its shape, a sentence each; a `LossWarning` told them."""
        return list(self._inner.losses)

    @property
    def warp(self) -> Warp:
        """How many vertices stayed, and how far that moved the surface."""
        return Warp(**self._inner.warp)

    @property
    def warnings(self) -> list[str]:
        """What the mesh has lost of its image's labels, a sentence each; `warnings` were told."""
        return list(self._inner.warnings)

    @property
    def checksum(self) -> int:
        """64 bits that tell whether two meshes are the same; as `certet mesh --json` says."""
        return self._inner.checksum()

    def quality(self) -> Quality:
        """Measures every tetrahedron, in exact and in world coordinates."""
        return _quality(self._inner.quality())

    def interfaces(self) -> list[Interface]:
        """Where labels touch, by growing labels: one for each pair of them.  The arrays share
        memory that is theirs alone.  Empty where the method does
        not cut labels apart (the paper's)."""
        return _interfaces(self._inner)

    def patches(self) -> list[Patch]:
        """The patches of the boundary, each of which has triangles, as `write` writes them where
        the format has patches.  The arrays share memory that is theirs alone."""
        return [Patch(*one) for one in _certet.patches(self._inner)]

    def name_patches(self, where: Mapping[str, str | tuple[str, float]]) -> None:
        """Gives parts of the boundary names of their own, by which `patches` and `write` call them.

            mesh.name_patches({"inlet": "xmin", "top": ("z", 12.5), "wall": "surface"})

        Parameters
        ----------
        where : by name (a letter, and letters, digits and underscores), either a patch that there
            is by itself, or an axis and a coordinate in world units: what of the boundary lies
            within half a long edge of that plane and leans by at most 60 degrees against it.  What
            several have is the last one's.

        Raises
        ------
        ValueError : a name that is taken or no name, or a patch without triangles; no name is
            given then
        """
        _certet.name_patches(self._inner, _arguments.patches(where))

    def pieces(self) -> Pieces:
        """Counts the pieces, by faces and by vertices, of the whole and of each label."""
        return _pieces(self._inner)

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with the cell data `label`, if there are labels."""
        import meshio

        data = {} if self.labels is None else {"label": [self.labels]}
        if self.middles is None or self.middle_points is None:
            return meshio.Mesh(self.points, [("tetra", self.tets)], cell_data=data)
        cells = np.hstack([self.tets, len(self.points) + self.middles])
        return meshio.Mesh(np.vstack([self.points, self.middle_points]), [("tetra10", cells)],
                           cell_data=data)

    def __repr__(self) -> str:
        return f"<certet.Mesh of {len(self.points)} points and {len(self.tets)} tetrahedra>"


def inner(mesh: Any) -> Any:
    """What the library has of a mesh."""
    if not isinstance(mesh, (Mesh, FileMesh)):
        raise ValueError(f"mesh is a certet.Mesh or a certet.FileMesh, not a {type(mesh).__name__}")
    return mesh._inner


def _quality(found: dict[str, Any]) -> Quality:
    histogram: dict[str, Any] = {"histogram": np.asarray(found["histogram"], np.uint64)}
    return Quality(**{**found, **histogram})


def _pieces(mesh: _certet.Mesh | _certet.FileMesh) -> Pieces:
    found = _certet.pieces(mesh)
    places = {key: np.asarray(found[key], float).reshape(-1, 3)
              for key in ("edge_places", "vertex_places")}
    return Pieces(**{**found, **places})


def _interfaces(mesh: _certet.Mesh | _certet.FileMesh) -> list[Interface]:
    names = mesh.names
    return [Interface(labels, (names.get(labels[0], str(labels[0])),
                               names.get(labels[1], str(labels[1]))), triangles, area)
            for labels, triangles, area in _certet.interfaces(mesh)]
