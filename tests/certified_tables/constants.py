#!/usr/bin/env python3
"""Whether every constant of the engine is in the dump of its tables, or excused.

usage: constants.py DUMP_TABLES            compare what clang finds in the sources with the dump
       constants.py DUMP_TABLES --list     print what clang finds
       constants.py DUMP_TABLES --self-test  constants planted in a copy of the sources must be missed

The engine is cpp/lattice, cpp/engine, cpp/include/certet and cpp/mesh, headers and sources.  Its constants are
all variables at namespace scope, all static ones, all that are constexpr, its enumerations, and its
constexpr functions; clang's syntax tree tells which.  excused.txt says what they are that are not
dumped under their own name.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
FOLDERS = ("cpp/include/certet/lattice", "cpp/include/certet", "cpp/lattice", "cpp/engine", "cpp/mesh",
           "cpp/mesh/quality")
FUNCTIONS = ("FunctionDecl", "CXXMethodDecl", "CXXConversionDecl", "CXXConstructorDecl",
             "CXXDestructorDecl")
SCOPES = ("NamespaceDecl", "CXXRecordDecl", "ClassTemplateSpecializationDecl", "EnumDecl")


def sources(root):
    """Headers before sources, so that a unit of all of them is in order."""
    return [path for suffix in (".hpp", ".cpp") for folder in FOLDERS
            for path in sorted((root / folder).glob("*" + suffix))]


def syntax_tree(root, files):
    """The declarations in namespace certet, or None if the files do not compile as one unit."""
    unit = "".join(f'#include "{file}"\n' for file in files)
    clang = [os.environ.get("CLANGXX", "clang++"), "-std=c++20", "-fsyntax-only", "-x", "c++",
             *(f"-I{root / folder}" for folder in ("cpp", *FOLDERS[2:], "cpp/include")),
             "-Xclang", "-ast-dump=json", "-Xclang", "-ast-dump-filter=certet", "-"]
    run = subprocess.run(clang, input=unit, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, check=False)
    if run.returncode != 0:
        return None, run.stderr
    decoder, at, trees = json.JSONDecoder(), 0, []
    while (at := run.stdout.find("{", at)) >= 0:
        tree, at = decoder.raw_decode(run.stdout, at)
        trees.append(tree)
    return trees, ""


class Constants:
    """Walks a syntax tree; `found` maps the qualified name of each constant to its file."""

    def __init__(self, root):
        self.root = root
        self.file = ""
        self.found = {}
        self.enumerators = {}
        self.scopes = {}  # of classes, by clang's number of them

    def locate(self, node):
        """clang names a file only where it differs from the place that it printed before."""
        for key in ("loc", "begin", "end", "spellingLoc", "expansionLoc", "range"):
            part = node.get(key)
            if isinstance(part, dict):
                self.file = part.get("file", self.file)
                self.locate(part)

    def is_ours(self):
        return any(Path(self.file).is_relative_to(self.root / folder) for folder in FOLDERS)

    def walk(self, node, scope=(), local=False):
        self.locate(node)
        kind, name = node.get("kind", ""), node.get("name")
        ours = self.is_ours() and not node.get("isImplicit") and not node.get("explicitlyDefaulted")
        if kind == "CXXRecordDecl" and node.get("definitionData", {}).get("isLambda"):
            return  # the body of the lambda stands beside it
        if kind in FUNCTIONS:
            scope = self.scopes.get(node.get("parentDeclContextId"), scope)
            scope, local = scope + (f"{name}()",), True
            if ours and node.get("constexpr"):
                self.add(scope)
        elif kind in SCOPES and name:
            scope += (name,)
            self.scopes[node["id"]] = scope
            if ours and kind == "EnumDecl":
                self.add(scope)
                self.enumerators["::".join(scope)] = [
                    child["name"] for child in node.get("inner", ())
                    if child.get("kind") == "EnumConstantDecl"]
        elif kind == "VarDecl":
            scope += (name or "",)
            if ours and (not local or node.get("constexpr") or node.get("storageClass") == "static"):
                self.add(scope)
        for child in node.get("inner", ()):
            self.walk(child, scope, local or kind == "LambdaExpr")

    def add(self, scope):
        self.found.setdefault("::".join(scope), str(Path(self.file).relative_to(self.root)))


def engine_constants(root):
    files = sources(root)
    found = Constants(root)
    trees, _ = syntax_tree(root, files)
    if trees is None:  # two sources use one name: each by itself then, which takes longer
        trees = []
        for file in files:
            more, error = syntax_tree(root, [file])
            if more is None:
                sys.exit(f"constants.py: {file} does not compile\n{error}")
            trees += more
    for tree in trees:
        found.file = ""
        found.walk(tree)
    return found


def excuses():
    """NAME = TABLE, or ENUMERATION{ENUMERATOR, ...} = TABLE, or NAME: REASON; # is a comment."""
    dumped_as, excused, enumerators = {}, {}, {}
    for line in (HERE / "excused.txt").read_text().splitlines():
        line = line.split("#")[0].strip()
        if not line:
            continue
        name, separator, rest = line.partition(" = ")
        if separator:
            name, _, dumped = name.strip().partition("{")
            dumped_as[name] = [table.strip() for table in rest.split(",")]
            enumerators[name] = [one.strip() for one in dumped.rstrip("}").split(",") if one]
            continue
        name, separator, reason = line.partition(": ")
        if not separator or not reason.strip():
            sys.exit(f"constants.py: no reason is given for {line}")
        excused[name.strip()] = reason.strip()
    return dumped_as, excused, enumerators


def ask(dump, question):
    return subprocess.run([dump, question], check=True, text=True,
                          stdout=subprocess.PIPE).stdout.split()


def complaints(constants, dump):
    """What is neither dumped nor excused, and what is so without need."""
    own_name, tables = set(ask(dump, "--constants")), set(ask(dump, "--tables"))
    dumped_as, excused, enumerators = excuses()
    found, enumerations = constants.found, constants.enumerators
    wrong = []
    for name, dumped in sorted(enumerators.items()):
        if name in found and dumped != enumerations.get(name, []):
            wrong.append(f"{name} ({found[name]}) has other enumerators than are dumped")
    for name, file in sorted(found.items()):
        parts = name.split("::")
        within = any("::".join(parts[:n]) in own_name for n in range(1, len(parts)))
        ways = (name in own_name) + (name in dumped_as) + (name in excused)
        if ways == 0 and not within:
            wrong.append(f"{name} ({file}) is neither dumped nor excused")
        if ways > 1:
            wrong.append(f"{name} is both dumped and excused")
    for name in sorted((own_name | set(dumped_as) | set(excused)) - set(found)):
        wrong.append(f"{name} is dumped or excused, but is no constant of the engine")
    for name, targets in sorted(dumped_as.items()):
        wrong += [f"{name} is said to be in the table {table}, which is not dumped"
                  for table in targets if table not in tables]
    return wrong


PLANTED = {
    "cpp/lattice/lattice_edges.hpp": ("/// An edge as one",
                                   "inline constexpr std::array<int, 3> planted_a{1, 2, 3};\n"),
    "cpp/engine/emit_points.cpp": ("/// Cuts of one family.", "const int planted_b[] = {4, 5};\n"),
    "cpp/mesh/quality/bounds.cpp": ("  // As many digits as are",
                               "  static constexpr double planted_c = 0.5; (void)planted_c;\n"),
    "cpp/include/certet/frame.hpp": ("  double size = 1;",
                                     "  static constexpr int planted_d = 7;\n"),
    "cpp/include/certet/lattice/direction.hpp": ("/// The square of an edge",
                                         "constexpr /* a\n comment */ int planted_e(int d)"
                                         " { return d; }\n"),
    "cpp/include/certet/method.hpp": ("  midpoint,  ///<", "  planted_f,\n"),
}


def self_test(dump):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        shutil.copytree(SOURCE / "cpp", root / "cpp")
        for file, (before, constant) in PLANTED.items():
            text = (root / file).read_text()
            if text.count(before) != 1:
                sys.exit(f"constants.py: no place to plant in {file}")
            (root / file).write_text(text.replace(before, constant + before))
        missed = complaints(engine_constants(root), dump)
    wrong = [f"planted in {file}, and not missed" for file in PLANTED
             if sum(f"({file})" in line for line in missed) != 1]
    return wrong + [line for line in missed if not any(f"({file})" in line for file in PLANTED)]


def main():
    arguments = sys.argv[1:]
    if not arguments or arguments[1:] not in ([], ["--list"], ["--self-test"]):
        sys.exit(__doc__)
    dump = arguments[0]
    if arguments[1:] == ["--self-test"]:
        wrong = self_test(dump)
        print("\n".join(wrong) if wrong else f"all {len(PLANTED)} planted constants were missed in the dump")
        sys.exit(bool(wrong))
    found = engine_constants(SOURCE)
    if arguments[1:] == ["--list"]:
        print("\n".join(f"{name}  {file}" for name, file in sorted(found.found.items())))
        return
    wrong = complaints(found, dump)
    print("\n".join(wrong) if wrong else f"all {len(found.found)} constants are dumped or excused")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
