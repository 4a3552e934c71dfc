"""The mesher once more, written from README.md in this folder alone.

Lattice points and positions are triples of integers, signs are the characters
'+', '0' and '-', directions are numbered from 0, corners from 1.
"""

import itertools

STEPS = 65536
DIRECTIONS = [
    (2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2),
    (1, 1, 1), (-1, -1, -1), (1, 1, -1), (-1, -1, 1),
    (1, -1, 1), (-1, 1, -1), (-1, 1, 1), (1, -1, -1)]
LONG = range(0, 6)
THRESHOLDS = {"angles": (18688, 26112), "embedding": (16384, 26880), "midpoint": (0, 0)}

CASES = {name: [tuple(map(int, corner)) for corner in corners.split()] for name, corners in {
    "I1": "022 222 131 133", "I2": "022 222 131 111", "I3": "022 222 113 133",
    "I4": "022 222 113 111", "J1": "202 222 311 313", "J2": "202 222 311 111",
    "J3": "202 222 113 313", "J4": "202 222 113 111", "K1": "220 222 311 331",
    "K2": "220 222 311 111", "K3": "220 222 131 331", "K4": "220 222 131 111"}.items()}
RIGHT_HANDED = {"I1", "I4", "J2", "J3", "K1", "K4"}
ORDERS = ((1, 2, 3, 4), (2, 1, 4, 3))

STENCILS = """
    +--- 1 12 13 14
    +0-- 1 2 13 14
    +-0- 1 12 3 14
    +--0 1 12 13 4
    +00- 1 2 3 14
    +0-0 1 2 13 4
    +-00 1 12 3 4
    ++0- 2 1 14 3  2 14 24 3
    +0+- 1 3 34 2  1 34 14 2
    0++- 2 3 1 34  2 34 1 24
    ++-- 1 2 23 14  1 23 13 14  2 23 14 24
    +-+- 1 3 34 12  1 34 14 12  3 34 12 23
    +--+ 1 4 12 34  1 34 12 13  4 34 24 12
    +++- 2 1 34 3  2 1 14 34  2 14 24 34
"""
RENUMBERINGS = ("1234", "2143", "3412", "4321")


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(n, a):
    return tuple(n * x for x in a)


def determinant(p1, p2, p3, p4):
    """Of the edges from the first of four points: six times the volume."""
    u, v, w = minus(p2, p1), minus(p3, p1), minus(p4, p1)
    return sum(
        u[i] * (v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3])
        for i in range(3))


def opposite(a, b):
    return {a, b} == {"+", "-"}


# -- the lattice --------------------------------------------------------------

def corners(anchor, case):
    return [plus(anchor, offset) for offset in CASES[case]]


def right_handed(case):
    return case in RIGHT_HANDED


def neighbor(anchor, case, place):
    """The tetrahedron across from a corner (place 0 to 3): anchor, case, order.
    It is found by looking at all that are near."""
    own = corners(anchor, case)
    for by in itertools.product((-2, 0, 2), repeat=3):
        for other in CASES:
            near = plus(anchor, by)
            theirs = corners(near, other)
            if len(set(theirs) & set(own)) != 3:
                continue
            for order in ORDERS:
                lined_up = [theirs[n - 1] for n in order]
                if all(lined_up[n] == own[n] for n in range(4) if n != place):
                    return near, other, order
    raise LookupError("a tetrahedron without a neighbour")


# -- the stencils -------------------------------------------------------------

def renumbered(vertex, g, signs):
    """A vertex such as '3' or '14' with other numbers, its + end first."""
    numbers = [g[int(n) - 1] for n in vertex]
    numbers.sort(key=lambda n: signs[int(n) - 1] != "+")
    return "".join(numbers)


def stencil(signs):
    """The tetrahedra for the signs of four corners, right-handed."""
    if "+" not in signs:
        return []
    if "-" not in signs:
        return [["1", "2", "3", "4"]]
    for g in RENUMBERINGS:
        for row in STENCILS.strip().splitlines():
            pattern, *vertices = row.split()
            if all(signs[int(g[n]) - 1] == pattern[n] for n in range(4)):
                new = [renumbered(v, g, signs) for v in vertices]
                return [new[n:n + 4] for n in range(0, len(new), 4)]
    raise LookupError("a pattern without a stencil")


def oriented(tet, is_right_handed):
    a, b, c, d = tet
    return [a, b, c, d] if is_right_handed else [a, b, d, c]


# -- cuts and warping ---------------------------------------------------------

def bisect(sign_at):
    """The cut of an edge whose signs are given by a function of the step."""
    low, half = 0, STEPS // 2
    while half >= 1:
        sign = sign_at(low + half)
        if sign == "0":
            return low + half
        if sign == "+":
            low += half
        half //= 2
    return low


def warp(thresholds, sign, neighbors, cuts):
    """The direction and distance that a point moves, or (-1, 0)."""
    best = (-1, 0)
    nearest = None
    for d in range(14):
        limit = thresholds[0] if d in LONG else thresholds[1]
        if not opposite(sign, neighbors[d]):
            continue
        if not cuts[d] < limit:
            continue
        distance = (4 if d in LONG else 3) * cuts[d] ** 2
        if nearest is None or distance < nearest:
            best, nearest = (d, cuts[d]), distance
    return best


def sign_after(sign, warping):
    return sign if warping[0] < 0 else "0"


def displacement(warping):
    d, distance = warping
    return (0, 0, 0) if d < 0 else times(distance, DIRECTIONS[d])


# -- meshes -------------------------------------------------------------------

class Domain:
    """A domain as the lattice sees it: signs of points, and cuts of edges."""

    def __init__(self, origin, cells, even, odd, cut, midpoint):
        self.midpoint = midpoint
        self.cuts = {(tuple(c[0:3]), tuple(c[3:6])): c[6] for c in cut}
        self.signs = {}
        for grid, shift in ((even, 0), (odd, 1)):
            for index in itertools.product(*map(range, cells)):
                point = tuple(o + 2 * i + shift for o, i in zip(origin, index))
                self.signs[point] = self.counted(index, cells, grid)

    def counted(self, index, cells, grid):
        i, j, k = index
        if any(n in (0, last - 1) for n, last in zip(index, cells)):
            return "-"
        sign = grid[k][j][i]
        return "+" if self.midpoint and sign == "0" else sign

    def sign(self, point):
        return self.signs.get(point, "-")

    def cut(self, inner, outer):
        """From the + end."""
        return STEPS // 2 if self.midpoint else self.cuts[inner, outer]

    def cut_seen_from(self, point, other):
        if not opposite(self.sign(point), self.sign(other)):
            return 0
        if self.sign(point) == "+":
            return self.cut(point, other)
        return STEPS - self.cut(other, point)


class Warped:
    """A domain once its points have moved."""

    def __init__(self, domain, thresholds):
        self.domain = domain
        self.thresholds = thresholds
        self.known = {}

    def warping(self, point):
        if point not in self.known:
            around = [plus(point, d) for d in DIRECTIONS]
            self.known[point] = warp(
                self.thresholds, self.domain.sign(point),
                [self.domain.sign(u) for u in around],
                [self.domain.cut_seen_from(point, u) for u in around])
        return self.known[point]

    def sign(self, point):
        return sign_after(self.domain.sign(point), self.warping(point))

    def position(self, point):
        return plus(times(STEPS, point), displacement(self.warping(point)))

    def cut_position(self, inner, outer):
        t = self.domain.cut(inner, outer)
        return plus(times(STEPS, inner), times(t, minus(outer, inner)))


def structured_tets(origin, cells):
    """All (anchor, case), in the order of the output."""
    for k in range(cells[2] - 1):
        for j in range(cells[1] - 1):
            for i in range(cells[0] - 1):
                for case in CASES:
                    yield plus(origin, times(2, (i, j, k))), case


def is_turned_over(warped, anchor, case):
    points = corners(anchor, case)
    if any(warped.sign(p) != "0" for p in points):
        return False
    volume = determinant(*map(warped.position, points))
    return volume <= 0 if right_handed(case) else volume >= 0


def stuffed(warped, anchor, case):
    """The tetrahedra that fill one structured tetrahedron, as four positions."""
    points = corners(anchor, case)
    signs = "".join(map(warped.sign, points))
    for tet in stencil(signs):
        placed = []
        for vertex in tet:
            ends = [points[int(n) - 1] for n in vertex]
            placed.append(warped.position(*ends) if len(ends) == 1
                          else warped.cut_position(*ends))
        yield oriented(placed, right_handed(case))


def mesh(origin, cells, even, odd, cuts, cut, guarantee):
    """The answers of a mesh case, by their names in the kit."""
    midpoint = cuts == "midpoint"
    domain = Domain(origin, cells, even, odd, cut, midpoint)
    used = "midpoint" if midpoint else guarantee
    warped = Warped(domain, THRESHOLDS[used])
    turned_over = 0
    if used == "angles":
        turned_over = sum(is_turned_over(warped, *s) for s in structured_tets(origin, cells))
        if turned_over > 0:
            used = "embedding"
            warped = Warped(domain, THRESHOLDS[used])
    tets = [t for s in structured_tets(origin, cells) for t in stuffed(warped, *s)]
    points = sorted({p for t in tets for p in t})
    number = {p: n for n, p in enumerate(points)}
    return {"turned_over": turned_over, "thresholds": used, "points": points,
            "tets": [[number[p] for p in t] for t in tets]}
