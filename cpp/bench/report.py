"""Takes the figures of certet: bench.md, bench.json and bench.svg.

usage: report.py BUILD [--large] [--only materials]
BUILD is a build folder; all is written to BUILD/bench.  --large sends 300 million
tetrahedra to a file instead of 30 million.  --only takes the figures of several regions
alone, into materials.md and materials.json.  A missed bound is told, not an error:
how fast a machine is, is no property of the program.  Exit status: 0 done, 1 a
program failed, 2 wrong usage.
"""

import argparse
import dataclasses
import json
import sys
import time

import figures
import materials
import plot
import programs


def say(words):
    print(f"bench: {words}", flush=True)


def of_the_whole(bench, large):
    return [
        ("the engine against memcpy", figures.engine_and_copy(bench)),
        ("1M against 100M", figures.growth(bench)),
        ("the brain atlas", figures.brain(bench)),
        ("graded interiors", figures.grading(bench)),
        ("the program's start", figures.start_up(bench)),
        ("a large file", figures.memory_to_file(bench, 3e8 if large else 3e7)),
        ("the extracted reference", figures.reference(bench)),
    ]


def of_materials(bench):
    return [
        ("interfaces of a brain atlas", materials.interfaces(bench)),
        ("several solids", materials.solids(bench)),
    ]


def take(tasks):
    """All figures, one after the other."""
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


def machine_lines(machine):
    return [
        f"{machine['processor']}, {machine['cores']} cores, {machine['memory_gib']} GiB; "
        f"{machine['system']}; {machine['compiler']}, {machine['build']}.",
        f"Others used {machine['others_cores']:.2f} of the cores meanwhile"
        + (": the machine was not quiet, and times are too long." if
           machine["others_cores"] > 0.1 else "."),
        "Every time is the least of several; what is compared took turns.", ""]


def figure_lines(rows):
    return ["| figure | value | bound | of what |", "|---|---|---|---|", *map(row, rows), ""]


def peer_lines(result):
    return [
        "## Beside CGAL", "",
        "The same labels meshed by CGAL's Mesh_3 (its labelled image domain, optimised against "
        "slivers, as Debian's python3-pygalmesh runs it) and by certet with the size that gives "
        "about as many tetrahedra, and with a finer lattice.  One thread each; from the image's file to a MEDIT file, of "
        "certet the whole process, of CGAL without the start of Python.  Everything else is "
        "judged from the two files by one program that shares no code with either, and `certet "
        "check` must agree with it.  Volumes are of labels of 1,000 voxels and more.", "",
        *materials.peer_lines(result["peers"], result["no_peers"])]


def markdown(result, rows, with_plot):
    lines = [
        "# Figures of certet", "", *machine_lines(result["machine"]),
        "## The whole", "", *figure_lines(rows), *peer_lines(result),
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


def several_regions(bench):
    """The figures, and the part of the report that the peers make."""
    rows = take(of_materials(bench))
    say("the same labels by CGAL")
    contests, why = materials.peers(bench)
    return rows, {"peers": materials.as_json(contests), "no_peers": why}


def take_all(bench, large):
    rows = take(of_the_whole(bench, large))
    more, result = several_regions(bench)
    say("the engine by size")
    result["series"] = figures.series(bench)
    say("the parts")
    result["parts"] = bench.parts() if bench.has("certet_bench_parts") else {}
    return rows + more, result


def write(bench, name, result, text):
    (bench.folder / f"{name}.json").write_text(json.dumps(result, indent=2) + "\n")
    (bench.folder / f"{name}.md").write_text(text)
    return bench.folder / f"{name}.md"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", metavar="BUILD")
    parser.add_argument("--large", action="store_true")
    parser.add_argument("--only", choices=["materials"])
    options = parser.parse_args()
    bench = programs.Programs(options.build)
    if not bench.has("certet_bench_whole") and not options.only:
        raise programs.Failed(f"there are no benchmarks in '{bench.bin}'")
    start, neighbours = time.perf_counter(), programs.Neighbours()
    rows, result = several_regions(bench) if options.only else take_all(bench, options.large)
    machine = programs.machine(bench.build) | {"others_cores": round(neighbours.cores(), 2)}
    result = {"machine": machine, "figures": [as_json(f) for f in rows]} | result
    if options.only:
        text = "\n".join([*machine_lines(machine), *figure_lines(rows), *peer_lines(result)])
        file = write(bench, "materials", result, text)
    else:
        with_plot = draw(result["series"], bench.folder / "bench.svg")
        text = markdown(result, rows, with_plot)
        file = write(bench, "bench", result, text)
    print(text if options.only else "\n".join(map(row, rows)))
    say(f"{file}, in {time.perf_counter() - start:.0f} s")


if __name__ == "__main__":
    try:
        main()
    except (programs.Failed, OSError) as failure:
        sys.exit(f"bench: {failure}")
