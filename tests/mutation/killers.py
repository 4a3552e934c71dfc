"""Compiling as little as a mutant asks for, and running the tests that may catch it."""

import os
import re
import shutil
import subprocess
from pathlib import Path

FLAGS = ["-std=c++20", "-ffp-contract=off", "-fno-math-errno", "-march=x86-64-v2", "-w",
         "-D_GLIBCXX_ASSERTIONS", "-Icpp/include", "-Icpp", "-Itests", "-Ibridge",
         "-Itests/differential", "-Itests/property"]
OPTIMIZED = ["-O1"]   # the engine
QUICK = ["-O0"]       # the tests, which are compiled more often than they are run

# What is compiled of the library.
ENGINE = ("cpp/lattice", "cpp/engine")

# Every program is one test file; those with the bridge compare with the certified functions.
PROGRAMS = {
    "constants": ("tests/differential/constants_test.cpp", "bridge"),
    "lattice": ("tests/differential/structured_tet_test.cpp", "bridge"),
    "stencil": ("tests/differential/stencil_test.cpp", "bridge"),
    "warp": ("tests/differential/warp_test.cpp", "bridge"),
    "mesh": ("tests/differential/mesh_test.cpp", "bridge core"),
    "bisect": ("tests/differential/bisect_test.cpp", "bridge core"),
    "cubes": ("tests/differential/cube_test.cpp", "bridge core"),
    "engine": ("tests/unit/engine_test.cpp", "core"),
    "faces": ("tests/property/face_test.cpp", ""),
    "soundness": ("tests/property/mesh_test.cpp", "core"),
    "link": ("tests/property/link_test.cpp", "settling"),
    "settling": ("tests/property/settling_test.cpp", "core settling"),
    "numbers": ("tests/unit/numbers_test.cpp", ""),
    "bounds": ("tests/unit/bounds_test.cpp", "core"),
    "limits": ("tests/unit/lattice_limits_test.cpp", "core"),
    "conformance": ("tests/conformance/engine_test.cpp", "core"),
    "pieces": ("tests/property/pieces_test.cpp", "core plain"),
    "regions": ("tests/property/regions_by_signs_test.cpp", "core plain"),
}

# The quickest killers of a file come first; afterwards all others.
FIRST = {
    "structured_tet.hpp": ["lattice", "numbers"], "tiling.hpp": ["mesh"], "stencil.hpp": ["stencil"], "warp.hpp": ["warp"],
    "direction.hpp": ["constants"], "coord3.hpp": ["numbers", "constants"], "sign.hpp": ["stencil", "numbers"],
    "orientation.hpp": ["numbers"], "checksum.hpp": ["numbers"], "frame.hpp": ["numbers"],
    "cuts.cpp": ["mesh", "bisect"], "domain.cpp": ["bisect", "mesh"], "parallel.hpp": ["engine"], "stuffing.cpp": ["engine", "mesh"],
    "stuffing.hpp": ["engine"], "lattice_around.cpp": ["bounds"],
    "lattice_limits.cpp": ["limits"], "inverted_tets.cpp": ["mesh", "conformance"],
    "link.hpp": ["link"], "settle.cpp": ["settling"], "part_cubes.cpp": ["cubes"],
    "disjoint_sets.hpp": ["pieces"], "plus_runs.hpp": ["pieces"], "plus_runs.cpp": ["pieces"],
    "run_cursor.hpp": ["pieces"], "zero_link.cpp": ["pieces", "regions"], "zero_tets.cpp": ["regions"],
    "join_zero_vertices.cpp": ["pieces", "regions"], "join_long_cuts.cpp": ["regions"],
    "joined_parts.cpp": ["pieces", "regions"], "piece_tets.cpp": ["pieces", "regions"],
    "piece_count.cpp": ["pieces"], "places.cpp": ["pieces"], "keep.cpp": ["pieces"],
}
OTHERWISE = ["mesh", "engine", "bisect", "soundness", "numbers", "constants", "lattice", "stencil", "warp", "faces",
             "bounds", "limits", "settling", "link", "cubes", "conformance", "pieces", "regions"]


def programs_for(file):
    first = FIRST.get(Path(file).name, [])
    return first + [p for p in OTHERWISE if p not in first]


class Broken(Exception):
    """The compiler refuses; the argument is what it says."""


class Workshop:
    """Objects of the untouched tree, and those that a mutant changes."""

    def __init__(self, root, ocaml_object, seconds):
        self.tree = root / "tree"
        self.objects = root / "objects"
        self.changed = root / "changed"
        self.ocaml_object = ocaml_object
        self.seconds = seconds
        self.mutated = None
        self.kit = f'-DCERTET_KIT="{self.tree / "tests/conformance/kit.json"}"'
        self.objects.mkdir(parents=True, exist_ok=True)

    # --- sources of a program ---------------------------------------------------------------

    def sources(self, program):
        test, needs = PROGRAMS[program]
        sources = [test]
        if "core" in needs:
            sources += sorted(str(p.relative_to(self.tree)) for room in ENGINE
                              for p in (self.tree / room).glob("*.cpp"))
        if "settling" in needs:
            sources += [f"tests/property/{n}.cpp" for n in ("settling_model", "topology")]
        if "plain" in needs:
            sources += ["tests/property/plain_pieces.cpp"]
        if "bridge" in needs:
            sources += ["tests/differential/main.cpp"]
            sources += [f"bridge/{n}.cpp" for n in ("certified", "runtime", "stubs")]
        return sources

    def _run(self, command):
        return subprocess.run(command, cwd=self.tree, capture_output=True, text=True)

    def _compile(self, source, folder):
        target = folder / (source.replace("/", "_") + ".o")
        is_engine = source.startswith("cpp/")
        header = [] if is_engine or source.startswith("bridge") else ["-include", str(self.objects / "tests.hpp")]
        extra = ["-isystem", _ocaml_headers()] if source.startswith("bridge") else []
        command = ["g++", *FLAGS, self.kit, *(OPTIMIZED if is_engine else QUICK), *header, *extra,
                   "-MMD", "-c", source, "-o", str(target)]
        result = self._run(command)
        if result.returncode != 0:
            raise Broken(result.stderr)
        return target

    def prepare(self, programs):
        """Compiles the untouched tree."""
        header = self.objects / "tests.hpp"
        header.write_text("#include <gtest/gtest.h>\n#include <rapidcheck.h>\n")
        self._run(["g++", *FLAGS, self.kit, *QUICK, "-x", "c++-header", str(header), "-o", f"{header}.gch"])
        for source in dict.fromkeys(s for p in programs for s in self.sources(p)):
            self._compile(source, self.objects)

    def _depends(self, source):
        notes = self.objects / (source.replace("/", "_") + ".d")
        return self.mutated in re.split(r"[\s\\]+", notes.read_text())

    def _object(self, source):
        if self.mutated is None or not self._depends(source):
            return self.objects / (source.replace("/", "_") + ".o")
        target = self.changed / (source.replace("/", "_") + ".o")
        return target if target.exists() else self._compile(source, self.changed)

    def _link(self, program):
        sources = self.sources(program)
        # The engine first: it is there that most mutants fail to compile.
        objects = [str(self._object(s)) for s in sorted(sources, key=lambda s: not s.startswith("cpp"))]
        bridge = "bridge" in PROGRAMS[program][1]
        libraries = [str(self.ocaml_object)] if bridge else ["-lgtest_main"]
        target = self.changed / program
        result = self._run(["g++", *objects, *libraries, "-lrapidcheck", "-lgtest", "-lm", "-ldl",
                            "-lpthread", "-o", str(target)])
        if result.returncode != 0:
            raise Broken(result.stderr)
        return target

    # --- one mutant --------------------------------------------------------------------------

    def mutate(self, mutant):
        self.restore()
        path = self.tree / mutant.file
        self.original = path.read_text()
        lines = self.original.splitlines()
        assert lines[mutant.line - 1] == mutant.before
        lines[mutant.line - 1] = mutant.after
        path.write_text("\n".join(lines) + "\n")
        self.mutated = mutant.file

    def restore(self):
        shutil.rmtree(self.changed, ignore_errors=True)
        self.changed.mkdir()
        if self.mutated is not None:
            (self.tree / self.mutated).write_text(self.original)
            self.mutated = None

    def _affects(self, program):
        return self.mutated is None or any(self._depends(s) for s in self.sources(program))

    def verdict(self, programs):
        """What caught it: ("compiler" or "test" or "timeout", by what), or ("survived", "")."""
        for program in programs:
            if not self._affects(program):
                continue
            try:
                executable = self._link(program)
            except Broken as broken:
                return "compiler", str(broken)[:300]
            outcome = self.failure_of(executable)
            if outcome is not None:
                return outcome[0], f"{program}: {outcome[1]}"
        return "survived", ""

    def failure_of(self, executable):
        """None if all tests pass, else how it ended.  The seeds are fixed; the tests that plant
        defects of their own are left out."""
        environment = dict(os.environ, CERTET_SEED="20071",
                           RC_PARAMS="seed=20071 max_success=60")
        command = ["prlimit", f"--as={4 << 30}", "--core=0",
                   str(executable), "--gtest_fail_fast", "--gtest_brief=1", "--gtest_filter=-*Catches*"]
        try:
            run = subprocess.run(command, env=environment, capture_output=True, text=True,
                                 errors="replace", timeout=self.seconds)
        except subprocess.TimeoutExpired:
            return "timeout", f"after {self.seconds} s"
        if run.returncode == 0:
            return None
        failed = re.findall(r"\[  FAILED  \] (\w+\.\w+)", run.stdout)
        return "test", failed[0] if failed else f"ended with status {run.returncode}"


def _ocaml_headers():
    where = subprocess.run(["ocamlfind", "ocamlc", "-where"], capture_output=True, text=True)
    return where.stdout.strip()
