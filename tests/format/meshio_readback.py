"""Reads the files of certet_dump_meshes with meshio and compares every number.

usage: meshio_readback.py CERTET_DUMP_MESHES
"""

import pathlib
import subprocess
import sys
import tempfile

import meshio
import numpy


class PlainDump:
    """The numbers that a mesh file must hold."""

    def __init__(self, file):
        lines = file.read_text().splitlines()
        points, tets, labels = (int(word) for word in lines.pop(0).split())
        rows = [line.split() for line in lines]
        assert len(rows) == points + tets + labels, f"{file} is damaged"
        self.points = numpy.array([[float.fromhex(x) for x in row] for row in rows[:points]])
        self.tets = numpy.array([[int(x) for x in row] for row in rows[points : points + tets]])
        self.labels = numpy.array([int(row[0]) for row in rows[points + tets :]])


def read(file):
    mesh = meshio.read(file)
    # The boundary's triangles are another test's business.
    blocks = [block.type for block in mesh.cells]
    assert blocks[0] == "tetra" and set(blocks[1:]) <= {"triangle"}, f"{file} has {blocks}"
    name = "label" if file.suffix == ".vtu" else "medit:ref"
    labels = mesh.cell_data.get(name, [numpy.array([])])[0]
    return mesh.points, mesh.cells[0].data, labels


def compare(file, expected):
    points, tets, labels = read(file)
    # meshio reads text with numpy, which rounds as it should; binary is exact.
    assert points.dtype == numpy.float64, f"{file}: points are {points.dtype}"
    assert numpy.array_equal(points, expected.points), f"{file}: other points"
    assert numpy.array_equal(tets, expected.tets), f"{file}: other tetrahedra"
    if len(expected.labels) or file.suffix == ".vtu":
        assert numpy.array_equal(labels, expected.labels), f"{file}: other labels"
    else:
        assert (labels == 1).all(), f"{file}: more than the one region"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([sys.argv[1], folder], check=True)
        dumps = sorted(folder.glob("*.txt"))
        assert len(dumps) == 3, "meshes are missing"
        for dump in dumps:
            expected = PlainDump(dump)
            for suffix in (".vtu", ".mesh"):
                compare(dump.with_suffix(suffix), expected)
                print(f"{dump.stem}{suffix}: {len(expected.points)} points, "
                      f"{len(expected.tets)} tetrahedra agree")


main()
