"""Plants bugs in conforming.py, settling.py and grading.py, one at a time; the kit must catch each.

usage: mutations.py KIT.json [BUG...]      exit status 1 if one is not caught
"""

import json
import pathlib
import sys
import types

import check

SOURCES = {name: pathlib.Path(__file__).with_name(f"{name}.py").read_text(encoding="utf-8")
           for name in ("conforming", "settling", "grading")}

# A name, what stands in the source once, and what is put there.
MUTATIONS = [
    ("a vertex of a lattice case", "\"I3\": \"022 222 113 133\"", "\"I3\": \"022 222 133 113\""),
    ("a corner off by two", "\"K4\": \"220 222 131 111\"", "\"K4\": \"220 222 131 113\""),
    ("a case of the wrong hand", "{\"I1\", \"I4\", \"J2\",", "{\"I1\", \"I4\", \"J1\","),
    ("a neighbour's order forgotten", "ORDERS = ((1, 2, 3, 4), (2, 1, 4, 3))",
     "ORDERS = ((1, 2, 3, 4), (1, 2, 4, 3))"),
    ("swapped directions", "(1, 1, 1), (-1, -1, -1),", "(-1, -1, -1), (1, 1, 1),"),
    ("one direction twice", "(-1, 1, 1), (1, -1, -1)]", "(-1, 1, 1), (1, 1, -1)]"),
    ("a short threshold one step off", "(18688, 26112)", "(18688, 26113)"),
    ("a long threshold one step off", "(16384, 26880)", "(16383, 26880)"),
    ("a diagonal the other way", "2 1 14 3  2 14 24 3", "2 1 24 3  1 14 24 3"),
    ("two vertices of a stencil exchanged", "+--0 1 12 13 4", "+--0 1 13 12 4"),
    ("tetrahedra of a stencil out of order", "1 2 23 14  1 23 13 14  2 23 14 24",
     "1 23 13 14  1 2 23 14  2 23 14 24"),
    ("a cut taken for a corner", "2 1 34 3  2 1 14 34", "2 1 34 3  2 1 4 34"),
    ("renumberings tried in another order", "(\"1234\", \"2143\", \"3412\", \"4321\")",
     "(\"1234\", \"2143\", \"4321\", \"3412\")"),
    ("a renumbering missing", "(\"1234\", \"2143\", \"3412\", \"4321\")",
     "(\"1234\", \"2143\", \"3412\")"),
    ("cuts not named from the + end", "!= \"+\")", "!= \"-\")"),
    ("all on the surface taken for inside", "if \"+\" not in signs:", "if \"-\" in signs:"),
    ("left-handed tetrahedra not mirrored", "is_right_handed else [a, b, d, c]", "is_right_handed else [a, b, c, d]"),
    ("left-handed tetrahedra mirrored elsewhere", "is_right_handed else [a, b, d, c]", "is_right_handed else [b, a, c, d]"),
    ("a lost round of bisection", "while half >= 1", "while half > 1"),
    ("bisection runs past the surface", "if sign == \"0\":", "if sign == \"?\":"),
    ("bisection ends at the outer end", "half //= 2\n    return low", "half //= 2\n    return low + 1"),
    ("a surface found is outside", "return low + half", "return low + half - 1"),
    ("a threshold that is not strict", "if not cuts[d] < limit", "if not cuts[d] <= limit"),
    ("thresholds of the other kind of edge", "thresholds[0] if d in LONG else thresholds[1]",
     "thresholds[1] if d in LONG else thresholds[0]"),
    ("ties for the last direction", "distance < nearest", "distance <= nearest"),
    ("the farthest cut", "distance < nearest", "distance > nearest"),
    ("lengths not weighed", "(4 if d in LONG else 3)", "1"),
    ("lengths weighed the other way", "(4 if d in LONG else 3)", "(3 if d in LONG else 4)"),
    ("lengths weighed without their root", "else 3) * cuts[d] ** 2", "else 3) * cuts[d]"),
    ("a neighbour on the surface is opposite", "return {a, b} == {\"+\", \"-\"}", "return a != b"),
    ("a point moves the other way", "times(distance, DIRECTIONS[d])",
     "times(-distance, DIRECTIONS[d])"),
    ("a warped point keeps its sign", "return sign if warping[0] < 0 else \"0\"", "return sign"),
    ("midpoints leave the surface outside", "return \"+\" if self.midpoint and sign == \"0\" else sign",
     "return sign"),
    ("the border is not closed", "if any(n in (0, last - 1)", "if any(n in (0,)"),
    ("cuts always seen from the inner end", "return STEPS - self.cut(other, point)",
     "return self.cut(other, point)"),
    ("midpoint cuts one step off", "return STEPS // 2 if self.midpoint",
     "return STEPS // 2 - 1 if self.midpoint"),
    ("cuts counted from the outer end", "times(t, minus(outer, inner))",
     "times(STEPS - t, minus(outer, inner))"),
    ("neighbours looked at after warping", "[self.domain.sign(u) for u in around]",
     "[self.sign(u) if u in self.known else self.domain.sign(u) for u in around]"),
    ("i runs slowest", "plus(origin, times(2, (i, j, k)))",
     "plus(origin, times(2, (k, j, i)))"),
    ("a flat tetrahedron passes", "volume <= 0 if right_handed", "volume < 0 if right_handed"),
    ("no falling back", "if turned_over > 0:", "if turned_over > 1000:"),
    ("left-handed tetrahedra always turned over", "else volume >= 0", "else volume <= 0"),
    ("falling back in name only", "used = \"embedding\"\n            warped = Warped",
     "used = \"embedding\"\n            Warped"),
    ("the thresholds asked for are ignored", "else guarantee", "else \"embedding\""),
    ("a pinched neighbour overlooked", "len(run) == len(NEXT[d]) or (run", "(run"),
    ("two runs around a neighbour", "or (run and not in_one_piece(run))", ""),
    ("walls overlooked", "if d < e and all(f in inner", "if d > e and all(f in inner"),
    ("others in several pieces", "in_one_piece(set(range(14)) - inner)", "in_one_piece(inner)"),
    ("a sample on the surface cut elsewhere", "(higher, lower), STEPS)", "(higher, lower), STEPS // 2)"),
    ("the far before the near", "8 * (4 * t // alpha(d))", "8 * (3 - 4 * t // alpha(d))"),
    ("the inner before the outer", "+ 4 * self.is_higher(point, d)", "- 4 * self.is_higher(point, d)"),
    ("other colours", "2 * (point[0] % 2) + sum(point) // 2 % 2",
     "2 * (1 - point[0] % 2) + sum(point) // 2 % 2"),
    ("nobody stays for a link", "or self.fills_would_touch(link):\n            return", ":\n            pass"),
    ("a move that is not shortened", "if d not in LONG:\n            return t", "if True:\n            return t"),
    ("shortened by those behind", "dot(DIRECTIONS[d], DIRECTIONS[e]) <= 0", "dot(DIRECTIONS[d], DIRECTIONS[e]) >= 0"),
    ("those who give way have no turn", "elif self.turn(w) > self.turn(point):", "else:"),
    ("who comes first gives up nothing", "elif self.turn(w) > self.turn(point):", "elif False:"),
    ("who comes first gives up all", "(room + t - back) // 2", "room - back"),
    ("a move that falls short by much", "if alpha(d) - t < t - reached and", "if False and"),
    ("many cuts moved rather than one point", "self.domain.violating(point) == 1:", "True:"),
    ("a cut that is not clamped", "max(least, min(STEPS - least, self.domain.cut(higher, lower)))",
     "self.domain.cut(higher, lower)"),
    ("a cut clamped at one end", "min(STEPS - least, self.domain.cut(higher, lower))",
     "self.domain.cut(higher, lower)"),
    ("materials judged together alone", "[{m} for m in higher] + [higher]", "[higher]"),
    ("materials judged by themselves alone", "[{m} for m in higher] + [higher]", "[{m} for m in higher]"),
    ("the lowest material judged too", "materials - {min(materials)}", "materials"),
    ("fills that touch", "if e not in NEXT[d] or link[d] == link[e]:", "if True:"),
    ("what four corners share", "len(lower) > 1 or ", ""),
    ("a lower material beside what four corners share", " or min(around) < min(lower)", ""),
    ("a fill of another material", "AABC A 13 14 23 34 A 14 24 23 34", "AABC B 13 14 23 34 A 14 24 23 34"),
    ("a fill's other diagonal", "AABC A 13 14 23 34 A 14 24 23 34", "AABC A 13 14 24 34 A 13 24 23 34"),
    ("no fill", "if name == pattern:", "if False:"),
    ("the outside filled", "            if material == 0:\n                continue\n", ""),
    ("a shared tetrahedron of the higher material", "material = min(self.pair(points[0]", "material = max(self.pair(points[0]"),
    ("centres two cells away looked at", "(0, 0, 0), *DIRECTIONS[:6]", "(0, 0, 0), *(times(2, d) for d in DIRECTIONS[:6])"),
    ("cells across faces not looked at", "*DIRECTIONS[:6], *itertools", "*itertools"),
    ("an octree balanced by faces alone", "if not set(d) <= {-1, 2}]", "if sum(n in (-1, 2) for n in d) < 2]"),
    ("an octree balanced by corners too", "if not set(d) <= {-1, 2}]", "]"),
    ("a level too few", "if level == self.levels:", "if level >= self.levels - 1:"),
    ("flags where a child is", "int(sign > 0)", "int(sign < 0)"),
    ("middles that are not used", "if level == 0:\n            return False", "if level <= 1:\n            return False"),
    ("a middle looked at from one side", "for d in itertools.product((0, 1), repeat=3))", "for d in [(0, 0, 0)])"),
    ("the other diagonal of a pyramid", "r = far if k in (p, opposite_p) else k", "p, opposite_p, r = k, minus(times(2, m), k), p"),
    ("a pyramid's corner nearest along one axis", "cell[axis] % 2 == 0", "cell[axis] % 2 == 0 or axis == 2"),
    ("a tetrahedron that is inside out", "determinant(*tet) > 0", "determinant(*tet) < 0"),
    ("an octree counted from the lattice", "range(o // 2 >> level, (o // 2 + n - 1 >> level) + 1)", "range(o // 2 + n >> level)"),
]


def mutant(old, new):
    """The implementation with one piece of it replaced."""
    if sum(source.count(old) for source in SOURCES.values()) != 1:
        raise ValueError(f"'{old}' does not stand once in the implementation")
    for name, source in SOURCES.items():
        module = sys.modules[name] = types.ModuleType(name)
        exec(compile(source.replace(old, new), name, "exec"), module.__dict__)
    return module


def is_caught(module, kit):
    """By a difference; or because the bug leads nowhere."""
    try:
        return next(check.differences(module, kit), None) is not None
    except (LookupError, ValueError):
        return True


def main(file, *only):
    with open(file, encoding="utf-8") as opened:
        kit = json.load(opened)
    chosen = [m for m in MUTATIONS if not only or m[0] in only]
    survivors = [name for name, old, new in chosen if not is_caught(mutant(old, new), kit)]
    for name in survivors:
        print(f"not caught: {name}")
    print(f"{len(chosen) - len(survivors)} of {len(chosen)} planted bugs caught")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
