"""Meshes that go to files and come back."""

import pathlib
import tempfile

import certet


def read_back(case, mesh, names):
    """What is read of the mesh from a file of each name; written again, it is that file to the byte."""
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            file = pathlib.Path(folder) / name
            certet.write(mesh, file)
            read = certet.read(file)
            yield read
            again = file.with_stem("again")
            certet.write(read, again)
            case.assertEqual(again.read_bytes(), file.read_bytes())
