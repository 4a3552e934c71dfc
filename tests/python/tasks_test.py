"""The page of the commonest tasks: every answer is short, and runs."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import warnings

import certet
import numpy as np

PAGE = pathlib.Path(os.environ["CERTET_EXAMPLES"]).parent / "docs" / "tasks.md"
CORNERS = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.4, 0.6)])
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = np.array([t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))])


def answers(language):
    """The blocks of the page in a language."""
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def segmentation():
    """A ball of two labels and a bead of a third."""
    x, y, z = np.indices((30, 30, 30)) - 14.5
    radius = np.sqrt(x**2 + y**2 + z**2)
    labels = np.where(radius < 6, 2, np.where(radius < 12, 1, 0)).astype(np.uint8)
    labels[np.sqrt((x - 8)**2 + y**2 + z**2) < 3] = 3
    return labels


def scan():
    """Two balls of gray, one of them small."""
    x, y, z = np.indices((24, 24, 24)) - 9.5
    far = np.minimum(np.sqrt(x**2 + y**2 + z**2) - 7,
                     np.sqrt((x - 11)**2 + (y - 11)**2 + (z - 11)**2) - 2)
    return (300 - 40 * far).astype(np.int16)


def write_nrrd(file, array):
    kind = {"uint8": "uint8", "int16": "int16"}[array.dtype.name]
    head = (f"NRRD0004\ntype: {kind}\ndimension: 3\nsizes: {' '.join(map(str, array.shape))}\n"
            "spacings: 1 1 1\nencoding: raw\nendian: little\n\n")
    file.write_bytes(head.encode() + array.tobytes(order="F"))


def write_stl(file, triangles):
    lines = ["solid part"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {} {} {}".format(*CORNERS[corner]) for corner in triangle]
        lines += ["endloop", "endfacet"]
    file.write_text("\n".join([*lines, "endsolid part", ""]))


class Tasks(unittest.TestCase):
    def test_ten_of_each_in_two_lines(self):
        commands, python = answers("sh"), answers("python")[1:]
        self.assertEqual((len(commands), len(python)), (10, 10))
        for answer in commands + python:
            self.assertLessEqual(answer.count("\n"), 2, answer)

    def test_commands(self):
        path = os.path.dirname(os.environ["CERTET"]) + os.pathsep + os.environ["PATH"]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_nrrd(folder / "labels.nrrd", segmentation())
            write_nrrd(folder / "ct.nrrd", scan())
            write_stl(folder / "part.stl", TRIANGLES)
            write_stl(folder / "holes.stl", TRIANGLES[1:])
            (folder / "names.txt").write_text("1 outer\n2 core\n3 bead\n")
            for line in "".join(answers("sh")).splitlines():
                done = subprocess.run(line, shell=True, cwd=folder, env={**os.environ, "PATH": path},
                                      text=True, capture_output=True)
                self.assertEqual(done.returncode, 0, f"{line}\n{done.stderr}")
                for written in re.findall(r"-o (\S+)", line):
                    self.assertGreater((folder / written).stat().st_size, 0, line)

    def test_python(self):
        names = {"labels": segmentation(), "ct": scan(), "points": CORNERS, "triangles": TRIANGLES}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            os.chdir(folder)
            try:
                for answer in answers("python"):
                    with self.subTest(answer):
                        exec(answer, names)  # what the page tells users to write
            finally:
                os.chdir(before)
        self.assertEqual(set(names["tissue"].names.values()), {"tissue"})
        self.assertEqual(names["bone"].pieces().by_faces, 1)
        self.assertEqual(names["bone"].dropped.pieces, 1)
        self.assertEqual(set(np.unique(names["two"].labels)), {1, 2})
        # A cube has faces along those of the lattice: its counts go in steps.
        self.assertAlmostEqual(len(names["coarse"].tets) / 20_000, 1, delta=0.15)
        self.assertEqual(names["curved"].order, 2)
        self.assertGreater(names["inlet"][0], 100)
        for name in ("mesh", "bone", "part", "mended", "ball", "hollow", "graded", "half"):
            self.assertEqual(certet.check(names[name]).failures, [], name)


if __name__ == "__main__":
    unittest.main()
