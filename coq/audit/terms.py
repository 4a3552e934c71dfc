"""Makes readable what Walk.v prints: the kernel's terms, with every name in full.

A line of the walk is a parenthesized tree; its leaves are names in full, bound variables by their
distance (#1 is the nearest), names of binders, and sorts.
"""

from rules import Refused

WIDTH = 100
NUMBERS = "Coq.Numbers.BinNums."


def parse(line):
    """The tree of a line, as nested lists of strings."""
    stack = [[]]
    for token in line.replace("(", " ( ").replace(")", " ) ").split():
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    (tree,) = stack[0]
    return tree


# -- numerals -----------------------------------------------------------------

def positive(tree):
    """The number that a closed term of Coq's positive stands for, or None."""
    if tree == NUMBERS + "xH":
        return 1
    if isinstance(tree, list) and len(tree) == 3 and tree[0] == "app":
        bit = {NUMBERS + "xO": 0, NUMBERS + "xI": 1}.get(tree[1] if isinstance(tree[1], str) else "")
        rest = positive(tree[2]) if bit is not None else None
        return None if rest is None else 2 * rest + bit
    return None


def numeral(tree):
    """The decimal notation of a closed number, or None."""
    if tree == NUMBERS + "Z0":
        return "0%Z"
    if isinstance(tree, list) and len(tree) == 3 and tree[1] in (NUMBERS + "Zpos", NUMBERS + "Zneg"):
        n = positive(tree[2])
        if n is not None:
            return f"{n}%Z" if tree[1].endswith("Zpos") else f"(-{n})%Z"
    n = positive(tree)
    return None if n is None else f"{n}%positive"


# -- layout: text that breaks where it must -----------------------------------
#
# A document is a string or ("box", indent, parts); a box is written on one line if it fits, and
# otherwise with a new line, indented, before every part but the first.

def box(indent, *parts):
    return ("box", indent, parts)


def flat(doc):
    return doc if isinstance(doc, str) else " ".join(flat(part) for part in doc[2])


def lines(doc, width):
    """The lines of a document that fits the width where it can."""
    whole = flat(doc)
    if isinstance(doc, str) or len(whole) <= width:
        return [whole]
    _, indent, parts = doc
    out = lines(parts[0], width)
    for part in parts[1:]:
        out += [" " * indent + line for line in lines(part, width - indent)]
    return out


def glue(before, doc, after=""):
    """The document with text put directly before and after it."""
    if isinstance(doc, str):
        return before + doc + after
    _, indent, parts = doc
    parts = list(parts)
    parts[0] = glue(before, parts[0])
    parts[-1] = glue("", parts[-1], after)
    return ("box", indent, tuple(parts))


# -- terms --------------------------------------------------------------------

def mentions(tree, distance):
    """Whether the bound variable at this distance occurs."""
    if isinstance(tree, str):
        return tree == f"#{distance}"
    if tree[0] in ("forall", "fun"):
        return mentions(tree[2], distance) or mentions(tree[3], distance + 1)
    if tree[0] == "let":
        return mentions(tree[2], distance) or mentions(tree[3], distance) or mentions(tree[4], distance + 1)
    if tree[0] in ("fix", "cofix"):
        bodies = fixpoints(tree)
        return any(mentions(type_, distance) or mentions(body, distance + len(bodies))
                   for _, _, type_, body in bodies)
    return any(mentions(part, distance) for part in tree[1:])


def fixpoints(tree):
    """(decreasing argument, name, type, body) of each function of a fix or cofix."""
    rest = tree[2:]
    if tree[0] == "cofix":
        return [("", *rest[i:i + 3]) for i in range(0, len(rest), 3)]
    return [tuple(rest[i:i + 4]) for i in range(0, len(rest), 4)]


class Printer:
    """Prints terms; knows the constructors of the inductive types that were walked."""

    def __init__(self, trees):
        self.constructors = {t[1]: [(c[1], c[2]) for c in t[3:]] for t in trees if t[0] == "inductive"}

    @staticmethod
    def fresh(name, scope, used=True):
        if name == "_":
            if not used:
                return "_"
            name = "x"
        while name in scope:
            name += "'"
        return name

    def atom(self, tree, scope):
        """A term in parentheses unless it needs none."""
        doc = self.term(tree, scope)
        plain = isinstance(tree, str) or numeral(tree) is not None
        return doc if plain else glue("(", doc, ")")

    def term(self, tree, scope):
        number = numeral(tree)
        if number is not None:
            return number
        if isinstance(tree, str):
            return scope[int(tree[1:]) - 1] if tree.startswith("#") else tree
        return getattr(self, "show_" + tree[0])(tree, scope)

    def show_app(self, tree, scope):
        return box(2, *(self.atom(part, scope) for part in tree[1:]))

    def show_forall(self, tree, scope):
        if not mentions(tree[3], 1):
            left = tree[2]
            domain = (self.atom if isinstance(left, list) and left[0] in ("forall", "let", "fun")
                      else self.term)(left, scope)
            return box(0, glue("", domain, " ->"), self.term(tree[3], ["_"] + scope))
        binders, body, inner = self.binders("forall", tree, scope)
        return box(2, box(4, "forall", *binders[:-1], glue("", binders[-1], ",")), self.term(body, inner))

    def show_fun(self, tree, scope):
        binders, body, inner = self.binders("fun", tree, scope)
        return box(2, box(4, "fun", *binders[:-1], glue("", binders[-1], " =>")), self.term(body, inner))

    def binders(self, kind, tree, scope):
        """The binders before a body, those of one type together; the body, and its scope."""
        groups = []
        while isinstance(tree, list) and tree[0] == kind and (kind == "fun" or mentions(tree[3], 1)):
            name = self.fresh(tree[1], scope, mentions(tree[3], 1))
            type_ = self.term(tree[2], scope)
            if groups and flat(groups[-1][1]) == flat(type_):
                groups[-1][0].append(name)
            else:
                groups.append(([name], type_))
            tree, scope = tree[3], [name] + scope
        return [glue(f"({' '.join(names)} : ", type_, ")") for names, type_ in groups], tree, scope

    def show_let(self, tree, scope):
        _, name, type_, value, body = tree
        name = self.fresh(name, scope)
        return box(0, box(2, glue(f"let {name} : ", self.term(type_, scope), " :="),
                          glue("", self.term(value, scope), " in")),
                   self.term(body, [name] + scope))

    def show_match(self, tree, scope):
        _, predicate, scrutinee, *branches = tree
        returned, dependent, arity, inner = predicate, False, 0, list(scope)
        while isinstance(returned, list) and returned[0] == "fun":
            scrutinee_type, arity = returned[2], arity + 1
            dependent = dependent or mentions(returned[3], 1)
            returned, inner = returned[3], ["_"] + inner
        for distance in range(1, arity + 1):
            dependent = dependent or mentions(returned, distance)
        shown = self.atom(predicate, scope) if dependent else self.term(returned, inner)
        head = box(2, glue("match ", self.term(scrutinee, scope)), glue("return ", shown, " with"))
        applied = scrutinee_type[1:] if isinstance(scrutinee_type, list) else [scrutinee_type]
        parameters = len(applied) - 1 - (arity - 1)
        constructors = self.constructors[applied[0]]
        assert len(constructors) == len(branches)
        return box(0, head, *(self.branch(c, parameters, b, scope) for c, b in zip(constructors, branches)),
                   "end")

    def branch(self, constructor, parameters, branch, scope):
        name, type_ = constructor
        arguments = -parameters
        while isinstance(type_, list) and type_[0] in ("forall", "let"):
            arguments += type_[0] == "forall"
            type_ = type_[-1]
        names, scope = [], list(scope)
        for _ in range(arguments):
            assert branch[0] == "fun", "a branch is not a function of the arguments"
            names.append(self.fresh(branch[1], scope, mentions(branch[3], 1)))
            branch, scope = branch[3], [names[-1]] + scope
        return box(4, " ".join(["|", name, *names, "=>"]), self.term(branch, scope))

    def show_fix(self, tree, scope):
        functions = fixpoints(tree)
        names, inner = [], scope
        for _, name, _, _ in functions:
            names.append(self.fresh(name, inner))
            inner = [names[-1]] + inner
        shown = []
        for name, (argument, _, type_, body) in zip(names, functions):
            by = f" {{argument {int(argument) + 1}}}" if argument else ""
            shown.append(box(2, glue(f"{name}{by} : ", self.term(type_, scope), " :="), self.term(body, inner)))
        joined = [glue(f"{tree[0]} ", shown[0]), *(glue("with ", s) for s in shown[1:])]
        if len(names) > 1:
            joined.append(f"for {names[int(tree[1])]}")
        return box(0, *joined)

    show_cofix = show_fix

    def show_unprintable(self, tree, scope):
        raise Refused("the theorems speak of machine numbers, arrays or primitive projections, "
                      "which the audit does not read.")

    # -- one line of the walk --

    def text(self, tree):
        """What a line of the walk says, in lines."""
        kind, name, type_ = tree[:3]
        word = {"statement": "Theorem", "definition": "Definition", "inductive": "Inductive",
                "hidden": "Sealed"}[kind]
        type_ = self.term(type_, [])
        if kind in ("statement", "hidden"):
            doc = box(2, f"{word} {name} :", glue("", type_, "."))
        else:
            head = box(4, f"{word} {name} :", glue("", type_, " :="))
            rest = ([glue("", self.term(tree[3], []), ".")] if kind == "definition" else
                    [glue(f"| {c[1]} : ", self.term(c[2], [])) for c in tree[3:]])
            doc = box(2, head, *rest)
        return "\n".join(lines(doc, WIDTH)) + "\n"
