"""The label images that several programs mesh, and the files that these read."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

ATLAS = Path("/usr/share/mricron/templates/aal.nii.gz")


@dataclass
class LabelImage:
    """Labels (nx, ny, nz) of 8 bits, 0 outside, in voxels of one unit cubed; the centre of
    voxel (i, j, k) lies at (i, j, k)."""

    name: str
    labels: np.ndarray
    size: float  # how long edges are to be, about, in voxels
    finer: float  # the same of the mesh that CGAL is not asked for

    def voxels(self):
        """How many each label has, without the outside."""
        found, counts = np.unique(self.labels, return_counts=True)
        return {int(label): int(n) for label, n in zip(found, counts) if label != 0}


def balls():
    """Three balls: the second within the first, the third reaching into both."""
    shape = (64, 64, 64)
    points = np.moveaxis(np.indices(shape), 0, -1)
    labels = np.zeros(shape, np.uint8)
    for label, (centre, radius) in enumerate((((30.2, 31.1, 32.3), 20), ((26.4, 33.2, 30.1), 9),
                                              ((44.3, 30.6, 33.7), 11)), start=1):
        labels[((points - centre) ** 2).sum(-1) < radius**2] = label
    return LabelImage("three balls, 64³", labels, 1.6, 1)


def atlas():
    """The brain atlas; none where it is not there."""
    if not ATLAS.exists():
        return
    import nibabel

    labels = np.asarray(nibabel.load(ATLAS).dataobj).astype(np.uint8)
    yield LabelImage("brain atlas", labels, 4, 2)


def write_nrrd(labels, file):
    """For certet."""
    header = ("NRRD0004\ntype: uint8\ndimension: 3\n"
              f"sizes: {' '.join(map(str, labels.shape))}\nspacings: 1 1 1\nencoding: raw\n\n")
    file.write_bytes(header.encode() + labels.tobytes(order="F"))


def write_inr(labels, file):
    """For CGAL."""
    x, y, z = labels.shape
    header = (f"#INRIMAGE-4#{{\nXDIM={x}\nYDIM={y}\nZDIM={z}\nVDIM=1\nTYPE=unsigned fixed\n"
              "PIXSIZE=8 bits\nCPU=decm\nVX=1\nVY=1\nVZ=1\n")
    header += "\n" * (256 - 4 - len(header)) + "##}\n"
    file.write_bytes(header.encode() + labels.tobytes(order="F"))
