"""OpenFOAM's polyMesh: its own rules, looked at here, by VTK and by checkMesh.

The truth is the raw .vtu file of the same mesh, read byte by byte."""

import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from program import ProgramTest  # noqa: E402
from readback_test import Readback, boundary_of, interfaces_of, rotated  # noqa: E402
from readers import vtk_to_numpy  # noqa: E402

try:
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
except ImportError:
    vtkOpenFOAMReader = None

NAMES = ("boundary", "cellZones", "faceZones", "faces", "neighbour", "owner", "points")
REGIONS = {"Left__lobe____more": 3, "Left_lobe": 7, "left_lobe_12": 12}
PATCHES = ("surface", "xmax", "ymin", "ymax", "zmin")
ZONES = {"Left__lobe____more_Left_lobe": (3, 7), "Left__lobe____more_left_lobe_2": (3, 12),
         "Left_lobe_left_lobe": (7, 12)}


class PolyMesh:
    """What the files of a folder say."""

    def __init__(self, folder):
        self.text = {}
        for name in NAMES:
            head, self.text[name] = (pathlib.Path(folder) / name).read_text().split("}\n\n", 1)
            assert re.search(rf"object +{name};", head), head
        self.points = np.array(self.numbers("points")[1:]).reshape(-1, 3)
        faces = np.array(self.numbers("faces")[1:]).reshape(-1, 4).astype(int)
        assert (faces[:, 0] == 3).all()
        self.faces = faces[:, 1:]
        self.owner, self.neighbour = (np.array(self.numbers(n)[1:]).astype(int)
                                      for n in ("owner", "neighbour"))
        for name, values in (("points", self.points), ("faces", self.faces),
                             ("owner", self.owner), ("neighbour", self.neighbour)):
            assert int(self.numbers(name)[0]) == len(values), name
        found = re.findall(r"(\w+)\s*\{\s*type\s+patch;\s*nFaces\s+(\d+);\s*startFace\s+(\d+);\s*\}",
                           self.text["boundary"])
        self.patches = [(name, int(count), int(start)) for name, count, start in found]
        self.cells = {name: lists[0] for name, lists in self.zones("cellZones")}
        self.zone_faces = dict(self.zones("faceZones"))

    def numbers(self, name):
        return [float(w) for w in self.text[name].replace("(", " ").replace(")", " ").split()]

    def zones(self, file):
        for name, body in re.findall(r"(\w+)\s*\{\s*type[^}]*?;(.*?)\}", self.text[file], re.S):
            lists = []
            for count, values in re.findall(r"List<\w+>\s+(\d+)\s*\(([^)]*)\)\s*;", body):
                lists.append(np.array(values.split(), int))
                assert len(lists[-1]) == int(count)
            yield name, lists


def faults(mesh, truth):
    """What breaks OpenFOAM's rules, or is another mesh than the truth: sentences."""
    found = []
    inner = len(mesh.neighbour)
    owner, neighbour = mesh.owner, mesh.neighbour
    if not np.array_equal(mesh.points, truth.points):
        found.append("other points")
    if not (owner[:inner] < neighbour).all():
        found.append("an owner that is no less than the neighbour")
    order = list(zip(owner[:inner].tolist(), neighbour.tolist()))
    if order != sorted(order):
        found.append("faces that are not in upper triangular order")
    start = inner
    for name, count, first in mesh.patches:
        if first != start:
            found.append(f"the patch {name} does not begin where the one before ends")
        start = first + count
    if start != len(mesh.faces) or len(owner) != len(mesh.faces):
        found.append("patches that are not all faces of the boundary")
    corners = [set() for _ in truth.tets]
    counts = np.zeros(len(truth.tets), int)
    for cells in (owner, neighbour):
        np.add.at(counts, cells, 1)
        for cell, face in zip(cells.tolist(), mesh.faces[:len(cells)].tolist()):
            corners[cell].update(face)
    if (counts != 4).any():
        found.append("a cell that has not four faces")
    if [sorted(c) for c in corners] != np.sort(truth.tets, axis=1).tolist():
        found.append("other cells")
    centres = mesh.points[truth.tets].mean(axis=1)
    a, b, c = (mesh.points[mesh.faces[:, i]] for i in range(3))
    away = (a + b + c) / 3 - centres[owner]
    if not (np.einsum("ij,ij->i", np.cross(b - a, c - a), away) > 0).all():
        found.append("a face that does not look away from its owner")
    if not np.array_equal(rotated(mesh.faces[inner:]), boundary_of(truth.tets)):
        found.append("another boundary")
    labels = np.zeros(len(truth.tets), int)
    for name, cells in mesh.cells.items():
        labels[cells] = REGIONS[name]
    if not np.array_equal(labels, truth.labels):
        found.append("other regions")
    seen = []
    for name, (places, flips) in mesh.zone_faces.items():
        lesser, greater = (truth.labels[cells] for cells in (owner[places], neighbour[places]))
        lesser, greater = (np.where(flips, greater, lesser), np.where(flips, lesser, greater))
        if set(zip(lesser, greater)) != {ZONES[name]}:
            found.append(f"the zone {name} is not between its regions, seen from the lesser")
        seen.append(np.where(flips[:, None], mesh.faces[places][:, ::-1], mesh.faces[places]))
    if not np.array_equal(rotated(np.concatenate(seen)), interfaces_of(truth.tets, truth.labels)):
        found.append("other interfaces")
    return found


class Folder(Readback):
    def mesh_of(self, name="polyMesh"):
        return PolyMesh(self.make(name, "--label-names", "names.txt"))

    def test_rules(self):
        mesh = self.mesh_of()
        self.assertEqual(sorted(p.name for p in (self.folder / "polyMesh").iterdir()),
                         sorted(NAMES))
        self.assertEqual(faults(mesh, self.truth), [])
        self.assertEqual(tuple(name for name, _, _ in mesh.patches), PATCHES)
        self.assertEqual(set(mesh.zone_faces), set(ZONES))

    def test_patches_lie_where_their_names_say(self):
        mesh = self.mesh_of()
        for name, count, start in mesh.patches[1:]:
            corners = mesh.points[mesh.faces[start:start + count]]
            axis, end = "xyz".index(name[0]), name[1:]
            plane = {"min": -0.5, "max": (9, 8, 7)[axis] - 0.5}[end]
            at = np.abs(corners[:, :, axis] - plane) < 1e-3
            self.assertTrue((at.sum(axis=1) >= 1).all())
            self.assertGreater(at.all(axis=1).sum(), 0.5 * count)

    def test_faults_are_found(self):
        """Planted, one of each kind."""
        def swap_owner(mesh):
            mesh.owner[5], mesh.neighbour[5] = mesh.neighbour[5], mesh.owner[5]

        def exchange(mesh):
            for values in (mesh.owner, mesh.neighbour, mesh.faces):
                values[[20, 21]] = values[[21, 20]]

        def turn(mesh):
            mesh.faces[30] = mesh.faces[30][::-1]

        def turn_outer(mesh):
            mesh.faces[-1] = mesh.faces[-1][::-1]

        def shift_patch(mesh):
            name, count, start = mesh.patches[1]
            mesh.patches[1] = (name, count - 1, start + 1)

        def lose_face(mesh):
            mesh.faces, mesh.owner = mesh.faces[:-1], mesh.owner[:-1]

        def move_cell(mesh):
            cells = list(mesh.cells)
            one, other = mesh.cells[cells[0]], mesh.cells[cells[1]]
            mesh.cells[cells[1]] = np.append(other, one[0])
            mesh.cells[cells[0]] = one[1:]

        def flip(mesh):
            places, flips = mesh.zone_faces["Left_lobe_left_lobe"]
            flips[0] = 1 - flips[0]

        def other_point(mesh):
            mesh.faces[40, 0] = (mesh.faces[40, 0] + 7) % len(mesh.points)

        for plant in (swap_owner, exchange, turn, turn_outer, shift_patch, lose_face, move_cell,
                      flip, other_point):
            with self.subTest(plant.__name__):
                mesh = self.mesh_of()
                plant(mesh)
                self.assertNotEqual(faults(mesh, self.truth), [])

    def test_by_convert_too(self):
        self.make("a.msh", "--label-names", "names.txt")
        self.make("polyMesh", "--label-names", "names.txt")
        (self.folder / "other").mkdir()
        run = self.run_certet("convert", "a.msh", "other/polyMesh")
        self.assertEqual(run.returncode, 0, run.stderr)
        for name in NAMES:
            self.assertEqual((self.folder / "polyMesh" / name).read_bytes(),
                             (self.folder / "other" / "polyMesh" / name).read_bytes(), name)

    def test_the_same_whatever_threads_and_memory(self):
        told = self.mesh("a.nrrd", "-o", "polyMesh", "--threads", 1)
        first = {n: (self.folder / "polyMesh" / n).read_bytes() for n in NAMES}
        size = sum(map(len, first.values()))
        self.assertLess(abs(told["output"]["bytes"] / size - 1), 0.3)
        self.mesh("a.nrrd", "-o", "polyMesh/", "--threads", 3, "--max-memory",
                  told["memory"]["least"])
        for name in NAMES:
            self.assertEqual((self.folder / "polyMesh" / name).read_bytes(), first[name], name)


class Output(ProgramTest):
    """The folder appears whole, and takes the place of nothing else."""

    BALL = ("mesh", "--shape", "sphere:1", "--size", 0.3, "-o")

    def test_one_that_is_there_is_replaced(self):
        self.mesh(*self.BALL[1:], "polyMesh")
        first = (self.folder / "polyMesh" / "owner").read_bytes()
        self.mesh("--shape", "sphere:1", "--size", 0.25, "-o", "polyMesh")
        self.assertNotEqual((self.folder / "polyMesh" / "owner").read_bytes(), first)
        self.assertEqual(self.files(), ["polyMesh"])

    def test_other_folders_and_files_are_left_alone(self):
        (self.folder / "polyMesh").mkdir()
        (self.folder / "polyMesh" / "blockMeshDict").write_text("mine")
        self.assert_fails(6, ["polyMesh", "blockMeshDict"], *self.BALL, "polyMesh")
        self.assertEqual((self.folder / "polyMesh" / "blockMeshDict").read_text(), "mine")
        (self.folder / "f").mkdir()
        (self.folder / "f" / "polyMesh").write_text("mine")
        self.assert_fails(6, ["f/polyMesh", "not a folder"], *self.BALL, "f/polyMesh")
        self.assert_fails(6, ["no such folder"], *self.BALL, "constant/polyMesh")
        self.assert_fails(2, ["ten nodes"], *self.BALL, "g/polyMesh", "--order", 2)

    @unittest.skipIf(os.name != "posix", "no limits on the size of files")
    def test_a_disk_that_is_full_leaves_nothing(self):
        self.mesh(*self.BALL[1:], "polyMesh")
        before = {n: (self.folder / "polyMesh" / n).read_bytes() for n in NAMES}
        faces = len(before["faces"])
        for limit in (faces // 3, faces - 100):
            self.assert_fails(6, ["polyMesh"], *self.BALL, "polyMesh", preexec_fn=lambda: (
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))))
            for name in NAMES:
                self.assertEqual((self.folder / "polyMesh" / name).read_bytes(), before[name])


class Case(Readback):
    """A case around the mesh."""

    CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1;
"""

    def setUp(self):
        super().setUp()
        (self.folder / "system").mkdir()
        (self.folder / "constant").mkdir()
        (self.folder / "system" / "controlDict").write_text(self.CONTROL)
        for name, sections in (("fvSchemes", ("ddtSchemes", "gradSchemes", "divSchemes",
                                              "laplacianSchemes", "interpolationSchemes",
                                              "snGradSchemes")), ("fvSolution", ())):
            (self.folder / "system" / name).write_text(
                f"FoamFile {{ version 2.0; format ascii; class dictionary; object {name}; }}\n"
                + "".join(f"{s} {{ }}\n" for s in sections))
        self.make("constant/polyMesh", "--label-names", "names.txt")


@unittest.skipIf(shutil.which("checkMesh") is None, "openfoam was not found: no checkMesh")
class CheckMesh(Case):
    def told(self):
        run = subprocess.run(["checkMesh", "-allTopology", "-allGeometry", "-constant"],
                             cwd=self.folder, capture_output=True, text=True,
                             env={"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ})
        return run.returncode, run.stdout + run.stderr

    def test_mesh(self):
        status, text = self.told()
        self.assertEqual(status, 0, text)
        self.assertIn(f"cells:            {len(self.truth.tets)}", text)
        self.assertIn(f"tetrahedra:    {len(self.truth.tets)}", text)
        for line in ("Boundary definition OK.", "Point usage OK.", "Upper triangular ordering OK.",
                     "Face vertices OK.", "Boundary openness", "Face pyramids OK.", "Cell volumes OK."):
            self.assertIn(line, text)
        for name in PATCHES:
            self.assertIn(name, text)

    def test_a_fault_is_found(self):
        """Planted: two faces exchanged."""
        self.assertIn("Upper triangular ordering OK.", self.told()[1])
        file = self.folder / "constant" / "polyMesh" / "neighbour"
        lines = file.read_text().split("\n")
        at = lines.index("(") + 40
        lines[at], lines[at + 1] = lines[at + 1], lines[at]
        file.write_text("\n".join(lines))
        self.assertNotIn("Upper triangular ordering OK.", self.told()[1])


@unittest.skipIf(vtkOpenFOAMReader is None, "VTK was not found")
class Vtk(Case):
    def test_mesh(self):
        (self.folder / "case.foam").write_text("")
        reader = vtkOpenFOAMReader()
        reader.SetFileName(str(self.folder / "case.foam"))
        reader.ReadZonesOn()
        reader.UpdateInformation()
        reader.EnableAllPatchArrays()
        reader.Update()
        output = reader.GetOutput()
        blocks = {output.GetMetaData(n).Get(output.NAME()): output.GetBlock(n)
                  for n in range(output.GetNumberOfBlocks())}
        grid = blocks["internalMesh"]
        self.assertTrue(np.allclose(vtk_to_numpy(grid.GetPoints().GetData()), self.truth.points,
                                    atol=1e-5))
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        self.assertEqual(np.sort(cells, axis=1).tolist(), np.sort(self.truth.tets, axis=1).tolist())


if __name__ == "__main__":
    unittest.main()
