"""A ball, given by a function that is negative inside, becomes ball.vtu."""
import certet

mesh = certet.mesh(lambda points: (points**2).sum(1) - 1,  # of points (n, 3)
                   bounds=((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1)), size=0.1)
certet.write(mesh, "ball.vtu")
print(f"{len(mesh.tets)} tetrahedra, {len(certet.check(mesh).failures)} defects")
