"""Tetrahedra of ten nodes: every format, read by programs that share no code with certet, with
each middle node where its edge says; what is refused; and curved ones, whose volume is nearer
to the shape's."""

import itertools
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
import vtu  # noqa: E402
from program import ProgramTest  # noqa: E402
from readers import (arrays_of, gmsh, meshio, open_in_gmsh, read_by_vtk,  # noqa: E402
                     vtkXMLUnstructuredGridReader)

try:
    import h5py
except ImportError:
    h5py = None


def real(text):
    """Nastran's exponents have no letter."""
    return float(re.sub(r"(?<=[0-9.])([+-])", r"e\1", text.strip().lower().replace("e", "")))


# The edges that the middle nodes of an element are in the middle of, by its corners.
VTK = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
GMSH = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
TETGEN = ((2, 3), (0, 3), (0, 1), (1, 2), (1, 3), (0, 2))
TRIANGLE = ((0, 1), (1, 2), (0, 2))


def misplaced(points, cells, corners, order):
    """How many middle nodes are not in the middle of the edges that an order says."""
    count = 0
    for place, (i, j) in enumerate(order):
        middles = (points[cells[:, i]] + points[cells[:, j]]) / 2
        aside = np.abs(points[cells[:, corners + place]] - middles).max(axis=1)
        count += int((aside > 1e-9).sum())
    return count


def edges_of(cells):
    corners = cells[:, :4]
    pairs = np.concatenate([corners[:, pair] for pair in itertools.combinations(range(4), 2)])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def curved_volume(points, cells):
    """By the mean of the Bernstein coefficients, written anew: the determinant of the linear
    derivative, integrated by a rule of Gauss that is exact for cubics."""
    a, b = 1 / 4, -4 / 5
    nodes = [((a,) * 4, b)]
    for k in range(4):
        nodes.append((tuple(1 / 2 if k == i else 1 / 6 for i in range(4)), 9 / 20))
    x = points[cells]
    volume = 0
    for weights, weight in nodes:
        gradient = np.zeros((10, 4))
        for i in range(4):
            gradient[i, i] = 4 * weights[i] - 1
        for e, (i, j) in enumerate(VTK):
            gradient[4 + e, i], gradient[4 + e, j] = 4 * weights[j], 4 * weights[i]
        local = gradient[:, 1:] - gradient[:, :1]
        volume += weight * np.linalg.det(np.einsum("tna,nk->tak", x, local)).sum() / 6
    return volume


# Two materials, cut off flat, so that there is a surface, a border and an interface.
SOLIDS = ("--material", "shell=sphere:1", "--material", "core=sphere:0.6", "--bounds",
          "-1.2,-1.2,0,1.2,1.2,1.2", "--size", 0.35)


class Order(ProgramTest):
    def make(self, name, *options, order=2):
        told = self.mesh(*SOLIDS, "--order", order, *options, "-o", name)
        return told, str(self.folder / name)

    def assert_in_the_middle(self, points, tets, order, told):
        self.assertEqual(len(tets), told["mesh"]["tets"])
        self.assertEqual(len(points), told["mesh"]["points"] + told["order2"]["middle_nodes"])
        self.assertEqual(len(edges_of(tets)), told["order2"]["middle_nodes"])
        self.assertEqual(misplaced(points, tets, 4, order), 0)
        # Any other order is another one.
        for other in {VTK, GMSH, TETGEN} - {order}:
            self.assertGreater(misplaced(points, tets, 4, other), 0)


class Files(Order):
    def test_numbers(self):
        """Behind the corners, by the ends of edges; the corners are those of four nodes."""
        told, name = self.make("a.vtu")
        self.make("linear.vtu", order=1)
        points = np.array(vtu.points(self.folder / "a.vtu"))
        cells = np.array(vtu.numbers(self.folder / "a.vtu", "connectivity")).reshape(-1, 10)
        linear = np.array(vtu.points(self.folder / "linear.vtu"))
        self.assertTrue(np.array_equal(points[:len(linear)], linear))
        self.assertTrue(np.array_equal(cells[:, :4], vtu.tets(self.folder / "linear.vtu")))
        edges = edges_of(cells)
        middles = (linear[edges[:, 0]] + linear[edges[:, 1]]) / 2
        self.assertTrue(np.allclose(points[len(linear):], middles, atol=1e-12))
        self.assertEqual(set(vtu.numbers(self.folder / "a.vtu", "types")), {24})
        self.assert_in_the_middle(points, cells, VTK, told)
        checked = self.check("a.vtu")
        self.assertEqual(checked["order2"]["middle_nodes"], len(edges))
        self.assertEqual(checked["order2"]["bent"], 0)
        self.assertAlmostEqual(checked["order2"]["least_jacobian"], 1, places=9)
        self.assertEqual(checked["mesh"]["checksum"], told["mesh"]["file_checksum"])

    def test_threads_and_slabs(self):
        self.make("one.vtu", "--curved", "--threads", 1)
        self.make("four.vtu", "--curved", "--threads", 4)
        self.assertEqual((self.folder / "one.vtu").read_bytes(),
                         (self.folder / "four.vtu").read_bytes())

    def test_formats_hold_the_same(self):
        """Read by certet itself, and written again."""
        self.make("a.vtu", "--curved")
        truth = self.check("a.vtu")
        for name, options in (("b.msh", ()), ("c.msh", ("--format", "msh22")), ("d.mesh", ()),
                              ("e.meshb", ()), ("f.vtu", ("--compress",))):
            run = self.run_certet("convert", "a.vtu", name, *options)
            self.assertEqual(run.returncode, 0, run.stderr)
            found = self.check(name)
            self.assertEqual(found["order2"], truth["order2"], name)
            self.assertEqual(found["mesh"]["volume"], truth["mesh"]["volume"])
            run = self.run_certet("convert", name, "again.vtu")
            self.assertEqual(run.returncode, 0, run.stderr)
            if name == "e.meshb" or name == "f.vtu":
                self.assertEqual(vtu.numbers(self.folder / "again.vtu", "connectivity"),
                                 vtu.numbers(self.folder / "a.vtu", "connectivity"))
                self.assertEqual(vtu.points(self.folder / "again.vtu"),
                                 vtu.points(self.folder / "a.vtu"))

    def test_defects_are_found(self):
        """Planted: a node pulled through its element, and one element with a node of another edge."""
        self.make("a.vtu")
        file = self.folder / "a.vtu"
        whole = file.read_bytes()
        cells = vtu.numbers(file, "connectivity")
        points = vtu.points(file)
        corner = np.array(points[cells[0]])
        far = corner + 2 * (corner - np.array(points[cells[1]]))
        for axis in range(3):
            vtu.overwrite(file, "Points", 3 * cells[4] + axis, "d", far[axis])
        run = self.run_certet("check", "a.vtu")
        self.assertEqual(run.returncode, 1)
        self.assertIn("Jacobian", run.stdout)
        file.write_bytes(whole)
        vtu.overwrite(file, "connectivity", 4, "i", cells[5])
        run = self.run_certet("check", "a.vtu")
        self.assertEqual(run.returncode, 1)
        self.assertIn("several", run.stdout)

    def test_refusals(self):
        for name in ("a.stl", "a.ply", "a.vtp", "polyMesh"):
            self.assert_fails(2, ["--order 2", "ten nodes"], "mesh", *SOLIDS, "--order", 2,
                              "-o", name)
        self.assert_fails(2, ["--curved", "--order 2"], "mesh", *SOLIDS, "--curved", "-o", "a.vtu")
        self.assert_fails(2, ["--curved", "midpoint"], "mesh", *SOLIDS, "--order", 2, "--curved",
                          "--method", "midpoint", "-o", "a.vtu")
        self.make("a.vtu")
        self.assert_fails(2, ["ten nodes"], "convert", "a.vtu", "a.stl")

    def test_report(self):
        self.make("a.vtu", "--curved")
        run = self.run_certet("report", "a.vtu", "-o", "a.html")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("middle nodes", (self.folder / "a.html").read_text())


class Text(Order):
    """Formats that nobody reads here, and those of text, by this file."""

    def test_fields_of_abaqus(self):
        """No number is longer than programs read, and none is changed by more than rounding."""
        options = ("--shape", "sphere:1e-4", "--size", 3e-5, "--order", 2, "--curved")
        self.mesh(*options, "-o", "a.inp")
        self.mesh(*options, "-o", "a.vtu")
        text = (self.folder / "a.inp").read_text()
        rows = text[text.index("*NODE\n") + 6:text.index("*ELEMENT")].splitlines()
        words = [[w.strip() for w in row.split(",")[1:]] for row in rows]
        self.assertLessEqual(max(len(w) for row in words for w in row), 20)
        exact = np.array(vtu.points(self.folder / "a.vtu"))
        self.assertTrue(np.allclose(np.array(words, float), exact, rtol=1e-11, atol=1e-18))

    def test_tetgen(self):
        told, _ = self.make("a.ele")
        points = np.loadtxt(self.folder / "a.node", skiprows=1)[:, 1:]
        rows = np.loadtxt(self.folder / "a.ele", skiprows=1, dtype=np.int64)
        self.assertEqual((self.folder / "a.ele").read_text().split("\n")[0].split()[1], "10")
        self.assert_in_the_middle(points, rows[:, 1:11] - 1, TETGEN, told)

    @unittest.skipIf(shutil.which("tetgen") is None, "tetgen was not found")
    def test_tetgen_has_that_order(self):
        """The order of the nodes of a tetrahedron that TetGen itself makes."""
        (self.folder / "one.node").write_text("4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n")
        subprocess.run(["tetgen", "-o2", "one.node"], cwd=self.folder, check=True,
                       capture_output=True)
        points = np.loadtxt(self.folder / "one.1.node", skiprows=1)[:, 1:4]
        cells = np.loadtxt(self.folder / "one.1.ele", skiprows=1, dtype=np.int64, ndmin=2)
        self.assertEqual(misplaced(points, cells[:, 1:] - 1, 4, TETGEN), 0)

    def test_febio(self):
        told, _ = self.make("a.feb")
        mesh = ElementTree.parse(self.folder / "a.feb").getroot().find("Mesh")
        points = np.array([[float(x) for x in n.text.split(",")]
                           for n in mesh.find("Nodes").findall("node")])
        for part in mesh.findall("Elements"):
            self.assertEqual(part.get("type"), "tet10")
        tets = np.array([[int(x) - 1 for x in e.text.split(",")]
                         for part in mesh.findall("Elements") for e in part])
        self.assert_in_the_middle(points, tets, VTK, told)
        faces = np.array([[int(x) - 1 for x in f.text.split(",")]
                          for surface in mesh.findall("Surface") for f in surface])
        self.assertEqual(faces.shape[1], 6)
        self.assertEqual(misplaced(points, faces, 3, TRIANGLE), 0)


    def assert_fields(self, name, nodes_of, points_of):
        """Columns of text; and that a file whose nodes are in another order is noticed."""
        told, path = self.make(name)
        text = (self.folder / name).read_text().splitlines()
        points, tets = np.array(points_of(text)), np.array(nodes_of(text), np.int64) - 1
        self.assert_in_the_middle(points, tets, VTK, told)
        spoilt = tets.copy()
        spoilt[0, [8, 9]] = spoilt[0, [9, 8]]  # planted: the order of Gmsh, of one element
        self.assertGreater(misplaced(points, spoilt, 4, VTK), 0)

    def test_nastran(self):
        """CTETRA: the corners and two middle nodes, and the four others in the next line."""
        def numbers(line, first):
            return [int(line[i:i + 8]) for i in range(first, len(line), 8)]

        self.assert_fields(
            "a.bdf",
            lambda text: [numbers(line, 24) + numbers(text[i + 1], 8)
                          for i, line in enumerate(text) if line.startswith("CTETRA")],
            lambda text: [[real(line[40:56]), real(line[56:72]), real(text[i + 1][8:24])]
                          for i, line in enumerate(text) if line.startswith("GRID*")])

    def test_dyna(self):
        """ELEMENT_SOLID: a line of number and part, and one of ten nodes."""
        def elements(text):
            first = text.index("*ELEMENT_SOLID") + 1
            last = next(i for i in range(first, len(text)) if text[i].startswith("*"))
            for heading in text[first:last:2]:
                self.assertEqual(len(heading), 16)
            return [[int(line[i:i + 8]) for i in range(0, 80, 8)]
                    for line in text[first + 1:last:2]]

        def points(text):
            first = text.index("*NODE") + 1
            last = text.index("*ELEMENT_SOLID")
            return [[float(line[i:i + 16]) for i in (8, 24, 40)] for line in text[first:last]]

        self.assert_fields("a.k", elements, points)
        self.assertIn("         1        16\n", (self.folder / "a.k").read_text())

    def test_mfem(self):
        """Nodes of each element by themselves, by growing multiples of a half along its edges from the
        first corner: as MFEM's L2_T1_3D_P2 has them."""
        told, _ = self.make("a.mfem")
        text = (self.folder / "a.mfem").read_text()
        head, nodes = text.split("\nnodes\n")
        words = head.split("\nelements\n")[1].split()
        elements = np.array(words[1:1 + 6 * int(words[0])], np.int64).reshape(-1, 6)
        self.assertTrue((elements[:, 1] == 4).all())
        corners = int(head.split("\nvertices\n")[1])
        self.assertEqual(len(np.unique(elements[:, 2:])), corners)
        self.assertEqual(elements[:, 2:].max(), corners - 1)
        heading, numbers = nodes.split("Ordering: 1\n")
        self.assertEqual(heading, "FiniteElementSpace\nFiniteElementCollection: L2_T1_3D_P2\nVDim: 3\n")
        places = np.array(numbers.split(), float).reshape(-1, 10, 3)
        self.assertEqual(len(places), len(elements))
        halves = [(i, j, k) for k in range(3) for j in range(3 - k) for i in range(3 - j - k)]
        points = np.full((corners, 3), np.nan)
        own = np.zeros((len(elements), 10), np.int64)  # as VTK has them
        for place, (i, j, k) in enumerate(halves):
            ends = [c for c, times in enumerate((2 - i - j - k, i, j, k)) for _ in range(times)]
            if ends[0] == ends[1]:
                own[:, ends[0]] = place
                known = points[elements[:, 2 + ends[0]]]
                self.assertTrue((np.isnan(known) | (known == places[:, place])).all())
                points[elements[:, 2 + ends[0]]] = places[:, place]
            else:
                own[:, 4 + VTK.index(tuple(ends))] = place
        # Elements side by side have nodes at the same places, to the last bit.
        shared, numbers = np.unique(places.reshape(-1, 3), axis=0, return_inverse=True)
        cells = numbers[own + 10 * np.arange(len(elements))[:, None]]
        self.assert_in_the_middle(shared, cells, VTK, told)
        cells[0, [8, 9]] = cells[0, [9, 8]]  # planted
        self.assertGreater(misplaced(shared, cells, 4, VTK), 0)


@unittest.skipIf(h5py is None, "h5py was not found")
class Hdf5(Order):
    def test_vtkhdf(self):
        told, path = self.make("a.vtkhdf")
        with h5py.File(path) as file:
            grid = file["VTKHDF"]
            self.assertEqual(set(grid["Types"][:]), {24})
            self.assertTrue((np.diff(grid["Offsets"][:]) == 10).all())
            self.assert_in_the_middle(grid["Points"][:], grid["Connectivity"][:].reshape(-1, 10),
                                      VTK, told)

    def test_xdmf(self):
        told, path = self.make("a.xdmf")
        with h5py.File(self.folder / "a.h5") as file:
            points = file["geometry"][:]
            self.assert_in_the_middle(points, file["topology"][:], VTK, told)
            faces = file["surface_topology"][:]
        self.assertEqual(faces.shape[1], 6)
        self.assertEqual(misplaced(points, faces, 3, TRIANGLE), 0)


@unittest.skipIf(meshio is None, "meshio was not found")
class Meshio(Order):
    @unittest.skipIf(h5py is None, "h5py was not found")
    def test_xdmf(self):
        told, points, tets, _ = self.read("a.xdmf")
        self.assert_in_the_middle(points, tets, VTK, told)

    def test_nastran(self):
        """meshio turns Nastran's order, which it takes for another than VTK's in hexahedra alone."""
        told, points, tets, _ = self.read("a.bdf")
        self.assert_in_the_middle(points, tets, VTK, told)

    def read(self, name, *options, **settings):
        told, path = self.make(name, *options)
        mesh = meshio.read(path, **settings)
        tets = np.concatenate([b.data for b in mesh.cells if b.type == "tetra10"])
        faces = [b.data for b in mesh.cells if b.type == "triangle6"]
        return told, mesh.points, tets, np.concatenate(faces) if faces else None

    def test_vtu(self):
        for options in ((), ("--compress",)):
            told, points, tets, _ = self.read("a.vtu", *options)
            self.assert_in_the_middle(points, tets, VTK, told)

    def test_gmsh(self):
        """meshio turns Gmsh's order into VTK's."""
        for options, settings in (((), {}), (("--format", "msh22"), {"file_format": "gmsh"})):
            told, points, tets, faces = self.read("a.msh", *options, **settings)
            self.assert_in_the_middle(points, tets, VTK, told)
            self.assertEqual(misplaced(points, faces, 3, TRIANGLE), 0)

    def test_abaqus(self):
        told, points, tets, _ = self.read("a.inp")
        self.assert_in_the_middle(points, tets, VTK, told)


@unittest.skipIf(gmsh is None, "gmsh was not found")
class Gmsh(Order):
    def elements(self, name, kind, nodes, *options):
        told, path = self.make(name, *options)
        points = open_in_gmsh(path, self)
        found = []
        for tets in (11, 9):
            _, numbers = gmsh.model.mesh.getElementsByType(tets)
            found.append(np.reshape(np.asarray(numbers, np.int64),
                                    (-1, 10 if tets == 11 else 6)) - 1)
        return told, points, *found

    def assert_read(self, *arguments):
        told, points, tets, faces = self.elements(*arguments)
        self.assert_in_the_middle(points, tets, GMSH, told)
        self.assertGreater(len(faces), 0)
        self.assertEqual(misplaced(points, faces, 3, TRIANGLE), 0)
        places, _ = gmsh.model.mesh.getIntegrationPoints(11, "Gauss4")
        determinants = gmsh.model.mesh.getJacobians(11, places)[1]
        self.assertGreater(min(determinants), 0)

    def test_msh(self):
        self.assert_read("a.msh", 11, 10)

    def test_msh22(self):
        self.assert_read("a.msh", 11, 10, "--format", "msh22")

    def test_medit(self):
        self.assert_read("a.mesh", 11, 10)


@unittest.skipIf(vtkXMLUnstructuredGridReader is None, "VTK was not found")
class Vtk(Order):
    def test_vtu(self):
        for options in ((), ("--compress",)):
            told, path = self.make("a.vtu", *options)
            grid = read_by_vtk(vtkXMLUnstructuredGridReader(), path)
            self.assertEqual({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}, {24})
            points, cells = arrays_of(grid)
            self.assert_in_the_middle(points, cells.reshape(-1, 10).astype(np.int64), VTK, told)


class Curved(ProgramTest):
    def volumes(self, size):
        """Those of a ball of radius 1, of straight and of curved elements."""
        found = []
        for options in ((), ("--curved",)):
            told = self.mesh("--shape", "sphere:1", "--size", size, "--order", 2, *options,
                             "-o", "ball.vtu")
            file = self.folder / "ball.vtu"
            points = np.array(vtu.points(file))
            cells = np.array(vtu.numbers(file, "connectivity")).reshape(-1, 10)
            found.append(curved_volume(points, cells))
            checked = self.check("ball.vtu")["order2"]
            self.assertAlmostEqual(checked["volume"], found[-1], places=9)
        return told, checked, np.array(found) / (4 / 3 * math.pi) - 1

    def test_ball(self):
        """The error of the volume falls by an order."""
        for size in (0.4, 0.2, 0.1):
            told, checked, (straight, curved) = self.volumes(size)
            print(f"ball, long edge {size}: volume {straight:+.2e} straight, {curved:+.2e} curved; "
                  f"{json.dumps(told['order2'])}")
            self.assertLess(abs(curved), abs(straight) / 10)
            self.assertGreaterEqual(told["order2"]["least_jacobian"], 0.25)
            self.assertAlmostEqual(told["order2"]["least_jacobian"], checked["least_jacobian"],
                                   places=6)
            self.assertEqual(told["order2"]["moved"], checked["bent"])

    def test_nodes_are_on_the_ball(self):
        told, _, _ = self.volumes(0.2)
        file = self.folder / "ball.vtu"
        points = np.array(vtu.points(file))
        cells = np.array(vtu.numbers(file, "connectivity")).reshape(-1, 10)
        corners = points[:told["mesh"]["points"]]
        bent = 0
        for place, (i, j) in enumerate(VTK):
            middles = (corners[cells[:, i]] + corners[cells[:, j]]) / 2
            nodes = points[cells[:, 4 + place]]
            moved = np.abs(nodes - middles).max(axis=1) > 1e-9
            bent += moved.sum()
            radii = np.linalg.norm(nodes[moved], axis=1)
            self.assertLess(np.abs(radii - 1).max(), 0.2 * 2**-15)
        self.assertGreater(bent, 0)

    def test_interfaces(self):
        """Two balls, one within the other: the middle nodes of both surfaces are on them."""
        told = self.mesh("--material", "ball=sphere:1", "--material", "core=sphere:0.6", "--size",
                         0.15, "--order", 2, "--curved", "-o", "two.vtu")
        self.assertEqual(told["order2"]["straight"]["seams"], 0)
        checked = self.check("two.vtu")
        self.assertLess(abs(checked["order2"]["volume"] / (4 / 3 * math.pi) - 1), 1e-3)
        self.assertEqual(told["order2"]["moved"], checked["order2"]["bent"])

    def test_rim(self):
        """Where bounds cut a ball off, the flat side stays flat; the straight mesh has not all of
        the rim itself, so that some edges there are far from the surface."""
        told = self.mesh("--expr", "x^2+y^2+z^2-1", "--bounds", "-1.2,-1.2,0,1.2,1.2,1.2",
                         "--size", 0.2, "--order", 2, "--curved", "-o", "half.vtu")
        file = self.folder / "half.vtu"
        z = np.array(vtu.points(file))[:, 2]
        self.assertGreater(z.min(), -1e-4)
        volume = self.check("half.vtu")["order2"]["volume"]
        self.assertLess(abs(volume / (2 / 3 * math.pi) - 1), 1e-2)
        self.assertEqual(told["order2"]["straight"]["seams"], 0)


@unittest.skipIf(shutil.which("ccx") is None, "calculix-ccx was not found")
class Calculix(ProgramTest):
    """The patch test: displacements that are linear on the surface are so within."""

    def displacements(self, *options):
        self.mesh("--shape", "box:1,1.2,0.8", "--size", 0.4, "-o", "a.inp", *options)
        text = (self.folder / "a.inp").read_text()
        nodes, kind, bodies = {}, "", []
        outer = set()
        elements = {}
        for line in text.splitlines():
            words = [w.strip() for w in line.split(",")]
            if line.startswith("*"):
                kind = words[0]
                if kind == "*ELEMENT":
                    bodies.append(words[-1].split("=")[1])
            elif kind == "*NODE":
                nodes[int(words[0])] = np.array([float(w) for w in words[1:]])
            elif kind == "*ELEMENT":
                elements[int(words[0])] = [int(w) for w in words[1:]]
        sides = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}
        for line in text[text.index("*SURFACE"):].splitlines():
            if line.startswith("*"):
                continue
            number, side = (w.strip() for w in line.split(","))
            corners = sides[side]
            element = elements[int(number)]
            outer |= {element[c] for c in corners}
            if len(element) == 10:
                outer |= {element[4 + e] for e, pair in enumerate(VTK) if set(pair) <= set(corners)}
        matrix = np.array([[2e-3, 5e-4, -3e-4], [1e-4, -1e-3, 2e-4], [4e-4, -2e-4, 1.5e-3]])
        lines = [text.rstrip(), "*MATERIAL, NAME=m", "*ELASTIC", "1000, 0.3"]
        lines += [f"*SOLID SECTION, ELSET={body}, MATERIAL=m" for body in bodies]
        lines += ["*NSET, NSET=all, GENERATE", f"1, {max(nodes)}", "*STEP", "*STATIC", "*BOUNDARY"]
        for n in sorted(outer):
            for axis, value in enumerate(matrix @ nodes[n]):
                lines.append(f"{n}, {axis + 1}, {axis + 1}, {value:.12e}")
        lines += ["*NODE PRINT, NSET=all", "U", "*END STEP", ""]
        (self.folder / "run.inp").write_text("\n".join(lines))
        run = subprocess.run(["ccx", "run"], cwd=self.folder, capture_output=True, text=True,
                             env={**os.environ, "OMP_NUM_THREADS": "1"})
        self.assertEqual(run.returncode, 0, run.stdout[-2000:])
        worst, inner = 0, 0
        for line in (self.folder / "run.dat").read_text().splitlines():
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                n = int(words[0])
                exact = matrix @ nodes[n]
                worst = max(worst, np.abs(np.array([float(w) for w in words[1:]]) - exact).max())
                inner += n not in outer
        self.assertGreater(inner, 10)
        return worst

    def test_patch(self):
        for options in ((), ("--order", 2)):
            self.assertLess(self.displacements(*options), 1e-8, options)

    def test_curved(self):
        """CalculiX integrates at four points, which is exact of straight elements alone."""
        self.assertLess(self.displacements("--order", 2, "--curved"), 2e-6)


if __name__ == "__main__":
    unittest.main()
