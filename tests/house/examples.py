#!/usr/bin/env python3
"""Whether every example is short, and the README shows examples word for word.

usage: examples.py              look at them
       examples.py --self-test  longer ones, and other words, must be found

That they are compiled and run is tested in tests/package (C++), tests/python and tests/solvers.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
MOST_LINES = 15
# CalculiX has a line for each keyword.
MOST_KEYWORD_LINES = 20
FENCE = re.compile(r"^```(cpp|python)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def sources():
    folder = ROOT / "cpp" / "examples"
    return {path.relative_to(ROOT).as_posix(): path.read_text()
            for pattern in ("*/main.cpp", "python/*.py", "solvers/*") for path in sorted(folder.glob(pattern))}


def complaints(readme, examples):
    for name, text in examples.items():
        lines = text.count("\n")
        most = MOST_KEYWORD_LINES if name.endswith(".inp") else MOST_LINES
        if lines > most:
            yield f"{name} has {lines} lines, more than {most}"
    shown = FENCE.findall(readme)
    for language in ("cpp", "python"):
        if language not in [shown_language for shown_language, _ in shown]:
            yield f"README.md shows no example of {language}"
    yield from untried(examples)
    for language, snippet in shown:
        if snippet not in examples.values():
            yield f"README.md shows {language} that is no example word for word: {snippet[:60]!r}"


def untried(examples):
    """What no test of a solver names."""
    tests = "".join(path.read_text() for path in (ROOT / "tests" / "solvers").glob("*_test.py"))
    for name in examples:
        if "/solvers/" in name and f'"{Path(name).name}"' not in tests:
            yield f"{name} is run by no test in tests/solvers"


def self_test(readme, examples):
    name, text = next(iter(examples.items()))
    shown = FENCE.search(readme)[2]
    planted = {
        "a long example": (readme, {**examples, name: text + "\n" * MOST_LINES}),
        "a long input of a solver": (readme, {**examples, "a.inp": "\n" * (MOST_KEYWORD_LINES + 1)}),
        "an input that is not run": (readme, {**examples, "cpp/examples/solvers/new.inp": "\n"}),
        "another word": (readme.replace(shown, shown.replace("certet::", "certet:: ")
                                        .replace("import", "import ")), examples),
        "no example": (FENCE.sub("", readme), examples),
    }
    missed = [what for what, (r, e) in planted.items() if not list(complaints(r, e))]
    for what in missed:
        print("not found:", what)
    return 1 if missed else 0


def main():
    readme, examples = (ROOT / "README.md").read_text(), sources()
    if sys.argv[1:] == ["--self-test"]:
        return self_test(readme, examples)
    found = list(complaints(readme, examples))
    print("\n".join(found) or f"{len(examples)} examples, all short and run")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
