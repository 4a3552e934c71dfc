"""DOLFINx, on files of XDMF, and of Gmsh's formats by Gmsh's own module, of four and of ten nodes."""

import importlib.util
import sys
import unittest

import numpy as np
from solids import (AT_INTERFACES, CURVED_MEAN, LAMBDA, LENGTH, MU, SHELLS, STRAIGHT_MEAN, SolverTest,
                    bent, exchange_nodes, heated, heated_tolerance, linear, numbers, pressed,
                    shells_tolerance, stretched, through_shells)

DOLFINX = all(importlib.util.find_spec(name) for name in ("dolfinx", "gmsh"))
if DOLFINX:
    import gmsh
    import ufl
    from dolfinx.fem import (Constant, Function, FunctionSpace, VectorFunctionSpace, assemble_scalar,
                             dirichletbc, form, locate_dofs_topological)
    from dolfinx.fem.petsc import LinearProblem
    from dolfinx.io import XDMFFile, gmshio
    from dolfinx.mesh import exterior_facet_indices
    from mpi4py import MPI
    from petsc4py import PETSc


def read(file):
    """The mesh, the labels of its tetrahedra, and the numbers of its patches and interfaces."""
    if file.suffix == ".msh":
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(file))
        found = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0)
        gmsh.finalize()
        return found
    with XDMFFile(MPI.COMM_SELF, str(file), "r") as mesh_file:
        mesh = mesh_file.read_mesh(name="mesh")
        labels = mesh_file.read_meshtags(mesh, name="mesh")
    # It looks for the numbers by the name of the description.
    surfaces = file.with_name(file.stem + "_surfaces.xdmf")
    surfaces.with_suffix(".h5").unlink(missing_ok=True)
    surfaces.with_suffix(".h5").symlink_to(file.with_suffix(".h5"))
    mesh.topology.create_connectivity(2, 3)
    with XDMFFile(MPI.COMM_SELF, str(surfaces), "r") as mesh_file:
        return mesh, labels, mesh_file.read_meshtags(mesh, name="surfaces")


class Solid:
    """A field on the mesh of a file."""

    def __init__(self, file, components, degree):
        self.mesh, self.labels, self.sheets = read(file)
        space = (FunctionSpace if components == 1 else VectorFunctionSpace)(self.mesh, ("CG", degree))
        self.space, self.components = space, components
        self.u, self.v = ufl.TrialFunction(space), ufl.TestFunction(space)
        self.points = space.tabulate_dof_coordinates()
        self.inside = ufl.Measure("dx", self.mesh, subdomain_data=self.labels)

    def number(self, value):
        return Constant(self.mesh, PETSc.ScalarType(value))

    def held(self, exact):
        """All of the surface."""
        values = Function(self.space)
        values.x.array[:] = exact(self.points).ravel()
        self.mesh.topology.create_connectivity(2, 3)
        around = exterior_facet_indices(self.mesh.topology)
        return dirichletbc(values, locate_dofs_topological(self.space, 2, around))

    def elastic(self):
        strain = ufl.sym(ufl.grad(self.u))
        stress = (self.number(LAMBDA) * ufl.tr(strain) * ufl.Identity(3)
                  + self.number(2 * MU) * strain)
        return ufl.inner(stress, ufl.sym(ufl.grad(self.v))) * self.inside

    def leash(self, exact):
        """Holds a solid that is free to move as a whole, without a force where it is right."""
        values = Function(self.space)
        values.x.array[:] = exact(self.points).ravel()
        weak = self.number(1e-6)
        return (weak * ufl.inner(self.u, self.v) * self.inside,
                weak * ufl.inner(values, self.v) * self.inside, values)

    def error(self, exact, left, right, held=()):
        self.found = LinearProblem(left, right, bcs=list(held),
                                   petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
        values = self.found.x.array.reshape(len(self.points), -1).squeeze()
        return np.abs(values - exact(self.points)).max()


FILES = [("a.xdmf", (), 1), ("a.msh", (), 1), ("a.msh", ("--format", "msh22"), 1),
         ("a.msh", ("--order", 2), 2), ("a.msh", ("--order", 2, "--format", "msh22"), 2)]


@unittest.skipUnless(DOLFINX, "python3-dolfinx was not found")
class Dolfinx(SolverTest):
    def patch_error(self, file, degree):
        solid = Solid(file, 3, degree)
        nothing = solid.number((0.0, 0.0, 0.0))
        return solid.error(linear, solid.elastic(), ufl.inner(nothing, solid.v) * solid.inside,
                           [solid.held(linear)])

    def test_patch(self):
        for name, options, order in FILES:
            self.assertLess(self.patch_error(self.patch(name, *options), order), 1e-10)
        spoilt = exchange_nodes(self.patch("a.msh", "--order", 2, "--format", "msh22"), (1, 2), numbers(15))
        self.assert_caught(lambda: self.patch_error(spoilt, 2), 1e-10)

    def bar_error(self, file, degree, exact):
        """Both ends are moved along x, by stiff springs."""
        solid = Solid(file, 3, degree)
        left, right, values = solid.leash(exact)
        x = ufl.SpatialCoordinate(solid.mesh)[0]
        grip = ufl.conditional(abs(abs(x) - LENGTH / 2) < 1e-6, 1e9, 0.0)
        left += grip * solid.u[0] * solid.v[0] * ufl.ds
        right += grip * values[0] * solid.v[0] * ufl.ds
        return solid.error(exact, solid.elastic() + left, right)

    def test_bar(self):
        for order, exact in ((1, stretched), (2, stretched), (2, bent)):
            file = self.bar("bar.msh", "--order", order)
            self.assertLess(self.bar_error(file, order, exact), 1e-8)
        scaled = self.bar("bar.msh", "--order", 2, "--scale", 1.001)
        self.assert_caught(lambda: self.bar_error(scaled, 2, bent), 1e-8)

    def pressed_error(self, file, degree, patch=1):
        """A patch of the file is under pressure."""
        solid = Solid(file, 3, degree)
        left, right, _ = solid.leash(pressed)
        around = ufl.Measure("ds", solid.mesh, subdomain_data=solid.sheets)
        right -= ufl.inner(ufl.FacetNormal(solid.mesh), solid.v) * around(patch)
        return solid.error(pressed, solid.elastic() + left, right)

    def test_pressed_ball(self):
        for name, order in (("ball.xdmf", 1), ("ball.msh", 2)):
            file = self.ball(name, 0.5, "--order", order)
            self.assertLess(self.pressed_error(file, order), 1e-8)
        self.assert_caught(lambda: self.pressed_error(file, 2, patch=2), 1e-8)

    def heated_error(self, file, degree):
        solid = Solid(file, 1, degree)
        return solid.error(heated, ufl.dot(ufl.grad(solid.u), ufl.grad(solid.v)) * solid.inside,
                           solid.number(1.0) * solid.v * solid.inside,
                           [solid.held(lambda points: np.zeros(len(points)))])

    def test_heated_ball(self):
        """As with CalculiX, curved elements are nearer by an order."""
        size = 0.4
        for degree, options, better in ((1, (), 1), (2, ("--order", 2), 1),
                                        (2, ("--order", 2, "--curved"), 10)):
            file = self.ball("ball.msh", size, *options)
            self.assertLess(self.heated_error(file, degree), heated_tolerance(size) / better)
        scaled = self.ball("ball.msh", size, *options, "--scale", 1.05)
        self.assert_caught(lambda: self.heated_error(scaled, 2), heated_tolerance(size) / 10)

    def shells_errors(self, file, degree):
        """By the numbers of regions, of all points and of the means on interfaces."""
        solid = Solid(file, 1, degree)
        left = sum(solid.number(conductivity) * ufl.dot(ufl.grad(solid.u), ufl.grad(solid.v))
                   * solid.inside(label) for label, (_, _, conductivity) in enumerate(SHELLS, start=1))
        worst = solid.error(through_shells, left, solid.number(1.0) * solid.v * solid.inside,
                            [solid.held(lambda points: np.zeros(len(points)))])
        between = ufl.Measure("dS", solid.mesh, subdomain_data=solid.sheets)
        one = solid.number(1.0)
        means = []
        for number, value in zip((3, 4), AT_INTERFACES):
            total = assemble_scalar(form(ufl.avg(solid.found) * between(number)))
            means.append(total / assemble_scalar(form(ufl.avg(one) * between(number))) / value - 1)
        return worst / through_shells(np.zeros((1, 3)))[0], np.abs(means).max()

    def test_shells(self):
        size = 0.25
        for name, options, order, mean in (("a.xdmf", (), 1, STRAIGHT_MEAN),
                                           ("a.msh", (), 1, STRAIGHT_MEAN),
                                           ("a.msh", ("--order", 2, "--curved"), 2, CURVED_MEAN)):
            errors = self.shells_errors(self.shells(name, size, *options), order)
            self.assertLess(errors[0], shells_tolerance(size))
            self.assertLess(errors[1], mean)
        wrong = self.shells("wrong.xdmf", size, order=(0, 2, 1))
        for n, tolerance in enumerate((shells_tolerance(size), STRAIGHT_MEAN)):
            self.assert_caught(lambda: self.shells_errors(wrong, 1)[n], tolerance / 2)

    def test_example(self):
        self.assert_poisson("dolfinx_ball.py", sys.executable, "dolfinx_ball.py",
                            tolerance=heated_tolerance(0.3))


if __name__ == "__main__":
    unittest.main()
