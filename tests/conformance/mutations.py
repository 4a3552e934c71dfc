"""Plants bugs in conforming.py, one at a time; the kit must catch each.

usage: mutations.py KIT.json [BUG...]      exit status 1 if one is not caught
"""

import json
import pathlib
import sys
import types

import check

SOURCE = pathlib.Path(__file__).with_name("conforming.py").read_text(encoding="utf-8")

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
    ("left-handed tetrahedra not mirrored", "else [a, b, d, c]", "else [a, b, c, d]"),
    ("left-handed tetrahedra mirrored elsewhere", "else [a, b, d, c]", "else [b, a, c, d]"),
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
]


def mutant(old, new):
    """conforming.py with one piece of it replaced."""
    if SOURCE.count(old) != 1:
        raise ValueError(f"'{old}' does not stand once in conforming.py")
    module = types.ModuleType("mutant")
    exec(compile(SOURCE.replace(old, new), "mutant", "exec"), module.__dict__)
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
