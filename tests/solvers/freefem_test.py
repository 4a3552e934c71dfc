"""FreeFem, on files of MEDIT's and Gmsh's formats.  It has linear tetrahedra alone, on which its
elements P2 are quadratic; each script tells how far it is from what is right."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

from solids import (AT_INTERFACES, GRADIENT, LAMBDA, LENGTH, MU, POISSON, SHELLS, STRAIGHT_MEAN, STRAIN,
                    YOUNG, Refused, SolverTest, exchange_nodes, heated_tolerance, numbers)

ELASTIC = """
macro strain(u, v, w) [dx(u), dy(v), dz(w), (dx(v) + dy(u)) / sqrt(2.), (dx(w) + dz(u)) / sqrt(2.),
                       (dy(w) + dz(v)) / sqrt(2.)] // EOM
macro div(u, v, w) (dx(u) + dy(v) + dz(w)) // EOM
macro work() (LAMBDA * div(u, v, w) * div(a, b, c) + 2 * MU * (strain(u, v, w)' * strain(a, b, c))) // EOM
fespace Space(solid, [PK, PK, PK]);
Space [u, v, w], [a, b, c];
"""
TELL_MOVED = """
cout << "error " << sqrt(int3d(solid)((u - U)^2 + (v - V)^2 + (w - W)^2) / int3d(solid)(1.)) << endl;
"""
# Holds a solid that is free to move as a whole, without a force if it is where it should be.
LEASH = "int3d(solid)(1e-6 * (u * a + v * b + w * c)) - int3d(solid)(1e-6 * (U * a + V * b + W * c))"

PATCH = ELASTIC + f"""
func U = {GRADIENT[0, 0]} * x + {GRADIENT[0, 1]} * y + {GRADIENT[0, 2]} * z;
func V = {GRADIENT[1, 0]} * x + {GRADIENT[1, 1]} * y + {GRADIENT[1, 2]} * z;
func W = {GRADIENT[2, 0]} * x + {GRADIENT[2, 1]} * y + {GRADIENT[2, 2]} * z;
solve Patch([u, v, w], [a, b, c]) = int3d(solid)(work) + on(1, 2, u = U, v = V, w = W);
""" + TELL_MOVED

# Both ends are moved along x, by stiff springs.
BAR = ELASTIC + f"""
func grip = 1e9 * (abs(abs(x) - {LENGTH / 2}) < 1e-6);
solve Bar([u, v, w], [a, b, c]) = int3d(solid)(work) + {LEASH}
  + int2d(solid, 1, 2)(grip * u * a) - int2d(solid, 1, 2)(grip * U * a);
""" + TELL_MOVED
STRETCHED = f"""
func U = {STRAIN} * x; func V = -{STRAIN * POISSON} * y; func W = -{STRAIN * POISSON} * z;
"""
BENT = f"""
func U = -{STRAIN} * x * z; func V = {STRAIN * POISSON} * y * z;
func W = {STRAIN / 2} * (x^2 + {POISSON} * (z^2 - y^2));
"""

PRESSED = ELASTIC + f"""
real shrink = -{(1 - 2 * POISSON) / YOUNG};
func U = shrink * x; func V = shrink * y; func W = shrink * z;
solve Pressed([u, v, w], [a, b, c]) = int3d(solid)(work) + {LEASH}
  + int2d(solid, 1)(N.x * a + N.y * b + N.z * c);
""" + TELL_MOVED

HEATED = """
fespace Space(solid, PK);
Space u, v;
solve Heated(u, v) = int3d(solid)(dx(u) * dx(v) + dy(u) * dy(v) + dz(u) * dz(v))
  - int3d(solid)(v) + on(1, u = 0);
cout << "error " << abs(u(0, 0, 0) - 1. / 6) << endl;
"""

CONDUCTIVITY = " + ".join(f"{value} * (region == {label})"
                          for label, (_, _, value) in enumerate(SHELLS, start=1))
# The interfaces are numbered from 3 on, behind the two patches.
THROUGH_SHELLS = f"""
fespace Space(solid, PK);
fespace Flat(solid, P0);
Space u, v;
Flat k = {CONDUCTIVITY};
solve Shells(u, v) = int3d(solid)(k * (dx(u) * dx(v) + dy(u) * dy(v) + dz(u) * dz(v)))
  - int3d(solid)(v) + on(1, u = 0);
real outer = int2d(solid, 3)(u) / int2d(solid, 3)(1.), inner = int2d(solid, 4)(u) / int2d(solid, 4)(1.);
cout << "error " << max(abs(outer / {AT_INTERFACES[0]} - 1), abs(inner / {AT_INTERFACES[1]} - 1)) << endl;
"""


def run_freefem(script, **settings):
    """Debian's looks for its parts where they are not."""
    return subprocess.run(["FreeFem++-nw", "-nw", "-v", "0", script], text=True, capture_output=True,
                          timeout=100, env={**os.environ, "FF_LOADPATH": "/usr/lib/freefem++"},
                          **settings)


@unittest.skipIf(shutil.which("FreeFem++-nw") is None, "freefem++ was not found")
class FreeFem(SolverTest):
    FILES = [("a.mesh", ()), ("a.meshb", ())]

    @classmethod
    def setUpClass(cls):
        """Its reader of Gmsh's files is a package of its own."""
        super().setUpClass()
        with tempfile.NamedTemporaryFile("w", suffix=".edp") as script:
            script.write('load "gmsh"\n')
            script.flush()
            run = run_freefem(script.name)
        if run.returncode == 0:
            cls.FILES = [*cls.FILES, ("a.msh", ("--format", "msh22"))]
        else:
            print("libfreefem++ was not found: no .msh")

    def error(self, file, script, element="P1"):
        if file.suffix == ".msh":
            read = f'load "gmsh"\nmesh3 solid = gmshload3("{file.name}");\n'
        else:
            read = f'mesh3 solid = readmesh3("{file.name}");\n'
        for word, value in (("PK", element), ("LAMBDA", str(LAMBDA)), ("MU", str(MU))):
            script = re.sub(rf"\b{word}\b", value, script)
        (self.folder / "run.edp").write_text(read + script)
        run = run_freefem("run.edp", cwd=self.folder)
        found = re.search(r"^error (\S+)$", run.stdout, re.MULTILINE)
        if run.returncode != 0 or found is None or "nan" in found[1]:
            raise Refused(run.stdout[-2000:] + run.stderr)
        return float(found[1])

    def test_patch(self):
        for name, options in self.FILES:
            for element in ("P1", "P2"):
                with self.subTest(name, element=element):
                    file = self.patch(name, *options)
                    self.assertLess(self.error(file, PATCH, element), 1e-9)
        file = exchange_nodes(self.patch("a.mesh"), (1, 2), numbers(5))
        self.assert_caught(lambda: self.error(file, PATCH), 1e-9)

    def test_bar(self):
        file = self.bar("bar.mesh")
        self.assertLess(self.error(file, STRETCHED + BAR), 1e-8)
        self.assertLess(self.error(file, BENT + BAR, "P2"), 1e-8)
        scaled = self.bar("bar.mesh", "--scale", 1.001)
        self.assert_caught(lambda: self.error(scaled, BENT + BAR, "P2"), 1e-8)

    def test_pressed_ball(self):
        file = self.ball("ball.mesh", 0.5)
        for element in ("P1", "P2"):
            self.assertLess(self.error(file, PRESSED, element), 1e-9)
        text = file.read_text()
        file.write_text(re.sub(r" 1\n(?=\d+ \d+ \d+ 1\n)", " 2\n", text, count=1))
        self.assertNotEqual(file.read_text(), text)
        self.assert_caught(lambda: self.error(file, PRESSED), 1e-9)

    def test_heated_ball(self):
        size = 0.3
        for element in ("P1", "P2"):
            self.assertLess(self.error(self.ball("ball.mesh", size), HEATED, element),
                            heated_tolerance(size))
        scaled = self.ball("ball.mesh", size, "--scale", 1.5)
        self.assert_caught(lambda: self.error(scaled, HEATED), heated_tolerance(size))

    def test_shells(self):
        """By the numbers of regions and interfaces."""
        for name, options in self.FILES:
            file = self.shells(name, 0.25, *options)
            for element in ("P1", "P2"):
                self.assertLess(self.error(file, THROUGH_SHELLS, element), STRAIGHT_MEAN)
        wrong = self.shells("a.mesh", 0.25, order=(0, 2, 1))
        self.assert_caught(lambda: self.error(wrong, THROUGH_SHELLS), STRAIGHT_MEAN)

    def test_example(self):
        self.assert_poisson("freefem.edp", "FreeFem++-nw", "-nw", "-v", "0", "freefem.edp",
                            tolerance=heated_tolerance(0.3))


if __name__ == "__main__":
    unittest.main()
