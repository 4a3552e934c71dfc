"""Node sets of .inp files, and a run of CalculiX with what their comments say."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from images import voxels, write_nrrd  # noqa: E402
from program import ProgramTest  # noqa: E402

# Corners of each face, and the places of the middle nodes between them.
FACES = {"S1": (0, 1, 2, 4, 5, 6), "S2": (0, 3, 1, 7, 8, 4), "S3": (1, 3, 2, 8, 9, 5),
         "S4": (2, 3, 0, 9, 7, 6)}


def blocks(text):
    """Keyword, its parameters and the rows behind it, without comments."""
    found = []
    for line in text.splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            keyword, *parameters = (w.strip() for w in line.split(","))
            found.append((keyword, dict(p.split("=") for p in parameters), []))
        else:
            found[-1][2].append([w.strip() for w in line.split(",") if w.strip()])
    return found


def faults(text):
    """Sets that are not the nodes of what has their name: sentences."""
    regions, surfaces, sets, elements, wrong = {}, {}, {}, {}, []
    for keyword, parameters, rows in blocks(text):
        if keyword == "*ELEMENT":
            for number, *nodes in rows:
                elements[number] = [int(n) for n in nodes]
            regions[parameters["ELSET"]] = {int(n) for row in rows for n in row[1:]}
        elif keyword == "*NSET":
            numbers = [int(n) for row in rows for n in row]
            if numbers != sorted(set(numbers)) or any(len(row) > 16 for row in rows):
                wrong.append("the set {NSET} is not in order".format(**parameters))
            sets[parameters["NSET"]] = set(numbers)
        elif keyword == "*SURFACE":
            nodes = set()
            for number, side in rows:
                element = elements[number]
                nodes |= {element[p] for p in FACES[side] if p < len(element)}
            surfaces[parameters["NAME"]] = nodes
    expected = list(surfaces.values()) + list(regions.values())
    if list(sets.values()) != expected:
        wrong.append("other nodes")
    if list(sets)[:len(surfaces)] != list(surfaces):
        wrong.append("other names")
    return wrong, regions, sets


class Sets(ProgramTest):
    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "a.nrrd", (9, 8, 7),
                   voxels((9, 8, 7), lambda i, j, k: 0 if k > 4 else 1 + int(i > 3)), kind="B")
        (self.folder / "names.txt").write_text("1 surface\n2 bone\n")

    def test_they_are_the_nodes_of_regions_and_surfaces(self):
        for order in (1, 2):
            self.mesh("a.nrrd", "-o", "a.inp", "--order", order, "--label-names", "names.txt")
            wrong, regions, sets = faults((self.folder / "a.inp").read_text())
            self.assertEqual(wrong, [])
            self.assertEqual(list(regions), ["surface", "bone"])
            # A region and a patch of one name have sets of different names.
            self.assertEqual(list(sets), ["surface", "xmin", "xmax", "ymin", "ymax", "zmin",
                                          "surface_bone", "surface_1", "bone"])

    def test_faults_are_found(self):
        """Planted: a node less, a node more, two sets exchanged."""
        self.mesh("a.nrrd", "-o", "a.inp")
        text = (self.folder / "a.inp").read_text()
        at = text.index("*NSET, NSET=xmin\n") + len("*NSET, NSET=xmin\n")
        first = text[at:].split(",")[0]
        for damaged in (text[:at] + text[at + len(first) + 2:],
                        text[:at] + "1, " + text[at:] if first != "1" else text[:at] + "2, " + text[at:],
                        text.replace("NSET=xmin", "NSET=t").replace("NSET=ymin", "NSET=xmin")):
            self.assertNotEqual(faults(damaged)[0], [])


@unittest.skipIf(shutil.which("ccx") is None, "calculix-ccx was not found")
class Calculix(ProgramTest):
    def test_it_runs_without_the_stars(self):
        """A bar of two materials that is pulled at its end: the strain is the same in both, since
        their numbers are."""
        write_nrrd(self.folder / "a.nrrd", (10, 5, 5),
                   voxels((10, 5, 5), lambda i, j, k: 1 + int(i > 4)), kind="B")
        for order in (1, 2):
            self.mesh("a.nrrd", "-o", "a.inp", "--size", 1, "--order", order, "--method", "midpoint")
            text = re.sub(r"(?m)^\*\* ", "", (self.folder / "a.inp").read_text())
            self.assertIn("*SOLID SECTION, ELSET=region_2, MATERIAL=region_2", text)
            text = text.replace("E, nu", "1000, 0.0")
            text += ("*STEP\n*STATIC\n*BOUNDARY\nxmin, 1, 1\nxmin, 2, 2\nxmin, 3, 3\nxmax, 1, 1, 0.1\n"
                     "*NODE PRINT, NSET=xmax\nU\n*END STEP\n")
            (self.folder / "run.inp").write_text(text)
            run = subprocess.run(["ccx", "run"], cwd=self.folder, capture_output=True, text=True,
                                 env={**os.environ, "OMP_NUM_THREADS": "1"})
            self.assertEqual(run.returncode, 0, run.stdout[-2000:])
            moved = [float(line.split()[1]) for line in
                     (self.folder / "run.dat").read_text().splitlines()
                     if len(line.split()) == 4 and line.split()[0].isdigit()]
            _, _, sets = faults((self.folder / "a.inp").read_text())
            self.assertEqual(len(moved), len(sets["xmax"]))
            self.assertTrue(all(abs(m - 0.1) < 1e-9 for m in moved))


if __name__ == "__main__":
    unittest.main()
