"""Single defects that a programmer may make: where they can be seeded, and a choice of them."""

import random
import re
from dataclasses import dataclass
from pathlib import Path

TABLES = "table"


@dataclass(frozen=True)
class Mutant:
    file: str  # relative to the tree
    line: int  # counted from 1
    operator: str
    before: str  # the line as it was
    after: str

    def diff(self):
        return f"{self.file}:{self.line}\n-{self.before}\n+{self.after}"


# Lines that are tables; a defect in one of them is a defect of the lattice or of the stencils.
TABLE_LINES = re.compile(
    r'^ *(Row\{\{|\{\{\{\{\{|\{\{\{0, 0, 0\}|\{\{\{0, 1, 2, 3\}'  # lattice table, symmetries
    r'|\{"[-+0]{4}"'                                              # representatives
    r'|\{-?\d, -?\d, -?\d\}, \{'                                  # directions
    r'|\{(even|odd), \{|constexpr std::array<Shift, 3> axes'      # ends of edges
    r'|inline constexpr VertexOrder|true\}|false\})')

# Changing these changes nothing that a caller can see; each says why.
EQUIVALENT = [
    (r"buffer\.cpp$", r"huge_page|MADV|alignment", "how memory is aligned, never what is in it"),
    (r"parallel\.hpp$", r"tbb|threads|relaxed", "which thread does the work"),
    (r"shared_loop\.hpp$", r"reserve|\(own|arrived|others", "which thread takes which turn"),
    (r"count\.cpp$", r"any_plus", "a shortcut around cells without tetrahedra"),
    (r"row_ranks\.cpp$", r"if \(any_plus == 0 \|\| any_minus == 0\)|any_(plus|minus) = 0", "a shortcut around words without cuts"),
    (r"row_ranks\.hpp$", r"= 0;$", "overwritten by compute before it is read"),
    (r"sample\.cpp$", r"any|int block = |blocks_in|return planes", "how much is skipped or sampled at a time"),
    (r"emit_loop\.hpp$", r"rows_per_task|pieces|j = ", "how the work is divided among threads"),
    (r"cuts\.cpp$", r"batch|reserve", "how many edges are bisected in lockstep"),
    (r"violations\.hpp$", r"direction = 0", "whoever writes a distance writes the direction"),
    (r"plus_runs\.cpp$", r"layers_per_block = |single|a == a_end", "how joining is divided, and shortcuts around it"),
    (r"piece_tets\.cpp$", r"any_plus|pending_|reserve", "shortcuts, and how counts are added up"),
    (r"zero_link\.cpp$", r"is_strict_disk|is_connected", "a shortcut around what has nothing to tell"),
    (r"join_\w+\.cpp$", r"is_simple|cut_ == 0|across == 0|size\(\) == 0", "shortcuts around what has nothing to tell"),
    (r"zero_tets\.hpp$", r"any == 0", "a shortcut around words without zeros"),
    (r"warped_lattice\.cpp$", r"if \(zero == 0\) return", "a shortcut around words without zeros"),
    (r"part_cubes\.cpp$", r"if \(inner != 0\)|edges < 4", "a shortcut around words without odd points inside; more rounds than are needed"),
    (r"settle\.cpp$", r"reserve|relaxed", "room, or the order of what threads see"),
    (r"emit_points\.cpp$", r"w < planes\.words", "the word after a row's last is empty"),
    (r"sign_planes\.hpp$", r"stride_\(|bytes|resize|\(cells", "room around the planes, or what it takes"),
    (r"\.hpp$|\.cpp$", r"array<[^;]*> \w+\{\{|= default|~\w+\(\);", "the size of an array that is written out, a declaration"),
    (r".", r"static_assert|#|std::min\(cells, 1e18\)|throw Error", "a check of the source, or a sentence"),
]


def _replace(pairs):
    def sites(line):
        for old, new in pairs:
            for match in re.finditer(re.escape(old), line):
                yield line[:match.start()] + new + line[match.end():]
    return sites


def _numbers(line):
    for match in re.finditer(r"(?<![\w.'\"])\d+(?![\w.'>])", line):
        n = int(match.group())
        for other in (n + 1, n - 1):
            if other >= 0:
                yield line[:match.start()] + str(other) + line[match.end():]


def _table_entries(line):
    if '"' in line:  # a representative: one corner, or one sign
        for match in re.finditer(r'(?<=[" |\d+0-])[1-4+0-](?=[" |\d+0-])', line):
            old = match.group()
            within = "1234" if match.start() > line.index(",") else "+-0"
            if old not in within:
                continue
            new = within[(within.index(old) + 1) % len(within)]
            yield line[:match.start()] + new + line[match.end():]
        return
    yield from _numbers(line)
    for old, new in (("true", "false"), ("false", "true"), ("same", "flip"), ("flip", "same"),
                     ("even", "odd"), ("odd", "even")):
        for match in re.finditer(rf"\b{old}\b", line):
            yield line[:match.start()] + new + line[match.end():]
    for match in re.finditer(r"\b([IJK])([1-4])\b", line):
        yield line[:match.start()] + match.group(1) + "2341"[int(match.group(2)) - 1] + line[match.end():]
    for match in re.finditer(r"(-?\d), (-?\d)", line):
        if match.group(1) != match.group(2):
            yield line[:match.start()] + f"{match.group(2)}, {match.group(1)}" + line[match.end():]


STATEMENT = re.compile(
    r"^\s+(?!return|throw|break|using|const\b|constexpr|int |bool |auto |template|std::|\[\[|friend"
    r"|default|case|delete)"
    r"((\+\+|--)?[\w\[\]\.>\(\)*-]+(\+\+|--)?( [-|&+]?= .*|\(.*\))?;|if \(.*\) (continue|return[^;]*);)$")


def _statement(line):
    if STATEMENT.match(line) and not re.match(r"^\s+[\w:<>,]+ \w+(_|\{\})?;$", line):
        indent = line[:len(line) - len(line.lstrip())]
        yield indent + ";"


# Arguments whose types differ from all others: the compiler would refuse them elsewhere.
OF_ONE_TYPE = ("planes_?|lattice_?|context|stage_?|row|numbers|domain|cuts_?|out|after|before|r|g|grid|ref"
               "|thresholds_?|signs|moves|warped|rank|old_row|new_row|displacement|cut_edges|violated_?")


def _arguments(line):
    term = r"(?!(?:%s)\b)[\w.]+(?: [-+] [\w.]+)?" % OF_ONE_TYPE
    for match in re.finditer(rf"(\w\(|[,(] )?\b({term}), ({term})(?=[,)])", line):
        a, b = match.group(2), match.group(3)
        if match.group(1) and a != b and not re.search(r"^\s*(inline|constexpr|void)", line):
            yield line[:match.start(2)] + f"{b}, {a}" + line[match.end(3):]


OPERATORS = {
    "comparison": _replace([(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "),
                            (" == ", " != "), (" != ", " == ")]),
    "arithmetic": _replace([(" + ", " - "), (" - ", " + "), (" += ", " -= "), (" * ", " + ")]),
    "logic": _replace([(" && ", " || "), (" || ", " && ")]),
    "bits": _replace([(" & ", " | "), (" | ", " & "), (" |= ", " &= "), (" &= ", " |= "),
                      (" ^ ", " & "), ("~", "")]),
    "shift": _replace([(" >> ", " << "), (" << ", " >> "), ("<< 1", "<< 2"), (">> 1", ">> 2"),
                       ("<< 63", "<< 62"), (">> 63", ">> 62")]),
    "constant": _numbers,
    "statement": _statement,
    "arguments": _arguments,
}


def why_equivalent(file, line):
    for path, text, why in EQUIVALENT:
        if re.search(path, file) and re.search(text, line):
            return why
    return None


def _code_lines(text):
    """The lines of code, each after its number and the line before; without comments,
    static_asserts, and what is there for threads or for other machines."""
    skipping = elsewhere = False
    previous = ""
    for number, line in enumerate(text.splitlines(), 1):
        if "static_assert" in line:
            skipping = True
        if line.startswith("#if"):
            elsewhere = True
        if line.startswith("#endif"):
            elsewhere = False
        if not skipping and not elsewhere and line.strip() and not re.match(
                r"\s*(//|#|template|namespace|class|struct|enum)", line):
            yield number, previous, line
            previous = line
        if skipping and re.search(r'\);$', line) and not line.startswith("    "):
            skipping = False


def of_file(tree, file):
    """All mutants of a file but for the equivalent ones that are known."""
    mutants = []
    for number, previous, line in _code_lines((Path(tree) / file).read_text()):
        code = line.split(" //")[0]
        comment = line[len(code):]
        if why_equivalent(file, line):
            continue
        if TABLE_LINES.match(code) and not code.rstrip().endswith(" {"):
            kinds = {TABLES: _table_entries}
        else:
            kinds = OPERATORS
            if not re.search(r"[;{})]$", previous.split(" //")[0].rstrip()):
                kinds = {o: k for o, k in kinds.items() if o != "statement"}
            if '"' in code:
                continue
        for operator, sites in kinds.items():
            for changed in dict.fromkeys(sites(code)):
                mutants.append(Mutant(file, number, operator, line, changed + comment))
    return mutants


def choose(tree, files, count, seed):
    """`count` mutants spread over files and operators: each group in turn gives one (a
    table four), at most one for a line and an operator, until there are enough."""
    chance = random.Random(seed)
    groups = {}
    for file in files:
        for mutant in of_file(tree, file):
            groups.setdefault((file, mutant.operator), []).append(mutant)
    for group in groups.values():
        chance.shuffle(group)
    chosen = {}

    def take_one(group):
        while group:
            mutant = group.pop()
            place = (mutant.file, mutant.line, mutant.operator)
            if mutant.operator == TABLES:
                place += (mutant.after,)
            if place not in chosen:
                chosen[place] = mutant
                return

    while len(chosen) < count and any(groups.values()):
        for (_, operator), group in groups.items():
            for _ in range(4 if operator == TABLES else 1):
                take_one(group)
    return list(chosen.values())[:count]
