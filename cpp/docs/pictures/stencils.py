"""The 81 stencils, by the symmetries of a structured tetrahedron."""

from svg import INK, LINE, PAPER, SOFT, TET_COLOURS, Picture, View, between, mean, tetrahedron

# The rotations of a structured tetrahedron: where each corner goes.
ROTATIONS = [(0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0)]
# In the order in which the table is written: + before 0 before -.
RANK = {"+": 0, "0": 1, "-": 2}
# Right-handed; 1 2 and 3 4 are the long edges.
CORNERS = [(-1.0, 0.0, -0.5), (1.0, 0.0, -0.5), (0.0, 1.0, 0.5), (0.0, -1.0, 0.5)]


def moved(signs, g):
    image = [""] * 4
    for n in range(4):
        image[g[n]] = signs[n]
    return "".join(image)


def classes(stencils):
    """Lists of patterns, each of which the rotations make of its first one."""
    seen, found = set(), []
    for signs in sorted(stencils, key=lambda s: [RANK[c] for c in s]):
        if signs not in seen:
            images = list(dict.fromkeys(moved(signs, g) for g in ROTATIONS))
            seen |= set(images)
            found.append(images)
    return found


def place(vertex):
    """A corner, or the middle of an edge."""
    return mean([CORNERS[int(digit) - 1] for digit in vertex])


def stencil(picture, centre, scale, signs, tets, labels):
    view = View(centre, scale, turn=-20, tilt=60)
    edges = [(a, b) for a in range(4) for b in range(a)]
    for a, b in edges:
        is_long = {a, b} in ({0, 1}, {2, 3})
        picture.line(view(CORNERS[a]), view(CORNERS[b]), "#aab3bc", 2.2 if is_long else 1.0)
    shrunk = []
    for n, tet in enumerate(tets):
        points = [place(v) for v in tet]
        inner = mean(points)
        shrink = 0.9 if len(tets) > 1 else 1
        shrunk.append(([between(inner, p, shrink) for p in points], TET_COLOURS[n]))
    for corners, colour in sorted(shrunk, key=lambda t: -view.depth(mean(t[0]))):
        tetrahedron(picture, view, corners, colour, 0.42, "#2b3a48", 0.55 + scale / 140)
    for cut in sorted({v for tet in tets for v in tet if len(v) == 2}):
        picture.dot(view(place(cut)), 1 + scale / 32, "#c0392b", PAPER, 0.8)
    for n in range(4):
        at = view(CORNERS[n])
        picture.sign(at, signs[n], 2.2 + scale / 17)
        if labels:
            dx, dy = at[0] - centre[0], at[1] - centre[1]
            away = 1 + 15 / (dx * dx + dy * dy) ** 0.5
            picture.text((centre[0] + away * dx, centre[1] + away * dy + 4), str(n + 1), 12, SOFT, "middle", "700")


def card(picture, x, y, patterns, table):
    """A class that is cut: its first pattern, and the others small."""
    first = patterns[0]
    picture.rect(x, y, 338, 168, "#f7f9fb", LINE, 8)
    stencil(picture, (x + 96, y + 97), 62, first, table[first], True)
    picture.text((x + 12, y + 158), first, 16, INK, weight="700", mono=True)
    words = [" ".join(tet) for tet in table[first]]
    for n, tet in enumerate(words):
        at = (x + 206, y + 26 + 17 * n)
        picture.rect(at[0] - 14, at[1] - 9, 9, 9, TET_COLOURS[n], "#2b3a48", 1)
        picture.text(at, tet, 13, INK, mono=True)
    for n, signs in enumerate(patterns[1:]):
        at = (x + 212 + 47 * n, y + 112)
        stencil(picture, at, 19, signs, table[signs], False)
        picture.text((at[0], y + 152), signs, 12, SOFT, "middle", mono=True)


def simple(picture, x, y, patterns, table):
    """A class that is kept whole, or of which nothing is: all small.  Returns the width."""
    for n, signs in enumerate(patterns):
        at = (x + 26 + 50 * n, y + 26)
        stencil(picture, at, 19, signs, table[signs], False)
        picture.text((at[0], y + 66), signs, 12, INK if n == 0 else SOFT, "middle", mono=True)
    width = 50 * len(patterns) + 4
    picture.rect(x, y - 6, width, 82, "none", LINE, 6)
    return width


def draw(kit):
    table = {row["signs"]: row["right_handed"] for row in kit["stencils"]}
    found = classes(table)
    cut = [c for c in found if "+" in c[0] and "-" in c[0]]
    kept = [c for c in found if "+" in c[0] and "-" not in c[0]]
    nothing = [c for c in found if "+" not in c[0]]
    picture = Picture(1080, 1500, "The 81 stencils by symmetry")
    picture.heading((24, 38), "The 81 stencils of a structured tetrahedron, by its rotations "
                    "1234, 2143, 3412 and 4321")
    x = 24
    for sign, words in (("+", "inside"), ("0", "on the surface"), ("-", "outside")):
        picture.sign((x + 8, 62), sign, 6.5)
        picture.text((x + 20, 67), words, 13, SOFT)
        x += 34 + 8 * len(words)
    picture.dot((x + 14, 62), 4, "#c0392b")
    picture.text((x + 24, 67), "cut of an edge from + to −; 14 is the cut from corner 1 to corner 4. "
                 "Thick edges are long.", 13, SOFT)
    picture.text((24, 102), f"With + and −: {sum(map(len, cut))} patterns in {len(cut)} classes. "
                 "The others of a class (small) are the first one turned.", 14, INK, weight="700")
    for n, patterns in enumerate(cut):
        card(picture, 24 + 348 * (n % 3), 116 + 178 * (n // 3), patterns, table)
    y = 116 + 178 * ((len(cut) + 2) // 3) + 26
    for words, group in ((f"With + and no −: {sum(map(len, kept))} patterns in {len(kept)} classes, "
                          "each the tetrahedron itself.", kept),
                         (f"With no +: {sum(map(len, nothing))} patterns in {len(nothing)} classes, "
                          "nothing is made.", nothing)):
        picture.text((24, y), words, 14, INK, weight="700")
        x, y = 24, y + 20
        for patterns in group:
            if x + 50 * len(patterns) > 1050:
                x, y = 24, y + 96
            x += simple(picture, x, y, patterns, table) + 10
        y += 116
    picture.height = int(y - 20)
    return picture
