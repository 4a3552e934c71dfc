"""Tetrahedral meshes with proven angles, by isosurface stuffing.

    import certet
    mesh = certet.mesh(labels, spacing=(1, 1, 1), size=1.5)
    mesh.points, mesh.tets, mesh.labels          # NumPy arrays that share the mesh's memory
    certet.write(mesh, "brain.vtu")

`mesh` makes one of voxels, of a function that is negative inside, of closed triangles, or of several
solids; so do `mesh_image`, `mesh_function`, `mesh_surface` and `mesh_solids`, each for one
of these.  A `Solid` is made of any of them, and `a & b`, `a | b` and `a - b` of two solids.
`write`, `read`, `check`, `interfaces`, `patches`, `inside`, `quality` and `voxelise` do what they say.  They
run on all cores without Python's lock; Ctrl-C stops them.  What they refuse is a `ValueError` with one sentence, a lattice or
mesh that is too large a `MemoryError`.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _certet, _sizes
from ._sizes import SizeField

__all__ = ["CheckReport", "Curve", "Distance", "Distances", "Features", "FileMesh", "Interface",
           "LossWarning", "Mesh", "Optimised", "Patch", "Pieces", "Quality", "Solid", "Warp", "check",
           "distance", "inside",
           "interfaces", "mesh", "mesh_function", "mesh_image", "mesh_solids", "mesh_surface",
           "patches", "quality", "read", "voxelise", "write"]
__version__: str = _certet.version

Cuts = Literal["bisect", "midpoint"]
Guarantee = Literal["angles", "embedding"]
Method = Literal["embedded", "angles", "embedding", "midpoint", "key"]


class Quality(NamedTuple):
    """What was measured of a mesh; angles in degrees, the volume in world units cubed."""

    tets: int
    volume: float
    min_dihedral: float
    max_dihedral: float
    histogram: NDArray[np.uint64]
    """Shape (36,): all six dihedral angles of each tetrahedron, in bins of 5 degrees."""
    theorem: str | None = None
    """The theorem of the certificate for such meshes; it covers this one where `holds`.  None,
    and so the next three, of a mesh from a file, which does not tell how it was made."""
    proven_min: float | None = None
    proven_max: float | None = None
    holds: bool | None = None
    """Whether all tetrahedra are positive and all angles within the proven bounds: exactly in
    the lattice, and to a thousandth of a degree in the world, where no two points coincide."""


class CheckReport(NamedTuple):
    """What `check` found."""

    failures: list[str]
    """One sentence for each broken property; empty: all is well."""
    points: int
    tets: int
    boundary_faces: int


class Pieces(NamedTuple):
    """The pieces of a mesh, counted on its tetrahedra, and where its surface is no manifold."""

    by_faces: int
    """What is joined by faces that two tetrahedra share."""
    by_vertices: int
    """What is joined by points."""
    largest_tets: int
    """The tetrahedra of the largest piece by faces."""
    regions: dict[int, tuple[int, int]]
    """Of each label: its pieces by faces and by vertices; empty without labels."""
    nonmanifold_edges: int
    """Edges in more than two faces of the surface."""
    nonmanifold_vertices: int
    """Vertices around which its faces are not one closed fan."""
    edge_places: NDArray[np.float64]
    """Shape (n, 3), n at most 8: the middles of the first such edges, in world units."""
    vertex_places: NDArray[np.float64]
    """Shape (n, 3), n at most 8: the first such vertices, in world units."""


class Warp(NamedTuple):
    """What became of the vertices that the surface passes too close to; all 0 but by the methods
    "key" and "embedded"."""

    violated: int
    """So many there were."""
    stayed: int
    """So many did not move, so that no piece is lost or joined; cuts moved away from them."""
    shortened: int
    """So many moved less than to the surface."""
    clamped_cuts: int
    """The cuts that were moved; how far is told of these alone."""
    greatest: float
    """World units."""
    rms: float
    """World units."""
    greatest_edges: float
    """In lengths of the cut's edge."""
    rms_edges: float
    """In lengths of the cut's edge."""
    missed_edges: float
    """By how much shortened moves miss the surface at most, in long edges."""
    missed_rms_edges: float
    """The same, root mean square of these alone."""


class Optimised(NamedTuple):
    """What became of the vertices that were to move for better angles."""

    goal: float
    """The angle, in degrees, that none was to be nearer to 0 or to 180 than."""
    rounds: int
    """Over all vertices around which one was."""
    moved: int
    """Vertices."""
    moved_on_surface: int
    """Of those, on the boundary or an interface."""
    moved_on_seams: int
    """Of those, where more than two regions meet."""
    left_surface: int
    """Those that had to leave theirs, by an eighth of a long edge at most."""
    greatest_edges: float
    """The farthest move, in long edges of the lattice."""
    greatest_on_surface_edges: float
    """The same of those on surfaces."""
    short_before: int
    """Tetrahedra with an angle nearer than the goal to 0 or to 180, before."""
    short_after: int
    """The same, after."""


class Curve(NamedTuple):
    """What became of the edges of the boundary and of interfaces, by curved=True."""

    edges: int
    """All of them, but for those where the shape is cut off."""
    moved: int
    """The middle node was put on the surface."""
    on_surface: int
    """It was there."""
    guarded: int
    """It stayed in the middle, or else an element would be spoilt."""
    far: int
    """It stayed: no surface within a quarter of the edge."""
    seams: int
    """It stayed, where more than two regions meet."""
    greatest_edges: float
    """The farthest move, in long edges of the lattice."""
    least_jacobian: float
    """A lower bound on the Jacobian determinant of all elements, as a part of that of the straight
    element, at least a quarter."""


class Distance(NamedTuple):
    """How far points of one surface are from another."""

    greatest: float
    """World units."""
    rms: float
    """Root mean square over the area, in world units."""
    at: NDArray[np.float64]
    """Shape (3,): where it is the greatest, a point of the first surface in the world."""
    points: int
    """At so many it was measured."""


class Distances(NamedTuple):
    """How far a mesh is from a shape, and the shape from the mesh."""

    to_shape: Distance
    """From the mesh's surface."""
    to_mesh: Distance
    """From the shape's surface."""
    edge: float
    """The long edge of the lattice on which the shape answered, in world units."""
    exact: bool
    """Whether the shape is a closed surface, and distances those from its triangles."""


class Features(NamedTuple):
    """Vertices that moved onto sharp edges."""

    angle: float | None
    """Between normals of neighbours, in degrees, of sharp edges; None where vertices stayed."""
    why: str
    """The end of a sentence."""
    length: float
    """Of all sharp edges, in world units."""
    followed_percent: float
    """Of that what is between two vertices exactly on it, joined by an edge of the mesh."""
    kept_percent: float
    """What these edges are within 2 % of a long edge of; where the shape is bent, chords are not."""
    corners: int
    kept_corners: int
    """Those with a vertex exactly there."""
    greatest_distance_edges: float
    """Of a sharp edge from the edges of the mesh's surface, in long edges."""
    moved: int
    """Vertices."""
    greatest_move_edges: float


class LossWarning(UserWarning):
    """A mesh has not the pieces of its shape, or a volume that differs by a fiftieth or more; the
    sentence says a size that keeps them, which was tried, if one was found."""


class Interface(NamedTuple):
    """Where the tetrahedra of two labels touch."""

    labels: tuple[int, int]
    """The lesser first."""
    names: tuple[str, str]
    """Those of the labels; a label without a name is called by its number."""
    triangles: NDArray[np.uint64]
    """Shape (n, 3): numbers of points of the mesh, anticlockwise seen from the second label's
    side.  `mesh.points[triangles]` has their corners, shape (n, 3, 3)."""
    area: float
    """In world units squared."""


class Patch(NamedTuple):
    """A part of the boundary of a mesh."""

    name: str
    """"surface"; where bounds or the edge of an image cut the shape off "xmin", "xmax", "ymin",
    "ymax", "zmin" or "zmax"; or as `Mesh.name_patches` or the file says."""
    triangles: NDArray[np.uint64]
    """Shape (n, 3): numbers of points of the mesh, anticlockwise seen from outside, by growing
    numbers of points."""
    area: float
    """In world units squared."""


class _MiddleNodes:
    """The middle nodes of tetrahedra, where they have ten nodes."""

    _inner: Any

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
        not cut labels apart (the paper's)"""
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
        if self.middles is None:
            return meshio.Mesh(self.points, [("tetra", self.tets)], cell_data=data)
        cells = np.hstack([self.tets, len(self.points) + self.middles])
        return meshio.Mesh(np.vstack([self.points, self.middle_points]), [("tetra10", cells)],
                           cell_data=data)

    def __repr__(self) -> str:
        return f"<certet.Mesh of {len(self.points)} points and {len(self.tets)} tetrahedra>"


class Solid:
    """What is inside of a shape: several make others, and are the materials of one mesh.

        part = certet.Solid("gyroid:1,0.2", bounds=box) & certet.Solid((points, triangles))
        bone = certet.Solid(labels, spacing=(1, 1, 2)) - certet.Solid(screw)
        certet.mesh(part, size=0.1)

    `a & b` is what is in both, `a | b` what is in either, `a - b` what is in the first alone.  The
    labels of an image stay apart in `a & b` and `a - b`, where it is `a`.  The lattice is that of
    the first image among them, or along the axes of the world.

    Parameters
    ----------
    shape : a function that is negative inside, as `mesh_function` takes, with `bounds` and perhaps
        `batch`; a pair
        (points, triangles), as `mesh_surface` does, with `repair` if it may be open; an array of
        voxels, as `mesh_image` does, with `spacing`, `origin`, `direction`, `labels`, `iso`,
        `smooth` and `merge`; or a text: a shape that `certet mesh --shape` knows, like
        "sphere:1", or a formula with `bounds`
    options : those that are named there

    Raises
    ------
    ValueError, MemoryError : as `mesh_image`, and for solids without a place in common
    """

    def __init__(self, shape: Any, **options: Any) -> None:
        self._inner = _inner_solid("the shape", shape, options)

    @classmethod
    def _of(cls, inner: _certet.Solid) -> Solid:
        solid = cls.__new__(cls)
        solid._inner = inner
        return solid

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Shape (2, 3): the corners of a box around it, in world units."""
        return np.asarray([self._inner.low, self._inner.high])

    @property
    def notes(self) -> list[str]:
        """What was done to surfaces so that they bound solids, a sentence each."""
        return list(self._inner.notes)

    def __and__(self, other: Solid) -> Solid:
        return Solid._of(self._inner & other._inner) if isinstance(other, Solid) else NotImplemented

    def __or__(self, other: Solid) -> Solid:
        return Solid._of(self._inner | other._inner) if isinstance(other, Solid) else NotImplemented

    def __sub__(self, other: Solid) -> Solid:
        return Solid._of(self._inner - other._inner) if isinstance(other, Solid) else NotImplemented

    def __repr__(self) -> str:
        return f"<certet.Solid in {self.bounds[0].tolist()} to {self.bounds[1].tolist()}>"


def inside(shape: Any, points: ArrayLike) -> NDArray[np.bool_]:
    """Which points are in a solid, or on its surface.

    Parameters
    ----------
    shape : a `Solid`, or what it is made of without options, like a pair (points, triangles)
    points : shape (..., 3), in world units; each is taken for the nearest point of a grid of 2^26
        along the longest side of the solid's box

    Returns
    -------
    shape (...) : truth values

    Raises
    ------
    ValueError, MemoryError : as `Solid`
    """
    solid = shape if isinstance(shape, Solid) else Solid(shape)
    places = _arguments.points(points)
    if places.ndim == 0 or places.shape[-1] != 3:
        raise ValueError(f"points are of shape (..., 3), not {places.shape}")
    found: NDArray[np.bool_] = _certet.inside(solid._inner, places.reshape(-1, 3))
    return found.reshape(places.shape[:-1])


def distance(mesh: Mesh | FileMesh, shape: Any, *, threads: int = 0, **options: Any) -> Distances:
    """Measures how far a mesh's surface is from a shape's, and back.

        certet.distance(mesh, (points, triangles)).to_shape.greatest

    The mesh is measured at its vertices, edge middles and centroids.  Of a closed surface
    distances are to its triangles, and from them, exactly.  Of all else the surface is where it
    answers otherwise, also between labels, where both the mesh and the shape have several: to a
    hundredth within a long edge, at corners to a few, and back from where lines half a long edge
    apart pass through it.  The long edge is the mesh's or, of one from a file, the mean length of
    the edges of its surface.

    Parameters
    ----------
    mesh : in the coordinates of the shape
    shape : a `Solid`, or what it is made of
    threads : 0 takes all cores; the figures do not depend on it
    options : as `Solid` has them, where the shape is none

    Raises
    ------
    ValueError : as `Solid`, and where one of them has no surface
    MemoryError : as `Solid`
    """
    if isinstance(shape, Solid) and options:
        raise ValueError(f"{next(iter(options))} goes with what a Solid is made of")
    solid = shape if isinstance(shape, Solid) else Solid(shape, **options)
    to_shape, to_mesh, edge, exact = _certet.distance(
        _inner(mesh), solid._inner, _arguments.whole("threads", threads))
    return Distances(_distance(*to_shape), _distance(*to_mesh), edge, exact)


def mesh(shape: Any, **options: Any) -> Mesh:
    """Meshes a shape, by what it is.

    Parameters
    ----------
    shape : a function that is negative inside, as `mesh_function` takes; a pair (points,
        triangles), as `mesh_surface` does; a dictionary of these, as `mesh_solids` does; an
        array of voxels, as `mesh_image` does; or a `Solid`, with `size`, `margin`, `method`,
        `threads`, `order`, `curved`, `optimise`, `features`, `grade` and `size_field` as options
    options : those of that function, by name; `bounds` is required for a function

    Raises
    ------
    ValueError, MemoryError : as `mesh_image`
    """
    if callable(shape):
        return mesh_function(shape, **options)
    if isinstance(shape, Solid):
        return _mesh_solid(shape, **options)
    if isinstance(shape, Mapping):
        return mesh_solids(shape, **options)
    if isinstance(shape, tuple) and len(shape) == 2:
        return mesh_surface(*shape, **options)
    return mesh_image(shape, **options)


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
    _warn(_certet.write(_inner(mesh), file, format))


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
    return CheckReport(**_certet.check(_inner(mesh)))


def interfaces(mesh: Mesh | FileMesh) -> list[Interface]:
    """Where labels touch; `mesh.interfaces()` is the same."""
    return mesh.interfaces()


def patches(mesh: Mesh | FileMesh) -> list[Patch]:
    """The patches of the boundary; `mesh.patches()` is the same."""
    return mesh.patches()


def quality(mesh: Mesh | FileMesh) -> Quality:
    """Measures every tetrahedron of a mesh; `mesh.quality()` is the same."""
    _inner(mesh)
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
        _inner(mesh), size, _arguments.three("spacing", spacing, one_will_do=True),
        _arguments.three("origin", origin), _arguments.direction(direction))
    _warn(doubts)
    return labels


def mesh_image(
    array: ArrayLike,
    *,
    spacing: float | Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike | None = None,
    labels: int | Iterable[int | tuple[int, int]] | None = None,
    iso: float | tuple[float | None, float | None] | None = None,
    smooth: float | None = None,
    merge: Mapping[int | tuple[int, int], int | str] | None = None,
    size: float | None = None,
    margin: int = 2,
    method: Method | None = None,
    cuts: Cuts = "bisect",
    guarantee: Guarantee | None = None,
    threads: int = 0,
    order: Literal[1, 2] = 1,
    curved: bool = False,
    optimise: bool | float = False,
    features: float | Literal["auto", "off"] = "auto",
    grade: int = 0,
    size_field: SizeField | None = None,
) -> Mesh:
    """Meshes voxels: chosen labels, or where a grayscale image is above `iso`.

    Parameters
    ----------
    array : shape (nx, ny, nz)
        The centre of voxel [i, j, k] is `origin + direction @ (spacing * (i, j, k))`.  Arrays
        of SimpleITK have their axes the other way round: pass `a.T`.  Whole numbers are
        labels, floating point ones too; with `iso` any real numbers will do.  Beyond the image
        all is outside, and so is what is masked in a masked array.
    spacing : 3 numbers, in world units, or one for all
    origin : 3 numbers, in world units
    direction : shape (3, 3), orthonormal; a left-handed one is welcome (default: identity)
    labels : labels and pairs (first, last) of them that make the solid, or one label (default:
        all but 0)
    iso : the level, or a pair of which one may be None: what is above the first and below the
        second; then `labels` must be None
    smooth : of labels: the standard deviation, in world units, by which the surfaces between
        them and to the outside are smoothed, at most 4 voxels along any axis (default: one
        voxel); 0: they follow the faces of voxels, as always with the paper's rule
    merge : labels and pairs (first, last) of them that become one label, or have a name, before
        any are chosen, like {(1, 5): "bone", 7: 9}
    size : the long edge of the lattice, in world units (default: the smallest spacing)
    margin : cells of the lattice around the solid, at least 1
    method : "key" (default: dihedral angles from 11.18 to 157.13 degrees, no tetrahedra overlap,
        the surface is a manifold, and no piece of the samples is lost, cut or joined to another;
        where several materials meet it is "embedded"), "embedded" (the same from 10.77 to 164.76
        degrees, of several labels but for single points), "angles" and "embedding" (the paper's
        rule with either of its thresholds; from 9.27 to 161.46 degrees with the second) or
        "midpoint" (from 30 to 135: edges are cut in the middle, whatever the surface does
        between its ends)
    cuts, guarantee : the same in two older words, where there is no `method`: cuts="midpoint",
        or guarantee="angles" or "embedding"
    threads : 0 takes all cores; the mesh does not depend on it
    order : 2: tetrahedra of ten nodes, one in the middle of each edge, which `Mesh.middles` and
        `Mesh.middle_points` have, and `write` writes
    curved : with order=2: middle nodes of the boundary and of interfaces lie on the surface, where
        no element is spoilt by it; `Mesh.curve` says how many do
    optimise : vertices move, those of surfaces along these, where the worst dihedral angle around
        grows by it, until none is nearer to 0 or to 180 than so many degrees, at most 60 (True:
        25), or no move helps; `Mesh.optimised` says what became of them
    features : "auto" (default), "off", or an angle in degrees: vertices of the boundary move onto
        edges of the shape at which normals differ by more than that, and onto the corners of these,
        as far as all angles stay within the method's bounds.  "auto" does so by 40 degrees for
        surfaces of which nine tenths of the edges are flat or sharp, boxes and cylinders.  Of
        functions, several solids and whatever bounds cut off an angle has them looked for on the
        mesh; of voxels those alone at which these end.  `Mesh.features` says what was chosen, and
        why
    grade : 0 to 3: away from the surface, and from where labels meet, tetrahedra are larger, by
        up to so many levels, each of which doubles the edges; what touches the surface stays as it
        is.  Vertices of such a mesh do not move
    size_field : the greatest long edges wanted, place by place, in world units: a formula of x, y
        and z, a function of points, called as that of `mesh_function` is and with points inside
        alone, or (array, spacing, origin) or (array, spacing, origin, direction) of an image of
        sizes, trilinear between voxel centres.  The mesh is graded by as many levels as stay
        within, 3 or `grade` at most, and nowhere finer than `size`

    Warns of labels that the mesh has lost, with a size that keeps them, of labels asked for one by
    one that no voxel has, and of gray values taken for labels; `Mesh.warnings` has the sentences.

    Raises
    ------
    ValueError : voxels that are no labels, an impossible geometry, nothing inside
    MemoryError : more than memory or the coordinate range allow
    """
    if labels is not None and iso is not None:
        raise ValueError("labels and iso exclude each other")
    if merge is not None and iso is not None:
        raise ValueError("merge and iso exclude each other")
    if smooth is not None and iso is not None:
        raise ValueError("smooth and iso exclude each other")
    ranges = _arguments.labels(labels)
    levels, merges = _arguments.levels(iso), _arguments.merges(merge)
    return _told(_certet.mesh_image(
        _arguments.voxels(array, ranges, merges, gray=levels is not None),
        _arguments.three("spacing", spacing, one_will_do=True),
        _arguments.three("origin", origin), _arguments.direction(direction), ranges, levels,
        None if smooth is None else float(smooth), merges, _arguments.size(size), _arguments.whole("margin", margin),
        _options(method, cuts, guarantee, threads, order, curved, optimise, features, grade,
                 size_field)))


def mesh_function(
    f: Callable[[NDArray[np.float64]], ArrayLike],
    bounds: Sequence[Sequence[float]] | Sequence[float],
    size: float | None = None,
    *,
    batch: int = 100_000,
    margin: int = 2,
    method: Method | None = None,
    cuts: Cuts = "bisect",
    guarantee: Guarantee | None = None,
    threads: int = 0,
    order: Literal[1, 2] = 1,
    curved: bool = False,
    optimise: bool | float = False,
    features: float | Literal["auto", "off"] = "auto",
    grade: int = 0,
    size_field: SizeField | None = None,
) -> Mesh:
    """Meshes where a function is negative.

    Parameters
    ----------
    f : called with arrays of points, shape (n, 3), in world units; gives n numbers, negative
        inside, or n truth values, True inside.  NaN and what is masked are outside.  It is called
        by one thread at a time, and must give the same answer for the same point every time.
        What it raises ends the run and is raised here.
    bounds : ((x0, y0, z0), (x1, y1, z1)), or these six numbers: a box, beyond which all is
        outside
    size : the long edge of the lattice (default: a 64th of the longest side of the box)
    batch : how many points `f` is called with at most; the mesh is the same for any number
    margin, method, cuts, guarantee, threads, order, curved, optimise, features, grade,
        size_field : as `mesh_image` has them

    Raises
    ------
    ValueError, MemoryError : as `mesh_image`
    """
    if not callable(f):
        raise ValueError("f is a function of points, and negative inside")
    low, high = _arguments.bounds(bounds)
    return _told(_certet.mesh_function(
        _arguments.signs(f), low, high, _arguments.batch(batch), _arguments.size(size),
        _arguments.whole("margin", margin),
        _options(method, cuts, guarantee, threads, order, curved, optimise, features, grade,
                 size_field)))


def mesh_surface(
    points: ArrayLike,
    triangles: ArrayLike,
    *,
    size: float | None = None,
    repair: bool = False,
    margin: int = 2,
    method: Method | None = None,
    cuts: Cuts = "bisect",
    guarantee: Guarantee | None = None,
    threads: int = 0,
    order: Literal[1, 2] = 1,
    curved: bool = False,
    optimise: bool | float = False,
    features: float | Literal["auto", "off"] = "auto",
    grade: int = 0,
    size_field: SizeField | None = None,
) -> Mesh:
    """Meshes the inside of a closed surface.

    Corners that differ by rounding, repeated triangles, T-junctions, walls stored once and
    patches that run the wrong way around are mended, and `Mesh.notes` says what was done.

    Parameters
    ----------
    points : shape (n, 3), in world units
    triangles : shape (m, 3), numbers of points, anticlockwise seen from outside
    size : the long edge of the lattice (default: a 64th of the longest side, or less where the
        solid is thin, as far as some 4 million tetrahedra)
    repair : of an open surface, mesh what it winds around by more than one half (the
        generalised winding number); `Mesh.notes` says how many holes that closed
    margin, method, cuts, guarantee, threads, order, curved, optimise, features, grade,
        size_field : as `mesh_image` has them

    Raises
    ------
    ValueError : also for an open surface, unless it is to be repaired, or where the winding
        number does not tell inside from outside
    MemoryError : as `mesh_image`
    """
    return _told(_certet.mesh_surface(
        _arguments.points(points), _arguments.triangles(triangles), _arguments.size(size),
        _arguments.whole("margin", margin), bool(repair),
        _options(method, cuts, guarantee, threads, order, curved, optimise, features, grade,
                 size_field)))


def mesh_solids(
    solids: Mapping[str, Solid | Callable[[NDArray[np.float64]], ArrayLike]
                    | tuple[ArrayLike, ArrayLike] | str],
    *,
    bounds: Sequence[Sequence[float]] | None = None,
    priority: Sequence[str] = (),
    keep_labels: Sequence[str] = (),
    size: float | None = None,
    repair: bool = False,
    margin: int = 2,
    method: Method | None = None,
    cuts: Cuts = "bisect",
    guarantee: Guarantee | None = None,
    threads: int = 0,
    order: Literal[1, 2] = 1,
    curved: bool = False,
    optimise: bool | float = False,
    features: float | Literal["auto", "off"] = "auto",
    grade: int = 0,
    size_field: SizeField | None = None,
) -> Mesh:
    """Meshes several solids as the materials of one mesh, cut apart where they meet.

        certet.mesh_solids({"skull": (points, triangles), "brain": (more_points, more_triangles)})

    They may overlap: what is in several of them belongs to the strongest.  A wall that two have in
    common is one interface.  `Mesh.labels` are 1, 2, … in the order of the dictionary, or the next
    after those that are kept, and `Mesh.names` their names.

    Parameters
    ----------
    solids : by their names, each a `Solid`, a pair (points, triangles), as `mesh_surface` takes,
        a function that is negative inside, as `mesh_function` does, or a shape or formula
    bounds : ((x0, y0, z0), (x1, y1, z1)): a box that cuts off functions and formulas, if there
        are any
    priority : names, the strongest first; the others are weaker (default: the last solid is the
        strongest)
    keep_labels : names of solids made of images whose labels are materials each, and keep their
        numbers
    size : the long edge of the lattice (default: the spacing of the first image or, without one, a
        64th of the longest side of the box around all)
    repair : of surfaces, as `mesh_surface` has it
    margin, method, cuts, guarantee, threads, order, curved, optimise, features, grade,
        size_field : as `mesh_image` has them; with the paper's methods the
        solids are meshed as one, and a tetrahedron has the label at its centre

    Raises
    ------
    ValueError, MemoryError : as `mesh_function` and `mesh_surface`
    """
    kept = list(keep_labels)
    for name in kept:
        if name not in solids:
            raise ValueError(f"keep_labels names {name!r}, which is no solid")
    inner = [(name, _one_of_several(name, one, bounds, repair), name in kept)
             for name, one in solids.items()]
    return _told(_certet.mesh_solids(inner, list(priority), _arguments.size(size),
                                     _arguments.whole("margin", margin),
                                     _options(method, cuts, guarantee, threads, order, curved, optimise, features, grade,
                 size_field)))


def _mesh_solid(
    solid: Solid,
    *,
    size: float | None = None,
    margin: int = 2,
    method: Method | None = None,
    cuts: Cuts = "bisect",
    guarantee: Guarantee | None = None,
    threads: int = 0,
    order: Literal[1, 2] = 1,
    curved: bool = False,
    optimise: bool | float = False,
    features: float | Literal["auto", "off"] = "auto",
    grade: int = 0,
    size_field: SizeField | None = None,
) -> Mesh:
    return _told(_certet.mesh_solid(solid._inner, _arguments.size(size),
                                    _arguments.whole("margin", margin),
                                    _options(method, cuts, guarantee, threads, order, curved, optimise, features, grade,
                 size_field)))


def _one_of_several(name: str, solid: Any, bounds: Sequence[Sequence[float]] | None,
                    repair: bool) -> _certet.Solid:
    if isinstance(solid, Solid):
        return solid._inner
    if not (callable(solid) or isinstance(solid, (str, tuple))):
        raise ValueError(f"{name!r} is neither a Solid nor a function, a pair (points, triangles), "
                         "a shape or a formula")
    if isinstance(solid, tuple):
        return _inner_solid(name, solid, {"repair": repair})
    return _inner_solid(name, solid, {} if bounds is None else {"bounds": bounds})


def _inner_solid(name: str, shape: Any, options: dict[str, Any]) -> _certet.Solid:
    if isinstance(shape, str):
        return _solid_of_text(shape, **options)
    if callable(shape):
        if "bounds" not in options:
            raise ValueError(f"the function {name!r} needs bounds")
        return _solid_of_function(shape, **options)
    if isinstance(shape, tuple) and len(shape) == 2:
        return _solid_of_surface(name, *shape, **options)
    return _solid_of_image(shape, **options)


def _solid_of_text(text: str, *, bounds: Any = None) -> _certet.Solid:
    return _certet.solid_of_text(text, None if bounds is None else _arguments.bounds(bounds))


def _solid_of_function(function: Callable[[NDArray[np.float64]], ArrayLike], *,
                       bounds: Any, batch: int = 100_000) -> _certet.Solid:
    low, high = _arguments.bounds(bounds)
    return _certet.solid_of_function(_arguments.signs(function), low, high,
                                     _arguments.batch(batch))


def _solid_of_surface(name: str, points: ArrayLike, triangles: ArrayLike, *,
                      repair: bool = False) -> _certet.Solid:
    return _certet.solid_of_surface(name, _arguments.points(points),
                                    _arguments.triangles(triangles), bool(repair))


def _solid_of_image(
    array: ArrayLike,
    *,
    spacing: float | Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike | None = None,
    labels: int | Iterable[int | tuple[int, int]] | None = None,
    iso: float | tuple[float | None, float | None] | None = None,
    smooth: float | None = None,
    merge: Mapping[int | tuple[int, int], int | str] | None = None,
) -> _certet.Solid:
    if iso is not None and not (labels is None and merge is None and smooth is None):
        raise ValueError("labels, merge and smooth go with labels, not with iso")
    ranges = _arguments.labels(labels)
    levels, merges = _arguments.levels(iso), _arguments.merges(merge)
    return _certet.solid_of_image(
        _arguments.voxels(array, ranges, merges, gray=levels is not None),
        _arguments.three("spacing", spacing, one_will_do=True),
        _arguments.three("origin", origin), _arguments.direction(direction), ranges, levels,
        None if smooth is None else float(smooth), merges)


def _told(inner: _certet.Mesh) -> Mesh:
    """The mesh, after warnings of what it has not kept, which point at the user's line."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for sentence in inner.losses:
        warnings.warn(sentence, LossWarning, stacklevel=level)
    for sentence in inner.warnings:
        warnings.warn(sentence, stacklevel=level)
    return Mesh(inner)


def _quality(found: dict[str, Any]) -> Quality:
    return Quality(**{**found, "histogram": np.asarray(found["histogram"], np.uint64)})


def _distance(greatest: float, rms: float, at: list[float], points: int) -> Distance:
    return Distance(greatest, rms, np.asarray(at), points)


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


def _warn(sentences: Iterable[str]) -> None:
    """Warns as from the line that called this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for sentence in sentences:
        warnings.warn(sentence, stacklevel=level)


def _inner(mesh: Any) -> Any:
    if not isinstance(mesh, (Mesh, FileMesh)):
        raise ValueError(f"mesh is a certet.Mesh or a certet.FileMesh, not a {type(mesh).__name__}")
    return mesh._inner


def _options(method: str | None, cuts: str, guarantee: str | None, threads: int,
             order: int = 1, curved: bool = False,
             optimise: bool | float = False,
             features: float | str = "auto", grade: int = 0,
             sizes: SizeField | None = None) -> _certet.Options:
    if order not in (1, 2):
        raise ValueError(f"order is 1 or 2, not {order!r}")
    if curved and order != 2:
        raise ValueError("curved goes with order=2")
    if cuts not in ("bisect", "midpoint"):
        raise ValueError(f"cuts is 'bisect' or 'midpoint', not {cuts!r}")
    if guarantee not in (None, "angles", "embedding"):
        raise ValueError(f"guarantee is 'angles' or 'embedding', not {guarantee!r}")
    if method is None:
        method = "midpoint" if cuts == "midpoint" else guarantee or "key"
    elif (cuts, guarantee) != ("bisect", None):
        raise ValueError("method says all that cuts and guarantee do: give one or the others")
    if optimise is not False and optimise is not True and not 0 < optimise <= 60:
        raise ValueError(f"optimise is an angle of at most 60 degrees, or True, not {optimise!r}")
    angle = None if features in ("auto", "off") else _arguments.angle("features", features)
    levels = _arguments.whole("grade", grade)
    if levels not in (0, 1, 2, 3):
        raise ValueError(f"grade is a number of levels from 0 to 3, not {grade!r}")
    field = _sizes.size_field(sizes)
    if field is not None and levels == 0:
        levels = 3
    if levels and (optimise or angle is not None):
        raise ValueError("vertices move where all tetrahedra are of one size: grade and size_field do "
                         "not go with optimise or an angle for features")
    return _certet.Options(_arguments.word("method", method), _arguments.whole("threads", threads),
                           int(order), bool(curved),
                           25.0 if optimise is True else float(optimise), features == "auto", angle,
                           levels, field)
