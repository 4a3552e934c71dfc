# -Δu = 1 in a ball, u = 0 around it: certet mesh --shape sphere:1 --size 0.3 -o ball.xdmf
import ufl
from dolfinx import fem, io
from dolfinx.fem.petsc import LinearProblem
from dolfinx.mesh import exterior_facet_indices
from mpi4py import MPI

mesh = io.XDMFFile(MPI.COMM_SELF, "ball.xdmf", "r").read_mesh(name="mesh")
space = fem.FunctionSpace(mesh, ("CG", 2))
u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
mesh.topology.create_connectivity(2, 3)
around = fem.locate_dofs_topological(space, 2, exterior_facet_indices(mesh.topology))
found = LinearProblem(ufl.dot(ufl.grad(u), ufl.grad(v)) * ufl.dx, v * ufl.dx,
                      bcs=[fem.dirichletbc(0.0, around, space)]).solve()
print("u in the middle is", found.x.array.max(), "and of a true ball 1/6")
