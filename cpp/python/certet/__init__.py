"""Tetrahedral meshes with proven angles, by isosurface stuffing.

    import certet
    mesh = certet.mesh_image(labels, spacing=(1, 1, 1), size=1.5)
    mesh.points, mesh.tets, mesh.labels          # NumPy arrays that share the mesh's memory
    mesh.to_meshio().write("brain.vtu")

Three functions make meshes: `mesh_image` of voxels, `mesh_function` of a function that is
negative inside, `mesh_surface` of closed triangles.  They run on all cores without Python's
lock; Ctrl-C stops them.  What they refuse is a `ValueError` with one sentence, a lattice or
mesh that is too large a `MemoryError`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _certet

__all__ = ["Mesh", "Quality", "mesh_function", "mesh_image", "mesh_surface"]
__version__: str = _certet.version

Cuts = Literal["bisect", "midpoint"]
Guarantee = Literal["pieces", "angles", "embedding"]


class Quality(NamedTuple):
    """What was measured of a mesh; angles in degrees, the volume in world units cubed."""

    tets: int
    volume: float
    min_dihedral: float
    max_dihedral: float
    histogram: NDArray[np.uint64]
    """Shape (36,): all six dihedral angles of each tetrahedron, in bins of 5 degrees."""
    theorem: str
    """The theorem of the certificate for such meshes; it covers this one where `holds`."""
    proven_min: float
    proven_max: float
    holds: bool
    """Whether all tetrahedra are positive and all angles within the proven bounds: exactly in
    the lattice, and to a thousandth of a degree in the world, where no two points coincide."""


class Mesh:
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
        """Shape (m,): the label of each tetrahedron; None but for images of labels."""
        return self._inner.labels

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
    def guarantee(self) -> Guarantee:
        """The thresholds that were used in the end."""
        return self._inner.guarantee

    @property
    def notes(self) -> list[str]:
        """What was done to a surface so that it bounds a solid, a sentence each."""
        return list(self._inner.notes)

    @property
    def checksum(self) -> int:
        """64 bits that tell whether two meshes are the same; as `certet mesh --json` says."""
        return self._inner.checksum()

    def quality(self) -> Quality:
        """Measures every tetrahedron, in exact and in world coordinates."""
        found = self._inner.quality()
        return Quality(**{**found, "histogram": np.asarray(found["histogram"], np.uint64)})

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with the cell data `label`, if there are labels."""
        import meshio

        data = {} if self.labels is None else {"label": [self.labels]}
        return meshio.Mesh(self.points, [("tetra", self.tets)], cell_data=data)

    def __repr__(self) -> str:
        return f"<certet.Mesh of {len(self.points)} points and {len(self.tets)} tetrahedra>"


def mesh_image(
    array: ArrayLike,
    *,
    spacing: Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike | None = None,
    labels: Iterable[int | tuple[int, int]] | None = None,
    iso: float | None = None,
    size: float | None = None,
    margin: int = 2,
    cuts: Cuts = "bisect",
    guarantee: Guarantee = "pieces",
    threads: int = 0,
) -> Mesh:
    """Meshes voxels: chosen labels, or where a grayscale image is above `iso`.

    Parameters
    ----------
    array : shape (nx, ny, nz)
        The centre of voxel [i, j, k] is `origin + direction @ (spacing * (i, j, k))`.  Arrays
        of SimpleITK have their axes the other way round: pass `a.T`.  Whole numbers are
        labels; with `iso` any real numbers will do.  Beyond the image all is outside.
    spacing, origin : 3 numbers, in world units
    direction : shape (3, 3), orthonormal; a left-handed one is welcome (default: identity)
    labels : labels and pairs (first, last) of them that make the solid (default: all but 0)
    iso : the level; then `labels` must be None
    size : the long edge of the lattice, in world units (default: the smallest spacing)
    margin : cells of the lattice around the solid, at least 1
    cuts : "bisect" finds the surface along every edge, "midpoint" cuts edges in the middle
        (angles between 30 and 135 degrees)
    guarantee : "pieces": no tetrahedra overlap, the surface is a manifold, and no piece of the
        samples is lost, cut or joined to another; "angles" and "embedding": the paper's rule
        with either of its thresholds; see the README
    threads : 0 takes all cores; the mesh does not depend on it

    Raises
    ------
    ValueError : voxels that are no labels, an impossible geometry, nothing inside
    MemoryError : more than memory or the coordinate range allow
    """
    if labels is not None and iso is not None:
        raise ValueError("labels and iso exclude each other")
    ranges = [(r, r) if np.isscalar(r) else tuple(r) for r in labels or ()]
    if labels is not None and not ranges:
        raise ValueError("labels is empty: no voxel is chosen")
    axes = np.eye(3) if direction is None else np.asarray(direction, float)
    return Mesh(_certet.mesh_image(np.asarray(array), _three(spacing), _three(origin),
                                   axes.tolist(), ranges, iso, _size(size), margin,
                                   _options(cuts, guarantee, threads)))


def mesh_function(
    f: Callable[[NDArray[np.float64]], ArrayLike],
    bounds: Sequence[Sequence[float]],
    size: float | None = None,
    *,
    margin: int = 2,
    cuts: Cuts = "bisect",
    guarantee: Guarantee = "pieces",
    threads: int = 0,
) -> Mesh:
    """Meshes where a function is negative.

    Parameters
    ----------
    f : called with arrays of points, shape (n, 3), in world units; gives n numbers, negative
        inside.  NaN is outside.  It is called by one thread at a time, and must give the same
        answer for the same point every time.  What it raises ends the run and is raised here.
    bounds : ((x0, y0, z0), (x1, y1, z1)): a box, beyond which all is outside
    size : the long edge of the lattice (default: a 64th of the longest side of the box)
    margin, cuts, guarantee, threads : as `mesh_image` has them

    Raises
    ------
    ValueError, MemoryError : as `mesh_image`
    """
    low, high = bounds
    return Mesh(_certet.mesh_function(f, _three(low), _three(high), _size(size), margin,
                                      _options(cuts, guarantee, threads)))


def mesh_surface(
    points: ArrayLike,
    triangles: ArrayLike,
    *,
    size: float | None = None,
    repair: bool = False,
    margin: int = 2,
    cuts: Cuts = "bisect",
    guarantee: Guarantee = "pieces",
    threads: int = 0,
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
    repair : close the holes of an open surface
    margin, cuts, guarantee, threads : as `mesh_image` has them

    Raises
    ------
    ValueError : also for an open surface, unless it is to be repaired
    MemoryError : as `mesh_image`
    """
    return Mesh(_certet.mesh_surface(np.asarray(points, float), np.asarray(triangles, np.int64),
                                     _size(size), margin, repair,
                                     _options(cuts, guarantee, threads)))


def _three(numbers: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = numbers
    return float(x), float(y), float(z)


def _size(size: float | None) -> float:
    """The library takes 0 for its own choice; a user who writes 0 is mistaken."""
    if size is None:
        return 0.0
    if not size > 0:
        raise ValueError(f"size must be a positive number, not {size}")
    return float(size)


def _options(cuts: str, guarantee: str, threads: int) -> _certet.Options:
    if cuts not in ("bisect", "midpoint"):
        raise ValueError(f"cuts is 'bisect' or 'midpoint', not {cuts!r}")
    if guarantee not in ("pieces", "angles", "embedding"):
        raise ValueError(f"guarantee is 'pieces', 'angles' or 'embedding', not {guarantee!r}")
    return _certet.Options(cuts == "midpoint", guarantee, threads)
