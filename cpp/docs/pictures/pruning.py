"""Pruning: zero vertices that no + vertex neighbours are no points of the mesh."""

from svg import INK, INSIDE, LINE, PAPER, SOFT, SURFACE, explained

# Signs of even vertices in three rows of one layer, after warping.
ROWS = {"j + 1": "----------0-----",
        "j": "-00+++0--00--0--",
        "j − 1": "--0++0----+0----"}
GONE = "#c0392b"


def bits(row, sign):
    return [c == sign for c in row]


def draw(_):
    picture = explained(1080, 640, "Pruning, a word at a time",
                        "Pruning: which zero vertices are points of the mesh", (
        "A tetrahedron of the output has a + corner, so that a zero vertex is used only if one of its 14 neighbours is +. "
        "The others are",
        "turned to −; then every + or zero vertex is a point, and points can be counted by their bits. All 64 vertices of "
        "a word are asked",
        "at once: the planes of the neighbours, shifted to the vertex, or-ed together. (Here a word has 16 bits, and 4 "
        "of the 14 directions are shown.)"))
    left, cell = 400, 36
    top = 160
    own = ROWS["j"]
    plus, zero = bits(own, "+"), bits(own, "0")
    shifted = [("+ of the next index", plus[1:] + [False]), ("+ of the index before", [False] + plus[:-1]),
               ("+ of row j + 1", bits(ROWS["j + 1"], "+")), ("+ of row j − 1", bits(ROWS["j − 1"], "+"))]
    any_plus = [any(words[i] for _, words in shifted) for i in range(16)]
    kept = [z and a for z, a in zip(zero, any_plus)]
    picture.indices(left, top - 14, cell, 16)
    picture.text((left - 20, top - 14), "index i", 12, SOFT, "end")
    for n, (name, row) in enumerate(ROWS.items()):
        y = top + 12 + 30 * n
        picture.line((left + 8, y), (left + 16 * cell - 8, y), LINE, 1)
        picture.text((left - 20, y + 5), f"signs of row {name}", 14, INK, "end", "700" if name == "j" else "400")
        for i, sign in enumerate(row):
            at = (left + cell * (i + 0.5), y)
            picture.sign(at, sign, 7)
            if name == "j" and zero[i] and not kept[i]:
                picture.line((at[0] - 10, y - 10), (at[0] + 10, y + 10), GONE, 2.2)
                picture.line((at[0] - 10, y + 10), (at[0] + 10, y - 10), GONE, 2.2)
    words = [(name, mask, INSIDE, False) for name, mask in shifted]
    words += [("any of them", any_plus, INSIDE, True), ("zero of row j", zero, SURFACE, False),
              ("zero & any: they stay", kept, SURFACE, True)]
    y = top + 112
    for n, (name, mask, colour, strong) in enumerate(words):
        if strong:
            picture.line((left, y - 4), (left + 16 * cell, y - 4), SOFT, 1.4)
        picture.text((left - 20, y + 20), name, 14, INK, "end", "700" if strong else "400")
        for i in range(16):
            picture.rect(left + cell * i + 2, y + 2, cell - 4, 24, colour if mask[i] else PAPER, LINE, 3,
                         fill_opacity="1" if strong or not mask[i] else "0.55")
        y += 34 if not strong else 42
    count = sum(zero) - sum(kept)
    picture.text((30, y + 26), f"Crossed out: the {count} zero vertices of row j that no + vertex neighbours. With the "
                 "other ten directions fewer may go.", 13.5, SOFT)
    picture.height = int(y + 48)
    return picture
