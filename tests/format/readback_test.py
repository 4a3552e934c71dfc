"""Every format, read by programs that share no code with certet: meshio, Gmsh's
Python module, VTK, and where nobody reads a format, by this file.

The truth is the raw .vtu file of the same mesh, read byte by byte."""

import os
import pathlib
import re
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
import vtu  # noqa: E402
from images import voxels, write_nrrd  # noqa: E402
from program import ProgramTest  # noqa: E402
from readers import (arrays_of, gmsh, h5py, meshio, open_in_gmsh, read_by_vtk,  # noqa: E402
                     vtk_to_numpy, vtkHDFReader, vtkXMLPolyDataReader,
                     vtkXMLUnstructuredGridReader)

SIZE = (9, 8, 7)
# By their numbers: the patches, of which `border` and two sides have no triangles, and interfaces.
SHEETS = {1: "surface", 4: "xmax", 5: "ymin", 6: "ymax", 7: "zmin",
          9: "Left <lobe> & more-Left-lobe", 10: "Left <lobe> & more-left?lobe",
          11: "Left-lobe-left?lobe"}
FIRST_SIDE, FIRST_INTERFACE = 3, 9
FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


class Mesh:
    """Points, tetrahedra and their labels; triangles of the boundary and the
    numbers of their patches, which may be missing."""

    def __init__(self, points, tets, labels, triangles=None, patches=None):
        self.points = np.asarray(points, dtype=float).reshape(-1, 3)
        self.tets = np.asarray(tets, dtype=np.int64).reshape(-1, 4)
        self.labels = np.asarray(labels, dtype=np.int64)
        self.triangles = None if triangles is None else np.asarray(triangles).reshape(-1, 3)
        self.patches = None if patches is None else np.asarray(patches, dtype=np.int64)

    def by_region(self):
        """The order of files that go region by region."""
        order = np.argsort(self.labels, kind="stable")
        return Mesh(self.points, self.tets[order], self.labels[order], self.triangles,
                    self.patches)


def rotated(triangles):
    """Each with its lowest point first, sorted."""
    triangles = np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
    first = np.argmin(triangles, axis=1)
    turned = np.stack([triangles[np.arange(len(triangles)), (first + i) % 3] for i in range(3)], 1)
    return turned[np.lexsort(turned.T[::-1])]


def boundary_of(tets):
    """Faces in one tetrahedron only, as seen from outside."""
    faces = np.concatenate([tets[:, f] for f in FACES])
    keys = np.sort(faces, axis=1)
    _, where, counts = np.unique(keys, axis=0, return_index=True, return_counts=True)
    return rotated(faces[where[counts == 1]])


def interfaces_of(tets, labels):
    """Faces between two labels, as seen from outside of the lesser one."""
    faces = np.concatenate([tets[:, f] for f in FACES])
    owners = np.tile(labels, len(FACES))
    order = np.lexsort((owners, *np.sort(faces, axis=1).T))
    keys, owners = np.sort(faces, axis=1)[order], owners[order]
    pairs = (keys[1:] == keys[:-1]).all(axis=1) & (owners[1:] != owners[:-1])
    return rotated(faces[order[:-1][pairs]])


def volume_within(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def open_edges(triangles):
    edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
    forward = {tuple(e) for e in edges}
    return sum((b, a) not in forward for a, b in forward)


def differences(truth, read, exact=True):
    """What is wrong with a mesh that was read: sentences."""
    found = []
    if truth.points.shape != read.points.shape:
        found.append(f"{len(read.points)} points, not {len(truth.points)}")
    elif not (np.array_equal(truth.points, read.points) if exact
              else np.allclose(truth.points, read.points, rtol=1e-6, atol=1e-5)):
        found.append("other points")
    if not np.array_equal(truth.tets, read.tets):
        found.append("other tetrahedra")
    if not np.array_equal(truth.labels, read.labels):
        found.append("other labels")
    if read.triangles is not None:
        found += boundary_differences(truth, read)
    return found


def boundary_differences(truth, read):
    found = []
    if read.patches is not None:
        inner = np.asarray(read.patches) >= FIRST_INTERFACE
        if not np.array_equal(interfaces_of(truth.tets, truth.labels),
                              rotated(read.triangles[inner])):
            found.append("other interfaces")
        read = Mesh(read.points, read.tets, read.labels, read.triangles[~inner],
                    read.patches[~inner])
    if not np.array_equal(boundary_of(truth.tets), rotated(read.triangles)):
        found.append("other boundary")
    if open_edges(read.triangles) != 0:
        found.append("a boundary that is not closed")
    a, b, c, d = (truth.points[truth.tets[:, i]] for i in range(4))
    volume = np.einsum("ij,ij->", b - a, np.cross(c - a, d - a)) / 6
    if not np.isclose(volume, volume_within(read.points, read.triangles), rtol=1e-9):
        found.append("a boundary around another volume")
    if read.patches is not None:
        found += patch_differences(read, interfaces_of(truth.tets, truth.labels))
    return found


def patch_differences(read, interfaces):
    """The bricks end at the faces of the voxels of the border; where two of them meet
    there, the boundary has a point between them."""
    low, high = np.full(3, -0.5), np.asarray(SIZE) - 0.5
    near = np.abs(np.stack([read.points - low, read.points - high], 2)).reshape(-1, 6) < 1e-3
    # A face belongs to the side that most of its corners are at, of several to the first.
    side = FIRST_SIDE + near[read.triangles].sum(axis=1).argmax(axis=1)
    near = near.any(axis=1)
    between = np.zeros(len(near), bool)
    between[interfaces.ravel()] = True
    at_border = ((near | between)[read.triangles].all(axis=1)
                 & (near[read.triangles].sum(axis=1) >= 2))
    expected = np.where(at_border, side, 1)
    return [] if np.array_equal(read.patches, expected) else ["other patches"]


def blocks(mesh, kind, data):
    """The numbers of all blocks of one kind of cell."""
    chosen = [i for i, block in enumerate(mesh.cells) if block.type == kind]
    cells = np.concatenate([mesh.cells[i].data for i in chosen])
    values = None
    if data is not None:
        values = np.concatenate([np.asarray(mesh.cell_data[data][i]) for i in chosen])
    return cells, values


class Readback(ProgramTest):
    """Two labels in a brick that touches four sides of its image."""

    @classmethod
    def label(cls, i, j, k):
        if k >= 5 or i < 1:
            return 0
        return 7 if i >= 5 else (12 if j >= 4 else 3)

    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "a.nrrd", SIZE, voxels(SIZE, self.label), kind="B")
        (self.folder / "names.txt").write_text("3 Left <lobe> & more\n7 Left-lobe 2001\n"
                                               "# nothing\n12 \"left\tlobe\"\n")
        self.truth = self.make("truth.vtu")

    def make(self, name, *options):
        self.mesh("a.nrrd", *options, "-o", name)
        if name != "truth.vtu":
            return str(self.folder / name)
        file = self.folder / name
        return Mesh(vtu.points(file), vtu.tets(file), vtu.numbers(file, "label"))

    def assert_same(self, truth, read, exact=True):
        self.assertEqual(differences(truth, read, exact), [])
        self.assert_defects_are_found(truth, read)

    def assert_defects_are_found(self, truth, read):
        """Planted: two corners swapped, a label one too large, a triangle turned."""
        tets, labels = read.tets.copy(), read.labels.copy()
        if len(tets):
            tets[5, [0, 1]] = tets[5, [1, 0]]
            labels[7] += 1
            for defect in (Mesh(read.points, tets, read.labels),
                           Mesh(read.points, read.tets, labels)):
                self.assertNotEqual(differences(truth, defect), [])
        if read.triangles is not None:
            turned = read.triangles.copy()
            turned[3] = turned[3][::-1]
            patches = read.patches
            for chosen in (slice(1, None), slice(None, -1)):
                self.assertNotEqual(boundary_differences(truth, Mesh(
                    read.points, read.tets, read.labels, read.triangles[chosen],
                    None if patches is None else patches[chosen])), [])
            self.assertNotEqual(boundary_differences(truth, Mesh(
                read.points, read.tets, read.labels, turned, patches)), [])
        if read.patches is not None:
            patches = read.patches.copy()
            patches[11] = 4 if patches[11] != 4 else 5
            self.assertNotEqual(boundary_differences(truth, Mesh(
                read.points, read.tets, read.labels, read.triangles, patches)), [])


@unittest.skipIf(meshio is None, "meshio was not found")
class Meshio(Readback):
    def read(self, name, reference, *options, **settings):
        mesh = meshio.read(self.make(name, *options), **settings)
        tets, labels = blocks(mesh, "tetra", reference)
        triangles, patches = blocks(mesh, "triangle", reference)
        return mesh, Mesh(mesh.points, tets, labels, triangles, patches)

    def test_vtu(self):
        for options in ((), ("--compress",)):
            mesh = meshio.read(self.make("a.vtu", *options))
            self.assert_same(self.truth, Mesh(mesh.points, *blocks(mesh, "tetra", "label")))

    def test_medit(self):
        for name in ("a.mesh", "a.meshb"):
            self.assert_same(self.truth, self.read(name, "medit:ref")[1])

    def test_gmsh(self):
        mesh, read = self.read("a.msh", "gmsh:physical", "--label-names", "names.txt")
        self.assert_same(self.truth.by_region(), read)
        self.assertEqual({name: tuple(tag) for name, tag in mesh.field_data.items()}, {
            "Left <lobe> & more": (3, 3), "Left-lobe": (7, 3), "left?lobe": (12, 3),
            **{name: (number, 2) for number, name in SHEETS.items()}})

    def test_gmsh_22(self):
        mesh, read = self.read("a.msh", "gmsh:physical", "--format", "msh22",
                               "--label-names", "names.txt", file_format="gmsh")
        self.assert_same(self.truth, read)
        self.assertEqual(tuple(mesh.field_data["Left-lobe"]), (7, 3))

    def test_abaqus(self):
        mesh = meshio.read(self.make("a.inp", "--label-names", "names.txt"))
        labels = np.concatenate([np.full(len(b.data), label)
                                 for b, label in zip(mesh.cells, (3, 7, 12))])
        truth = self.truth.by_region()
        triangles, patches = self.abaqus_surfaces(truth)
        self.assert_same(truth, Mesh(mesh.points, blocks(mesh, "tetra", None)[0], labels,
                                     triangles, patches))
        text = (self.folder / "a.inp").read_text()
        for name in ("ELSET=Left__lobe____more\n", "ELSET=Left_lobe\n", "ELSET=left_lobe_12\n"):
            self.assertIn(name, text)

    def abaqus_surfaces(self, truth):
        """meshio passes over surfaces."""
        corners = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}
        triangles, patches, patch, tets = [], [], 0, {}
        for line in (self.folder / "a.inp").read_text().splitlines():
            words = [w.strip() for w in line.split(",")]
            if line.startswith("*"):
                kind = words[0]
                patch = {"NAME=Left__lobe____more_Left_lobe": 9,
                         "NAME=Left__lobe____more_left_lobe_2": 10,
                         "NAME=Left_lobe_left_lobe": 11,
                         **{"NAME=" + name: number for number, name in SHEETS.items()}}.get(
                             words[-1], 0)
            elif kind == "*ELEMENT":
                tets[int(words[0])] = [int(w) - 1 for w in words[1:]]
            elif kind == "*SURFACE":
                # As seen from inside: Abaqus counts the corners so.
                a, b, c = (tets[int(words[0])][v] for v in corners[words[1]])
                triangles.append((a, c, b))
                patches.append(patch)
        return np.array(triangles), np.array(patches)

    def test_tetgen(self):
        mesh = meshio.read(self.make("a.ele"))
        rows = np.loadtxt(self.folder / "a.face", skiprows=1, dtype=np.int64)
        tets = [cells.data for cells in mesh.cells if cells.type == "tetra"][0]
        labels = np.loadtxt(self.folder / "a.ele", skiprows=1, dtype=np.int64)[:, 5]
        self.assert_same(self.truth, Mesh(mesh.points, tets, labels, rows[:, 1:4] - 1, rows[:, 4]))
        self.assertEqual([f for f in self.files() if f.startswith("a.")],
                         ["a.ele", "a.face", "a.node", "a.nrrd"])

    def test_ply(self):
        mesh = meshio.read(self.make("a.ply"))
        self.assert_surface(mesh.points, mesh.cells_dict["triangle"])

    def test_stl(self):
        mesh = meshio.read(self.make("a.stl"))
        self.assert_surface(mesh.points, mesh.cells_dict["triangle"])

    def assert_surface(self, points, triangles):
        """The points of the boundary alone, found again by where they are."""
        self.assertEqual(open_edges(triangles), 0)
        truth = boundary_of(self.truth.tets)
        self.assertEqual(len(triangles), len(truth))
        a = rotated_places(points, triangles)
        b = rotated_places(self.truth.points, truth)
        self.assertTrue(np.allclose(a, b, atol=1e-5))


def rotated_places(points, triangles):
    """Corners by their places, each triangle with its lowest corner first, sorted."""
    corners = np.round(points[triangles], 4) + 0.0
    listed = []
    for triangle in corners.tolist():
        first = triangle.index(min(triangle))
        listed.append(triangle[first:] + triangle[:first])
    return np.array(sorted(listed))


@unittest.skipIf(gmsh is None, "gmsh was not found")
class Gmsh(Readback):
    def read(self, name, *options):
        points = open_in_gmsh(self.make(name, *options), self)
        tets = self.elements(3, 4)
        triangles = self.elements(2, 2)
        return Mesh(points, tets[:, 2:], tets[:, 1], triangles[:, 2:], triangles[:, 1])

    def elements(self, dimension, kind):
        """Rows of a tag, a physical group and points, by tag."""
        corners = 4 if dimension == 3 else 3
        rows = []
        for _, entity in gmsh.model.getEntities(dimension):
            groups = gmsh.model.getPhysicalGroupsForEntity(dimension, entity)
            tags, nodes = gmsh.model.mesh.getElementsByType(kind, entity)
            group = np.full(len(tags), groups[0] if len(groups) else entity)
            rows.append(np.column_stack(
                [tags, group, np.reshape(nodes, (-1, corners)).astype(np.int64) - 1]))
        rows = np.concatenate(rows).astype(np.int64)
        return rows[np.argsort(rows[:, 0])]

    def test_41(self):
        read = self.read("a.msh", "--label-names", "names.txt")
        self.assert_same(self.truth, read)
        self.assertEqual(gmsh.model.getPhysicalName(2, 4), "xmax")
        self.assertEqual(gmsh.model.getPhysicalName(3, 7), "Left-lobe")

    def test_22(self):
        self.assert_same(self.truth, self.read("a.msh", "--format", "msh22"))

    def test_medit(self):
        self.assert_same(self.truth, self.read("a.mesh"))


@unittest.skipIf(vtkXMLUnstructuredGridReader is None, "VTK was not found")
class Vtk(Readback):
    def assert_grid(self, grid):
        self.assertEqual(set(vtk_to_numpy(grid.GetCellTypesArray())), {10})
        labels = vtk_to_numpy(grid.GetCellData().GetArray("label"))
        self.assert_same(self.truth, Mesh(*arrays_of(grid), labels))

    def test_vtu(self):
        for options in ((), ("--compress",), ("--label-names", "names.txt")):
            self.assert_grid(read_by_vtk(vtkXMLUnstructuredGridReader(),
                                         self.make("a.vtu", *options)))

    def test_vtkhdf(self):
        self.assert_grid(read_by_vtk(vtkHDFReader(), self.make("a.vtkhdf")))

    def test_frame_is_where_slicer_looks(self):
        for options, frame in (((), "LPS"), (("--frame", "ras"), "RAS")):
            data = read_by_vtk(vtkXMLPolyDataReader(), self.make("a.vtp", *options))
            self.assertEqual(data.GetFieldData().GetAbstractArray("SPACE").GetValue(0), frame)
        self.mesh("--shape", "sphere:1", "--size", 0.5, "-o", "b.vtp")
        data = read_by_vtk(vtkXMLPolyDataReader(), str(self.folder / "b.vtp"))
        self.assertIsNone(data.GetFieldData().GetAbstractArray("SPACE"))

    def test_vtp(self):
        data = read_by_vtk(vtkXMLPolyDataReader(),
                           self.make("a.vtp", "--label-names", "names.txt"))
        points = vtk_to_numpy(data.GetPoints().GetData())
        triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        sheet, label, behind = (vtk_to_numpy(data.GetCellData().GetArray(name))
                                for name in ("surface", "label", "behind"))
        names = data.GetFieldData().GetAbstractArray("surface_names")
        self.assertEqual([names.GetValue(n) for n in range(names.GetNumberOfValues())],
                         list(SHEETS.values()))
        # Its points are those of the mesh that surfaces have, in their order.
        number = {tuple(p): n for n, p in enumerate(self.truth.points.tolist())}
        places = np.array([number[tuple(p)] for p in points.tolist()])
        self.assertTrue((np.diff(places) > 0).all())
        triangles = places[triangles]
        outer = sheet < FIRST_INTERFACE
        self.assertTrue(np.array_equal(rotated(triangles[outer]), boundary_of(self.truth.tets)))
        self.assertTrue(np.array_equal(
            rotated(triangles[~outer]), interfaces_of(self.truth.tets, self.truth.labels)))
        self.assertTrue((behind[outer] == 0).all())
        pairs = {9: (3, 7), 10: (3, 12), 11: (7, 12)}
        for n, (lesser, greater) in pairs.items():
            self.assertEqual(set(zip(label[sheet == n], behind[sheet == n])), {(lesser, greater)})


class Febio(Readback):
    def test_mesh(self):
        mesh = ElementTree.parse(self.make("a.feb", "--label-names", "names.txt")).getroot()
        self.assertEqual((mesh.tag, mesh.get("version")), ("febio_spec", "4.0"))
        mesh = mesh.find("Mesh")
        nodes = mesh.find("Nodes")
        self.assertEqual([int(n.get("id")) for n in nodes], list(range(1, len(nodes) + 1)))
        points = [[float(c) for c in n.text.split(",")] for n in nodes]
        rows, names = [], {3: "Left <lobe> & more", 7: "Left-lobe", 12: "left?lobe"}
        parts = {part.get("name"): part for part in mesh.findall("Elements")}
        self.assertEqual(set(parts), set(names.values()))
        for label, name in names.items():
            self.assertEqual(parts[name].get("type"), "tet4")
            rows += [(int(e.get("id")), label, *numbers(e)) for e in parts[name]]
        rows = np.array(sorted(rows))
        self.assertEqual(rows[:, 0].tolist(), list(range(1, len(rows) + 1)))
        triangles, patches = [], []
        self.assertEqual([s.get("name") for s in mesh.findall("Surface")], list(SHEETS.values()))
        for patch, name in SHEETS.items():
            (surface,) = (s for s in mesh.findall("Surface") if s.get("name") == name)
            triangles += [numbers(e) for e in surface]
            patches += [patch] * len(surface)
        self.assert_same(self.truth, Mesh(points, rows[:, 2:], rows[:, 1], triangles, patches))


@unittest.skipIf(h5py is None, "h5py was not found")
class Xdmf(Readback):
    """The description by this file, the numbers by h5py; and both by meshio."""

    def grids(self, name):
        """Points, cells and numbers of each, by their description."""
        file = self.make(name, "--label-names", "names.txt")
        found = {}
        for part in (file, file.replace(".xdmf", "_surfaces.xdmf")):
            root = ElementTree.parse(part).getroot()
            self.assertEqual((root.tag, root.get("Version")), ("Xdmf", "3.0"))
            (grid,) = root.find("Domain").findall("Grid")
            arrays = []
            for path in ("Geometry/DataItem", "Topology/DataItem", "Attribute/DataItem"):
                item = grid.find(path)
                file, array = item.text.split(":")
                data = h5py.File(self.folder / file, "r")[array]
                self.assertEqual([int(n) for n in item.get("Dimensions").split()],
                                 list(data.shape))
                self.assertEqual(int(item.get("Precision")), data.dtype.itemsize)
                arrays.append(data[()])
            names = re.findall("<!-- (.*) -->", pathlib.Path(part).read_text())
            found[grid.get("Name")] = (*arrays, names)
        return found

    def test_mesh_and_surfaces(self):
        grids = self.grids("a.xdmf")
        points, tets, labels, names = grids["mesh"]
        _, triangles, patches, sheets = grids["surfaces"]
        self.assert_same(self.truth, Mesh(points, tets, labels, triangles, patches))
        self.assertEqual(names, ["SPACE=LPS", "label 3 is Left &lt;lobe&gt; &amp; more",
                                 "label 7 is Left-lobe", "label 12 is left?lobe"])
        self.assertEqual(sheets[1], "surface 4 is xmax")
        self.assertEqual(sheets[6], "surface 10 is Left &lt;lobe&gt; &amp; more-left?lobe")
        self.assertEqual([f for f in self.files() if f.startswith("a")],
                         ["a.h5", "a.nrrd", "a.xdmf", "a_surfaces.xdmf"])

    @unittest.skipIf(meshio is None, "meshio was not found")
    def test_meshio(self):
        mesh = meshio.read(self.make("b & c.xdmf"))
        self.assert_same(self.truth, Mesh(mesh.points, *blocks(mesh, "tetra", "label")))
        surfaces = meshio.read(self.folder / "b & c_surfaces.xdmf")
        self.assertEqual(boundary_differences(self.truth, Mesh(
            mesh.points, self.truth.tets, self.truth.labels,
            *blocks(surfaces, "triangle", "surface"))), [])

    def test_bytes_are_the_same_at_any_time(self):
        for name in ("a.xdmf", "a.vtkhdf"):
            self.make(name, "--threads", "1")
            first = (self.folder / name.replace("xdmf", "h5")).read_bytes()
            time.sleep(1.1)
            least = self.mesh("a.nrrd", "--threads", 3, "-o", name)["memory"]["least"]
            self.mesh("a.nrrd", "--threads", 3, "--max-memory", least, "-o", name)
            self.assertEqual((self.folder / name.replace("xdmf", "h5")).read_bytes(), first)


class Solvers(Readback):
    """Nastran's file is read by meshio and Gmsh too; nobody in reach reads the others."""

    REGIONS = {3: "Left <lobe> & more", 7: "Left-lobe", 12: "left?lobe"}

    def fields(self, line, width):
        return [line[i:i + width].strip() for i in range(0, len(line), width)]

    def text(self, name, *options):
        return pathlib.Path(self.make(name, "--label-names", "names.txt", *options)) \
            .read_text().splitlines()

    def points_of_sheets(self, truth):
        """By the faces of TetGen's file."""
        rows = np.loadtxt(self.make("a.face"), skiprows=1, dtype=np.int64)
        return {name: sorted({int(p) for p in rows[rows[:, 4] == number, 1:4].ravel()})
                for number, name in SHEETS.items()}

    def nastran(self, lines):
        """Points, elements by number, sets of points by name, properties by name."""
        points, tets, sets, names = [], [], {}, {}
        told = None
        for line in lines:
            if line.startswith("$"):
                told = line[2:]
                continue
            card = self.fields(line, 8)
            if line.startswith("GRID*"):
                wide = self.fields(line[8:], 16)
                self.assertEqual((int(wide[0]), wide[1]), (len(points) + 1, ""))
                points.append([float(wide[2]), float(wide[3])])
            elif line.startswith("*       "):
                points[-1].append(float(line[8:]))
            elif card[0] == "CTETRA":
                self.assertEqual(int(card[1]), len(tets) + 1)
                tets.append([int(word) for word in card[2:]])
            elif card[0] == "PSOLID":
                self.assertEqual(card[1], card[2])
                names[int(card[1])] = told.removeprefix("region ")
            elif card[0] == "SET1":
                latest = sets.setdefault(told.removeprefix("points of "), [])
                latest += [int(word) for word in card[2:]]
            elif card[0] == "+":
                latest += [int(word) for word in card[1:]]
        return np.array(points), np.array(tets), sets, names

    def test_nastran(self):
        lines = self.text("a.bdf")
        points, tets, sets, names = self.nastran(lines)
        self.assertEqual((lines[1], lines[-1]), ("BEGIN BULK", "ENDDATA"))
        self.assert_same(self.truth, Mesh(points, tets[:, 1:] - 1, tets[:, 0]), exact=False)
        self.assertEqual(names, self.REGIONS)
        self.assertEqual(sets, self.points_of_sheets(self.truth))

    @unittest.skipIf(meshio is None, "meshio was not found")
    def test_nastran_by_meshio(self):
        mesh = meshio.read(self.make("a.bdf"))
        tets = mesh.cells_dict["tetra"]
        labels = np.concatenate([np.asarray(d) for d in mesh.cell_data["nastran:ref"]])
        self.assert_same(self.truth, Mesh(mesh.points, tets, labels), exact=False)

    @unittest.skipIf(gmsh is None, "gmsh was not found")
    def test_nastran_by_gmsh(self):
        path = self.make("a.bdf")
        gmsh.initialize()
        self.addCleanup(gmsh.finalize)
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        tags, places, _ = gmsh.model.mesh.getNodes()
        points = np.empty((len(tags), 3))
        points[np.asarray(tags) - 1] = np.reshape(places, (-1, 3))
        rows = []
        for _, entity in gmsh.model.getEntities(3):
            numbers_, nodes = gmsh.model.mesh.getElementsByType(4, entity)
            rows.append(np.column_stack([numbers_, np.full(len(numbers_), entity),
                                         np.reshape(nodes, (-1, 4)).astype(np.int64) - 1]))
        rows = np.concatenate(rows).astype(np.int64)
        rows = rows[np.argsort(rows[:, 0])]
        self.assert_same(self.truth, Mesh(points, rows[:, 2:], rows[:, 1]), exact=False)

    def keywords(self, lines):
        """Blocks of lines behind each keyword, in order."""
        blocks_ = []
        for line in lines:
            if line.startswith("*"):
                blocks_.append((line[1:], []))
            else:
                blocks_[-1][1].append(line)
        return blocks_

    def test_dyna(self):
        found = self.keywords(self.text("a.k"))
        self.assertEqual(found[0][0], "KEYWORD")
        self.assertEqual(found[-1], ("END", []))
        sections, nodes, elements = (dict(found)[k] for k in
                                     ("SECTION_SOLID", "NODE", "ELEMENT_SOLID"))
        self.assertEqual([f.strip() for f in self.fields(sections[0], 10)], ["1", "10"])
        points = [[float(line[i:i + 16]) for i in (8, 24, 40)] for line in nodes]
        self.assertEqual([int(line[:8]) for line in nodes], list(range(1, len(nodes) + 1)))
        rows = np.array([[int(f) for f in self.fields(line, 8)] for line in elements])
        self.assertEqual(rows[:, 0].tolist(), list(range(1, len(rows) + 1)))
        self.assertTrue((rows[:, 6:] == rows[:, 5:6]).all())
        self.assertEqual({int(block[1][:10]): block[0] for k, block in found if k == "PART"},
                         self.REGIONS)
        for key, block in found:
            if key == "PART":  # number, section, material
                part = [int(f) for f in self.fields(block[1], 10)]
                self.assertEqual(part[1:], [1, part[0]])
        sets = {block[0]: [int(f) for line in block[2:] for f in self.fields(line, 10)]
                for key, block in found if key == "SET_NODE_LIST_TITLE"}
        self.assertEqual(sets, self.points_of_sheets(self.truth))
        triangles, patches = [], []
        for key, block in found:
            if key != "SET_SEGMENT_TITLE":
                continue
            for line in block[2:]:
                a, b, c, again = (int(f) - 1 for f in self.fields(line, 10))
                self.assertEqual(c, again)
                triangles.append((a, b, c))
                patches.append({name: number for number, name in SHEETS.items()}[block[0]])
        self.assert_same(self.truth, Mesh(points, rows[:, 2:6] - 1, rows[:, 1], triangles,
                                          patches), exact=False)

    def test_mfem(self):
        lines = self.text("a.mfem")
        self.assertEqual(lines[0], "MFEM mesh v1.0")
        told = [line for line in lines if line.startswith("#")]
        for number, name in SHEETS.items():
            self.assertIn(f"# boundary attribute {number} is {name}", told)
        for number, name in self.REGIONS.items():
            self.assertIn(f"# attribute {number} is {name}", told)
        words = iter(" ".join(line for line in lines[1:] if not line.startswith("#")).split())
        self.assertEqual([next(words) for _ in range(3)], ["dimension", "3", "elements"])
        elements = np.array([[int(next(words)) for _ in range(6)]
                             for _ in range(int(next(words)))])
        self.assertTrue((elements[:, 1] == 4).all())
        self.assertEqual(next(words), "boundary")
        boundary = np.array([[int(next(words)) for _ in range(5)]
                             for _ in range(int(next(words)))])
        self.assertTrue((boundary[:, 1] == 2).all())
        self.assertEqual(next(words), "vertices")
        count, dimension = int(next(words)), int(next(words))
        self.assertEqual(dimension, 3)
        points = [[float(next(words)) for _ in range(3)] for _ in range(count)]
        self.assertEqual(list(words), [])
        self.assert_same(self.truth, Mesh(points, elements[:, 2:], elements[:, 0],
                                          boundary[:, 2:], boundary[:, 0]))

    def test_labels_that_are_no_numbers_there(self):
        """0, negative, and beyond what eight characters hold."""
        labels = {3: -4, 7: 614454277, 12: 5}
        write_nrrd(self.folder / "b.nrrd", SIZE, voxels(
            SIZE, lambda i, j, k: labels.get(self.label(i, j, k), 0)), kind="i")
        for name, numbers_ in (("b.bdf", {5, 6, 7}), ("b.k", {5, 6, 7}),
                               ("b.mfem", {5, 614454277, 614454278})):
            run = self.run_certet("mesh", "b.nrrd", "-o", name, "--labels", "-4,5,614454277")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("label -4 has the number", run.stderr)
            text = (self.folder / name).read_text()
            for number in numbers_:
                self.assertRegex(text, rf"\b{number}\b")

    def test_coordinates_far_from_0(self):
        """Fields of 16 characters hold no atom's width at the end of the solar system."""
        write_nrrd(self.folder / "far.nrrd", SIZE, voxels(SIZE, self.label), kind="B",
                   origin=(1e12 + 0.125, 0, 0))
        for name in ("far.bdf", "far.k"):
            self.assert_fails(6, [name, "16 characters", "origin"], "mesh", "far.nrrd", "-o", name)
            self.make(name, "--origin", "0")


class Patches(Readback):
    """Where faces lie, whatever the cuts; and the same bytes for all threads."""

    def test_midpoint(self):
        self.make("m.node", "--cuts", "midpoint", "--smooth", "0")
        points = np.loadtxt(self.folder / "m.node", skiprows=1)[:, 1:4]
        rows = np.loadtxt(self.folder / "m.face", skiprows=1, dtype=np.int64)
        rows = rows[rows[:, 4] < FIRST_INTERFACE]
        low, high = np.full(3, -0.5), np.asarray(SIZE) - 0.5
        near = (np.abs(points - low) < 0.26) | (np.abs(points - high) < 0.26)
        at_border = near.any(axis=1)[rows[:, 1:4] - 1].all(axis=1)
        border = rows[:, 4] >= FIRST_SIDE
        self.assertTrue(border.any() and not border.all())
        self.assertFalse((border & ~at_border).any())
        # A cut in the middle of an edge towards label 0 can be as near.
        corners = points[rows[at_border & ~border, 1:4] - 1]
        inner = (corners[:, :, 0] < 0.8) | (corners[:, :, 2] > 4.2)
        self.assertTrue(inner.any(axis=1).all())

    def test_formula_is_cut_off_at_its_bounds(self):
        self.mesh("--expr", "x^2+y^2+z^2-1", "--bounds", "-2,-2,0,2,2,2", "--size", "0.1",
                  "-o", "h.node")
        points = np.loadtxt(self.folder / "h.node", skiprows=1)[:, 1:4]
        rows = np.loadtxt(self.folder / "h.face", skiprows=1, dtype=np.int64)
        flat = (np.abs(points[:, 2]) < 1e-4)[rows[:, 1:4] - 1].all(axis=1)
        self.assertTrue(flat.any())
        self.assertTrue(np.array_equal(rows[:, 4] == 7, flat))  # zmin
        labels = np.loadtxt(self.folder / "h.ele", skiprows=1, dtype=np.int64)[:, 5]
        self.assertEqual(set(labels), {1})

    def test_threads_and_memory(self):
        for name in ("a.msh", "a.feb", "a.mesh"):
            least = self.mesh("a.nrrd", "--threads", 1, "-o", name)["memory"]["least"]
            first = (self.folder / name).read_bytes()
            self.mesh("a.nrrd", "--threads", 3, "--max-memory", least, "-o", name)
            self.assertEqual((self.folder / name).read_bytes(), first)

    def test_files_of_others(self):
        """What meshio and VTK write is read."""
        labels = self.truth.labels.astype(np.int32)
        for name, settings in (("v.vtu", {}), ("w.vtu", {"compression": None}),
                               ("x.vtu", {"binary": False}), ("y.mesh", {}), ("z.meshb", {}),
                               ("g.msh", {"file_format": "gmsh"}),
                               ("h.msh", {"file_format": "gmsh22"}),
                               ("i.msh", {"file_format": "gmsh22", "binary": False}),
                               ("j.msh", {"file_format": "gmsh", "binary": False})):
            with self.subTest(name):
                data = {"vtu": {"label": [labels]}, "msh": {
                    "gmsh:physical": [labels], "gmsh:geometrical": [labels]}}.get(
                        name[-3:], {"medit:ref": [labels]})
                mesh = meshio.Mesh(self.truth.points, [("tetra", self.truth.tets)],
                                   cell_data=data)
                meshio.write(self.folder / name, mesh, **settings)
                run = self.run_certet("convert", name, "back.vtu")
                self.assertEqual(run.returncode, 0, run.stderr)
                file = self.folder / "back.vtu"
                back = Mesh(vtu.points(file), vtu.tets(file), vtu.numbers(file, "label"))
                found = differences(self.truth, back, exact=name not in ("x.vtu",))
                if name in ("g.msh", "j.msh"):  # by region, or without labels
                    found = [f for f in found if f == "other points"]
                self.assertEqual(found, [])


def numbers(element):
    return [int(n) - 1 for n in element.text.split(",")]


if __name__ == "__main__":
    unittest.main()
