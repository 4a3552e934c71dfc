"""A segmentation of two labels becomes a file that Gmsh opens; every tetrahedron has its label."""
import certet
import numpy as np

grid = np.indices((40, 40, 40)) - 19.5
distance = np.sqrt((grid**2).sum(0))
labels = np.where(distance < 8, 2, np.where(distance < 16, 1, 0)).astype(np.uint8)

mesh = certet.mesh(labels, spacing=(0.5, 0.5, 0.5), method="midpoint")
quality = certet.quality(mesh)
print(f"{len(mesh.tets)} tetrahedra, {np.bincount(mesh.labels)[1:]} of each label, angles from "
      f"{quality.min_dihedral:.1f} to {quality.max_dihedral:.1f} degrees ({quality.theorem})")
certet.write(mesh, "segmentation.msh")
