# -Δu = 1 in a ball, u = 0 around it: certet mesh --shape sphere:1 --size 0.4 --order 2 --curved -o ball.msh --format msh22
import getfem

mesh = getfem.Mesh("import", "gmsh", "ball.msh")
mesh.set_region(1000, mesh.outer_faces())
elements = getfem.MeshFem(mesh, 1)
elements.set_fem(getfem.Fem("FEM_PK(3, 2)"))
rule = getfem.MeshIm(mesh, getfem.Integ("IM_TETRAHEDRON(5)"))
model = getfem.Model("real")
model.add_fem_variable("u", elements)
model.add_linear_term(rule, "Grad_u . Grad_Test_u")
model.add_source_term(rule, "Test_u")
model.add_Dirichlet_condition_with_simplification("u", 1000)
model.solve()
print("u in the middle is", max(model.variable("u")), "and of a true ball 1/6")
