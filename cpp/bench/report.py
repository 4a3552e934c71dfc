"""Takes the figures of certet: bench.md, bench.json and bench.svg.

usage: report.py BUILD [--large]
BUILD is a build folder; all is written to BUILD/bench.  --large sends 300 million
tetrahedra to a file instead of 30 million.  A missed bound is told, not an error:
how fast a machine is, is no property of the program.  Exit status: 0 done, 1 a
program failed, 2 wrong usage.
"""

import argparse
import dataclasses
import json
import sys
import time

import figures
import plot
import programs


def say(words):
    print(f"bench: {words}", flush=True)


def take(bench, large):
    """All figures, one after the other."""
    tasks = [
        ("the engine against memcpy", figures.engine_and_copy(bench)),
        ("1M against 100M", figures.growth(bench)),
        ("the brain atlas", figures.brain(bench)),
        ("a large file", figures.memory_to_file(bench, 3e8 if large else 3e7)),
        ("the extracted reference", figures.reference(bench)),
    ]
    taken = []
    for words, task in tasks:
        say(words)
        taken += task
    return taken


def number(value):
    return f"{value:.0f}" if value >= 100 else f"{value:.2f}"


def verdict(figure):
    if figure.bound is None:
        return ""
    side = "at least" if figure.at_least else "at most"
    unit = f" {figure.unit}" if figure.unit else ""
    return f"{side} {figure.bound:g}{unit}: {'met' if figure.met else 'missed'}"


def row(figure):
    if isinstance(figure, figures.Skipped):
        return f"| {figure.name} | – | | not measured: {figure.why} |"
    value = f"{number(figure.value)} {figure.unit}".strip()
    return f"| {figure.name} | {value} | {verdict(figure)} | {figure.details} |"


def series_rows(series):
    for run in series:
        peak = figures.mib(run["peak_bytes"]) if "peak_bytes" in run else ""
        yield (f"| {run['tets']:,} | {run['threads']} | {figures.seconds(run['seconds'])} "
               f"| {run['seconds'] / run['tets'] * 1e9:.1f} "
               f"| {run['seconds'] / run['copy_warm_seconds']:.1f} "
               f"| {peak} | {figures.mib(run['mesh_bytes'])} |")


def parts_rows(parts):
    for name, part in parts.items():
        yield (f"| {name} | {figures.seconds(part['seconds'])} | {part['items']:,} "
               f"| {part['seconds'] / part['items'] * 1e9:.2f} |")


def markdown(result, rows, with_plot):
    machine = result["machine"]
    lines = [
        "# Figures of certet", "",
        f"{machine['processor']}, {machine['cores']} cores, {machine['memory_gib']} GiB; "
        f"{machine['system']}; {machine['compiler']}, {machine['build']}.",
        f"Others used {machine['others_cores']:.2f} of the cores meanwhile"
        + (": the machine was not quiet, and times are too long." if
           machine["others_cores"] > 0.1 else "."),
        "Every time is the least of several; what is compared took turns.", "",
        "## The whole", "",
        "| figure | value | bound | of what |", "|---|---|---|---|", *map(row, rows), "",
        "## The engine by size", "",
        "Torus, from sampling to the mesh in memory; each size in a process of its own.", "",
        "| tetrahedra | threads | time | ns per tetrahedron | over warm memcpy | peak memory "
        "| the mesh |", "|--:|--:|--:|--:|--:|--:|--:|", *series_rows(result["series"]), ""]
    if with_plot:
        lines += ["![Time and memory per tetrahedron](bench.svg)", ""]
    lines += ["## The parts", ""]
    if result["parts"]:
        lines += ["One thread; items are tetrahedra of a torus of a million, or what the name "
                  "says.", "", "| part | time | items | ns per item |", "|---|--:|--:|--:|",
                  *parts_rows(result["parts"]), ""]
    else:
        lines += ["Not measured: Google Benchmark was not found when certet was built.", ""]
    return "\n".join(lines)


def draw(series, file):
    """Whether there is a plot."""
    try:
        plot.draw(series, file)
    except ImportError:
        say("no plot, for matplotlib is missing (Debian package python3-matplotlib)")
        file.unlink(missing_ok=True)
        return False
    return True


def as_json(figure):
    fields = dataclasses.asdict(figure)
    return fields | {"met": figure.met} if isinstance(figure, figures.Figure) else fields


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", metavar="BUILD")
    parser.add_argument("--large", action="store_true")
    options = parser.parse_args()
    bench = programs.Programs(options.build)
    if not bench.has("certet_bench_whole"):
        raise programs.Failed(f"there are no benchmarks in '{bench.bin}'")
    start, neighbours = time.perf_counter(), programs.Neighbours()
    rows = take(bench, options.large)
    say("the engine by size")
    series = figures.series(bench)
    say("the parts")
    parts = bench.parts() if bench.has("certet_bench_parts") else {}
    machine = programs.machine(bench.build) | {"others_cores": round(neighbours.cores(), 2)}
    result = {"machine": machine, "figures": [as_json(f) for f in rows], "series": series,
              "parts": parts}
    (bench.folder / "bench.json").write_text(json.dumps(result, indent=2) + "\n")
    with_plot = draw(series, bench.folder / "bench.svg")
    (bench.folder / "bench.md").write_text(markdown(result, rows, with_plot))
    print("\n".join(map(row, rows)))
    say(f"{bench.folder / 'bench.md'}, in {time.perf_counter() - start:.0f} s")


if __name__ == "__main__":
    try:
        main()
    except (programs.Failed, OSError) as failure:
        sys.exit(f"bench: {failure}")
