"""SfePy, on files that it reads by meshio without their triangles: those of Nastran with regions,
those of Abaqus, VTK and XDMF without.  Its tetrahedra are linear, its fields of either degree."""

import importlib.util
import itertools
import re
import unittest

import numpy as np
from solids import (LAMBDA, LENGTH, MU, SHELLS, Refused, SolverTest, bent, heated, heated_tolerance, linear,
                    pressed, shells_tolerance, stretched, through_shells)

SFEPY = importlib.util.find_spec("sfepy") is not None
if SFEPY:
    from sfepy.base.base import output
    from sfepy.discrete import (Equation, Equations, FieldVariable, Function, Integral, Material,
                                Problem)
    from sfepy.discrete.conditions import Conditions, EssentialBC
    from sfepy.discrete.fem import FEDomain, Field, Mesh
    from sfepy.mechanics.matcoefs import stiffness_from_lame
    from sfepy.solvers.ls import ScipyDirect
    from sfepy.solvers.nls import Newton
    from sfepy.terms import Term

    output.set_output(quiet=True)


class Solid:
    """A field on the mesh of a file, and the weak form that it solves."""

    def __init__(self, file, components, degree):
        try:
            self.domain = FEDomain("solid", Mesh.from_file(str(file)))
            self.all = self.domain.create_region("all", "all")
        except (Exception, SystemExit) as error:
            raise Refused(str(error)) from error
        field = Field.from_args("field", np.float64, components, self.all, approx_order=degree)
        self.u = FieldVariable("u", "unknown", field)
        self.v = FieldVariable("v", "test", field, primary_var_name="u")
        self.points = field.get_coor()
        self.outer = self.domain.create_region("outer", "vertices of surface", "facet")
        self.terms, self.held, self.rule = [], [], Integral("rule", order=4)

    def add(self, name, region=None, source=False, **values):
        """A term on the left side, by SfePy's name of it."""
        material = {"m": Material(f"m{len(self.terms)}", **values)} if values else {}
        inside = f"{material['m'].name}.{next(iter(values))}, " if values else ""
        both = {} if source else {"u": self.u}
        words = f"{name}({inside}{', '.join(['v', *both])})"
        self.terms.append(Term.new(words, self.rule, region or self.all, v=self.v, **both,
                                   **{one.name: one for one in material.values()}))

    def choose(self, name, where, kind="vertex"):
        return self.domain.create_region(name, f"vertices in {where}", kind)

    def hold(self, region, exact, components="u.all"):
        """A region, at the values of a function of points."""
        values = Function(f"held{len(self.held)}", lambda ts, points, **_: exact(points).T.ravel("F"))
        self.held.append(EssentialBC(f"held{len(self.held)}", region, {components: values}))

    def error(self, exact):
        total = self.terms[0]
        for term in self.terms[1:]:
            total = total + term
        problem = Problem("solid", equations=Equations([Equation("balance", total)]))
        problem.set_bcs(ebcs=Conditions(self.held))
        problem.set_solver(Newton({"i_max": 1}, lin_solver=ScipyDirect({})))
        try:
            problem.solve(save_results=False)
        except ValueError as error:
            raise Refused(str(error)) from error
        self.found = self.u().reshape(len(self.points), -1).squeeze()
        return np.abs(self.found - exact(self.points)).max()


def with_wrong_corners(file):
    """Plants a defect: every fifth tetrahedron has point 1 for its last corner."""
    rows = itertools.count()
    file.write_text(re.sub(r"(?m)^(CTETRA.*).{8}$", lambda row: row[0] if next(rows) % 5 else
                           f"{row[1]}{1:8}", file.read_text()))
    return file


@unittest.skipUnless(SFEPY, "python3-sfepy was not found")
class SfePy(SolverTest):
    def patch_error(self, file, degree):
        solid = Solid(file, 3, degree)
        solid.add("dw_lin_elastic", D=stiffness_from_lame(3, LAMBDA, MU))
        solid.hold(solid.outer, linear)
        return solid.error(linear)

    def test_patch(self):
        for name in ("a.bdf", "a.vtu", "a.xdmf"):
            for degree in (1, 2):
                self.assertLess(self.patch_error(self.patch(name), degree), 1e-10)
        file = with_wrong_corners(self.patch("a.bdf"))
        self.assert_caught(lambda: self.patch_error(file, 1), 1e-10)

    def bar_error(self, file, degree, exact):
        solid = Solid(file, 3, degree)
        solid.add("dw_lin_elastic", D=stiffness_from_lame(3, LAMBDA, MU))
        try:
            ends = solid.choose("ends", f"(x < {1e-4 - LENGTH / 2}) | (x > {LENGTH / 2 - 1e-4})",
                                "facet")
        except ValueError as error:
            raise Refused(str(error)) from error
        low = solid.choose("low", f"(x < {1e-4 - LENGTH / 2}) & (y < -0.4999) & (z < -0.4999)")
        side = solid.choose("side", f"(x < {1e-4 - LENGTH / 2}) & (y > 0.4999) & (z < -0.4999)")
        for region, axis in ((ends, 0), (low, 1), (low, 2), (side, 2)):
            solid.hold(region, lambda points, axis=axis: exact(points)[:, axis], f"u.{axis}")
        return solid.error(exact)

    def test_bar(self):
        for degree, exact in ((1, stretched), (2, stretched), (2, bent)):
            self.assertLess(self.bar_error(self.bar("bar.vtu"), degree, exact), 1e-12)
        scaled = self.bar("bar.vtu", "--scale", 0.999)
        self.assert_caught(lambda: self.bar_error(scaled, 2, bent), 1e-12)

    def pressed_error(self, file, degree):
        """All of the surface is under pressure; three points hold the ball without a force."""
        solid = Solid(file, 3, degree)
        solid.add("dw_lin_elastic", D=stiffness_from_lame(3, LAMBDA, MU))
        solid.add("dw_surface_ltr", solid.outer, source=True, p=np.array([[1.0]] * 3 + [[0.0]] * 3))
        for name, axes in (("x", (1, 2)), ("y", (0, 2)), ("z", (0, 1))):
            pole = solid.choose(name, f"{name} > 0.9999")
            for axis in axes:
                solid.hold(pole, lambda points, axis=axis: pressed(points)[:, axis], f"u.{axis}")
        return solid.error(pressed)

    def test_pressed_ball(self):
        for degree in (1, 2):
            self.assertLess(self.pressed_error(self.ball("ball.vtu", 0.5), degree), 1e-12)
        spoilt = with_wrong_corners(self.ball("ball.bdf", 0.5))
        self.assert_caught(lambda: self.pressed_error(spoilt, 1), 1e-12)

    def heated_error(self, file, degree):
        solid = Solid(file, 1, degree)
        solid.add("dw_laplace", k=1.0)
        solid.add("dw_integrate", source=True, f=-1.0)
        solid.hold(solid.outer, lambda points: np.zeros(len(points)))
        return solid.error(heated)

    def test_heated_ball(self):
        size = 0.4
        for degree in (1, 2):
            file = self.ball("ball.xdmf", size)
            self.assertLess(self.heated_error(file, degree), heated_tolerance(size))
        scaled = self.ball("ball.xdmf", size, "--scale", 1.5)
        self.assert_caught(lambda: self.heated_error(scaled, 1), heated_tolerance(size))

    def shells_error(self, file, degree):
        """By the numbers of regions."""
        solid = Solid(file, 1, degree)
        for label, (_, _, conductivity) in enumerate(SHELLS, start=1):
            solid.add("dw_laplace", solid.domain.create_region(f"shell{label}", f"cells of group {label}"),
                      k=conductivity)
        solid.add("dw_integrate", source=True, f=-1.0)
        solid.hold(solid.outer, lambda points: np.zeros(len(points)))
        return solid.error(through_shells) / through_shells(np.zeros((1, 3)))[0]

    def test_shells(self):
        size = 0.25
        for degree in (1, 2):
            file = self.shells("shells.bdf", size)
            self.assertLess(self.shells_error(file, degree), shells_tolerance(size))
        wrong = self.shells("shells.bdf", size, order=(0, 2, 1))
        self.assert_caught(lambda: self.shells_error(wrong, 1), shells_tolerance(size))

    def test_example(self):
        self.assert_poisson("sfepy_ball.py", "sfepy-run", "simple", "sfepy_ball.py",
                            tolerance=heated_tolerance(0.3))


if __name__ == "__main__":
    unittest.main()
