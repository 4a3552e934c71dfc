"""-Δu = f on a ball of one size and graded, by FreeFem: how far the solution is from u in the energy
norm.  One u falls off within a thirtieth of the radius, the other is as smooth as can be.

Alone, with sizes, it prints a table: graded_test.py 0.1 0.05
"""

import os
import re
import shutil
import subprocess
import sys
import unittest

from solids import SolverTest

LAYER = 30
FIELD = "{size}*exp({rate}*(1-hypot(x,y,z)))"

SCRIPT = """
mesh3 solid = readmesh3("FILE");
fespace Space(solid, P1);
Space u, v;
func R = sqrt(x^2 + y^2 + z^2) + 1e-12;
SOLUTION
solve Poisson(u, v, solver = CG, eps = 1e-9) = int3d(solid)(dx(u) * dx(v) + dy(u) * dy(v) + dz(u) * dz(v))
  - int3d(solid)(SOURCE * v) + on(1, u = U);
cout << "error " << sqrt(int3d(solid)((dx(u) - SLOPE * x / R)^2 + (dy(u) - SLOPE * y / R)^2
                                      + (dz(u) - SLOPE * z / R)^2) / int3d(solid)(SLOPE^2)) << endl;
"""
LAYERED = f"""
func U = sinh({LAYER} * R) / (R * sinh({LAYER}.));
func SLOPE = ({LAYER} * cosh({LAYER} * R) - sinh({LAYER} * R) / R) / (R * sinh({LAYER}.));
func SOURCE = -{LAYER**2} * U;
"""
SMOOTH = """
func U = 1 - R^2;
func SLOPE = -2 * R;
func SOURCE = 6.;
"""


@unittest.skipIf(shutil.which("FreeFem++-nw") is None, "freefem++ was not found")
class GradedPoisson(SolverTest):
    def error(self, solution, size, *options):
        """Of the energy norm, relative; and how many tetrahedra there are."""
        run = self.mesh("--shape", "sphere:1", "--size", size, *options, "-o", "ball.mesh")
        script = SCRIPT.replace("FILE", "ball.mesh").replace("SOLUTION", solution)
        (self.folder / "a.edp").write_text(script)
        told = subprocess.run(["FreeFem++-nw", "-nw", "-v", "0", "a.edp"], text=True,
                              capture_output=True, timeout=900, cwd=self.folder,
                              env={**os.environ, "FF_LOADPATH": "/usr/lib/freefem++"})
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        return float(re.search(r"error (\S+)", told.stdout)[1]), run["mesh"]["tets"]

    @staticmethod
    def within(size):
        """Edges that double where u has fallen off by four."""
        return "--size-field", FIELD.format(size=size, rate=LAYER / 2)

    def test_where_the_solution_has_a_layer(self):
        size = 0.0667
        uniform, tets = self.error(LAYERED, size)
        for options in (("--grade", 3), self.within(size)):
            graded, fewer = self.error(LAYERED, size, *options)
            self.assertLess(graded, 1.1 * uniform)
            self.assertLess(fewer, tets / 3)
        # Larger tetrahedra at the surface too are noticed.
        coarse, _ = self.error(LAYERED, 1.5 * size)
        self.assertGreater(coarse, 1.2 * uniform)

    def test_where_the_solution_is_smooth(self):
        """Then it is the larger tetrahedra that decide, as is to be expected."""
        uniform, _ = self.error(SMOOTH, 0.1)
        graded, _ = self.error(SMOOTH, 0.1, "--grade", 3)
        self.assertGreater(graded, 1.2 * uniform)
        self.assertLess(graded, 8 * uniform)


def table(sizes):
    test = GradedPoisson("test_where_the_solution_is_smooth")
    test.setUp()
    for size in sizes:
        for name, solution in (("layer", LAYERED), ("smooth", SMOOTH)):
            for options in ((), ("--grade", 3), test.within(size)):
                if name == "smooth" and "--size-field" in options:
                    continue
                error, tets = test.error(solution, size, *options)
                print(size, name, *options, tets, f"{error:.5f}", flush=True)
    test.doCleanups()

if __name__ == "__main__":
    if len(sys.argv) > 1:
        table([float(word) for word in sys.argv[1:]])
    else:
        unittest.main()
