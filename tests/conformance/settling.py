"""The warp that keeps the shape, and several materials: written from README.md in this
folder alone.  With `conforming`, whose names it has too, this is all of an implementation.
"""

import itertools

from conforming import *


# -- links ----------------------------------------------------------------------

NEXT = [[e for e in range(14) if minus(DIRECTIONS[e], DIRECTIONS[d]) in DIRECTIONS]
        for d in range(14)]


def in_one_piece(members):
    """A set of directions, not empty."""
    if not members:
        return False
    reached = [next(iter(members))]
    for d in reached:
        reached += [e for e in NEXT[d] if e in members and e not in reached]
    return len(reached) == len(members)


def disk_row(inner):
    """Where no 0 may be if just these neighbours are +: single ones, and pairs.
    None: wherever they are, the link is no strict disk."""
    if not in_one_piece(inner) or not in_one_piece(set(range(14)) - inner):
        return None
    pinched, walls = set(), []
    for d in range(14):
        run = inner.intersection(NEXT[d])
        if len(run) == len(NEXT[d]) or (run and not in_one_piece(run)):
            pinched.add(d)
        for e in NEXT[d]:
            if d < e and all(f in inner for f in NEXT[d] if f in NEXT[e]):
                walls.append((d, e))
    return pinched, sorted(walls)


ROWS = {}


def is_strict_disk(inner, zero):
    key = frozenset(inner)
    if key not in ROWS:
        ROWS[key] = disk_row(set(inner))
    if ROWS[key] is None:
        return False
    pinched, walls = ROWS[key]
    return not pinched.intersection(zero) and not any(d in zero and e in zero for d, e in walls)


# -- the warp that keeps the shape ------------------------------------------------

class Materials:
    """A domain of several materials as the lattice sees it."""

    def __init__(self, origin, cells, even, odd, cut):
        self.cuts = {(tuple(c[0:3]), tuple(c[3:6])): c[6] for c in cut}
        self.materials = {}
        for grid, shift in ((even, 0), (odd, 1)):
            for k, j, i in itertools.product(*map(range, reversed(cells))):
                point = tuple(o + 2 * n + shift for o, n in zip(origin, (i, j, k)))
                rim = any(n in (0, last - 1) for n, last in zip((i, j, k), cells))
                self.materials[point] = 0 if rim else grid[k][j][i]

    def material(self, point):
        return self.materials.get(point, 0)

    def cut(self, higher, lower):
        return self.cuts[higher, lower]

    def cut_seen_from(self, point, far):
        if self.material(point) == self.material(far):
            return 0
        if self.material(point) > self.material(far):
            return self.cut(point, far)
        return STEPS - self.cut(far, point)

    def violating(self, point):
        """How many cuts violate a point."""
        around = [plus(point, d) for d in DIRECTIONS]
        return sum(self.material(u) != self.material(point)
                   and self.cut_seen_from(point, u) < alpha(d) for d, u in enumerate(around))

    def target(self, point):
        around = [plus(point, d) for d in DIRECTIONS]
        own = self.material(point)
        return warp(THRESHOLDS["angles"], "+",
                    ["+" if self.material(u) == own else "-" for u in around],
                    [self.cut_seen_from(point, u) for u in around])


class Solid(Materials):
    """One material, given by signs."""

    def __init__(self, origin, cells, even, odd, cut):
        inside = lambda grid: [[[int(s == "+") for s in row] for row in layer] for layer in grid]
        super().__init__(origin, cells, inside(even), inside(odd), cut)

    def cut(self, higher, lower):
        return self.cuts.get((higher, lower), STEPS)  # the lower one was sampled as 0


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def is_well_shaped(tet):
    volume = determinant(*tet)
    if volume <= 0:
        return False
    for a, b in itertools.combinations(range(4), 2):
        c, d = (minus(tet[n], tet[a]) for n in range(4) if n not in (a, b))
        edge = minus(tet[b], tet[a])
        n = dot(cross(edge, c), cross(edge, d))
        num, den = (221, 8) if n > 0 else (1751, 130)
        if den * n ** 2 > num * volume ** 2 * dot(edge, edge):
            return False
    return True


def alpha(d):
    return THRESHOLDS["angles"][0 if d in LONG else 1]


class Settled:
    """A domain once its points have had their turns, or none has with `midpoint`."""

    def __init__(self, domain, midpoint=False):
        self.domain = domain
        self.midpoint = midpoint
        self.moved = {}
        if midpoint:
            return
        targets = {p: domain.target(p) for p in domain.materials}
        self.targets = {p: target for p, target in targets.items() if target[0] >= 0}
        for point in sorted(self.targets, key=self.turn):
            self.settle(point, *self.targets[point])

    def pair(self, point, d):
        """The two materials that a point lies between, its own first."""
        return self.domain.material(point), self.domain.material(plus(point, DIRECTIONS[d]))

    def is_higher(self, point, d):
        own, other = self.pair(point, d)
        return own > other

    def turn(self, point):
        d, t = self.targets[point]
        colour = 2 * (point[0] % 2) + sum(point) // 2 % 2
        return 8 * (4 * t // alpha(d)) + 4 * self.is_higher(point, d) + colour

    def settle(self, point, d, t):
        around = [plus(point, e) for e in DIRECTIONS]
        link = [None if u in self.moved else self.domain.material(u) for u in around]
        if not self.are_disks(self.pair(point, d), link) or self.fills_would_touch(link):
            return
        reached = self.shortened(point, around, d, t)
        if alpha(d) - t < t - reached and self.domain.violating(point) == 1:
            return
        self.moved[point] = (d, reached)
        if not all(self.may_share(*tid) for tid in tets_around(point)):
            del self.moved[point]

    def are_disks(self, pair, link):
        zero = {d for d in range(14) if link[d] is None}
        materials = set(pair) | set(link) - {None}
        higher = materials - {min(materials)}
        parts = [{m} for m in higher] + [higher]
        return all(is_strict_disk({d for d in range(14) if link[d] in part}, zero)
                   for part in parts)

    def fills_would_touch(self, link):
        for d, e in itertools.combinations(range(6, 14), 2):
            if e not in NEXT[d] or link[d] == link[e]:
                continue
            sides = {link[f] for f in NEXT[d] if f in NEXT[e]}
            if None not in sides | {link[d], link[e]} and len(sides) == 1 \
                    and not sides & {link[d], link[e]}:
                return True
        return False

    def shortened(self, point, around, d, t):
        if d not in LONG:
            return t
        reached = t
        for e in range(6, 14):
            w = around[e]
            other, back = self.moved.get(w, self.targets.get(w, (d, 0)))
            if dot(DIRECTIONS[d], DIRECTIONS[e]) <= 0:
                continue
            if DIRECTIONS[other] == times(-1, DIRECTIONS[d]):
                room = STEPS // 2 - (not self.is_higher(point, d) and not self.is_higher(w, other))
                if w in self.moved:
                    reached = min(reached, room - back)
                elif self.turn(w) > self.turn(point):
                    reached = min(reached, (room + t - back) // 2)
        return reached

    def may_share(self, anchor, case):
        points = corners(anchor, case)
        if not all(p in self.moved for p in points):
            return True
        lower = {min(self.pair(p, self.moved[p][0])) for p in points}
        around = {self.domain.material(plus(p, d)) for p in points for d in DIRECTIONS}
        if len(lower) > 1 or min(around) < min(lower):
            return False
        return lower == {0} or \
            is_well_shaped(oriented([self.position(p) for p in points], right_handed(case)))

    def material(self, point):
        return "0" if point in self.moved else self.domain.material(point)

    def position(self, point):
        return plus(times(STEPS, point), displacement(self.moved.get(point, (-1, 0))))

    def cut_position(self, a, b):
        higher, lower = (a, b) if self.domain.material(a) > self.domain.material(b) else (b, a)
        step = minus(lower, higher)
        least = alpha(DIRECTIONS.index(step))
        t = STEPS // 2 if self.midpoint else \
            max(least, min(STEPS - least, self.domain.cut(higher, lower)))
        return plus(times(STEPS, higher), times(t, step))

    def tets(self, anchor, case):
        """The tetrahedra of one structured tetrahedron: materials, and four positions."""
        points = corners(anchor, case)
        for material, tet in material_stencil([self.material(p) for p in points]):
            if material == "Z":
                material = min(self.pair(points[0], self.moved[points[0]][0]))
            if material == 0:
                continue
            ends = [[points[int(n) - 1] for n in vertex] for vertex in tet]
            placed = [self.position(*e) if len(e) == 1 else self.cut_position(*e) for e in ends]
            yield material, oriented(placed, right_handed(case))


def tets_around(point):
    """All structured tetrahedra with this corner."""
    for case, offsets in CASES.items():
        for offset in offsets:
            anchor = minus(point, offset)
            if all(c % 2 == 0 for c in anchor):
                yield anchor, case


# -- several materials ------------------------------------------------------------

FILLS = """
    ABCD A 12 34 13 14 B 12 34 24 23 C 12 34 23 13 D 12 34 14 24
    AABC A 13 14 23 34 A 14 24 23 34
    ABCC C 13 14 12 23 C 14 24 12 23
    ABAC B 12 34 24 23 C 12 34 14 24
    ABCB A 12 34 13 14 C 12 34 23 13
    ABCA B 12 34 24 23 C 12 34 23 13
    ABBC A 12 34 13 14 C 12 34 14 24
    0ABC A 1 34 24 23
    A0BC A 2 34 13 14
    AB0C C 3 12 24 14
    ABC0 C 4 12 13 23
"""


def by_letters(materials):
    """The pattern, and what each letter stands for; a corner that moved is '0'."""
    order = [m for m in dict.fromkeys(materials) if m != "0"]
    return "".join("0" if m == "0" else "ABCD"[order.index(m)] for m in materials), order


def material_stencil(materials):
    """Tetrahedra with their materials, right-handed, for those of four corners."""
    pattern, order = by_letters(materials)
    if not order:
        return [("Z", ["1", "2", "3", "4"])]
    tets = []
    for m in order:
        signs = "".join("0" if n == "0" else "+" if n == m else "-" for n in materials)
        tets += [(m, ["".join(sorted(v)) for v in tet]) for tet in stencil(signs)]
    for row in FILLS.strip().splitlines():
        name, *words = row.split()
        if name == pattern:
            tets += [(order["ABCD".index(words[n])], words[n + 1:n + 5])
                     for n in range(0, len(words), 5)]
    return tets


def settled_mesh(origin, cells, even, odd, cut):
    """The answers of a case of `settled`."""
    answers = answers_of(Settled(Solid(origin, cells, even, odd, cut)), origin, cells)
    answers["tets"] = [tet[1:] for tet in answers["tets"]]
    return answers


def material_mesh(origin, cells, cuts, even, odd, cut):
    """The answers of a case of `materials`."""
    domain = Materials(origin, cells, even, odd, cut)
    return answers_of(Settled(domain, cuts == "midpoint"), origin, cells)


def answers_of(settled, origin, cells):
    tets = [t for s in structured_tets(origin, cells) for t in settled.tets(*s)]
    points = sorted({p for _, tet in tets for p in tet})
    number = {p: n for n, p in enumerate(points)}
    moved = [[*p, *settled.moved[p]] for p in settled.domain.materials if p in settled.moved]
    return {"moved": moved, "points": points,
            "tets": [[m, *(number[p] for p in tet)] for m, tet in tets]}
