"""Where the time of a run of `certet` goes: by stage, by library and by function.

usage: profile.py BUILD [--by perf|callgrind] [ARGUMENT...]
ARGUMENTs are those of `certet`; without any, a torus of a million tetrahedra is meshed to a .vtu.
Perf takes samples where the system allows it, else callgrind counts instructions (some fifty times
slower; the stages' seconds are of a run without it).  The table is printed and written to
BUILD/profile/profile.md, beside what perf or callgrind wrote.  Exit status: 0 done, 1 a program
failed, 2 wrong usage.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import programs

TORUS = ["mesh", "--shape", "torus:1,0.4", "--target-tets", "1000000", "-o", "torus.vtu"]
ROWS = 30


def allows_perf():
    if shutil.which("perf") is None:
        return False
    tried = subprocess.run(["perf", "stat", "-e", "cpu-clock:u", "true"], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return tried.returncode == 0


def stages(command, folder):
    """Seconds of each stage, as the program itself tells; none of subcommands that do not."""
    report = folder / "run.json"
    report.unlink(missing_ok=True)
    programs.run([*command, "--json", report], folder)
    return json.loads(report.read_text()).get("seconds", {})


def by_perf(command, folder):
    """Rows of (share, library, function), of samples."""
    data = folder / "perf.data"
    programs.run(["perf", "record", "-q", "-e", "cpu-clock:u", "-F", "2000", "-o", data, "--",
                  *command], folder)
    text, _, _ = programs.run(["perf", "report", "-i", data, "--stdio", "--no-inline", "-g", "none",
                               "-F", "overhead,dso,symbol", "-t", "|"], folder)
    for line in text.splitlines():
        parts = [part.strip() for part in line.split("|", 2)]
        if len(parts) == 3 and re.fullmatch(r"[\d.]+%", parts[0]):
            yield float(parts[0][:-1]), parts[1], re.sub(r"^\[.\] ", "", parts[2])


def by_callgrind(command, folder):
    """Rows of (share, library, function), of instructions."""
    data = folder / "callgrind.out"
    programs.run(["valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={data}", *command],
                 folder)
    text, _, _ = programs.run(["callgrind_annotate", "--auto=no", data], folder)
    for line in text.splitlines():
        row = re.match(r"\s*[\d,]+ \(\s*([\d.]+)%\)\s+[^:\s]*:(.*?)(?: \[(.*)\])?$", line)
        if row and row[3]:
            yield float(row[1]), Path(row[3]).name, row[2]


def readable(rows):
    """Names as in the sources, without what all of them have."""
    rows = list(rows)
    names = "\n".join(function for _, _, function in rows)
    plain = subprocess.run(["c++filt"], input=names, text=True, capture_output=True, check=True).stdout
    for (share, library, _), name in zip(rows, plain.splitlines()):
        yield share, library, re.sub(r"certet::|core::|\(anonymous namespace\)::|std::", "", name)


def table(seconds, rows, what):
    lines = ["| stage | seconds |", "|---|--:|"]
    lines += [f"| {stage} | {value:.3f} |" for stage, value in seconds.items()]
    lines += ["", f"| {what} | library | function |", "|--:|---|---|"]
    for share, library, function in rows[:ROWS]:
        lines.append(f"| {share:.2f} % | {library} | `{function[:100]}` |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--by", choices=("perf", "callgrind"))
    arguments, options = parser.parse_known_args()
    folder = arguments.build.resolve() / "profile"
    folder.mkdir(exist_ok=True)
    command = [arguments.build.resolve() / "bin" / "certet", *(options or TORUS)]
    by = arguments.by or ("perf" if allows_perf() else "callgrind")
    try:
        seconds = stages(command, folder)
        rows = list(readable((by_perf if by == "perf" else by_callgrind)(command, folder)))
    except programs.Failed as failed:
        print(f"profile: {failed}", file=sys.stderr)
        return 1
    text = table(seconds, rows, "samples" if by == "perf" else "instructions")
    (folder / "profile.md").write_text(text)
    print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
