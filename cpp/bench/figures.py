"""The figures of the whole, each a ratio of things measured in the same run."""

import math
import shutil
from dataclasses import dataclass
from pathlib import Path

import programs

ATLAS = Path("/usr/share/mricron/templates/aal.nii.gz")
ATLAS_SIZES = {"bisect": 1.22, "midpoint": 1.31}  # mm; some ten million tetrahedra
TORUS = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.16"
TORUS_BOUNDS = "--bounds=-1.4,-1.4,-0.4,1.4,1.4,0.4"
GIB = 2**30


@dataclass
class Figure:
    """One line of the table."""

    name: str
    value: float
    unit: str = ""
    bound: float = None
    at_least: bool = False  # the bound is from below
    details: str = ""

    @property
    def met(self):
        if self.bound is None:
            return None
        return self.value >= self.bound if self.at_least else self.value <= self.bound


@dataclass
class Skipped:
    """A line that could not be measured, and why."""

    name: str
    why: str


def seconds(value):
    for scale, unit in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= scale:
            return f"{value / scale:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def count(tets):
    return f"{tets / 1e6:.3g}M" if tets >= 1e6 else f"{tets / 1e3:.3g}k"


def mib(size):
    return f"{size / 2**20:.3g} MiB" if size < 1000 * 2**20 else f"{size / GIB:.3g} GiB"


def size_for(tets):
    """The long edge at which the torus has about so many tetrahedra; as in torus.hpp."""
    return (12 * 2 * math.pi**2 * 0.16 / tets) ** (1 / 3)


def room(folder):
    return shutil.disk_usage(folder).free


def engine_and_copy(bench):
    """The engine over memcpy, two threads over one, and memory, at 10M."""
    threads = [1, 2] if programs.cores() > 1 else [1]
    one, *two = bench.whole([1e7], threads, 15)
    size = f"torus, {count(one['tets'])} tetrahedra"
    engine = f"{size}, one thread: {seconds(one['seconds'])}"
    yield Figure(
        "engine / warm memcpy of its mesh", one["seconds"] / one["copy_warm_seconds"], bound=8,
        details=f"{engine} over {seconds(one['copy_warm_seconds'])} "
                f"for {mib(one['mesh_bytes'])} into memory touched before")
    yield Figure(
        "engine / memcpy into fresh memory", one["seconds"] / one["copy_fresh_seconds"],
        details=f"{engine} over {seconds(one['copy_fresh_seconds'])}")
    if two:
        yield Figure(
            "speed-up by two threads", one["seconds"] / two[0]["seconds"], bound=1.7,
            at_least=True,
            details=f"{size}: {seconds(one['seconds'])} over {seconds(two[0]['seconds'])}")
    else:
        yield Skipped("speed-up by two threads", "the machine has one core")
    yield Figure(
        "peak memory / bytes of the mesh", one["peak_bytes"] / one["mesh_bytes"], bound=1.6,
        details=f"{size}: {mib(one['peak_bytes'])} over {mib(one['mesh_bytes'])}")


def growth(bench):
    """Time per tetrahedron at 100M over that at 1M."""
    name = "time per tetrahedron, 100M / 1M"
    if programs.available_bytes() < 5 * GIB:
        yield Skipped(name, "less than 5 GiB of memory are available")
        return
    # The small size takes five turns for each of the large one.
    *small, large = bench.whole([1e6] * 5 + [1e8], [1], 4)
    small = min(small, key=lambda run: run["seconds"])
    a, b = (run["seconds"] / run["tets"] for run in (small, large))
    yield Figure(
        name, b / a, bound=1.1,
        details=f"torus, one thread: {b * 1e9:.3g} ns ({seconds(large['seconds'])} in all) "
                f"over {a * 1e9:.3g} ns ({seconds(small['seconds'])})")


def brain(bench, rounds=3):
    """The command on a brain atlas, over the engine alone."""
    name = "brain atlas: whole process / engine"
    if not ATLAS.exists():
        yield Skipped(name, f"{ATLAS} is not there (Debian package mricron-data)")
        return
    for cuts in ATLAS_SIZES:
        for threads in sorted({1, programs.cores()}):
            yield from _brain(bench, name, cuts, threads, rounds)


def _brain(bench, name, cuts, threads, rounds):
    output = bench.folder / "brain.vtu"
    size = ATLAS_SIZES[cuts]
    commands, engines = [], []
    for _ in range(rounds):
        commands.append(bench.mesh(ATLAS, "--cuts", cuts, "--size", size, "-o", output,
                                   "--threads", threads))
        engines.append(bench.image(ATLAS, size, cuts, threads, 3))
    output.unlink()
    command = min(commands, key=lambda run: run["wall"])
    engine = min(run["seconds"] for run in engines)
    spent = command["seconds"]
    between = command["wall"] - spent["read"] - spent["write"]
    where = f"{count(command['mesh']['tets'])} tetrahedra, cuts {cuts}, threads {threads}"
    yield Figure(
        f"{name}, cuts {cuts}, threads {threads}", command["wall"] / engine, bound=4,
        details=f"{where}: {seconds(command['wall'])} over {seconds(engine)}; reading "
                f"{seconds(spent['read'])}, measuring {seconds(spent['measure'])}, writing "
                f"{mib(command['output']['bytes'])} {seconds(spent['write'])}; peak "
                f"{mib(command['peak'])}")
    yield Figure(
        f"the same without reading and writing, cuts {cuts}, threads {threads}",
        between / engine, details=f"{seconds(between)} over {seconds(engine)}")


def grading(bench, rounds=3):
    """A torus with graded interior beside that of one size: the same surface, one thread."""
    output = bench.folder / "graded.vtu"
    solid = ["--shape", "torus:1,0.4", "--size", "0.01548", "--threads", 1, "-o", output]
    uniform, graded = [], []
    for _ in range(rounds):
        uniform.append(bench.mesh(*solid))
        graded.append(bench.mesh(*solid, "--grade", 3))
    output.unlink()
    tets = [runs[0]["mesh"]["tets"] for runs in (uniform, graded)]
    # All but measuring the mesh and writing it.
    one, other = (min(sum(run["seconds"][stage] for stage in ("sample", "cut", "warp", "count", "emit"))
                      for run in runs) for runs in (uniform, graded))
    yield Figure(
        "tetrahedra of a graded torus / of one size", tets[1] / tets[0], bound=0.1465,
        details=f"{tets[1]:,} over {tets[0]:,}, three levels")
    yield Figure(
        "engine of the graded torus / of one size", other / one, bound=0.6,
        details=f"{seconds(other)} over {seconds(one)}, one thread, into a file")
    yield Figure(
        "the same for each tetrahedron", other / tets[1] * tets[0] / one, bound=2.5)


def start_up(bench, rounds=9):
    """How long a program takes that has nothing to do, and one with next to nothing."""
    def least(*arguments):
        return min(bench.command(*arguments) for _ in range(rounds))
    ball = ("mesh", "--shape", "sphere:1", "--size", "0.4", "-o", "ball.vtu")
    yield Figure("`certet --version`, in ms", 1e3 * least("--version"), bound=10)
    yield Figure("a ball of a thousand tetrahedra to a file, in ms", 1e3 * least(*ball), bound=20)


def memory_to_file(bench, tets):
    """Peak memory of a mesh on its way to a file."""
    name = f"peak memory of {count(tets)} tetrahedra to a .vtu"
    solid = ["--expr", TORUS, TORUS_BOUNDS, "--size", f"{size_for(tets):.6g}"]
    try:
        needed = bench.mesh(*solid, "--dry-run")["output"]["bytes"]
    except programs.Failed as failure:  # built without muParser
        yield Skipped(name, str(failure))
        return
    if room(bench.folder) < 1.1 * needed + GIB:
        yield Skipped(name, f"no room for a file of {mib(needed)}")
        return
    output = bench.folder / "torus.vtu"
    run = bench.mesh(*solid, "-o", output)
    output.unlink()
    yield Figure(
        name, run["peak"] / GIB, unit="GiB", bound=1,
        details=f"torus by a formula, {count(run['mesh']['tets'])} tetrahedra, a file of "
                f"{mib(run['output']['bytes'])}, threads {programs.cores()}: "
                f"{seconds(run['wall'])}, peak {mib(run['peak'])}")


def tets_in_medit(file):
    lines = iter(file.read_text().splitlines())
    for line in lines:
        if line == "Tetrahedra":
            return int(next(lines))
    return 0


def reference(bench, tets=6e4, rounds=3):
    """The extracted mesher over the engine."""
    name = "extracted reference / engine"
    if not bench.reference_program.exists():
        yield Skipped(name, "certet-reference was not built (ocamlfind is missing)")
        return
    size = size_for(tets)
    wide, high = (math.ceil(half / size) + 2 for half in (1.4, 0.4))
    output = bench.folder / "reference.mesh"
    options = ["--solid", f"torus 0 0 0 {2 / size!r} {0.8 / size!r}",
               "--lattice", f"{-2 * wide} {-2 * wide} {-2 * high} {2 * wide} {2 * wide} {2 * high}",
               output]
    theirs, ours = [], []
    for _ in range(rounds):
        theirs.append(bench.reference(*options))
        ours += bench.whole([tets], [1], 5)
    made = tets_in_medit(output)
    output.unlink()
    if made != ours[0]["tets"]:
        yield Skipped(name, f"it made {made:,} tetrahedra, the engine {ours[0]['tets']:,}")
        return
    engine = min(run["seconds"] for run in ours)
    yield Figure(
        name, min(theirs) / engine,
        details=f"torus, {made:,} tetrahedra from both: {seconds(min(theirs))} for the "
                f"OCaml program, its MEDIT file included, over {seconds(engine)} for the engine, "
                "one thread")


def series(bench):
    """Engine and memory at all sizes, each size in a process of its own."""
    threads = [1, 2] if programs.cores() > 1 else [1]
    sizes = [1e5, 3e5, 1e6, 3e6, 1e7, 3e7, 1e8]
    if programs.available_bytes() < 5 * GIB:
        sizes.pop()
    # Small meshes are soon done, and the more easily disturbed.
    return [run for tets in sizes
            for run in bench.whole([tets], threads, 3 if tets > 2e7 else 9)]
