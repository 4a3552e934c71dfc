"""What a source file may say.  Whatever is not named here is refused.

Five kinds of files: the pages, those in PAGES, state; the files that they export define (and those
named *Spec.v are some of them); each Definitions.v passes on some of these; Extraction.v lists what
runs; all others prove.
"""

import re

from vernacular import Unreadable, sentences

PAGES = ("PaperCertificate.v", "WholeMeshCertificate.v", "MaterialCertificate.v",
         "GradingCertificate.v", "C15Certificate.v", "KeyCertificate.v", "Certificate.v")
DEFINING = {"From", "Import", "Open", "Section", "End", "Variable", "Variables",
            "Definition", "Fixpoint", "Inductive", "Record", "Arguments"}
PROVING = DEFINING | {"Theorem", "Lemma", "Corollary", "Let", "Hypothesis", "Hypotheses", "Ltac", "Local"}
PASSING_ON = {"From", "Export"}
STARTING_PROOF = {"Theorem", "Lemma", "Corollary"}
OF_SECTIONS = {"Variable", "Variables", "Hypothesis", "Hypotheses", "Let"}
LOCAL = {"Notation", "Infix", "Ltac", "Opaque", "Strategy"}  # after the word Local, in proofs
SCOPES = {"Z_scope", "R_scope", "nat_scope", "bool_scope", "list_scope", "positive_scope", "N_scope"}
IMPORTS = {"ListNotations"}
LIBRARIES = {"ZArith", "List", "Bool", "Lia"}  # what a Definitions.v may pass on of Coq's

# Tactics that leave a proof open, and the one that trusts a second compiler.
OPEN_TACTICS = {"admit", "give_up", "native_compute", "native_cast_no_check"}
# What has no place in a definition: tactics, generalization, attributes, coercions.
TRICKS = {"ltac", "`", ":>", "#", "#["}
# In the string of a notation: what Coq could read as a quote, as a comment, or as an end.
ODD_STRING = re.compile(r'"|\(\*|\*\)|\.(?!\.)(?<!\.\.)')


class Refused(Exception):
    """A file says what its kind may not say."""


def refuse(file, sentence, why):
    said = str(sentence)
    raise Refused(f"{file}:{sentence.line}: {said if len(said) < 70 else said[:70] + ' ...'}\n{why}")


def read(root, file):
    try:
        return sentences(root / file)
    except Unreadable as problem:
        raise Refused(f"{file}: {problem}\nit cannot be told what this file says.") from problem


def passes_on(file):
    return file.endswith("/Definitions.v")


def exports(root, file):
    """The files that a file exports."""
    return [module.replace(".", "/") + ".v" for sentence in read(root, file)
            if sentence.tokens[:4] == ("From", "Certet", "Require", "Export") for module in sentence.tokens[4:]]


def exported_files(root):
    """The files that the pages export, in order, but for the pages themselves; then each Definitions.v
    that exports nothing but these."""
    found = [file for page in PAGES for file in exports(root, page) if file not in PAGES]
    lists = [str(p.relative_to(root)) for p in sorted(root.glob("*/Definitions.v"))]
    while plain := [file for file in lists if file not in found and set(exports(root, file)) <= set(found)]:
        found += plain
    return list(dict.fromkeys(found))


def headlines(root):
    """The theorems of the pages, in order, each with its page: Certificate.DoorSuffices."""
    return [f"{page[:-2]}.{s.tokens[1]}" for page in PAGES for s in read(root, page)
            if s.tokens[0] in STARTING_PROOF]


def extracted(root):
    """The sentences of Extraction.v that import, and the names that it extracts."""
    said = read(root, "Extraction.v")
    return ([str(s).replace(" . ", ".") + "." for s in said if s.tokens[0] == "From"],
            [name for s in said if s.tokens[:2] == ("Extraction", '"certified.ml"')
             for name in s.tokens[2:]])


# -- every file ---------------------------------------------------------------

def check_import(file, sentence, exported=(), others=()):
    """From Coq, Certet or the others, nothing but modules; what the pages do not export, no other file does."""
    words = sentence.words
    plain = words[1] in ("Coq", "Certet", *others) and words[2:3] == ("Require",)
    modules = words[4:] if words[3:4] in (("Import",), ("Export",)) else words[3:]
    if not plain or not modules or not all(m[0].isalpha() for m in modules):
        refuse(file, sentence, "a file is required in an unusual way.")
    onward = {module.replace(".", "/") + ".v" for module in words[4:]}
    ours = words[1] == "Certet" and onward <= {*exported, *PAGES}
    basic = words[1] == "Coq" and passes_on(file) and set(words[4:]) <= LIBRARIES
    if words[3:4] == ("Export",) and not (ours or basic):
        refuse(file, sentence, "the pages do not export this, so no other file may.")


def check_command(file, sentence, allowed, depth, exported, others):
    words = sentence.words
    command = words[0]
    if command not in allowed:
        refuse(file, sentence, "no file, or no file of this kind, may say this.")
    if command == "From":
        check_import(file, sentence, exported, others)
    if command in ("Import", "Export") and not set(words[1:]) <= IMPORTS:
        refuse(file, sentence, "only notations of lists are imported.")
    if command == "Open" and (words[1] != "Scope" or len(words) != 3 or words[2] not in SCOPES):
        refuse(file, sentence, "only a scope of numbers or lists is opened.")
    if command == "Local" and words[1] not in LOCAL:
        refuse(file, sentence, "nothing else is local.")
    if command in OF_SECTIONS and depth == 0:
        refuse(file, sentence, "outside a section this is an axiom.")
    if command in ("Definition", "Fixpoint") and ":=" not in words:
        refuse(file, sentence, "what is defined is written out, not proved.")


def check_file(root, file, allowed, exported, others=()):
    """Every command is allowed, every proof is between Proof and Qed, every section ends."""
    allowed = PASSING_ON if passes_on(file) else allowed
    open_sections, in_proof = [], False
    for sentence in read(root, file):
        words = sentence.words
        if not words:
            refuse(file, sentence, "an empty sentence.")
        if OPEN_TACTICS & set(words):
            refuse(file, sentence, "a proof is left open, or trusts what Coq's kernel does not check.")
        if any(ODD_STRING.search(token[1:-1]) for token in words if token[0] == '"'):
            refuse(file, sentence, "this could change how Coq reads what follows.")
        if in_proof:
            if words == ("Qed",):
                in_proof = False
            elif words != ("Proof",) and not (words[0][0].islower() or words[0][0] in "[(_="):
                refuse(file, sentence, "within a proof stand only tactics.")
            continue
        check_command(file, sentence, allowed, len(open_sections), exported, others)
        if words[0] == "Section":
            open_sections.append(words[1])
        elif words[0] == "End" and (not open_sections or open_sections.pop() != words[1]):
            refuse(file, sentence, "no such section is open.")
        in_proof = words[0] in STARTING_PROOF or words[0] == "Let" and ":=" not in words
    if in_proof or open_sections:
        raise Refused(f"{file}\na proof or a section has no end.")


# -- one kind each ------------------------------------------------------------

def variables(sentence):
    """The names that Variable or Variables declares, without their types."""
    found, reading = [], True
    for token in sentence.tokens[1:]:
        reading = token == "(" or reading and token != ":"
        if reading and token != "(":
            found.append(token)
    return found


def short_names(root, file):
    """Local names for what the variables of open sections make: c12 for (GetIntersection v1 v2)."""
    found, declared = set(), []
    for sentence in read(root, file):
        words = sentence.tokens
        if words[0] == "Section":
            declared.append(set())
        elif words[0] == "End" and declared:
            declared.pop()
        elif words[0] in ("Variable", "Variables") and declared:
            declared[-1] |= set(variables(sentence))
        elif words[0] == "Local":
            known = set().union(*declared)
            if (words[1:4:2] != ("Notation", ":=") or words[4:5] + words[-1:] != ("(", ")")
                    or not set(words[5:-1]) <= known or words[2] in known | found):
                refuse(file, sentence, "only what the variables of a section make is given a local name.")
            found.add(words[2])
    return found


def check_definitions(root, file, exported):
    """A file that a page exports: plain definitions."""
    short_names(root, file)
    check_file(root, file, DEFINING | {"Local"}, exported)
    for sentence in read(root, file):
        if TRICKS & set(sentence.tokens) or any(t.startswith('"') for t in sentence.tokens):
            refuse(file, sentence, "a definition that users read has no notation, coercion, attribute or tactic.")
        if sentence.tokens[0] == "Arguments" and not set(sentence.tokens[2:]) <= set(
                "{}[]") | {t for t in sentence.tokens if t[0].isalpha()}:
            refuse(file, sentence, "arguments are made implicit, and no more.")


def check_page(root, page, exported):
    """Nothing but imports and theorems, each proved by exact and a theorem of the same name."""
    said = read(root, page)
    while said:
        sentence = said.pop(0)
        words = sentence.tokens
        if words[0] == "From":
            check_import(page, sentence, exported)
        elif words[0] in STARTING_PROOF:
            proof = [s.tokens for s in said[:3]]
            if (TRICKS | {"exact"}) & set(words) or any(t.startswith('"') for t in words):
                refuse(page, sentence, "a statement holds a trick.")
            if (len(proof) < 3 or proof[0] != ("Proof",) or proof[2] != ("Qed",)
                    or proof[1][0] != "exact" or len(proof[1]) != 2):
                refuse(page, sentence, "a headline is proved by exact and a name alone.")
            if proof[1][1].split(".")[1:] != [words[1]]:
                refuse(page, sentence, "a headline is proved in a file, by a theorem of its own name there.")
            del said[:3]
        elif words != ("Open", "Scope", "Z_scope"):
            refuse(page, sentence, "a page only imports and states.")


def check_pages(root):
    for page in PAGES:
        check_page(root, page, exported_files(root))


def check_extraction(root):
    """The extracted functions are OCaml as Coq gives it, from the files that the pages export."""
    said = read(root, "Extraction.v")
    exported = {file[:-2].replace("/", ".") for file in exported_files(root)}
    outputs = 0
    for sentence in said:
        words = sentence.tokens
        if words[0] == "From":
            known = {"Extraction", "ExtrOcamlBasic"} if words[1] == "Coq" else exported
            check_import("Extraction.v", sentence)
            if words[2:4] != ("Require", "Import") or not set(words[4:]) <= known:
                refuse("Extraction.v", sentence, "only ExtrOcamlBasic and what Certificate.v exports.")
        elif words[:2] == ("Extraction", '"certified.ml"') and all(w[0].isalpha() for w in words[2:]):
            outputs += 1
        elif words != ("Extraction", "Language", "OCaml"):
            refuse("Extraction.v", sentence, "this could put other code in the place of a function.")
    if outputs != 1:
        raise Refused("Extraction.v\none list of functions is extracted.")
