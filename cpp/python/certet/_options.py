"""How a mesh is made, whatever the shape."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Literal, TypedDict, TypeVar, Union

from . import _arguments, _certet, _progress, _sizes
from ._sizes import SizeField

Cuts = Literal["bisect", "midpoint"]
Guarantee = Literal["angles", "embedding"]
Method = Literal["embedded", "angles", "embedding", "midpoint", "key"]
Follow = Callable[[str, int, int], Any]


class MeshOptions(TypedDict, total=False):
    """The options that `mesh` and all of its kind take, whatever the shape.

    Parameters
    ----------
    target_tets : in the place of `size`: it is found, so that there are about so many tetrahedra,
        within 2 % or as near as 12 tries come
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
    keep : "largest", a number of pieces, or "percolating:x", y or z: only the largest pieces by
        faces, or those that reach from one end to the other along that axis of the lattice, are
        in the mesh; `Mesh.dropped` tells of the others
    patches : names of parts of the boundary, as `Mesh.name_patches` takes them
    progress : True shows a bar, by tqdm where that is installed; or a function that is called now
        and then with the stage ("sample", "cut", "warp", "count" or "emit"), how many layers of it
        are done, and how many there are.  What it raises ends the run and is raised here
    """

    target_tets: int | None
    margin: int
    method: Method | None
    cuts: Cuts
    guarantee: Guarantee | None
    threads: int
    order: Literal[1, 2]
    curved: bool
    optimise: bool | float
    features: float | Literal["auto", "off"]
    grade: int
    size_field: SizeField | None
    keep: str | int | None
    patches: Mapping[str, Union[str, tuple[str, float]]] | None
    progress: bool | Follow


DEFAULTS: dict[str, Any] = {
    "target_tets": None, "margin": 2, "method": None, "cuts": "bisect",
    "guarantee": None, "threads": 0, "order": 1, "curved": False, "optimise": False,
    "features": "auto", "grade": 0, "size_field": None, "keep": None, "patches": None,
    "progress": False}

_Function = TypeVar("_Function", bound=Callable[..., Any])


def takes_mesh_options(function: _Function) -> _Function:
    """Has `help` and completion show the options by name."""
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    shared = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default,
                                annotation=MeshOptions.__annotations__[name])
              for name, default in DEFAULTS.items() if name not in signature.parameters]
    function.__signature__ = signature.replace(parameters=own + shared)  # type: ignore[attr-defined]
    return function


def place_of(size: Any, options: Mapping[str, Any]) -> tuple[float, int]:
    """Size, 0 for the library's own choice, and margin."""
    for name in options:
        if name not in DEFAULTS:
            raise TypeError(f"{name!r} is no option of a mesh; these are {', '.join(DEFAULTS)}")
    if size is not None and options.get("target_tets") is not None:
        raise ValueError("target_tets finds the size: give one or the other")
    return _arguments.size(size), _arguments.whole("margin", options.get("margin", 2))


def library_options(options: Mapping[str, Any]) -> _certet.Options:
    """The options as the library takes them."""
    all_of = {**DEFAULTS, **options}
    order, curved, features = (all_of[name] for name in ("order", "curved", "features"))
    if order not in (1, 2):
        raise ValueError(f"order is 1 or 2, not {order!r}")
    if curved and order != 2:
        raise ValueError("curved goes with order=2")
    angle = None if features in ("auto", "off") else _arguments.angle("features", features)
    optimise = _goal(all_of["optimise"])
    levels, field = _grading(all_of["grade"], all_of["size_field"])
    if levels and (optimise or angle is not None):
        raise ValueError("vertices move where all tetrahedra are of one size: grade and size_field "
                         "do not go with optimise or an angle for features")
    target, keep = all_of["target_tets"], all_of["keep"]
    return _certet.Options(
        _method(all_of["method"], all_of["cuts"], all_of["guarantee"]),
        _arguments.whole("threads", all_of["threads"]), int(order), bool(curved), optimise,
        features == "auto", angle, levels, field, None if keep is None else _arguments.keep(keep),
        0 if target is None else _arguments.count("target_tets", target),
        _progress.follower(all_of["progress"]))


def _method(method: Any, cuts: Any, guarantee: Any) -> str:
    if cuts not in ("bisect", "midpoint"):
        raise ValueError(f"cuts is 'bisect' or 'midpoint', not {cuts!r}")
    if guarantee not in (None, "angles", "embedding"):
        raise ValueError(f"guarantee is 'angles' or 'embedding', not {guarantee!r}")
    if method is None:
        return "midpoint" if cuts == "midpoint" else guarantee or "key"
    if (cuts, guarantee) != ("bisect", None):
        raise ValueError("method says all that cuts and guarantee do: give one or the others")
    return _arguments.word("method", method)


def _goal(optimise: Any) -> float:
    """Degrees; 0: vertices stay."""
    if optimise is True:
        return 25.0
    if optimise is not False and not 0 < optimise <= 60:
        raise ValueError(f"optimise is an angle of at most 60 degrees, or True, not {optimise!r}")
    return float(optimise)


def _grading(grade: Any, size_field: Any) -> tuple[int, _certet.SizeField | None]:
    levels = _arguments.whole("grade", grade)
    if levels not in (0, 1, 2, 3):
        raise ValueError(f"grade is a number of levels from 0 to 3, not {grade!r}")
    field = _sizes.size_field(size_field)
    return (3 if field is not None and levels == 0 else levels), field
