"""A table of the methods over surfaces and images, for cpp/docs/methods.md.

usage: methods.py CERTET [--runs N] [INPUT --size H OPTION...]
CERTET meshes INPUT with these options by each method, N times (8) at sizes spread evenly over 4 %
around H, so that the lattice lies elsewhere each time.  Without an INPUT two surfaces are made and
meshed, a turned bracket, with its sharp edges kept and not, and a ball of 320 triangles.
Angles are in degrees, distances of the surface from the shape in long edges.
"""

import itertools
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

METHODS = {"`paper`, angles": ["--method", "paper"], "`embedded`": ["--method", "embedded"],
           "`paper`, embedding": ["--method", "paper", "--guarantee", "embedding"],
           "`key`": ["--method", "key"]}
HEAD = ("| shape | method | least (mean) | greatest | tetrahedra | rms | farthest | stayed |\n"
        "|---|---|---|---|---|---|---|---|")


def turned(point):
    """The point after turns around x by 0.4 and around z by 0.7."""
    x, y, z = point
    y, z = y * math.cos(0.4) - z * math.sin(0.4), y * math.sin(0.4) + z * math.cos(0.4)
    return x * math.cos(0.7) - y * math.sin(0.7), x * math.sin(0.7) + y * math.cos(0.7), z


def bracket():
    """An L of two plates, 2 by 1 by 1.6 and 0.4 thick: points and faces, seen from outside."""
    outline = [(0, 0), (2, 0), (2, 0.4), (0.4, 0.4), (0.4, 1.6), (0, 1.6)]
    corners = len(outline)
    points = [turned((x, depth, z)) for depth in (0, 1) for x, z in outline]
    caps = [(0, 1, 2, 3), (0, 3, 4, 5)]
    faces = caps + [tuple(corners + n for n in reversed(cap)) for cap in caps]
    for n in range(corners):
        after = (n + 1) % corners
        faces.append((after, n, corners + n, corners + after))
    return points, faces


def ball():
    """An icosahedron whose triangles were cut into four twice, its points on the unit sphere."""
    golden = (1 + math.sqrt(5)) / 2
    points = [tuple(x for _, x in sorted(zip(order, (0, a, b * golden))))
              for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
              for a, b in itertools.product((-1, 1), repeat=2)]
    near = [{m for m, q in enumerate(points) if 0 < math.dist(p, q) < 2.1} for p in points]
    faces = [(a, b, c) for a, b, c in itertools.combinations(range(12), 3)
             if b in near[a] and c in near[a] and c in near[b]]
    for _ in range(2):
        middles = {}

        def middle(a, b):
            if frozenset((a, b)) not in middles:
                middles[frozenset((a, b))] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            return middles[frozenset((a, b))]

        faces = [triangle for a, b, c in faces
                 for triangle in ((a, middle(a, b), middle(c, a)), (b, middle(b, c), middle(a, b)),
                                  (c, middle(c, a), middle(b, c)),
                                  (middle(a, b), middle(b, c), middle(c, a)))]
    points = [tuple(x / math.hypot(*p) for x in p) for p in points]
    return points, [outwards(points, face) for face in faces]


def outwards(points, face):
    """The triangle in the order in which it turns to the left, seen from outside the ball."""
    a, b, c = (points[n] for n in face)
    volume = sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    return face if volume > 0 else face[::-1]


def write_off(path, surface):
    points, faces = surface
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(map(repr, p)) for p in points),
             *(" ".join(map(str, (len(face), *face))) for face in faces)]
    path.write_text("\n".join(lines) + "\n")


def run(certet, source, size, options):
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder, "run.json")
        subprocess.run([certet, "mesh", *source, "--size", repr(size), *options, "--distance",
                        "-o", Path(folder, "mesh.vtu"), "--json", report],
                       check=True, stdout=subprocess.DEVNULL)
        return json.loads(report.read_text())


def row(name, method, reports):
    """The row of one shape and one method, over all runs."""
    least = [report["dihedral"]["min"] for report in reports]
    greatest = max(report["dihedral"]["max"] for report in reports)
    tets = sum(report["mesh"]["tets"] for report in reports) / len(reports)
    far = [report["distance"]["to_shape"] for report in reports]
    rms = math.sqrt(sum(one["rms_edges"] ** 2 for one in far) / len(far))
    farthest = max(one["greatest_edges"] for one in far)
    violated = sum(report["method"].get("violated", 0) for report in reports)
    stayed = "-"
    if violated:
        stayed = f"{100 * sum(report['method']['stayed'] for report in reports) / violated:.1f} %"
    return (f"| {name} | {method} | {min(least):.1f} ({sum(least) / len(least):.1f}) | {greatest:.1f} "
            f"| {tets:,.0f} | {rms:.5f} | {farthest:.4f} | {stayed} |")


def tell(certet, name, source, size, runs):
    for method, options in METHODS.items():
        sizes = [size * (0.98 + 0.04 * (n + 0.5) / runs) for n in range(runs)]
        print(row(name, method, [run(certet, source, one, options) for one in sizes]), flush=True)
        name = ""


def main(certet, *words):
    runs = 8
    if words[:1] == ("--runs",):
        runs, words = int(words[1]), words[2:]
    print(HEAD)
    if words:
        at = words.index("--size")
        source = words[:at] + words[at + 2:]
        tell(certet, Path(words[0]).name, source, float(words[at + 1]), runs)
        return
    with tempfile.TemporaryDirectory() as folder:
        part, coarse = Path(folder, "bracket.off"), Path(folder, "ball.off")
        write_off(part, bracket())
        write_off(coarse, ball())
        tell(certet, "bracket", (part, "--features", "off"), 0.08, runs)
        tell(certet, "bracket, its edges kept", (part, "--features", "40"), 0.08, runs)
        tell(certet, "ball of 320 triangles", (coarse, "--features", "off"), 0.08, runs)


if __name__ == "__main__":
    main(*sys.argv[1:])
