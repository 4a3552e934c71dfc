"""Warping: what a cut does to a vertex, and how a layer is decided in one pass over its cuts."""

from math import cos, pi, sin

from svg import INK, LINE, PAPER, SOFT, SURFACE, Picture, between

CUT, REACH, SLOT = "#c0392b", "#f6c667", "#b03a8c"


def star(picture, centre, radius, long_threshold, short_threshold):
    """A vertex with cuts on its edges, some of them within the thresholds."""
    # Of each direction: angle, long or short, the place of the cut or none.
    edges = [(0.02, True, 0.20), (1, False, 0.31), (2, True, None), (3.05, False, 0.62), (4, True, None),
             (5, False, None), (6, True, 0.80), (7.1, False, 0.36)]
    ends = []
    for turn, is_long, cut in edges:
        reach = radius * (1 if is_long else 0.866)
        end = (centre[0] + reach * cos(turn * pi / 4), centre[1] - reach * sin(turn * pi / 4))
        ends.append((end, is_long, cut))
        threshold = long_threshold if is_long else short_threshold
        picture.line(centre, end, "#9aa5b0", 2.4 if is_long else 1.2)
        picture.line(centre, between(centre, end, threshold), REACH, 9, stroke_opacity="0.75")
    for end, _, cut in ends:
        if cut is not None:
            picture.dot(between(centre, end, cut), 5, CUT, PAPER, 1)
        picture.sign(end, "-" if cut is not None else "+", 6.5)
    return ends


def one_vertex(picture, thresholds, steps):
    long_threshold, short_threshold = (t / steps for t in thresholds)
    picture.heading((30, 40), "Warping: what the cuts do to one vertex")
    centre, radius = (175, 205), 120
    star(picture, centre, radius, long_threshold, short_threshold)
    picture.sign(centre, "+", 8)
    picture.arrow((330, 205), (392, 205), SOFT, 2.2)
    picture.text((361, 192), "warp", 13, SOFT, "middle")
    centre = (545, 205)
    end = (centre[0] + radius * cos(0.02 * pi / 4), centre[1] - radius * sin(0.02 * pi / 4))
    landed = between(centre, end, 0.20)
    for turn, is_long, cut in [(0.02, True, 1), (1, False, 1), (2, True, 0), (3.05, False, 1), (4, True, 0),
                               (5, False, 0), (6, True, 1), (7.1, False, 1)]:
        reach = radius * (1 if is_long else 0.866)
        tip = (centre[0] + reach * cos(turn * pi / 4), centre[1] - reach * sin(turn * pi / 4))
        picture.line(landed, tip, "#9aa5b0", 2.4 if is_long else 1.2)
        picture.sign(tip, "-" if cut else "+", 6.5)
    picture.dot(centre, 5, PAPER, LINE, 1.5)
    picture.arrow((centre[0] - 2, centre[1] - 16), (landed[0] + 4, centre[1] - 16), INK, 1.8)
    picture.sign(landed, "0", 8)
    x = 700
    for n, (words, bold) in enumerate((
            ("A cut violates a vertex if it is nearer than alpha:", True),
            (f"{thresholds[0] * 256 // steps}/256 of a long edge (thick),", False),
            (f"{thresholds[1] * 256 // steps}/256 of a short one (thin).", False),
            ("Of the violating cuts the nearest wins, and among", True),
            ("equals the first direction. The vertex moves there;", True),
            ("it is on the surface then, so that no edge to it", True),
            ("is cut any more: the other cuts are gone.", True))):
        picture.text((x, 128 + 24 * n), words, 14, INK if bold else SOFT)
    picture.rect(90, 352, 22, 10, REACH, "none", 4)
    picture.text((120, 362), "within alpha", 13, SOFT)
    picture.dot((241, 357), 5, CUT)
    picture.text((252, 362), "cut", 13, SOFT)


def slots(picture, x, y, violated, words, wins):
    """The vertices of one row: a bit for each, and the violating cuts of those that are violated."""
    picture.text((x - 16, y + 22), words, 13.5, INK, "end")
    for i in range(8):
        at = x + 84 * i
        picture.rect(at, y, 78, 34, "#fbe9f5" if i in violated else PAPER, SLOT if i in violated else LINE, 4)
        if i in violated:
            picture.text((at + 39, y + 22), violated[i], 12.5, INK, "middle", mono=True)
            if i in wins:
                picture.text((at + 39, y + 52), wins[i], 12.5, SURFACE, "middle", "700", mono=True)


def one_layer(picture):
    top = 432
    picture.line((30, top - 34), (1050, top - 34), LINE, 1)
    picture.heading((30, top), "A layer in one pass: cuts look for their vertex, no vertex looks for its cuts")
    picture.lines((30, top + 26), (
        "Layer k is decided from the cuts that its own rows own and those of the rows of layer k − 1, in the order in "
        "which they stand in",
        "memory: row by row, family by family, bit by bit. A cut is left with the end that it violates, if any: never "
        "both, for alpha is at most",
        "a half. Ends are in row j or j + 1, so that two rows of slots are enough, taken in turns: after row j is "
        "collected, its slots are",
        "complete, are decided in the order of the index, and are free for row j + 2."))
    left, y = 330, top + 138
    picture.text((left - 16, y + 5), "cuts that row j owns, in their order", 13.5, INK, "end")
    cuts = [(0.4, 1, "a", (1, 0)), (1.5, 1, "b", (1, 0)), (2.7, 3, "c", (3, 1)), (3.6, None, "", None),
            (4.6, 5, "d", (5, 0)), (5.5, 6, "e", (6, 1)), (6.4, 6, "f", (6, 1)), (7.3, None, "", None)]
    first, second = y + 58, y + 150
    for place, _, name, target in cuts:
        at = (left + 84 * place + 30, y)
        if target:
            slot = (left + 84 * target[0] + 39 + (8 if name in "bf" else -8 if name in "ae" else 0),
                    (first, second)[target[1]] - 2)
            picture.line(at, slot, "#d9a7a1", 1.4)
    for place, _, name, target in cuts:
        at = (left + 84 * place + 30, y)
        picture.dot(at, 8, CUT if target else "#d5dade")
        if name:
            picture.text((at[0], at[1] + 4), name, 11, PAPER, "middle", "700")
    slots(picture, left, first, {1: "a, b", 3: "", 5: "d"}, "slots of row j: complete", {1: "→ b", 5: "→ d"})
    # Vertex 3 of row j is violated by a cut of the row before.
    picture.text((left + 84 * 3 + 39, first + 22), "earlier", 12, SOFT, "middle", mono=True)
    slots(picture, left, second, {3: "c", 6: "e, f"}, "slots of row j + 1: wait for its own cuts", {})
    picture.text((left, second + 64), "grey: a cut that violates neither end; it stays a cut; → the cut that wins: "
                 "the vertex moves there.", 13, SOFT)


def draw(kit):
    picture = Picture(1080, 800, "Warping, lane by lane")
    one_vertex(picture, kit["thresholds"]["angles"], kit["steps"])
    one_layer(picture)
    picture.height = 802
    return picture
