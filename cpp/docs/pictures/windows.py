"""Windows of layers and their halos: what each stage needs, for the mesh of some layers."""

import re
from pathlib import Path

from svg import INK, INSIDE, SOFT, Picture

HEADER = Path(__file__).resolve().parent.parent.parent / "engine/window.hpp"
# Each stage: what it makes, and the function that says of which layers, or how many more before
# and behind the window.
STAGES = [
    ("signs", "sampled_window"),
    ("cuts", "cut_window"),
    ("violated vertices", "violation_window"),
    ("signs after warping", "warped_window"),
    ("numbers of points", (0, 1)),
    ("points, tetrahedra", (0, 0)),
]
OWN = ["0", "1", "…", "n−1"]
NEEDS = [
    "A cut of layer k lies between signs of the layers k and k + 1.",
    "A vertex of layer k is violated by cuts of the layers k − 1 and k.",
    "A zero vertex of layer k stays if a neighbour, in the layers k − 1 to k + 1, is + after warping.",
    "Points of layer k are corners and cuts: signs of the layers k and k + 1.",
    "Tetrahedra of layer k use points of the layers k and k + 1.",
]


def halo(header, name):
    """How many layers a window of window.hpp has before and behind the one of the mesh."""
    if not isinstance(name, str):
        return name
    found = re.search(rf"Window {name}\([^{{]*{{\s*return widened\(window, (\d+)(?: \+ halo)?, (\d+)(?: \+ halo)?, lattice\);", header)
    return int(found[1]), int(found[2])


def draw(_):
    header = HEADER.read_text()
    halos = [halo(header, name) for _, name in STAGES]
    most_before, most_behind = (max(h[side] for h in halos) for side in (0, 1))
    layers = ([f"−{n}" for n in range(most_before, 0, -1)] + OWN
              + ["n"] + [f"n+{n}" for n in range(1, most_behind)])
    begin, end = most_before, most_before + len(OWN)
    picture = Picture(1080, 560, "Windows of layers and their halos")
    picture.heading((30, 40), "A window of layers, and how much more of the lattice each stage needs")
    left, top, high = 330, 98, 46
    wide = 720 / len(layers)
    place = lambda layer: left + wide * (layer + 0.5)
    picture.text((left - 20, top - 14), "layer of the window", 13, SOFT, "end")
    picture.rect(left + begin * wide, top - 4, (end - begin) * wide, high * len(STAGES) + 12, "#eef5fb", "none", 8)
    for i, name in enumerate(layers):
        own = begin <= i < end
        picture.text((place(i), top - 14), name, 14, INK if own else SOFT, "middle", "700" if own else "400")
    for n, ((words, name), (before, behind)) in enumerate(zip(STAGES, halos)):
        y = top + 6 + high * n
        picture.text((left - 20, y + 15), words, 14.5, INK, "end", "700")
        picture.text((left - 20, y + 32), name if isinstance(name, str) else
                     "the window and one more" if behind else "the window", 11.5, SOFT, "end",
                     mono=isinstance(name, str))
        for i in range(begin - before, end + behind):
            picture.rect(left + wide * i + 3, y, wide - 6, high - 12,
                         INSIDE if begin <= i < end else "#a9cbe8", "none", 4)
        if n + 1 < len(STAGES):
            for edge, inner in ((begin - before, begin - halos[n + 1][0]),
                                (end + behind - 1, end + halos[n + 1][1] - 1)):
                if edge != inner:
                    a, b = place(edge), place(inner)
                    picture.arrow((a + (b - a) * 0.12, y + high - 13), (b, y + high - 1), SOFT, 1.3)
    y = top + high * len(STAGES) + 40
    for n, words in enumerate(NEEDS):
        picture.text((30, y + 22 * n), words, 14, SOFT)
    picture.text((30, y + 22 * len(NEEDS) + 10), "Where the lattice ends the halo ends too: its rim, and not the "
                 "window's, closes the mesh.", 14, INK, weight="700")
    halo_of_settling = re.search(r"settling_halo = (\d+);", header)[1]
    picture.text((30, y + 22 * len(NEEDS) + 34), f"Where violated vertices settle one after the other, the first three stages "
                 f"need {halo_of_settling} layers more on each side.", 14, SOFT)
    picture.height = int(y + 22 * len(NEEDS) + 58)
    return picture
