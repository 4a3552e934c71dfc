#!/usr/bin/env python3
"""Writes theorems.md, the page from theorem to code, from theorems.txt.

usage: theorems.py               write it
       theorems.py --check BUILD whether every name is there, and the page as it would be written
       theorems.py --self-test   whether stale rows are found

A theorem must stand on one of the pages in coq/, with its proof in the file that it names; a function
in extracted/certified.mli; a C++ name, defined, in its file; a test in a source that its folder's
CMakeLists.txt compiles, and among those that ctest runs in the folder BUILD, if all is built there.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAGES = ("coq/Certificate.v", "coq/PaperCertificate.v", "coq/WholeMeshCertificate.v",
         "coq/MaterialCertificate.v", "coq/GradingCertificate.v", "coq/C15Certificate.v",
         "coq/KeyCertificate.v")
INTRODUCTION = """# From theorem to code

What is proved, the extracted function that it is proved of, the C++ that does the same, and the tests
that compare the two. The tables that this code reads are proved equal to what the extracted functions
say ([tests/certified_tables](../../tests/certified_tables/README.md)); the pictures of the hard parts are in
[pictures](pictures).

This page is written by [theorems.py](theorems.py) from [theorems.txt](theorems.txt), and a test fails if any
name on it is no longer where it says.
"""


def line_of(text, pattern):
    """The number of the first line that matches, or None."""
    found = re.search(pattern, text, re.MULTILINE)
    return found and text.count("\n", 0, found.start()) + 1


class Repository:
    """What names there are, and where."""

    def __init__(self, root):
        self.root = root
        self.theorems = {}
        for page in PAGES:
            if (root / page).exists():
                self.read_page(page)
        self.extracted = (root / "extracted/certified.mli").read_text()
        self.tests = {}
        for source in sorted((root / "tests").rglob("*.cpp")):
            built = source.parent / "CMakeLists.txt"
            if built.exists() and source.name in built.read_text():
                for suite, name in re.findall(r"^\w*(?:TEST|TEST_F|TEST_P|PROP)\((\w+),\s*(\w+)",
                                              source.read_text(), re.MULTILINE):
                    self.tests[f"{suite}.{name}"] = str(source.relative_to(root))

    def read_page(self, page):
        text = (self.root / page).read_text()
        for kind in re.finditer(r"^(?:Theorem|Lemma|Corollary) (\w+)", text, re.MULTILINE):
            proof = re.search(r"^Proof\. exact (?:(\w+)\.)?(\w+)\. Qed\.", text[kind.end():], re.MULTILINE)
            file = next((self.root / "coq").rglob(f"{proof[1]}.v"), None) if proof and proof[1] else None
            line = file and line_of(file.read_text(), rf"^ *(?:Theorem|Lemma|Corollary|Definition) {proof[2]}\b")
            self.theorems.setdefault(kind[1], (page, text.count("\n", 0, kind.start()) + 1,
                                               str(file.relative_to(self.root)) if line else None))

    def theorem(self, name):
        page, line, proof = self.theorems.get(name, (None, None, None))
        if page is None:
            raise LookupError(f"no theorem {name} on {' or '.join(PAGES)}")
        if proof is None:
            raise LookupError(f"the proof of {name} is not where {page} says")
        return f"[{name}](../../{page}#L{line})", proof

    def function(self, name):
        value = name[0].lower() + name[1:]
        line = line_of(self.extracted, rf"^val {value} :")
        if line is None:
            raise LookupError(f"no function {name} in extracted/certified.mli")
        return f"[{name}](../../extracted/certified.mli#L{line})"

    def code(self, file, name):
        path = self.root / "cpp" / file
        if not path.exists():
            raise LookupError(f"no file cpp/{file}")
        # A definition: after a type or another word, with nothing called or assigned before.
        line = line_of(path.read_text(), r"^(?!\s*//)(?!.*\b(?:return|else|case|throw)\b)"
                       rf"[^=(\"/\n]*[\w>&*\]][ ]+[*&]?(?:\w+::)*{name}\s*(?:[({{=:;]|$)")
        if line is None:
            raise LookupError(f"no {name} in cpp/{file}")
        return f"[{name}](../{file}#L{line})"

    def test(self, name):
        if name not in self.tests:
            raise LookupError(f"no test {name}")
        return f"[{name}](../../{self.tests[name]})"


def rows(text):
    """Headings, and rows as dictionaries of lists."""
    for line in text.splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith("== "):
            yield line[3:]
            row = None
        elif not line.startswith(" "):
            row = {"theorems": line.split(), "code": []}
            yield row
        else:
            key, _, value = line.strip().partition(": ")
            if key == "says":
                row[key] = value
            elif key == "code":
                file, *names = value.split()
                row[key].append((file, names))
            else:
                row[key] = value.split()


def page(repository, text):
    """The page, and what is wrong with the rows."""
    wrong, named = [], set()

    def look(find, *names):
        try:
            return find(*names)
        except LookupError as error:
            wrong.append(str(error))
            return names[-1], None

    parts = [INTRODUCTION]
    for row in list(rows(text)):
        if isinstance(row, str):
            parts.append(f"\n## {row}\n\n| in English | theorem | proof in `coq/` | extracted | C++ in `cpp/` | tests |\n"
                         "|---|---|---|---|---|---|\n")
            continue
        named |= set(row["theorems"])
        theorems = [look(repository.theorem, name) for name in row["theorems"]]
        proofs = list(dict.fromkeys(proof for _, proof in theorems if proof))
        cells = [row["says"], "<br>".join(link for link, _ in theorems),
                 "<br>".join(f"[{p.removeprefix('coq/')}](../../{p})" for p in proofs),
                 "<br>".join(str(look(repository.function, name)) for name in row.get("runs", [])) or "-",
                 "<br>".join(f"{file}: " + ", ".join(str(look(repository.code, file, name)) for name in names)
                             for file, names in row["code"]),
                 "<br>".join(str(look(repository.test, name)) for name in row["test"])]
        parts.append("| " + " | ".join(cells) + " |\n")
    rest = [name for name in repository.theorems if name not in named]
    parts.append("\n## Without a row\n\nWhat is proved of these functions beyond that, and of functions that no program "
                 "runs:\n" + ", ".join(f"`{name}`" for name in rest) + ".\n")
    return "".join(parts), wrong


def listed_tests(build):
    """The tests that ctest runs, without prefixes and numbers of instantiations; None if not all are built."""
    run = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    names = {test["name"] for test in json.loads(run.stdout)["tests"]}
    if any(name.endswith("_NOT_BUILT") for name in names):
        return None
    return {"/".join(part for part in name.split("/") if "." in part) for name in names}


def complaints(repository, text, committed):
    written, wrong = page(repository, text)
    if not wrong and written != committed:
        wrong.append("cpp/docs/theorems.md is not as it would be written: run cpp/docs/theorems.py")
    return wrong


# What is planted in theorems.txt, and what must be said.
PLANTED = [
    ("FacesCorrect Neighbor", "FacesRight Neighbor", "no theorem FacesRight"),
    ("runs: Bisect BisectedCuts", "runs: Halve BisectedCuts", "no function Halve"),
    ("code: engine/domain.cpp Bisection", "code: engine/bisection.cpp Bisection", "no file cpp/engine/bisection.cpp"),
    ("code: engine/domain.cpp Bisection", "code: engine/domain.cpp Halving", "no Halving in cpp/engine/domain.cpp"),
    # Called there, and not defined.
    ("code: engine/count.cpp count_tets", "code: engine/count.cpp popcount", "no popcount in cpp/engine/count.cpp"),
    ("test: Bisect.IsTheSame", "test: Bisect.IsNotTheSame", "no test Bisect.IsNotTheSame"),
]


def self_test(repository, text, committed):
    wrong = []
    for before, after, saying in PLANTED:
        assert text.count(before) == 1, before
        if not any(saying in line for line in complaints(repository, text.replace(before, after), committed)):
            wrong.append(f"a stale row is not found: {after}")
    moved = re.sub(r"#L(\d+)", lambda line: f"#L{int(line[1]) + 1}", committed, count=1)
    if not complaints(repository, text, moved):
        wrong.append("a wrong number of a line is not found")
    return wrong


def main():
    repository, text = Repository(ROOT), (HERE / "theorems.txt").read_text()
    output = HERE / "theorems.md"
    arguments = sys.argv[1:]
    if not arguments:
        written, wrong = page(repository, text)
        if not wrong:
            output.write_text(written)
    elif arguments[0] == "--check" and len(arguments) == 2:
        listed = listed_tests(arguments[1])
        if listed is not None:
            repository.tests = {name: file for name, file in repository.tests.items() if name in listed}
        wrong = complaints(repository, text, output.read_text())
    elif arguments == ["--self-test"]:
        wrong = self_test(repository, text, output.read_text())
    else:
        sys.exit(__doc__)
    if wrong:
        sys.exit("\n".join(wrong))
    if arguments:
        print("every name is where it says" if arguments[0] == "--check" else
              f"all {len(PLANTED) + 1} stale rows were found")


if __name__ == "__main__":
    main()
