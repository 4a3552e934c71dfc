"""Meshes a label image by CGAL, a program of its own: CGAL is GPL and goes into nothing else.

usage: cgal_mesh.py IMAGE.inr OUT.mesh SIZE
SIZE bounds the circumradii of tetrahedra and of the surface's triangles, in voxels.  CGAL's
optimisers against slivers (perturb, exude) run, as pygalmesh has it.  One thread.  Prints
one JSON object, {"seconds"}: from the image's file to the mesh's.
"""

import json
import sys
import time

from _pygalmesh import _generate_from_inr


def main():
    image, output, size = sys.argv[1], sys.argv[2], float(sys.argv[3])
    start = time.perf_counter()
    _generate_from_inr(image, output, min_facet_angle=25.0, max_radius_surface_delaunay_ball=size,
                       max_facet_distance=size / 4, max_circumradius_edge_ratio=2.0,
                       max_cell_circumradius=size, verbose=False, seed=1)
    print(json.dumps({"seconds": time.perf_counter() - start}))


if __name__ == "__main__":
    main()
