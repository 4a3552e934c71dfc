"""From a shape to a mesh."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _certet
from ._meshes import Mesh
from ._options import MeshOptions, library_options, place_of, takes_mesh_options
from ._results import LossWarning
from ._solids import Solid, inner_solid
from ._warn import warn

if TYPE_CHECKING:
    from typing import Unpack


def mesh(shape: Any, **options: Any) -> Mesh:
    """Meshes a shape, by what it is.

    Parameters
    ----------
    shape : a function that is negative inside, as `mesh_function` takes; a pair (points,
        triangles), as `mesh_surface` does; a dictionary of these, as `mesh_solids` does; an
        array of voxels, as `mesh_image` does; or a `Solid`, with `size` and the options of
        `MeshOptions`
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


@takes_mesh_options
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
    crop: Sequence[Sequence[float]] | Sequence[float] | None = None,
    size: float | None = None,
    **options: Unpack[MeshOptions],
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
    crop : ((x0, y0, z0), (x1, y1, z1)), or these six numbers, in world units: a box, of which alone
        the solid is meshed.  The lattice is that of the whole image
    size : the long edge of the lattice, in world units (default: the smallest spacing)
    options : those of `MeshOptions`

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
        None if smooth is None else float(smooth), merges,
        None if crop is None else _arguments.bounds(crop), *place_of(size, options),
        library_options(options)), options)


@takes_mesh_options
def mesh_function(
    f: Callable[[NDArray[np.float64]], ArrayLike],
    bounds: Sequence[Sequence[float]] | Sequence[float],
    size: float | None = None,
    *,
    batch: int = 100_000,
    **options: Unpack[MeshOptions],
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
    options : those of `MeshOptions`

    Raises
    ------
    ValueError, MemoryError : as `mesh_image`
    """
    if not callable(f):
        raise ValueError("f is a function of points, and negative inside")
    low, high = _arguments.bounds(bounds)
    return _told(_certet.mesh_function(
        _arguments.signs(f), low, high, _arguments.batch(batch),
        *place_of(size, options), library_options(options)), options)


@takes_mesh_options
def mesh_surface(
    points: ArrayLike,
    triangles: ArrayLike,
    *,
    repair: bool = False,
    size: float | None = None,
    **options: Unpack[MeshOptions],
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
    options : those of `MeshOptions`

    Raises
    ------
    ValueError : also for an open surface, unless it is to be repaired, or where the winding
        number does not tell inside from outside
    MemoryError : as `mesh_image`
    """
    return _told(_certet.mesh_surface(
        _arguments.points(points), _arguments.triangles(triangles), *place_of(size, options),
        bool(repair), library_options(options)), options)


@takes_mesh_options
def mesh_solids(
    solids: Mapping[str, Solid | Callable[[NDArray[np.float64]], ArrayLike]
                    | tuple[ArrayLike, ArrayLike] | str],
    *,
    bounds: Sequence[Sequence[float]] | None = None,
    priority: Sequence[str] = (),
    keep_labels: Sequence[str] = (),
    repair: bool = False,
    size: float | None = None,
    **options: Unpack[MeshOptions],
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
    options : those of `MeshOptions`; with the paper's methods the solids are meshed as one, and a
        tetrahedron has the label at its centre

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
    return _told(_certet.mesh_solids(inner, list(priority), *place_of(size, options),
                                     library_options(options)), options)


def _mesh_solid(solid: Solid, *, size: float | None = None,
                **options: Unpack[MeshOptions]) -> Mesh:
    return _told(_certet.mesh_solid(solid._inner, *place_of(size, options),
                                    library_options(options)), options)


def _one_of_several(name: str, solid: Any, bounds: Sequence[Sequence[float]] | None,
                    repair: bool) -> _certet.Solid:
    if isinstance(solid, Solid):
        return solid._inner
    if not (callable(solid) or isinstance(solid, (str, tuple))):
        raise ValueError(f"{name!r} is neither a Solid nor a function, a pair (points, triangles), "
                         "a shape or a formula")
    if isinstance(solid, tuple):
        return inner_solid(name, solid, {"repair": repair})
    return inner_solid(name, solid, {} if bounds is None else {"bounds": bounds})


def _told(inner: _certet.Mesh, options: Mapping[str, Any]) -> Mesh:
    """The mesh, with the names of its patches, after warnings of what it has not kept."""
    warn(inner.losses, LossWarning)
    warn(inner.warnings)
    mesh = Mesh(inner)
    patches = options.get("patches")
    if patches:
        mesh.name_patches(patches)
    return mesh
