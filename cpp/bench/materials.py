"""Figures of meshes of several regions: what interfaces cost, and the same images by CGAL."""

import importlib.util
import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

import figures
import programs

PEERS = Path(__file__).resolve().parent / "peers"
BALL = "x^2 + y^2 + z^2 - 1"
CORE = "x^2 + y^2 + z^2 - 0.25"
BALL_OPTIONS = "--bounds=-1.1,-1.1,-1.1,1.1,1.1,1.1", "--size", "0.02"


def per_tet(run):
    return run["wall"] / run["mesh"]["tets"]


def compare(bench, output, theirs, ours, rounds=3):
    """The best runs of `certet mesh` with each of two lists of options, which take turns."""
    runs = [(bench.mesh(*theirs, "-o", output), bench.mesh(*ours, "-o", output))
            for _ in range(rounds)]
    output.unlink()
    return [min(one, key=lambda run: run["wall"]) for one in zip(*runs)]


def of_both(which, plain, several):
    return (f"{which}: {figures.seconds(several['wall'])} for {figures.count(several['mesh']['tets'])} "
            f"tetrahedra, {figures.mib(several['peak'])}, over {figures.seconds(plain['wall'])} "
            f"for {figures.count(plain['mesh']['tets'])}, {figures.mib(plain['peak'])}")


def interfaces(bench):
    """A brain atlas with smooth interfaces, over one with labels at the tetrahedra's centres."""
    name = "brain atlas to a .vtu: smooth interfaces / labels at centres"
    if not figures.ATLAS.exists():
        yield figures.Skipped(name, f"{figures.ATLAS} is not there (Debian package mricron-data)")
        return
    size = figures.ATLAS_SIZES["bisect"]
    for threads in sorted({1, programs.cores()}):
        options = figures.ATLAS, "--size", size, "--threads", threads
        centres, smooth = compare(bench, bench.folder / "brain.vtu",
                                  [*options, "--method", "paper"], options)
        details = of_both("whole processes", centres, smooth)
        yield figures.Figure(f"{name}, time per tetrahedron, threads {threads}",
                             per_tet(smooth) / per_tet(centres), bound=2, details=details)
        yield figures.Figure(f"{name}, peak memory, threads {threads}",
                             smooth["peak"] / centres["peak"], bound=2, details=details)


def solids(bench):
    """A ball with a core of another material, over the ball alone."""
    name = "ball with a core by formulas / ball alone, time per tetrahedron"
    try:
        one, two = compare(bench, bench.folder / "ball.vtu", ["--expr", BALL, *BALL_OPTIONS],
                           ["--material", f"shell={BALL}", "--material", f"core={CORE}",
                            *BALL_OPTIONS])
    except programs.Failed as failure:  # built without muParser
        yield figures.Skipped(name, str(failure))
        return
    yield figures.Figure(name, per_tet(two) / per_tet(one),
                         details=of_both(f"threads {programs.cores()}", one, two))


@dataclass
class Contest:
    """One program's mesh of one label image."""

    image: str
    program: str
    tets: int
    seconds: float
    peak_bytes: int
    angles: tuple  # least and greatest dihedral angle, degrees
    region_edges: int  # edges that more than two triangles of a region's surface meet at
    interface_edges: int  # the same of interfaces between two regions
    volume_error: float  # the greatest among regions of 1,000 voxels and more
    lost: int  # labels that the mesh does not have


def judged(program, image, run, file):
    """What the judge finds, which `certet check` must find too."""
    import judge

    found = judge.judge(file)
    voxels = image.voxels()
    errors = [abs(found.volumes.get(label, 0) / n - 1) for label, n in voxels.items() if n >= 1000]
    return Contest(image.name, program, found.tets, run["seconds"], run["peak"], found.angles,
                   found.region_edges, found.interface_edges, max(errors),
                   len(voxels.keys() - found.volumes.keys()))


def agree(contest, checked):
    """Whether `certet check` and the judge, who share no code, tell the same of a file."""
    def crowded(parts):
        return sum(part["nonmanifold"]["edges"] for part in parts)

    ours = (checked["mesh"]["tets"], crowded(r["surface"] for r in checked["regions"]),
            crowded(checked.get("interfaces", [])))
    theirs = contest.tets, contest.region_edges, contest.interface_edges
    angles = checked["dihedral"]["min"], checked["dihedral"]["max"]
    if ours != theirs or max(abs(a - b) for a, b in zip(angles, contest.angles)) > 1e-3:
        raise programs.Failed(f"of {contest.program}'s mesh of '{contest.image}' the judge tells "
                              f"{theirs}, {contest.angles}, but certet check {ours}, {angles}")


def contest(bench, image, rounds=2):
    """CGAL, and certet with about as many tetrahedra; they take turns, one thread each.  Then
    certet with a finer lattice, such as its own default is."""
    import label_images

    inr, nrrd, theirs, ours = (bench.folder / f"labels.{end}" for end in
                               ("inr", "nrrd", "cgal.mesh", "certet.mesh"))
    label_images.write_inr(image.labels, inr)
    label_images.write_nrrd(image.labels, nrrd)

    def peer():
        out, _, peak = programs.run(
            [sys.executable, "-B", PEERS / "cgal_mesh.py", inr, theirs, image.size], bench.folder)
        return json.loads(out) | {"peak": peak}

    def certet(size):
        run = bench.mesh(nrrd, "--size", size, "--threads", 1, "-o", ours)
        return {"seconds": run["wall"], "peak": run["peak"]}

    def best(program, runs, file):
        fastest = min(runs, key=lambda run: run["seconds"])
        found = judged(program, image, fastest, file)
        agree(found, bench.check(file))
        return found

    peers = [peer()]
    tets = bench.check(theirs)["mesh"]["tets"]
    size = bench.mesh(nrrd, "--target-tets", tets, "--dry-run")["lattice"]["size"]
    runs = [certet(size)]
    for _ in range(rounds - 1):
        peers.append(peer())
        runs.append(certet(size))
    found = [best("CGAL", peers, theirs), best("certet", runs, ours)]
    found.append(best("certet, finer", [certet(image.finer) for _ in range(rounds)], ours))
    for file in (inr, nrrd, theirs, ours):
        file.unlink()
    return found


def peers(bench):
    """All contests, and why there are none."""
    for module, package in (("meshio", "python3-meshio"), ("_pygalmesh", "python3-pygalmesh")):
        if importlib.util.find_spec(module) is None:
            return [], f"{package} is not there"
    sys.path.insert(0, str(PEERS))
    import label_images

    images = [label_images.balls(), *label_images.atlas()]
    return [row for image in images for row in contest(bench, image)], None


def peer_lines(contests, why):
    """A table in Markdown."""
    if why:
        return [f"Not measured: {why}.", ""]
    lines = ["| labels | program | tetrahedra | time | tetrahedra a second | peak memory "
             "| dihedral angles | non-manifold edges: regions, interfaces "
             "| volume of a label off by at most | labels lost |",
             "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for contest in contests:
        row = Contest(**contest)
        lines.append(
            f"| {row.image} | {row.program} | {row.tets:,} | {figures.seconds(row.seconds)} "
            f"| {row.tets / row.seconds:,.0f} | {figures.mib(row.peak_bytes)} "
            f"| {row.angles[0]:.2f}° to {row.angles[1]:.2f}° "
            f"| {row.region_edges}, {row.interface_edges} | {row.volume_error:.2%} | {row.lost} |")
    return [*lines, ""]


def as_json(rows):
    return [asdict(row) for row in rows]
