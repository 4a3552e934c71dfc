"""Running the programs that are measured, and describing the machine they run on."""

import json
import os
import platform
import re
import resource
import subprocess
import tempfile
import time
from pathlib import Path


class Failed(Exception):
    """A program that should have run did not; one sentence."""


def run(arguments, folder, fine=(0,)):
    """Runs a program in a folder; gives (standard output, wall seconds, peak bytes)."""
    arguments = [str(a) for a in arguments]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as words:
        start = time.perf_counter()
        process = subprocess.Popen(arguments, cwd=folder, stdout=out, stderr=words)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        words.seek(0)
        if process.returncode not in fine:
            said = words.read().decode(errors="replace").strip()
            raise Failed(f"{Path(arguments[0]).name} ended with status {process.returncode}: {said}")
        return out.read().decode(), seconds, usage.ru_maxrss * 1024


class Programs:
    """The programs of a build folder; all they write goes to its folder `bench`."""

    def __init__(self, build):
        self.build = Path(build).resolve()
        self.bin = self.build / "bin"
        self.folder = self.build / "bench"
        self.folder.mkdir(exist_ok=True)
        self.reference_program = self.folder / "reference" / "certet-reference"

    def has(self, name):
        return (self.bin / name).exists()

    def whole(self, tets, threads, repeats):
        """One result for every size with every number of threads."""
        joined = [",".join(f"{x:g}" for x in xs) for xs in (tets, threads)]
        out, _, _ = run([self.bin / "certet_bench_whole", *joined, repeats], self.folder)
        return [json.loads(line) for line in out.splitlines()]

    def image(self, file, size, cuts, threads, repeats):
        out, _, _ = run([self.bin / "certet_bench_image", file, size, cuts, threads, repeats],
                        self.folder)
        return json.loads(out)

    def mesh(self, *options):
        """`certet mesh`: its own report, with `wall` seconds and `peak` bytes from outside."""
        report = self.folder / "mesh.json"
        _, wall, peak = run([self.bin / "certet", "mesh", *options, "--json", report], self.folder)
        result = json.loads(report.read_text())
        report.unlink()
        return {**result, "wall": wall, "peak": peak}

    def command(self, *arguments):
        """Wall seconds of `certet`."""
        _, wall, _ = run([self.bin / "certet", *arguments], self.folder)
        return wall

    def check(self, file):
        """What `certet check` tells of a file, whether it finds defects or not."""
        out, _, _ = run([self.bin / "certet", "check", file, "--json", "-"], self.folder,
                        fine=(0, 1))
        return json.loads(out)

    def parts(self):
        """The parts' benchmarks: the least nanoseconds of each by its name."""
        file = self.folder / "parts.json"
        run([self.bin / "certet_bench_parts", f"--benchmark_out={file}",
             "--benchmark_out_format=json", "--benchmark_min_time=0.2",
             "--benchmark_repetitions=3"], self.folder)
        least = {}
        for entry in json.loads(file.read_text())["benchmarks"]:
            if entry["run_type"] != "iteration":
                continue
            name = re.sub(r"/(iterations:\d+|real_time|manual_time)", "", entry["run_name"])
            seconds = entry["real_time"] * 1e-9  # its own unit unless told otherwise
            items = entry["items_per_second"] * seconds
            if name not in least or seconds < least[name]["seconds"]:
                least[name] = {"seconds": seconds, "items": round(items)}
        return least

    def reference(self, *options):
        """Wall seconds of the extracted mesher."""
        _, seconds, _ = run([self.reference_program, *options], self.folder)
        return seconds


def _first(pattern, file, otherwise="unknown"):
    try:
        found = re.search(pattern, Path(file).read_text(), re.MULTILINE)
    except OSError:
        found = None
    return found.group(1).strip() if found else otherwise


def cores():
    return len(os.sched_getaffinity(0))


def available_bytes():
    return int(_first(r"^MemAvailable:\s*(\d+)", "/proc/meminfo", "0")) * 1024


def machine(build):
    """What the figures were taken on."""
    cache = Path(build) / "CMakeCache.txt"
    compiler = _first(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, "c++")
    version = run([compiler, "--version"], build)[0].splitlines()[0]
    memory = int(_first(r"^MemTotal:\s*(\d+)", "/proc/meminfo", "0")) / 2**20
    return {
        "processor": _first(r"^model name\s*:\s*(.*)$", "/proc/cpuinfo", platform.machine()),
        "cores": cores(),
        "memory_gib": round(memory, 1),
        "system": f"{platform.system()} {platform.release()}",
        "compiler": version,
        "build": _first(r"^CMAKE_BUILD_TYPE:\w+=(.+)$", cache, "Release"),
    }


class Neighbours:
    """How much of the machine others used while the figures were taken."""

    def __init__(self):
        self._start = self._busy(), self._own(), time.perf_counter()

    @staticmethod
    def _busy():
        """Processor seconds of everybody since the machine was started."""
        fields = [int(f) for f in Path("/proc/stat").read_text().split("\n")[0].split()[1:]]
        user, nice, system, _idle, _wait, interrupts, soft, steal = fields[:8]
        return (user + nice + system + interrupts + soft + steal) / os.sysconf("SC_CLK_TCK")

    @staticmethod
    def _own():
        who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
        usages = [resource.getrusage(w) for w in who]
        return sum(u.ru_utime + u.ru_stime for u in usages)

    def cores(self):
        busy, own, start = self._start
        others = (self._busy() - busy) - (self._own() - own)
        return max(0.0, others) / (time.perf_counter() - start)
