"""Tetrahedral meshes with proven angles, by isosurface stuffing.

    import certet
    mesh = certet.mesh(labels, spacing=(1, 1, 1), size=1.5)
    mesh.points, mesh.tets, mesh.labels          # NumPy arrays that share the mesh's memory
    certet.write(mesh, "brain.vtu")

`mesh` makes one of voxels, of a function that is negative inside, of closed triangles, or of several
solids; so do `mesh_image`, `mesh_function`, `mesh_surface` and `mesh_solids`, each for one
of these, and `MeshOptions` are what all of them take.  A `Solid` is made of any of them, and `a & b`,
`a | b` and `a - b` of two solids.
`write`, `read`, `check`, `interfaces`, `patches`, `inside`, `quality` and `voxelise` do what they
say.  They run on all cores without Python's lock; Ctrl-C stops them.  What they refuse is a
`ValueError` with one sentence, a lattice or mesh that is too large a `MemoryError`.
"""

from __future__ import annotations

from . import _certet
from ._files import check, interfaces, patches, quality, read, voxelise, write
from ._meshes import FileMesh, Mesh
from ._meshing import mesh, mesh_function, mesh_image, mesh_solids, mesh_surface
from ._options import MeshOptions
from ._results import (CheckReport, Curve, Distance, Distances, Dropped, Features, Interface,
                       LossWarning, Optimised, Patch, Pieces, Quality, Warp)
from ._solids import Solid, distance, inside

__all__ = ["CheckReport", "Curve", "Distance", "Distances", "Dropped", "Features", "FileMesh",
           "Interface", "LossWarning", "Mesh", "MeshOptions", "Optimised", "Patch", "Pieces",
           "Quality", "Solid", "Warp", "check", "distance", "inside", "interfaces", "mesh",
           "mesh_function", "mesh_image", "mesh_solids", "mesh_surface", "patches", "quality",
           "read", "voxelise", "write"]
__version__: str = _certet.version

for _name in __all__:  # by the name that users know; so meshes are pickled
    globals()[_name].__module__ = __name__
del _name
