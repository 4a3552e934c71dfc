#!/usr/bin/env python3
"""Seeds single defects into a copy of the core and counts those that the tests catch.

usage: mutate.py BUILD [--count N] [--seed S] [--jobs J] [--only N] [--self-test]

BUILD is a build folder with the bridge to the certified functions.  Everything else happens in
BUILD/mutation; the results are BUILD/mutation/mutation.json and mutation.md.
"""

import argparse
import os
import queue
import shutil
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from killers import ENGINE, OTHERWISE, Workshop, programs_for
from mutants import Mutant, choose
from report import write_report

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
HEADERS = ["lattice/coord3", "lattice/structured_tet", "lattice/tiling", "lattice/stencil", "lattice/warp",
           "lattice/direction", "lattice/orientation", "lattice/sign", "checksum", "frame", "stuffing"]


def core_files():
    core = [p for room in ENGINE for p in sorted((SOURCE / room).iterdir()) if p.suffix in (".cpp", ".hpp")]
    headers = [SOURCE / f"cpp/include/certet/{name}.hpp" for name in HEADERS]
    return [str(p.relative_to(SOURCE)) for p in headers + core]


def copy_tree(root):
    """The tree in which the defects are seeded; the source stays as it is."""
    shutil.rmtree(root, ignore_errors=True)
    for folder in ("cpp", "tests", "bridge"):
        shutil.copytree(SOURCE / folder, root / "tree" / folder)


def examine(workshop, number, mutant):
    start = time.monotonic()
    workshop.mutate(mutant)
    outcome, by = workshop.verdict(programs_for(mutant.file))
    workshop.restore()
    seconds = time.monotonic() - start
    print(f"{number:4} {outcome:9} {seconds:5.1f} s  {mutant.operator:10} {mutant.file}:{mutant.line}"
          f"  {by.splitlines()[0] if outcome != 'compiler' and by else ''}", flush=True)
    return {"number": number, "file": mutant.file, "line": mutant.line,
            "operator": mutant.operator, "before": mutant.before, "after": mutant.after,
            "outcome": outcome, "by": by, "seconds": round(seconds, 1)}


def self_test(root, ocaml_object):
    """One defect that a test must catch, one that the compiler must, and a change that is none."""
    workshop = Workshop(root, ocaml_object, 60)
    workshop.prepare(["faces"])
    file = "cpp/include/certet/lattice/stencil.hpp"
    expected = [("test", "2 1 14 3 | 2 14 24 3", "2 1 24 3 | 1 14 24 3"),  # the other diagonal
                ("compiler", "if (!plus) return {};", "if (!plus) return 0 || {};"),
                ("survived", "i < pattern_count", "i != pattern_count")]
    lines = (workshop.tree / file).read_text().splitlines()
    wrong = []
    workshop.restore()
    if workshop.verdict(["faces"])[0] != "survived":
        wrong.append("the tests fail without any defect")
    for outcome, old, new in expected:
        number = next(n for n, line in enumerate(lines, 1) if old in line)
        before = lines[number - 1]
        workshop.mutate(Mutant(file, number, "planted", before, before.replace(old, new)))
        found = workshop.verdict(["faces"])
        if found[0] != outcome:
            wrong.append(f"{new}: {outcome} was expected, not {found}")
    workshop.restore()
    if (workshop.tree / file).read_text().splitlines() != lines:
        wrong.append("the tree was not put back as it was")
    return wrong


def open_workshop(root, ocaml_object, seconds):
    copy_tree(root)
    workshop = Workshop(root, ocaml_object, seconds)
    workshop.prepare(OTHERWISE)
    workshop.restore()
    outcome, by = workshop.verdict(OTHERWISE)
    if outcome != "survived":
        sys.exit(f"mutate.py: the tests fail without any defect: {outcome} {by}")
    return workshop


def run(root, ocaml_object, arguments):
    print(f"seed {arguments.seed}", flush=True)
    mutants = choose(SOURCE, core_files(), arguments.count, arguments.seed)
    numbered = [(n, m) for n, m in enumerate(mutants) if arguments.only in (None, n)]
    free = queue.SimpleQueue()
    results = []

    def examine_next(task):
        workshop = free.get()
        try:
            return examine(workshop, *task)
        finally:
            free.put(workshop)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        for workshop in pool.map(lambda n: open_workshop(root / f"workshop-{n}", ocaml_object,
                                                         arguments.seconds), range(arguments.jobs)):
            free.put(workshop)
        for result in pool.map(examine_next, numbered):
            results.append(result)
            write_report(root, arguments.seed, results, len(numbered))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--count", type=int, default=250)
    parser.add_argument("--seed", type=int, default=2007)
    parser.add_argument("--seconds", type=float, default=60, help="at most, for each program of tests")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", type=int, help="the number of one mutant")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    root = (arguments.build / ("mutation_self_test" if arguments.self_test else "mutation")).resolve()
    ocaml_object = (arguments.build / "bridge/ocaml/certified_complete.o").resolve()
    shutil.rmtree(root, ignore_errors=True)
    if arguments.self_test:
        copy_tree(root)
        wrong = self_test(root, ocaml_object)
        shutil.rmtree(root)
        sys.exit("\n".join(wrong) if wrong else 0)
    results = run(root, ocaml_object, arguments)
    survivors = [r for r in results if r["outcome"] == "survived"]
    compiled = [r for r in results if r["outcome"] != "compiler"]
    print(f"{len(compiled) - len(survivors)} of {len(compiled)} caught; see {root / 'mutation.md'}")


if __name__ == "__main__":
    main()
