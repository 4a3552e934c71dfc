"""What a mesh of several regions is like, from its file alone, whoever wrote it.

Reads with meshio, counts with numpy, and shares no code with any of the meshers.
"""

from dataclasses import dataclass

import meshio
import numpy as np

FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
DIHEDRALS = ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 0, 2), (2, 3, 0, 1))
BLOCK = 500_000  # tetrahedra at a time, for the memory's sake


@dataclass
class Judgement:
    """Of one mesh; angles in degrees, volumes in world units cubed, by label."""

    tets: int
    angles: tuple
    volumes: dict
    #: Edges with more than two triangles of one region's surface, added up over the regions.
    region_edges: int
    #: The same of the interfaces, each taken for itself.
    interface_edges: int


def dihedral_range(points, tets):
    """The least and the greatest dihedral angle."""
    least, greatest = 180.0, 0.0
    for start in range(0, len(tets), BLOCK):
        corners = points[tets[start:start + BLOCK]]
        for i, j, k, l in DIHEDRALS:
            origin = corners[:, i]
            edge = corners[:, j] - origin
            first = np.cross(edge, corners[:, k] - origin)
            second = np.cross(edge, corners[:, l] - origin)
            angles = np.arctan2(np.linalg.norm(np.cross(first, second), axis=1),
                                np.einsum("ij,ij->i", first, second))
            least, greatest = min(least, angles.min()), max(greatest, angles.max())
    return float(np.degrees(least)), float(np.degrees(greatest))


def volumes(points, tets, labels):
    corners = points[tets]
    each = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    return {int(label): float(each[labels == label].sum()) for label in np.unique(labels)}


def separating_faces(tets, labels):
    """Faces between two labels: their vertices (n, 3), ascending, and the labels (n, 2) on
    their sides, ascending; 0 where no tetrahedron is."""
    faces = np.sort(np.concatenate([tets[:, face] for face in FACES]), axis=1)
    sides = np.tile(labels, 4)
    order = np.lexsort(faces.T[::-1])
    faces, sides = faces[order], sides[order]
    again = (faces[1:] == faces[:-1]).all(1)
    first = np.concatenate([[True], ~again])
    shared = np.concatenate([again, [False]])[first]
    starts = np.flatnonzero(first)
    other = np.where(shared, sides[np.minimum(starts + 1, len(sides) - 1)], 0)
    pairs = np.sort(np.stack([sides[starts], other], axis=1), axis=1)
    apart = pairs[:, 0] != pairs[:, 1]
    return faces[starts[apart]], pairs[apart]


def crowded_edges(faces, owners):
    """How many (edge, owner) have more than two of the owner's triangles."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [0, 2]], faces[:, [1, 2]]])
    owners = np.tile(owners, 3)
    _, counts = np.unique(np.column_stack([edges, owners]), axis=0, return_counts=True)
    return int((counts > 2).sum())


def judge(file):
    mesh = meshio.read(file)
    kinds = [n for n, block in enumerate(mesh.cells) if block.type == "tetra"]
    tets = np.concatenate([mesh.cells[n].data for n in kinds]).astype(np.int64)
    labels = np.concatenate([mesh.cell_data["medit:ref"][n] for n in kinds]).astype(np.int64)
    points = np.asarray(mesh.points, float)
    faces, pairs = separating_faces(tets, labels)
    inside = pairs[:, 0] != 0
    of_regions = np.concatenate([faces, faces[inside]])
    regions = np.concatenate([pairs[:, 1], pairs[inside, 0]])
    return Judgement(
        tets=len(tets), angles=dihedral_range(points, tets), volumes=volumes(points, tets, labels),
        region_edges=crowded_edges(of_regions, regions),
        interface_edges=crowded_edges(faces[inside], pairs[inside, 0] << 32 | pairs[inside, 1]))
