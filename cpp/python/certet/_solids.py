"""Solids, of which several make others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _certet
from ._meshes import FileMesh, Mesh, inner
from ._results import Distance, Distances


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
        self._inner = inner_solid("the shape", shape, options)

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
        inner(mesh), solid._inner, _arguments.whole("threads", threads))
    return Distances(_distance(*to_shape), _distance(*to_mesh), edge, exact)


def inner_solid(name: str, shape: Any, options: dict[str, Any]) -> _certet.Solid:
    """What the library makes of a shape and its options; sentences call it by `name`."""
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


def _distance(greatest: float, rms: float, at: list[float], points: int) -> Distance:
    return Distance(greatest, rms, np.asarray(at), points)
