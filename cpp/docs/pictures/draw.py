#!/usr/bin/env python3
"""Draws the pictures of this folder.

usage: draw.py              write them
       draw.py --check      whether they are what would be written, and a source refers to each
       draw.py --self-test  whether a change of the tables or of a picture is found

Lattice and stencils are drawn from the certified functions' own answers, tests/conformance/kit.json.
"""

import copy
import json
import re
import sys
from pathlib import Path

import lattice
import pruning
import ranks
import stencils
import warping
import windows

HERE = Path(__file__).resolve().parent
KIT = HERE.parent.parent.parent / "tests/conformance/kit.json"
PICTURES = {"lattice.svg": lattice, "stencils.svg": stencils, "ranks.svg": ranks, "warping.svg": warping,
            "pruning.svg": pruning, "windows.svg": windows}


def stale(kit, committed):
    """The names of pictures that are not as drawn."""
    return [name for name, module in PICTURES.items() if str(module.draw(kit)) != committed[name]]


def unlinked():
    """Pictures that no comment of the sources refers to, and references to none."""
    cpp = HERE.parent.parent
    named = {name for path in cpp.rglob("*.?pp") for name in re.findall(r"docs/pictures/(\w+\.svg)", path.read_text())}
    return ([f"no source refers to {name}" for name in sorted(set(PICTURES) - named)]
            + [f"a source refers to {name}, which is not drawn" for name in sorted(named - set(PICTURES))])


def planted(kit):
    """Kits with one answer changed, and the picture that must differ."""
    turned = copy.deepcopy(kit)
    row = next(r for r in turned["lattice"] if r["anchor"] == [0, 0, 0] and r["case"] == "K3")
    row["vertices"][2], row["vertices"][3] = row["vertices"][3], row["vertices"][2]
    yield turned, "lattice.svg"
    diagonal = copy.deepcopy(kit)
    row = next(r for r in diagonal["stencils"] if r["signs"] == "0++-")
    row["right_handed"] = [["2", "3", "1", "24"], ["3", "34", "1", "24"]]
    yield diagonal, "stencils.svg"
    lost = copy.deepcopy(kit)
    row = next(r for r in lost["stencils"] if r["signs"] == "---+")
    row["right_handed"] = []
    yield lost, "stencils.svg"
    direction = copy.deepcopy(kit)
    direction["thresholds"]["angles"][0] += 1024
    yield direction, "warping.svg"


def main():
    kit = json.loads(KIT.read_text())
    arguments = sys.argv[1:]
    if not arguments:
        for name, module in PICTURES.items():
            (HERE / name).write_text(str(module.draw(kit)))
        return
    committed = {name: (HERE / name).read_text() if (HERE / name).exists() else "" for name in PICTURES}
    if arguments == ["--check"]:
        wrong = unlinked()
        wrong += [f"{name} is not as drawn: run {Path(__file__).name}" for name in stale(kit, committed)]
    elif arguments == ["--self-test"]:
        wrong = [f"a change of the tables does not show in {name}" for changed, name in planted(kit)
                 if stale(changed, committed) != [name]]
        for name in PICTURES:
            if stale(kit, committed | {name: committed[name].replace("stroke", "strike", 1)}) != [name]:
                wrong.append(f"a change of {name} is not found")
    else:
        sys.exit(__doc__)
    print("\n".join(wrong) if wrong else "the pictures are as drawn" if arguments == ["--check"]
          else "every planted change was found")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
