"""The solids that solvers are tried on, what is right of each, and files with a planted defect."""

import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from program import ProgramTest  # noqa: E402

EXAMPLES = pathlib.Path(__file__).parents[2] / "cpp" / "examples" / "solvers"


class Refused(Exception):
    """A solver that does not take a file."""


# All solids are of this material; a pressure of 1 makes displacements of about 1e-3.
YOUNG, POISSON = 1000.0, 0.3
MU = YOUNG / (2 * (1 + POISSON))
LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))

# A linear displacement: any will do that has no rotation or stretch alone.
GRADIENT = np.array([[2e-3, 5e-4, -3e-4], [1e-4, -1e-3, 2e-4], [4e-4, -2e-4, 1.5e-3]])


def linear(points):
    """Shape (n, 3), of points of the same shape; also what the regions are is one material."""
    return points @ GRADIENT.T


# A bar along x, from -LENGTH/2 to LENGTH/2, one wide and high.
LENGTH = 4.0
STRAIN = 1e-3


def stretched(points):
    """In pure tension: linear, so that linear elements have it exactly."""
    x, y, z = points.T
    return STRAIN * np.stack([x, -POISSON * y, -POISSON * z], axis=1)


def bent(points):
    """In pure bending: quadratic, so that quadratic elements have it exactly.  The curvature is
    STRAIN, its fibres at z have the strain -STRAIN z, and the sides are free."""
    x, y, z = points.T
    return STRAIN * np.stack([-x * z, POISSON * y * z,
                              (x**2 + POISSON * (z**2 - y**2)) / 2], axis=1)


def pressed(points):
    """A ball, or whatever else, under a pressure of 1 from all sides: the stress is the same
    everywhere, also within a surface of triangles."""
    return -(1 - 2 * POISSON) / YOUNG * points


def heated(points):
    """Of a ball of radius 1, 0 at its surface: -Δu = 1."""
    return (1 - (points**2).sum(axis=1)) / 6


def heated_tolerance(size):
    """Edges of the surface are at most √2 long edges of the lattice long, and so within the ball by
    size²/4, which times the slope of 1/3 is the error."""
    return size**2 / 12


# A ball of radius 1 of three materials, one within the other: names, radii and conductivities by
# label, from 1 on.  It is heated all over, and 0 at its surface.
SHELLS = (("outer", 1.0, 1.0), ("middle", 0.7, 0.25), ("core", 0.4, 5.0))


def through_shells(points):
    """-div(k grad u) = 1: whatever is within a radius r goes through there, so the slope is -r/3k."""
    radius = np.sqrt((points**2).sum(axis=1))
    found = np.zeros(len(points))
    for (_, outer, conductivity), inner in zip(SHELLS, (0.7, 0.4, 0)):
        found += (outer**2 - np.clip(radius, inner, outer) ** 2) / (6 * conductivity)
    return found


# At the interfaces, outermost first.
AT_INTERFACES = through_shells(np.array([[radius, 0, 0] for _, radius, _ in SHELLS[1:]]))


def shells_tolerance(size):
    """As above, at the interface of radius 0.7, where the slope is 0.7/3k; a part of the greatest."""
    return size**2 / (4 * 0.7) * 0.7 / (3 * 0.25) / through_shells(np.zeros((1, 3)))[0]


# On interfaces the mean is nearer: straight edges lie within, curved ones on it.
STRAIGHT_MEAN, CURVED_MEAN = 0.02, 0.005


class SolverTest(ProgramTest):
    """A file for a solver is of one of these; options go to `certet mesh`."""

    def patch(self, name, *options):
        """Two materials, one within the other: their interface is conforming or it is not."""
        return self.made(name, "--material", "box=box:1,1.2,0.8", "--material", "core=sphere:0.35",
                         "--size", 0.4, *options)

    def bar(self, name, *options):
        return self.made(name, "--shape", f"box:{LENGTH:g},1,1", "--size", 0.5, *options)

    def ball(self, name, size, *options):
        return self.made(name, "--shape", "sphere:1", "--size", size, *options)

    def shells(self, name, size, *options, order=(0, 1, 2)):
        """Region n is the n-th in order; another order is a planted defect."""
        solids = [word for shell in order
                  for word in ("--material", "{}=sphere:{}".format(*SHELLS[shell]))]
        return self.made(name, *solids, "--priority", "core,middle,outer", "--size", size, *options)

    def made(self, name, *arguments):
        self.mesh(*arguments, "-o", name)
        return self.folder / name

    def run_example(self, name, *command, planted=()):
        """What a solver says of an example, whose first line has the command that makes its mesh."""
        source = EXAMPLES / name
        head = source.read_text().splitlines()[0]
        words = shlex.split(re.search(r"certet (mesh .*)", head)[1])
        made = self.run_certet(*words, *planted)
        self.assertEqual(made.returncode, 0, made.stderr)
        shutil.copy(source, self.folder)
        run = subprocess.run(command, cwd=self.folder, text=True, capture_output=True,
                             timeout=100)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def assert_poisson(self, name, *command, tolerance):
        """An example that tells u in the middle of a heated ball; where all is larger by a tenth it
        is not what it should be."""
        for planted in ((), ("--scale", "1.1")):
            told = self.run_example(name, *command, planted=planted)
            found = float(re.search(r"u in the middle is (\S+)", told)[1])
            self.assertEqual(abs(found - 1 / 6) < tolerance, not planted, found)

    def assert_caught(self, error, tolerance):
        """Of a planted defect: the solver refuses it, or is wrong by far."""
        try:
            found = error()
        except Refused as refusal:
            print("planted:", str(refusal).strip().splitlines()[-1:])
            return
        print(f"planted: {found:.1e}, where {tolerance:.0e} is allowed")
        self.assertGreater(found, 10 * tolerance)


def exchange_nodes(file, places, row):
    """Plants a defect: two nodes of the tetrahedron in the middle of a text file change places,
    which are counted from the end.  `row` is what the lines of tetrahedra look like."""
    lines = file.read_text().splitlines()
    found = [n for n, line in enumerate(lines) if re.fullmatch(row, line)]
    chosen = found[len(found) // 2]
    words = re.split(r"([\s,]+)", lines[chosen].strip())
    one, other = (len(words) - 1 - 2 * place for place in places)
    words[one], words[other] = words[other], words[one]
    lines[chosen] = "".join(words)
    file.write_text("\n".join(lines) + "\n")
    return file


def numbers(count, between=r"\s+"):
    """What a line of so many whole numbers looks like."""
    return rf"\s*\d+({between}\d+){{{count - 1}}}\s*"
