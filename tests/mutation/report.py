"""The results as JSON, and as a page with a table by file and operator."""

import json
from pathlib import Path

TABLES_AND_LATTICE = ("structured_tet.hpp", "stencil.hpp", "direction.hpp", "coord3.hpp",
                      "lattice_edges.hpp", "cell_tables.hpp")


def _share(results):
    caught = sum(r["outcome"] != "survived" for r in results)
    return f"{caught} of {len(results)}" if results else ""


def in_tables(result):
    return result["operator"] == "table" or Path(result["file"]).name in TABLES_AND_LATTICE


def _table(results):
    operators = sorted({r["operator"] for r in results})
    rows = ["| file | " + " | ".join(operators) + " | all |", "|---" * (len(operators) + 2) + "|"]
    for file in sorted({r["file"] for r in results}):
        of_file = [r for r in results if r["file"] == file]
        cells = [_share([r for r in of_file if r["operator"] == o]) for o in operators]
        rows.append(f"| {file} | " + " | ".join(cells) + f" | {_share(of_file)} |")
    cells = [_share([r for r in results if r["operator"] == o]) for o in operators]
    rows.append("| all | " + " | ".join(cells) + f" | {_share(results)} |")
    return rows


def page(seed, results, planned):
    count = {outcome: sum(r["outcome"] == outcome for r in results)
             for outcome in ("test", "timeout", "compiler", "survived")}
    refused = count["compiler"]
    compiled = [r for r in results if r["outcome"] != "compiler"]
    lines = ["# Mutants of the core", "",
             f"Seed {seed}. Of {planned} planned, {len(results)} were examined; the compiler refused {refused}. "
             f"Of the others, {_share(compiled)} were caught: {count['test']} by a test that failed, "
             f"{count['timeout']} by the time limit. In tables and lattice: "
             f"{_share([r for r in compiled if in_tables(r)])}.", "",
             "The table counts those that compile.", ""]
    lines += _table(compiled) + ["", "## Survivors", ""]
    for r in results:
        if r["outcome"] == "survived":
            lines += [f"Number {r['number']}, {r['operator']}, {r['file']}:{r['line']}", "", "```diff",
                      "-" + r["before"], "+" + r["after"], "```", ""]
    return "\n".join(lines) + "\n"


def write_report(folder, seed, results, planned):
    summary = {"seed": seed, "planned": planned, "mutants": results}
    (folder / "mutation.json").write_text(json.dumps(summary, indent=1) + "\n")
    (folder / "mutation.md").write_text(page(seed, results, planned))
