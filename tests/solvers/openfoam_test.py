"""OpenFOAM, on files of Gmsh's format 2.2 that gmshToFoam turns into its own: finite volumes, for which
a linear temperature is the patch test."""

import os
import re
import shutil
import subprocess
import unittest

import numpy as np
from solids import GRADIENT, Refused, SolverTest, numbers

HEAD = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
CASE = {
    "system/controlDict": ("dictionary", """
application laplacianFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 12;
"""),
    "system/fvSchemes": ("dictionary", """
ddtSchemes { default steadyState; }
gradSchemes { default leastSquares; }
divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""),
    # The faces between tetrahedra are not at right angles to what joins their centres, which is
    # corrected again and again.
    "system/fvSolution": ("dictionary", """
solvers { T { solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0; } }
SIMPLE { nNonOrthogonalCorrectors 100; }
"""),
    "constant/transportProperties": ("dictionary", "DT [0 2 -1 0 0 0 0] 1;\n"),
}


def warm(points):
    """A linear temperature."""
    return 300 + points @ (1e3 * GRADIENT[0])


def rows_of(text, bare=False):
    """The rows of the one list of a file, each its numbers, which may have no brackets."""
    body = text[re.search(r"(?m)^\d+\s*\n\(", text).end():text.rindex("\n)")]
    return [[float(word) for word in re.findall(r"[-+.\de]+", row if bare else row.partition("(")[2])]
            for row in body.strip().splitlines()]


@unittest.skipIf(shutil.which("gmshToFoam") is None, "openfoam was not found")
class OpenFoam(SolverTest):
    def run_foam(self, *command):
        run = subprocess.run(command, cwd=self.folder, text=True, capture_output=True, timeout=200,
                             env={**os.environ, "WM_PROJECT_DIR": "/usr/share/openfoam"})
        if run.returncode != 0:
            raise Refused(run.stdout[-1000:] + run.stderr)
        return run.stdout

    def put(self, name, kind, text):
        file = self.folder / name
        file.parent.mkdir(exist_ok=True, parents=True)
        file.write_text(HEAD % (kind, file.name) + text)

    def open_case(self, file):
        for name, (kind, text) in CASE.items():
            self.put(name, kind, text)
        self.run_foam("gmshToFoam", file.name)
        folder = self.folder / "constant" / "polyMesh"
        points = np.array(rows_of((folder / "points").read_text()))
        faces = np.array(rows_of((folder / "faces").read_text()), dtype=int)
        boundary = (folder / "boundary").read_text()
        patches = {name: (int(start), int(count)) for name, count, start in re.findall(
            r"(?s)(\S+)\s*\{[^}]*?nFaces\s+(\d+);\s*startFace\s+(\d+);", boundary)}
        return points, faces, self.centres(points, faces, folder), patches

    def centres(self, points, faces, folder):
        """Of each face its owner's centre: a tetrahedron has each of its points in three faces."""
        owner = np.array(rows_of((folder / "owner").read_text(), bare=True), dtype=int).ravel()
        other = np.array(rows_of((folder / "neighbour").read_text(), bare=True), dtype=int).ravel()
        cells = np.concatenate([owner, other])
        sums = np.zeros((cells.max() + 1, 3))
        np.add.at(sums, cells, points[np.concatenate([faces, faces[:len(other)]])].sum(axis=1))
        return (sums / 12)[owner]

    def patch_error(self, file):
        points, faces, centres, patches = self.open_case(file)
        # OpenFOAM takes what is given on a face for the point nearest to the cell's centre.
        corners = points[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        away = ((corners[:, 0] - centres) * normals).sum(axis=1)
        places = centres + away[:, None] * normals
        fields = ""
        for name, (start, count) in patches.items():
            values = " ".join(f"{value:.15g}" for value in warm(places[start:start + count]))
            fields += f"{name} {{ type fixedValue; value nonuniform List<scalar> {count} ({values}); }}\n"
        self.put("0/T", "volScalarField", "dimensions [0 0 0 1 0 0 0];\ninternalField uniform 300;\n"
                 f"boundaryField {{\n{fields}}}\n")
        self.run_foam("laplacianFoam")
        self.run_foam("postProcess", "-func", "writeCellCentres", "-time", "1")
        return np.abs(self.cells("1/T")[:, 0] - warm(self.cells("1/C"))).max()

    def cells(self, name):
        text = (self.folder / name).read_text()
        body = re.search(r"(?s)internalField\s+nonuniform[^(]*\(\n(.*?)\n\)", text)[1]
        return np.array([[float(word) for word in re.findall(r"[-+.\de]+", row)]
                         for row in body.splitlines()])

    def test_patch(self):
        """Printed are twelve digits, of at most 303."""
        file = self.patch("a.msh", "--format", "msh22")
        self.assertLess(self.patch_error(file), 1e-8)
        self.assertIn("Mesh OK.", self.run_foam("checkMesh"))
        lines = file.read_text().splitlines()
        tets = [n for n, line in enumerate(lines) if re.fullmatch(numbers(9), line)]
        for n in tets[::5]:  # point 1 for the last corner
            lines[n] = lines[n].rpartition(" ")[0] + " 1"
        file.write_text("\n".join(lines))
        self.assert_caught(lambda: self.patch_error(file), 1e-8)

    def test_zones(self):
        """A zone of cells for each region, a patch, and a zone of faces for the interface."""
        told = self.mesh("--material", "box=box:1,1.2,0.8", "--material", "core=sphere:0.35", "--size",
                         0.4, "--format", "msh22", "-o", "a.msh")
        for name, (kind, text) in CASE.items():
            self.put(name, kind, text)
        folder = self.folder / "constant" / "polyMesh"
        self.run_foam("gmshToFoam", "a.msh")
        sizes = [int(size) for size in re.findall(r"List<label>\s+(\d+)",
                                                  (folder / "cellZones").read_text())]
        self.assertEqual(sizes, [region["tets"] for region in told["regions"]])
        self.assertEqual(sum(sizes), told["mesh"]["tets"])
        self.assertIn("core\n{", (folder / "cellZones").read_text())
        self.assertIn("box-core\n{", (folder / "faceZones").read_text())
        self.assertRegex((folder / "boundary").read_text(), r"surface\s*\{")


if __name__ == "__main__":
    unittest.main()
