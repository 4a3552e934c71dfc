"""Runs an implementation through the conformance kit.

usage: check.py KIT.json      exit status 0: it conforms, 1: it does not

`grading`, with what it takes from `settling` and `conforming`, is the implementation; put your own in its
place.
"""

import json
import sys

import grading


def plain(value):
    """Tuples as lists, as JSON has them."""
    return [plain(v) for v in value] if isinstance(value, (list, tuple)) else value


def constants(mine, kit):
    yield "steps", mine.STEPS, kit["steps"]
    yield "directions", mine.DIRECTIONS, kit["directions"]
    for name, steps in kit["thresholds"].items():
        yield f"thresholds {name}", mine.THRESHOLDS[name], steps


def lattice(mine, kit):
    for case in kit["lattice"]:
        anchor, name = tuple(case["anchor"]), case["case"]
        what = f"lattice {name} at {anchor}"
        yield what, mine.right_handed(name), case["right_handed"]
        yield what, mine.corners(anchor, name), case["vertices"]
        for place, n in enumerate(case["neighbors"]):
            answer = [n["anchor"], n["case"], n["order"]]
            yield f"{what}, neighbour {place + 1}", mine.neighbor(anchor, name, place), answer


def stencils(mine, kit):
    for case in kit["stencils"]:
        what = f"stencil {case['signs']}"
        tets = mine.stencil(case["signs"])
        yield what, [mine.oriented(t, True) for t in tets], case["right_handed"]
        yield what, [mine.oriented(t, False) for t in tets], case["left_handed"]


def warp(mine, kit):
    for n, case in enumerate(kit["warp"]):
        warping = mine.warp(mine.THRESHOLDS[case["thresholds"]], case["sign"],
                            case["neighbors"], case["cuts"])
        after = mine.sign_after(case["sign"], warping)
        left = [d for d, s in enumerate(case["neighbors"]) if mine.opposite(after, s)]
        yield (f"warp {n}", [warping, mine.displacement(warping), after, left],
               [[case["direction"], case["distance"]], case["displacement"],
                case["sign_after"], case["cuts_left"]])


def bisect(mine, kit):
    for n, case in enumerate(kit["bisect"]):
        runs = case["signs"]
        sign_at = lambda t, runs=runs: [s for start, s in runs if start <= t][-1]
        yield f"bisect {n}", mine.bisect(sign_at), case["cut"]


def whole_meshes(kind, cases, mesh, keys):
    """What `mesh` answers to what cases tell under these keys."""
    for case in cases:
        for key, answer in mesh(*(case[key] for key in keys)).items():
            yield f"{kind} '{case['name']}', {key}", answer, case[key]


def meshes(mine, kit):
    yield from whole_meshes("mesh", kit["meshes"], mine.mesh, (
        "origin", "cells", "even", "odd", "cuts", "cut", "guarantee"))


def set_of(number):
    return {d for d in range(14) if number >> d & 1}


def disks(mine, kit):
    rows = {row[0]: row[1:] for row in kit["disks"]}
    for number in range(1 << 14):
        row = mine.disk_row(set_of(number))
        answer = row and [sum(1 << d for d in row[0]), row[1]]
        yield f"disks, + {number}", answer, rows.get(number)


def settled(mine, kit):
    yield from whole_meshes("settled", kit["settled"], mine.settled_mesh, (
        "origin", "cells", "even", "odd", "cut"))


def material_stencils(mine, kit):
    for case in kit["material_stencils"]:
        tets = mine.material_stencil(list(case["corners"]))
        for hand, right in (("right_handed", True), ("left_handed", False)):
            answer = [[m, *mine.oriented(tet, right)] for m, tet in tets]
            yield f"materials {case['corners']}", answer, case[hand]


def materials(mine, kit):
    yield from whole_meshes("materials", kit["materials"], mine.material_mesh, (
        "origin", "cells", "cuts", "even", "odd", "cut"))


def graded(mine, kit):
    yield from whole_meshes("graded", kit["graded"], mine.graded_mesh, (
        "origin", "cells", "levels", "even", "odd", "cut"))


def differences(mine, kit):
    """A sentence for each answer that is not the kit's."""
    if kit["certet_conformance"] != 1:
        raise ValueError("this kit is of another version")
    for section in (constants, stencils, bisect, warp, lattice, meshes, material_stencils,
                    materials, settled, disks, graded):
        for what, answer, expected in section(mine, kit):
            if plain(answer) != expected:
                yield f"{what}: {str(plain(answer))[:200]} instead of {str(expected)[:200]}"


def main(file):
    with open(file, encoding="utf-8") as opened:
        found = list(differences(grading, json.load(opened)))
    print("\n".join(found[:20]))
    print(f"{len(found)} differences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
