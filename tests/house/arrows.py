#!/usr/bin/env python3
"""Whether no arrow in cpp/ points against the flow.

usage: arrows.py              look at the sources
       arrows.py --list       print the arrows between folders
       arrows.py --self-test  arrows planted in a copy of the sources must be found

An arrow goes from a file to one that it includes.  rooms.txt has the rooms in order; a file includes
its own room and those before it.  A public header includes public headers alone, and examples do so
too.  No file includes itself by way of others, and no folder does.
"""

import re
import shutil
import sys
import tempfile
from collections import defaultdict
from fnmatch import fnmatch
from pathlib import Path, PurePosixPath

HERE = Path(__file__).resolve().parent
CPP = HERE.parent.parent / "cpp"
PUBLIC = "include/certet/"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<(certet/[^>]+)>)', re.MULTILINE)


class Rooms:
    """Which room a file belongs to, by its name relative to cpp/."""

    def __init__(self, lines):
        self.names, self.leaves, self.headers = [], set(), []
        for line in lines:
            line = line.split("#")[0].strip()
            if not line:
                continue
            room, _, patterns = line.partition(":")
            name = room.removesuffix(" (leaf)")
            self.names.append(name)
            if name != room:
                self.leaves.add(name)
            self.headers += [(pattern, name) for pattern in patterns.split()]

    def of(self, file):
        """The room, or None."""
        if file.startswith(PUBLIC):
            rooms = {room for pattern, room in self.headers
                     if fnmatch(file.removeprefix(PUBLIC), pattern)}
            return rooms.pop() if len(rooms) == 1 else None
        room = file.split("/")[0]
        return room if room in self.names else None

    def complaints(self, file, target):
        """What is wrong with an arrow."""
        room, other = self.of(file), self.of(target)
        if room is None or other is None:
            return  # said of the file itself
        if self.names.index(other) > self.names.index(room):
            yield f"{file} includes {target}, against the flow: {other} comes after {room}"
        if other != room and other in self.leaves:
            yield f"{file} includes {target}, and {other} is for nobody to include"
        if (file.startswith(PUBLIC) or room == "examples") and not target.startswith(PUBLIC):
            yield f"{file} includes {target}, which is not public"

    def unused(self, files):
        for pattern, _ in self.headers:
            if not any(fnmatch(file, PUBLIC + pattern) for file in files):
                yield f"rooms.txt names {pattern}, which is not there"


def resolve(files, file, name):
    """The file of cpp/ that `file` means by `name`, or None: beside it, in a folder above it up to its
    room, in cpp/ or among the public headers."""
    folders = [folder for folder in PurePosixPath(file).parents]
    for folder in [*folders, PurePosixPath("include")]:
        parts = []
        for part in (folder / name).parts:
            if part == "..":
                parts.pop()
            else:
                parts.append(part)
        if "/".join(parts) in files:
            return "/".join(parts)
    return None


def arrows(cpp):
    """The files, the arrows, and what is included that is not there."""
    files = {str(path.relative_to(cpp)) for path in cpp.rglob("*") if path.suffix in (".hpp", ".cpp", ".h")}
    found, missing = defaultdict(set), []
    for file in sorted(files):
        for quoted, public in INCLUDE.findall((cpp / file).read_text()):
            target = resolve(files, file, quoted or public)
            if target:
                found[file].add(target)
            else:
                missing.append(f"{file} includes {quoted or public}, which is not there")
    return files, found, missing


def folder_of(rooms, file):
    """The folder of a file; public headers are one for each room."""
    if file.startswith(PUBLIC):
        return f"{rooms.of(file)} (public)"
    return str(PurePosixPath(file).parent)


def between_folders(rooms, found):
    graph = defaultdict(set)
    for file, targets in found.items():
        graph[folder_of(rooms, file)] |= {folder_of(rooms, target) for target in targets}
    return {folder: targets - {folder} for folder, targets in graph.items()}


def circle(graph):
    """The nodes of one circle, or an empty list."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):]
        if node in done:
            return []
        path.append(node)
        for target in sorted(graph.get(node, ())):
            if found := visit(target):
                return found
        path.pop()
        done.add(node)
        return []

    for node in sorted(graph):
        if found := visit(node):
            return found
    return []


def complaints(cpp):
    rooms = Rooms((HERE / "rooms.txt").read_text().splitlines())
    files, found, wrong = arrows(cpp)
    wrong += [f"{file} belongs to no room, or to several: rooms.txt tells" for file in sorted(files)
              if rooms.of(file) is None]
    wrong += rooms.unused(files)
    for file, targets in sorted(found.items()):
        for target in sorted(targets):
            wrong += rooms.complaints(file, target)
    for what, graph in (("files", found), ("folders", between_folders(rooms, found))):
        if around := circle(graph):
            wrong.append(f"a circle of {what}: " + " → ".join([*around, around[0]]))
    return wrong


# What is planted: in which file, what it includes, and what is to be said of it.
PLANTED = [
    ("lattice/lattice_limits.cpp", "engine/parallel.hpp", "against the flow: engine comes after lattice"),
    ("engine/parallel.hpp", "certet/survey.hpp", "against the flow: mesh comes after engine"),
    ("include/certet/lattice/sign.hpp", "certet/mesh.hpp", "against the flow: engine comes after lattice"),
    ("mesh/faces.cpp", "files/formats/cursor.hpp", "against the flow: files comes after mesh"),
    ("files/formats/cursor.cpp", "certet/image.hpp", "against the flow: domains comes after files"),
    ("domains/shape/shape_domain.cpp", "view/vector.hpp", "against the flow: view comes after domains"),
    ("bench/whole.cpp", "command/status.hpp", "command is for nobody to include"),
    ("include/certet/formats.hpp", "files/formats/names.hpp", "which is not public"),
    ("examples/surface/main.cpp", "engine/parallel.hpp", "which is not public"),
    ("engine/sample.hpp", "engine/no_such_file.hpp", "which is not there"),
    ("engine/window.hpp", "emit.hpp", "a circle of files"),
    ("files/formats/cursor.hpp", "files/label_names.hpp", "which is not there"),
    ("files/formats/cursor.hpp", "files/slab.hpp", "a circle of folders"),
]


def self_test():
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        cpp = Path(folder).resolve() / "cpp"
        shutil.copytree(CPP, cpp)
        for file, target, saying in PLANTED:
            text = (cpp / file).read_text()
            (cpp / file).write_text(f'#include "{target}"\n{text}')
            if not any(saying in line for line in complaints(cpp)):
                wrong.append(f"planted in {file}, and not found: {target}")
            (cpp / file).write_text(text)
        (cpp / PUBLIC / "planted.hpp").write_text("#pragma once\n")
        if not any("planted.hpp belongs to no room" in line for line in complaints(cpp)):
            wrong.append("a public header without a room was not found")
    return wrong


def main():
    arguments = sys.argv[1:]
    if arguments == ["--list"]:
        rooms = Rooms((HERE / "rooms.txt").read_text().splitlines())
        for folder, targets in sorted(between_folders(rooms, arrows(CPP)[1]).items()):
            print(folder, "→", ", ".join(sorted(targets)))
        return
    if arguments not in ([], ["--self-test"]):
        sys.exit(__doc__)
    wrong = self_test() if arguments else complaints(CPP)
    print("\n".join(wrong) if wrong else
          f"all {len(PLANTED) + 1} planted arrows were found" if arguments else "every arrow goes with the flow")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
