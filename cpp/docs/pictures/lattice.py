"""The body-centred cubic lattice and the twelve cases of its tetrahedra."""

from itertools import product

from svg import INK, LINE, PAPER, SOFT, Picture, View, between, mean, tetrahedron

EVEN, ODD = "#1c2733", "#d1495b"
FILL = {True: "#7db7e8", False: "#f0b775"}  # right- and left-handed


def is_even(p):
    return p[0] % 2 == 0


def point(picture, view, p, radius=5):
    if is_even(p):
        picture.dot(view(p), radius, EVEN, PAPER, 1)
    else:
        picture.dot(view(p), radius, PAPER, ODD, 2)


def cube(picture, view, low, high, colour=LINE, width=1):
    for axis in range(3):
        for a, b in product((low, high), repeat=2):
            ends = []
            for c in (low, high):
                p = [a, b]
                p.insert(axis, c)
                ends.append(view(p))
            picture.line(*ends, colour, width)


def long_and_short(picture, view, corners, width=1):
    """The edges of a structured tetrahedron: two long ones, four short ones."""
    a, b, c, d = (view(p) for p in corners)
    for p, q in ((a, c), (a, d), (b, c), (b, d)):
        picture.line(p, q, SOFT, 1.3 * width)
    picture.line(a, b, EVEN, 3 * width)
    picture.line(c, d, ODD, 3 * width)


def whole(picture, kit):
    view = View((215, 222), 62, at=(2, 2, 2))
    low, high = 0, 4
    for axis in range(3):
        for a, b in product(range(low, high + 1, 2), repeat=2):
            ends = []
            for c in (low, high):
                p = [a, b]
                p.insert(axis, c)
                ends.append(view(p))
            picture.line(*ends, LINE, 1)
    row = next(r for r in kit["lattice"] if r["case"] == "J1" and r["anchor"] == [0, 0, 0])
    odd = [p for p in product((1, 3), repeat=3)]
    for p in odd:
        for axis in range(3):
            q = list(p)
            q[axis] += 2
            if q[axis] <= 3:
                picture.line(view(p), view(q), "#efb9c0", 1)
    centre = (1, 1, 1)
    for corner in product((0, 2), repeat=3):
        picture.line(view(centre), view(corner), "#9aa5b0", 1, stroke_dasharray="4 3")
    tetrahedron(picture, view, row["vertices"], FILL[row["right_handed"]], 0.6, "none")
    long_and_short(picture, view, row["vertices"], 0.9)
    for p in sorted([*product((0, 2, 4), repeat=3), *odd], key=lambda p: -view.depth(p)):
        point(picture, view, p, 4.5)


def legend(picture):
    x, y = 450, 62
    picture.heading((x, y), "The lattice")
    rows = [
        ("even points: all coordinates even", lambda c: picture.dot(c, 6, EVEN, PAPER, 1)),
        ("odd points, in the middle of the cubes: all coordinates odd", lambda c: picture.dot(c, 6, PAPER, ODD, 2)),
        ("long edges: between even points, or between odd points", lambda c: (
            picture.line((c[0] - 16, c[1] - 4), (c[0] + 16, c[1] - 4), EVEN, 3),
            picture.line((c[0] - 16, c[1] + 4), (c[0] + 16, c[1] + 4), ODD, 3))),
        ("short edges: from an odd point to the corners of its cube", lambda c:
            picture.line((c[0] - 16, c[1]), (c[0] + 16, c[1]), SOFT, 1.5)),
        ("right-handed: det(v2 − v1, v3 − v1, v4 − v1) = +4", lambda c:
            picture.rect(c[0] - 14, c[1] - 8, 28, 16, FILL[True], INK, 2)),
        ("left-handed: −4, and mirrored in the output", lambda c:
            picture.rect(c[0] - 14, c[1] - 8, 28, 16, FILL[False], INK, 2)),
    ]
    for n, (words, draw) in enumerate(rows):
        at = (x + 18, y + 32 + 30 * n)
        draw(at)
        picture.text((x + 50, at[1] + 5), words, 14, INK)
    for n, words in enumerate((
            "A structured tetrahedron has a long edge v1 v2 between even points and a long edge",
            "v3 v4 between odd points, across from each other; the other four edges are short.",
            "Four of them share an even long edge. A cell owns the three even edges that end at",
            "its far corner (2,2,2): along x (cases I), y (J) and z (K), twelve tetrahedra.",
            "Below, each case beside its own cube, whose near corner on the left is the anchor.")):
        picture.text((x, y + 236 + 21 * n), words, 14, SOFT)


def ring(picture, centre, rows, axis):
    """The four tetrahedra of an edge, seen along it."""
    flat = [a for a in range(3) if a != axis]
    x, y, s = *centre, 34
    at = lambda p: (x + s * (p[flat[0]] - 2), y - s * (p[flat[1]] - 2))
    for row in rows:
        c, d = row["vertices"][2], row["vertices"][3]
        picture.polygon([(x, y), at(c), at(d)], FILL[row["right_handed"]], 0.85, SOFT, 1)
        label = mean([(x, y), at(c), at(d)])
        picture.text((label[0], label[1] + 5), row["case"], 14, INK, "middle", "700")
    for row in rows:
        c, d = row["vertices"][2], row["vertices"][3]
        picture.line(at(c), at(d), ODD, 3)
        for p in (c, d):
            picture.dot(at(p), 5, PAPER, ODD, 2)
    picture.dot((x, y), 6, EVEN, PAPER, 1)
    names = "xyz"
    picture.text((x, y + 66), f"seen along {names[axis]}, the even edge", 12, SOFT, "middle")
    corner = (x - 58, y + 48)
    picture.arrow(corner, (corner[0] + 24, corner[1]), SOFT, 1.2)
    picture.arrow(corner, (corner[0], corner[1] - 24), SOFT, 1.2)
    picture.text((corner[0] + 28, corner[1] + 4), names[flat[0]], 12, SOFT)
    picture.text((corner[0] - 3, corner[1] - 28), names[flat[1]], 12, SOFT)


def case(picture, centre, row):
    view = View(centre, 36, at=(1.5, 1.5, 1.5))
    cube(picture, view, 0, 2)
    around = [p for p in product((1, 3), repeat=3) if p in [tuple(v) for v in row["vertices"]]]
    tetrahedron(picture, view, row["vertices"], FILL[row["right_handed"]], 0.62, "none")
    long_and_short(picture, view, row["vertices"])
    shown = {tuple(v) for v in row["vertices"]} | set(product((0, 2), repeat=3)) | set(around)
    for p in sorted(shown, key=lambda p: -view.depth(p)):
        point(picture, view, p, 5 if list(p) in row["vertices"] else 3)
    middle = view(mean(row["vertices"]))
    for n, v in enumerate(row["vertices"]):
        x, y = between(middle, view(v), 1.0)
        dx, dy = x - middle[0], y - middle[1]
        length = max((dx * dx + dy * dy) ** 0.5, 1)
        picture.text((x + 13 * dx / length, y + 13 * dy / length + 5), f"v{n + 1}", 13, INK, "middle", "700", halo=True)
    picture.text((centre[0] - 90, centre[1] - 70), row["case"], 17, INK, weight="700")


def draw(kit):
    picture = Picture(1080, 1010, "The lattice and its twelve cases of structured tetrahedra")
    whole(picture, kit)
    legend(picture)
    rows = [r for r in kit["lattice"] if r["anchor"] == [0, 0, 0]]
    for axis, letter in enumerate("IJK"):
        y = 515 + 195 * axis
        family = [r for r in rows if r["case"][0] == letter]
        picture.line((30, y - 92), (1050, y - 92), LINE, 1)
        ring(picture, (110, y), family, axis)
        for n, row in enumerate(family):
            case(picture, (310 + 212 * n, y + 12), row)
    return picture
