"""GetFEM, on files of Gmsh's format 2.2."""

import re
import sys
import unittest

import numpy as np
from solids import (AT_INTERFACES, CURVED_MEAN, LAMBDA, LENGTH, MU, SHELLS, STRAIGHT_MEAN, Refused,
                    SolverTest, bent, exchange_nodes, heated, heated_tolerance, linear, numbers,
                    pressed, shells_tolerance, stretched, through_shells)

try:
    import getfem
except ImportError:
    getfem = None
else:
    getfem.util_trace_level(0)
    getfem.util_warning_level(0)

# What GetFEM has in the place of a face's number, of a whole tetrahedron.
WHOLE = 65535
# Regions of our own: those of a file are its patches, interfaces and labels.
OUTER, PRESSED, ENDS, OWN = 1001, 1002, 1003, 1010


class Problem:
    """A field on the mesh of a file, whose elements have the degree of its tetrahedra or another."""

    def __init__(self, file, components, degree):
        try:
            self.mesh = getfem.Mesh("import", "gmsh", str(file))
        except RuntimeError as error:
            raise Refused(str(error)) from error
        self.components = components
        self.rule = getfem.MeshIm(self.mesh, getfem.Integ("IM_TETRAHEDRON(5)"))
        self.elements = getfem.MeshFem(self.mesh, components)
        self.elements.set_fem(getfem.Fem(f"FEM_PK(3,{degree})"))
        self.model = getfem.Model("real")
        self.model.add_fem_variable("u", self.elements)
        self.mesh.set_region(OUTER, self.mesh.outer_faces())

    def points(self):
        return self.elements.basic_dof_nodes().T[::self.components]

    def own(self, region, number, faces):
        """Makes a region of a file's: of its faces or its solids, for which GetFEM has one
        numbering."""
        found = self.mesh.region(number)
        self.mesh.set_region(region, found[:, (found[1] != WHOLE) == faces])

    def choose(self, region, low, high, axis):
        """The outer faces between two places along an axis."""
        box = np.array([[-9.0] * 3, [9.0] * 3])
        box[:, axis] = low - 1e-4, high + 1e-4
        self.mesh.set_region(region, self.mesh.outer_faces_in_box(*box))

    def add(self, bilinear, source="", region=-1):
        """Of the weak form, both sides."""
        if bilinear:
            self.model.add_linear_term(self.rule, bilinear, region)
        if source:
            self.model.add_source_term(self.rule, source, region)

    def add_elastic(self):
        self.add(f"{LAMBDA} * Div_u * Div_Test_u + {2 * MU} * Sym(Grad_u) : Grad_Test_u")

    def hold(self, values):
        """All of the surface."""
        self.model.add_initialized_fem_data("held", self.elements, np.ravel(values))
        self.model.add_Dirichlet_condition_with_simplification("u", OUTER, "held")

    def leash(self, exact):
        """Holds a solid that is free to move as a whole, without a force where it is right."""
        self.model.add_initialized_fem_data("exact", self.elements, np.ravel(exact(self.points())))
        self.add("1e-6 * u . Test_u", "1e-6 * exact . Test_u")

    def error(self, exact):
        try:
            self.model.solve()
        except RuntimeError as error:
            raise Refused(str(error)) from error
        found = np.reshape(self.model.variable("u"), (-1, self.components)).squeeze()
        return np.abs(found - exact(self.points())).max()


@unittest.skipIf(getfem is None, "python3-getfem was not found")
class GetFem(SolverTest):
    MSH = "--format", "msh22"

    def patch_error(self, file, degree):
        problem = Problem(file, 3, degree)
        problem.add_elastic()
        problem.hold(linear(problem.points()))
        return problem.error(linear)

    def test_patch(self):
        for order in (1, 2):
            file = self.patch("a.msh", *self.MSH, "--order", order)
            for degree in (1, 2):
                self.assertLess(self.patch_error(file, degree), 1e-10)
        exchange_nodes(file, (1, 2), numbers(15))
        self.assert_caught(lambda: self.patch_error(file, 2), 1e-10)

    def bar_error(self, file, degree, exact):
        """Both ends are moved along x, by stiff springs."""
        problem = Problem(file, 3, degree)
        problem.add_elastic()
        problem.leash(exact)
        for region, x in ((ENDS, -LENGTH / 2), (ENDS + 1, LENGTH / 2)):
            problem.choose(region, x, x, axis=0)
            problem.add("1e9 * u(1) * Test_u(1)", "1e9 * exact(1) * Test_u(1)", region)
        return problem.error(exact)

    def test_bar(self):
        for order, exact in ((1, stretched), (2, stretched), (2, bent)):
            file = self.bar("bar.msh", *self.MSH, "--order", order)
            self.assertLess(self.bar_error(file, order, exact), 1e-8)
        exchange_nodes(file, (1, 2), numbers(15))
        self.assert_caught(lambda: self.bar_error(file, 2, bent), 1e-8)
        scaled = self.bar("bar.msh", *self.MSH, "--order", 2, "--scale", 1.001)
        self.assert_caught(lambda: self.bar_error(scaled, 2, bent), 1e-8)

    def pressed_error(self, file, degree):
        """The file's own surface is under pressure."""
        problem = Problem(file, 3, degree)
        problem.add_elastic()
        problem.leash(pressed)
        problem.own(PRESSED, 1, faces=True)
        problem.add("", "-Normal . Test_u", PRESSED)
        return problem.error(pressed)

    def test_pressed_ball(self):
        for order in (1, 2):
            file = self.ball("ball.msh", 0.5, *self.MSH, "--order", order)
            self.assertLess(self.pressed_error(file, order), 1e-8)
        moved, count = re.subn(r"(?m)^(\d+) 9 2 1 1 ", r"\1 9 2 2 2 ", file.read_text(), count=1)
        self.assertEqual(count, 1)
        file.write_text(moved)
        self.assert_caught(lambda: self.pressed_error(file, 2), 1e-8)

    def heated_error(self, file, degree):
        problem = Problem(file, 1, degree)
        problem.add("Grad_u . Grad_Test_u", "Test_u")
        problem.hold(np.zeros(len(problem.points())))
        return problem.error(heated)

    def test_heated_ball(self):
        """As with CalculiX, curved elements are nearer by an order."""
        size = 0.4
        for degree, options, better in ((1, (), 1), (2, ("--order", 2), 1),
                                        (2, ("--order", 2, "--curved"), 10)):
            file = self.ball("ball.msh", size, *self.MSH, *options)
            self.assertLess(self.heated_error(file, degree), heated_tolerance(size) / better)
        scaled = self.ball("ball.msh", size, *self.MSH, *options, "--scale", 1.05)
        self.assert_caught(lambda: self.heated_error(scaled, 2), heated_tolerance(size) / 10)

    def shells_errors(self, file, degree):
        """By the numbers of regions, of all points and of the interfaces' means."""
        problem = Problem(file, 1, degree)
        problem.hold(np.zeros(len(problem.points())))
        problem.add("", "Test_u")
        for label, (_, _, conductivity) in enumerate(SHELLS, start=1):
            problem.own(OWN + label, label, faces=False)
            problem.add(f"{conductivity} * Grad_u . Grad_Test_u", region=OWN + label)
        worst, means = problem.error(through_shells), []
        for number, value in zip((3, 4), AT_INTERFACES):
            problem.own(OWN, number, faces=True)
            nodes = problem.elements.basic_dof_on_region(OWN)
            means.append(problem.model.variable("u")[nodes].mean() / value - 1)
        return worst / through_shells(np.zeros((1, 3)))[0], np.abs(means).max()

    def test_shells(self):
        size = 0.25
        for degree, options, mean in ((1, (), STRAIGHT_MEAN), (2, ("--order", 2), STRAIGHT_MEAN),
                                      (2, ("--order", 2, "--curved"), CURVED_MEAN)):
            file = self.shells("shells.msh", size, *self.MSH, *options)
            errors = self.shells_errors(file, degree)
            self.assertLess(errors[0], shells_tolerance(size))
            self.assertLess(errors[1], mean)
        wrong = self.shells("shells.msh", size, *self.MSH, order=(0, 2, 1))
        for n, tolerance in enumerate((shells_tolerance(size), STRAIGHT_MEAN)):
            self.assert_caught(lambda: self.shells_errors(wrong, 1)[n], tolerance / 2)

    def test_example(self):
        self.assert_poisson("getfem_ball.py", sys.executable, "getfem_ball.py",
                            tolerance=heated_tolerance(0.4) / 10)


if __name__ == "__main__":
    unittest.main()
