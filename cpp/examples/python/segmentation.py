"""Meshes a segmentation of two labels, and writes what ParaView opens."""

import certet
import numpy as np

grid = np.indices((40, 40, 40)) - 19.5
distance = np.sqrt((grid**2).sum(0))
labels = np.where(distance < 8, 2, np.where(distance < 16, 1, 0)).astype(np.uint8)

mesh = certet.mesh_image(labels, spacing=(0.5, 0.5, 0.5), cuts="midpoint")
quality = mesh.quality()
print(f"{len(mesh.tets)} tetrahedra, {np.bincount(mesh.labels)[1:]} of each label, angles from "
      f"{quality.min_dihedral:.1f} to {quality.max_dihedral:.1f} degrees ({quality.theorem})")
mesh.to_meshio().write("segmentation.vtu")
