"""What is told of a mesh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


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


class Dropped(NamedTuple):
    """Pieces that were not to stay."""

    pieces: int
    """By faces."""
    tets: int
    volume: float
    """World units cubed."""


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
