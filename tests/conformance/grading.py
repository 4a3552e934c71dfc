"""Larger tetrahedra inside: written from README.md in this folder alone.  With `settling`, whose
names it has too, this is all of an implementation.
"""

import itertools

from settling import *


class Octree:
    """Which cells exist, of so many levels, once the points have moved."""

    def __init__(self, settled, levels):
        self.settled = settled
        self.levels = levels
        self.known = {}

    def is_inside(self, point):
        return self.settled.material(point) == 1

    def exists(self, level, cell):
        if level == self.levels:
            return True
        if (level, cell) not in self.known:
            self.known[level, cell] = self.is_near(cell) if level == 0 else any(
                self.exists(level - 1, plus(times(2, cell), d)) for d in AROUND_CHILDREN)
        return self.known[level, cell]

    def is_near(self, cell):
        middle = centre(0, cell)
        around = [(0, 0, 0), *DIRECTIONS[:6], *itertools.product((-1, 1), repeat=3)]
        return not all(self.is_inside(plus(middle, d)) for d in around)

    def is_used(self, level, point):
        """Whether a point is a corner of a cell of the level below."""
        if level == 0:
            return False
        side = 2 << (level - 1)
        corner = tuple(x // side for x in point)
        return any(self.exists(level - 1, minus(corner, d))
                   for d in itertools.product((0, 1), repeat=3))

    def tet(self, level, cell, axes, signs):
        """The tetrahedron that a flag belongs to, in any order; None where it is not present."""
        if not self.exists(level, cell):
            return None
        child = [0, 0, 0]
        for axis, sign in zip(axes, signs):
            child[axis] = int(sign > 0)
        if level > 0 and self.exists(level - 1, plus(times(2, cell), child)):
            return None
        half = 1 << level
        s, t, u = (times(sign, unit(axis)) for axis, sign in zip(axes, signs))
        c = centre(level, cell)
        m = plus(c, times(half, s))
        q = plus(m, times(half, t))
        k, far = plus(q, times(half, u)), minus(q, times(half, u))
        if not self.exists(level, plus(cell, s)):
            p = nearest_to_parent(cell, m, half, axes[1:])
            opposite_p = minus(times(2, m), p)
            r = far if k in (p, opposite_p) else k
            return frozenset((r, p, opposite_p, c))
        used_m, used_q = self.is_used(level, m), self.is_used(level, q)
        across = m if used_m else plus(c, times(2 * half, s))
        return frozenset((k, q if used_q else far, across, c))


AROUND_CHILDREN = [d for d in itertools.product((-1, 0, 1, 2), repeat=3)
                   if not set(d) <= {-1, 2}]


def unit(axis):
    return tuple(int(n == axis) for n in range(3))


def centre(level, cell):
    return times(1 << level, tuple(2 * c + 1 for c in cell))


def nearest_to_parent(cell, middle, half, axes):
    for axis in axes:
        middle = plus(middle, times(half if cell[axis] % 2 == 0 else -half, unit(axis)))
    return middle


def cells_of(level, origin, cells):
    """Those that touch the lattice."""
    return itertools.product(*(
        range(o // 2 >> level, (o // 2 + n - 1 >> level) + 1) for o, n in zip(origin, cells)))


def graded_mesh(origin, cells, levels, even, odd, cut):
    """The answers of a case of `graded`."""
    settled = Settled(Solid(origin, cells, even, odd, cut))
    octree = Octree(settled, levels)
    found = {octree.tet(level, cell, axes, signs)
             for level in range(levels + 1) for cell in cells_of(level, origin, cells)
             for axes in itertools.permutations(range(3))
             for signs in itertools.product((-1, 1), repeat=3)} - {None}
    structured = {frozenset(corners(*s)): s for s in structured_tets(origin, cells)}
    tets = []
    for tet in found:
        if all(octree.is_inside(p) for p in tet):
            tets.append(right_way_round([times(STEPS, p) for p in tet]))
        elif tet in structured:  # what lies outside the lattice is empty
            tets += [placed for _, placed in settled.tets(*structured[tet])]
    points = sorted({p for tet in tets for p in tet})
    number = {p: n for n, p in enumerate(points)}
    return {"points": points, "tets": sorted(turned([number[p] for p in tet]) for tet in tets)}


def right_way_round(tet):
    a, b, c, d = tet
    return [a, b, c, d] if determinant(*tet) > 0 else [a, b, d, c]


def turned(tet):
    """Least number first, the least of the others second, and as it was the way round."""
    a, b, c, d = tet
    first, p, q, r = next(order for order in ((a, b, c, d), (b, a, d, c), (c, d, a, b), (d, c, b, a))
                          if order[0] == min(tet))
    return next([first, *rest] for rest in ((p, q, r), (q, r, p), (r, p, q)) if rest[0] == min(rest))
