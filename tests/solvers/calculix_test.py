"""CalculiX, on files of Abaqus' format."""

import os
import re
import shutil
import subprocess
import unittest

import numpy as np
from solids import (AT_INTERFACES, CURVED_MEAN, LENGTH, POISSON, SHELLS, STRAIGHT_MEAN, YOUNG, Refused,
                    SolverTest, bent, exchange_nodes, heated, heated_tolerance, linear, numbers,
                    pressed, shells_tolerance, stretched, through_shells)

# The edges of middle nodes, and the corners of the faces S1 to S4.
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))

# What is printed has seven digits, of displacements of at most 5e-3 and temperatures of at most 1.
SEVEN_DIGITS = 1e-8
ELASTIC = f"*ELASTIC\n{YOUNG}, {POISSON}"


class Mesh:
    """Of a file: points, element sets by name, and the nodes of its surfaces by name."""

    def __init__(self, file):
        self.file, self.sets, self.surfaces = file, [], {}
        points, elements = [], {}
        for line in file.read_text().splitlines():
            words = [w.strip() for w in line.split(",")]
            if line.startswith("*"):
                kind, name = words[0], words[-1].partition("=")[2]
                if kind == "*ELEMENT":
                    self.sets.append(name)
            elif kind == "*NODE":
                points.append([float(w) for w in words[1:]])
            elif kind == "*ELEMENT":
                elements[int(words[0])] = [int(w) for w in words[1:]]
            elif kind == "*SURFACE":
                nodes = self.surfaces.setdefault(name, set())
                nodes.update(self.of_face(elements[int(words[0])], FACES[int(words[1][1]) - 1]))
        self.points = np.array(points)

    @staticmethod
    def of_face(element, corners):
        middles = [4 + place for place, edge in enumerate(EDGES) if set(edge) <= set(corners)]
        return [element[place] for place in [*corners, *middles] if place < len(element)]

    def around(self):
        return sorted(self.surfaces.get("surface", set()) | self.surfaces.get("border", set()))

    def where(self, chosen):
        """The numbers of points, by a truth value for each."""
        return (np.nonzero(chosen)[0] + 1).tolist()

    def nearest(self, place):
        return int(np.argmin(((self.points - place) ** 2).sum(axis=1))) + 1


def held(nodes, axis, values):
    """Lines of *BOUNDARY."""
    return [f"{node}, {axis}, {axis}, {value:.12e}" for node, value in zip(nodes, values)]


@unittest.skipIf(shutil.which("ccx") is None, "calculix-ccx was not found")
class Calculix(SolverTest):
    def solve(self, mesh, materials, step, ask):
        """What is asked for, of each node: shape (n,) or (n, 3)."""
        lines = [f"*INCLUDE, INPUT={mesh.file.name}", "*NSET, NSET=all, GENERATE",
                 f"1, {len(mesh.points)}"]
        for name, material in zip(mesh.sets, materials):
            lines += [f"*MATERIAL, NAME={name}", material,
                      f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"]
        lines += ["*STEP", *step, "*NODE PRINT, NSET=all", ask, "*END STEP", ""]
        (self.folder / "run.inp").write_text("\n".join(lines))
        run = subprocess.run(["ccx", "run"], cwd=self.folder, capture_output=True, text=True,
                             timeout=100, env={**os.environ, "OMP_NUM_THREADS": "1"})
        rows = [line.split() for line in (self.folder / "run.dat").read_text().splitlines()
                if re.match(r"\s+\d+\s+\S*\d\.\d", line)] if run.returncode == 0 else []
        if len(rows) != len(mesh.points):
            raise Refused(run.stdout[-2000:])
        return np.array([[float(w) for w in row[1:]] for row in rows]).squeeze()

    def moved(self, mesh, step):
        return self.solve(mesh, [ELASTIC] * len(mesh.sets), ["*STATIC", *step], "U")

    def warmed(self, mesh, conductivities, step):
        materials = [f"*CONDUCTIVITY\n{value}" for value in conductivities]
        return self.solve(mesh, materials, ["*HEAT TRANSFER, STEADY STATE", *step], "NT")

    def patch_error(self, file):
        mesh = Mesh(file)
        nodes = mesh.around()
        exact = linear(mesh.points)
        step = ["*BOUNDARY"]
        for axis in range(3):
            step += held(nodes, axis + 1, exact[np.array(nodes) - 1, axis])
        self.assertGreater(len(mesh.points) - len(nodes), 10)
        return np.abs(self.moved(mesh, step) - exact).max()

    def test_patch(self):
        for order, places in ((1, (0, 1)), (2, (0, 1))):
            file = self.patch(f"order{order}.inp", "--order", order)
            self.assertLess(self.patch_error(file), SEVEN_DIGITS)
            exchange_nodes(file, places, numbers(11 if order == 2 else 5, ", *"))
            self.assert_caught(lambda: self.patch_error(file), SEVEN_DIGITS)

    def bar_error(self, file, answer):
        """Both ends are moved along x as they should be, all else is free, but for what holds the
        bar where it is."""
        mesh = Mesh(file)
        exact = answer(mesh.points)
        ends = mesh.where(np.abs(np.abs(mesh.points[:, 0]) - LENGTH / 2) < 1e-6)
        if not ends:
            raise Refused("no nodes at the ends")
        low, side = (mesh.nearest((-LENGTH / 2, y, -0.5)) for y in (-0.5, 0.5))
        step = ["*BOUNDARY", *held(ends, 1, exact[np.array(ends) - 1, 0])]
        for node, axis in ((low, 2), (low, 3), (side, 3)):
            step += held([node], axis, [exact[node - 1, axis - 1]])
        return np.abs(self.moved(mesh, step) - exact).max()

    def test_bar(self):
        for order, answer in ((1, stretched), (2, stretched), (2, bent)):
            file = self.bar("bar.inp", "--order", order)
            self.assertLess(self.bar_error(file, answer), SEVEN_DIGITS)
        exchange_nodes(file, (1, 2), numbers(11, ", *"))
        self.assert_caught(lambda: self.bar_error(file, bent), SEVEN_DIGITS)
        scaled = self.bar("bar.inp", "--order", 2, "--scale", 1.001)
        self.assert_caught(lambda: self.bar_error(scaled, bent), SEVEN_DIGITS)

    def pressed_error(self, file):
        """The file's own surface is under pressure; three nodes hold the ball without a force."""
        mesh = Mesh(file)
        exact = pressed(mesh.points)
        nodes = [mesh.nearest(place) for place in np.eye(3)]
        step = ["*BOUNDARY"]
        for node, axis in zip((0, 0, 1, 1, 2, 2), (2, 3, 1, 3, 1, 2)):
            step += held([nodes[node]], axis, [exact[nodes[node] - 1, axis - 1]])
        return np.abs(self.moved(mesh, step + ["*DSLOAD", "surface, P, 1"]) - exact).max()

    def test_pressed_ball(self):
        for order in (1, 2):
            file = self.ball("ball.inp", 0.5, "--order", order)
            self.assertLess(self.pressed_error(file), SEVEN_DIGITS)
        text = file.read_text()
        turned, count = re.subn(r"(\*SURFACE.*\n.*)S3\n", r"\1S4\n", text, count=1)
        self.assertEqual(count, 1)
        file.write_text(turned)
        self.assert_caught(lambda: self.pressed_error(file), SEVEN_DIGITS)

    def heated_error(self, file):
        mesh = Mesh(file)
        nodes = mesh.around()
        step = ["*BOUNDARY", *held(nodes, 11, np.zeros(len(nodes))), "*DFLUX",
                *(f"{name}, BF, 1" for name in mesh.sets)]
        return np.abs(self.warmed(mesh, [1], step) - heated(mesh.points)).max()

    def test_heated_ball(self):
        """Curved elements are nearer by an order."""
        size = 0.4
        for options, better in (((), 1), (("--order", 2), 1), (("--order", 2, "--curved"), 10)):
            file = self.ball("ball.inp", size, *options)
            self.assertLess(self.heated_error(file), heated_tolerance(size) / better)
        scaled = self.ball("ball.inp", size, *options, "--scale", 1.05)
        self.assert_caught(lambda: self.heated_error(scaled), heated_tolerance(size) / 10)

    def shells_errors(self, file):
        """By the names of the regions, of all points and of the interfaces' means."""
        mesh = Mesh(file)
        conductivity = {name: value for name, _, value in SHELLS}
        nodes = sorted(mesh.surfaces["surface"])
        step = ["*BOUNDARY", *held(nodes, 11, np.zeros(len(nodes))), "*DFLUX",
                *(f"{name}, BF, 1" for name in mesh.sets)]
        found = self.warmed(mesh, [conductivity[name] for name in mesh.sets], step)
        exact = through_shells(mesh.points)
        means = [found[np.array(sorted(mesh.surfaces[name])) - 1].mean() / value - 1
                 for name, value in zip(("outer_middle", "middle_core"), AT_INTERFACES)]
        return np.abs(found - exact).max() / exact.max(), np.abs(means).max()

    def test_shells(self):
        size = 0.25
        for options, mean in (((), STRAIGHT_MEAN), (("--order", 2), STRAIGHT_MEAN),
                              (("--order", 2, "--curved"), CURVED_MEAN)):
            file = self.shells("shells.inp", size, *options)
            errors = self.shells_errors(file)
            self.assertLess(errors[0], shells_tolerance(size))
            self.assertLess(errors[1], mean)
        text = file.read_text()
        for one, other in (("middle", "x"), ("core", "middle"), ("x", "core")):
            text = text.replace(f"ELSET={one}\n", f"ELSET={other}\n")
        file.write_text(text)
        for n, tolerance in enumerate((shells_tolerance(size), CURVED_MEAN)):
            self.assert_caught(lambda: self.shells_errors(file)[n], tolerance / 2)

    def test_example(self):
        """The stress is the same everywhere."""
        self.run_example("calculix.inp", "ccx", "calculix")
        rows = [line.split() for line in (self.folder / "calculix.dat").read_text().splitlines()]
        stresses = np.array([row[2:] for row in rows if len(row) == 8 and row[0].isdigit()], float)
        self.assertGreater(len(stresses), 1000)
        self.assertLess(np.abs(stresses - [-100, -100, -100, 0, 0, 0]).max(), 1e-3)


if __name__ == "__main__":
    unittest.main()
