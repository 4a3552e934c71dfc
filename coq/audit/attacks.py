"""The defects that the audit must refuse: (what, the check that refuses it, how it is planted).

Each is planted in a Workshop whose last page was shortened.  What is only read need not compile;
what is compiled carries proofs cut short, as an attacker would.
"""

import re

PROOF, SPEC, LIST = "Stencil/OtherStencilsProof.v", "Range/RangeSpec.v", "Lattice/Definitions.v"
PAPER, PAGE = "PaperCertificate.v", "Certificate.v"


# -- ways to plant ------------------------------------------------------------

def said(text, file=PROOF):
    """A sentence at the end of a file."""
    return lambda w: w.append(file, text)


def in_proof(text):
    return said(f"Lemma planted : True. Proof. {text} exact I. Qed.")


def edited(file, old, new):
    return lambda w: w.edit(file, old, new)


def file(name, text=""):
    """A file more."""
    return lambda w: w.write(name, text)


def cut_short(w, proofs, proof="Admitted."):
    """Leaves of a file of proofs what the last page uses, proved otherwise."""
    text = (w.root / proofs).read_text()
    module = proofs.split("/")[-1][:-2]
    used = re.findall(rf"exact {module}\.(\w+)\.", (w.root / PAGE).read_text())
    head = re.search(r"\A.*?Open Scope[^\n]*\n", text, re.S).group()
    stated = [re.search(rf"^(?:Theorem|Lemma) {name}\b.*?(?=^Proof\.)", text, re.S | re.M).group()
              for name in used]
    w.write(proofs, head + "".join(f"{statement}{proof}\n" for statement in stated))
    w.compile(proofs)


def resign(w, *theorems):
    """Gives up the proofs of these headlines, so that only what they say is looked at."""
    for page in (PAPER, PAGE):
        for theorem in theorems:
            text = (w.root / page).read_text()
            w.write(page, re.sub(rf"({theorem} :.*?)Proof\. exact [\w.]+ Qed\.", r"\1Admitted.", text,
                                 count=1, flags=re.S))
    w.compile(PAPER, PAGE)


def in_ranges(change, *theorems):
    """A change of RangeSpec.v, compiled."""
    def plant(w):
        change(w)
        w.compile(SPEC)
        cut_short(w, "Range/RangeProof.v")
        resign(w, *theorems)
    return plant


def in_degrees(change, proof="Admitted."):
    """A change of DegreesSpec.v, compiled, and what is then proved of it."""
    def plant(w):
        change(w)
        w.compile("Angles/DegreesSpec.v")
        cut_short(w, "Angles/Degrees/DegreesProof.v", proof)
        w.compile(PAGE)
    return plant


def on_page(page, *changes):
    """(old, new) on a page, compiled."""
    def plant(w):
        for old, new in changes:
            w.edit(page, old, new)
        w.compile(*dict.fromkeys((page, PAGE)))
    return plant


def alone(text, options=()):
    """A compiled file by itself, for coqchk to look at."""
    def plant(w):
        w.write("_CoqProject", "-Q . Certet\nPlanted.v\n")
        w.write("Planted.v", text)
        w.compile("Planted.v", options=options)
    return plant


# -- what the theorems mean ---------------------------------------------------

WITHIN_DEGREES = re.compile(r"Definition WithinDegrees .*", re.S)


def within_degrees_is_true(w):
    path = "Angles/DegreesSpec.v"
    w.write(path, WITHIN_DEGREES.sub(
        "Definition WithinDegrees (_ _ : R) (_ : UnstructuredTet Coord3) : Prop := True.\n",
        (w.root / path).read_text()))


TETS = "From Certet Require Import Stencil.UnstructuredTet.\n"
PLACES = "From Certet Require Import Lattice.StructuredTet Lattice.NeighborSpec.\n"
POSITIVE = said(TETS + "Definition Positive (_ : UnstructuredTet Coord3) : Prop := True.", SPEC)
WITHIN = said(TETS + "From Coq Require Import Reals.\n"
              "Definition WithinDegrees (_ _ : R) (_ : UnstructuredTet Coord3) : Prop := True.", SPEC)
FACE = said(PLACES + "Definition FaceOf (_ : StructuredTetId) (_ : Place) : list Coord3 := nil.", SPEC)
NEVER = "(match (sign : SignField), (cut : CutField) with _, _ => False end)"


def axiom_by_another_name(w):
    """An axiom that Coq prints as it prints one of those of the real numbers."""
    name = "Range/ClassicalDedekindReals.v"
    w.write(name, "Axiom sig_not_dec : forall P : Prop, {~ ~ P} + {~ P}.\n")
    w.compile(name)
    w.edit(PAGE, "Open Scope", "From Certet Require Range.ClassicalDedekindReals.\nOpen Scope")
    on_page(PAGE, ("exact MeshProof.FaceTriangleOnce.",
                   "generalize Range.ClassicalDedekindReals.sig_not_dec. intros _. "
                   "exact MeshProof.FaceTriangleOnce."))(w)


MEANING = [
    ("WithinDegrees made True, proved by exact I", "definitions",
     in_degrees(within_degrees_is_true, "Proof. intros. exact I. Qed.")),
    ("a second Positive in the file exported last", "names", in_ranges(POSITIVE, "WarpedLatticePositive")),
    ("the same, not asking for names", "statements", in_ranges(POSITIVE, "WarpedLatticePositive")),
    ("a second WithinDegrees there", "statements", in_ranges(WITHIN, "MidpointBoundsInDegrees")),
    ("a second FaceOf there", "statements", in_ranges(FACE, "FaceTriangleOnce")),
    ("another acos than the library's", "definitions",
     in_degrees(edited("Angles/DegreesSpec.v", "(** The angle between",
                       "Definition acos (x : R) : R := x.\n\n(** The angle between"))),
    ("a local notation that makes <= say True", "definitions",
     in_degrees(edited("Angles/DegreesSpec.v", "Open Scope R_scope.",
                       'Open Scope R_scope.\nLocal Notation "x <= y <= z" := (let _ := (x, y, z) in True).'))),
    ("a definition three steps down made True", "definitions",
     in_ranges(edited(SPEC, "- 2 ^ (bits - 1) <= n <= 2 ^ (bits - 1) - 1.", "True."))),
    ("an inductive type with a case less", "definitions",
     in_ranges(lambda w: (w.edit(SPEC, "AxisY | AxisZ", "AxisY"), w.edit(SPEC, "  | C3 _ _ z, AxisZ => z\n", ""),
                          w.write(SPEC, re.sub(r"\(\*\* Six times.*", "", (w.root / SPEC).read_text(),
                                               flags=re.S))))),
    ("a constant that is off by one", "definitions", in_ranges(edited(SPEC, ":= 32000.", ":= 32001."))),
    ("a definition whose body nobody can read", "definitions",
     in_ranges(edited(SPEC, "Definition LatticeLimit : Z := 32000.",
                      "Definition LatticeLimit : Z.\nProof. exact 32000. Qed."))),
    ("a hypothesis that never holds, printed as the agreed one", "statements",
     on_page(PAGE, ("CutsOnEdges sign cut ->\n    Positive", NEVER + " ->\n    Positive"),
             ("exact LatticeProof.WarpedLatticePositive", "intros ? ? ? []"),
             ("Open Scope", 'Notation "\'CutsOnEdges\' sign cut" := ' + NEVER +
              " (at level 10, sign at level 9, cut at level 9, only printing).\nOpen Scope"))),
    ("a weakened theorem", "statements",
     on_page(PAGE, ("Bounded LatticeLimit v.\n", "Bounded LatticeLimit v \\/ True.\n"),
             ("exact RangeProof.CornersInRange", "now right"))),
    ("a weakened theorem on the paper's page", "statements",
     on_page(PAPER, ("        (Face1Correct v1 v2 v3 v4 tid1 o1) /\\\n", ""),
             ("exact StructuredTetProof.FacesCorrect", "intros tid; pose proof (StructuredTetProof.FacesCorrect tid)"
              " as all; destruct (GetStructuredTet tid) as [? ? ? ? [] [] [] []]; apply all"))),
    ("a theorem that is gone", "statements",
     lambda w: (w.write(PAGE, re.sub(r"Theorem DoorSuffices .*?Qed\.", "", (w.root / PAGE).read_text(), flags=re.S)),
                w.compile(PAGE))),
    ("the paper's theorems, all gone", "statements",
     lambda w: (w.write(PAPER, (w.root / PAPER).read_text().split("Theorem FacesCorrect")[0]),
                w.compile(PAPER, PAGE))),
    ("a type class, and an instance of it", "names",
     in_ranges(said("Class Small := { small : Z }.\nInstance tiny : Small := { small := 1 }.", SPEC))),
    ("a notation that Coq tells of", "names",
     in_ranges(said("Notation Twelve := 12.", SPEC))),
    ("an axiom in a file that nothing uses", "names",
     lambda w: (w.append("Stencil/OtherStencils.v", "Axiom idle : False."),
                w.compile("Stencil/OtherStencils.v"))),
    ("a theorem that is an axiom", "assumptions", lambda w: resign(w, "DoorSuffices")),
    ("a theorem of the paper's that is an axiom", "assumptions", lambda w: resign(w, "FacesCorrect")),
    ("an axiom with the name of one of the library", "assumptions", axiom_by_another_name),
]

# -- what switches off the kernel's checks, as coqchk sees it ------------------

LOOP = "Fixpoint loop (n : nat) {struct n} : False := loop n."
CURRY = "Inductive Curry := curry : (Curry -> False) -> Curry."
BIG = "Definition Big : Type := Type. Definition inside : Big := Big -> Big : Big."

CHECKER = [
    ("an axiom", "checker", alone("Axiom planted : False.")),
    ("a variable outside a section", "checker", alone("Variable planted : False.")),
    ("an axiom within a module", "checker",
     alone("Module Type T. Parameter planted : False. End T. Declare Module M : T.")),
    ("an endless fixpoint, Unset Guard Checking", "checker", alone("Unset  Guard (* *) Checking. " + LOOP)),
    ("an endless fixpoint, bypass_check", "checker", alone("#[ bypass_check( guard ) ]\n" + LOOP)),
    ("a type that is not positive", "checker", alone("Unset Positivity Checking. " + CURRY)),
    ("a universe too small", "checker",
     alone("Unset Universe Checking. Definition u : Type := Type. Definition planted : u := u.")),
    ("-type-in-type", "checker", alone("Definition U := Type. Definition planted : U := U.", ["-type-in-type"])),
    ("an impredicative Set", "checker",
     alone("Definition planted : Set := forall A : Set, A.", ["-impredicative-set"])),
]

# -- what sources say ---------------------------------------------------------

LEFTOVERS = [(what, "leftovers", plant) for what, plant in [
    ("an admitted lemma", said("Lemma planted : False. Admitted.")),
    ("the same in four lines and a comment", said("Lemma planted\n: False.\n(* Qed. *)\nAdmitted .")),
    ("an aborted lemma", said("Lemma planted : True. Proof. Abort.")),
    ("a proof that is put off", in_proof("try admit.")),
    ("a proof that is given up", in_proof("all: give_up.")),
    ("a second compiler that is trusted", in_proof("native_compute.")),
    ("a proof whose body is transparent", said("Lemma planted : True. Proof. exact I. Defined.")),
    ("a query left behind", said("Check CompatibilityOrders.")),
    ("a query within a proof", in_proof("Print nat.")),
    ("a query behind a bullet", in_proof("- Search nat.")),
    ("an axiom after a string in a comment", said('(* "(*" *) Axiom planted : False.')),
    ("an axiom after nested comments", said("(* (* *) *) Axiom planted : False. (* *)")),
    ("a conjecture", said("Conjecture planted : False.")),
    ("a parameter", said("Parameters planted : False.")),
    ("a variable outside a section", said("Variable planted : False.")),
    ("a hypothesis outside a section", said("Section S. End S. Hypothesis planted : False.")),
    ("a context outside a section", said("Context (planted : False).")),
    ("a section that has no end", said("Section S. Variable planted : False.")),
    ("Unset  Guard Checking", said("Unset  Guard Checking.")),
    ("Unset (* *) Guard Checking", said("Unset (* no *) Guard\nChecking.")),
    ("Unset Guard Checking within a proof", in_proof("Unset Guard Checking.")),
    ("Unset Universe Checking", said("Unset Universe\tChecking.")),
    ("Set Universe Polymorphism", said("Set Universe Polymorphism.")),
    ("Set Definitional UIP", said("Set Definitional UIP.")),
    ("Set Warnings", said('Set Warnings "-all".')),
    ("Set Printing, exported", said("#[export] Set Printing All.")),
    ("#[bypass_check(guard)]", said("#[bypass_check(guard)] Fixpoint f (n : nat) : nat := f n.")),
    ("#[ local, bypass_check( positivity = yes ) ]",
     said("#[ local , (* *) bypass_check( positivity = yes ) ]\nInductive I := i : (I -> nat) -> I.")),
    ("Local Unset", said("Local Unset Guard Checking.")),
    ("Global Opaque", said("Global Opaque HoledStencils.")),
    ("Fail, which hides an error", said("Fail Definition planted : nat := true.")),
    ("a file loaded by Load", said('Load "other".')),
    ("OCaml code", said('Declare ML Module "planted".')),
    ("another folder", said('Add LoadPath "/" as Certet.')),
    ("Cd", said('Cd "/".')),
    ("a module type with a parameter", said("Module Type T. Parameter planted : False. End T.")),
    ("Program and its obligations", said("Program Definition planted : {n : nat | n = 1} := 0.")),
    ("a primitive", said("Primitive planted := #int63_add.")),
    ("Ltac2", said("From Ltac2 Require Import Ltac2.")),
    ("a library of somebody else", said("From Other Require Import Axioms.")),
    ("a file required without From", said("Require Import Certet.Range.RangeSpec.")),
    ("an export past the pages", said("From Certet Require Export Range.RangeProof.")),
    ("an export of a proof among definitions", said("From Certet Require Export Range.RangeProof.", LIST)),
    ("an export of more of Coq there", said("From Coq Require Export Reals.", LIST)),
    ("an export of Coq elsewhere", said("From Coq Require Export Lia.")),
    ("a definition where others are passed on", said("Definition planted := True.", LIST)),
    ("notations passed on by a proof", said("Export ListNotations.")),
    ("an extraction of its own", said('Extract Constant Nat.add => "fun _ _ -> 0".')),
    ("letters that look like others", said("Definition Pos\u0456tive := True.")),
    ("a dot that ends no sentence", said("Definition planted := 1.Axiom idle : False.")),
    ("a notation that reads a comment", said('Local Notation "x (* y" := x (at level 9).')),
    ("a comment that has no end", said("(* Qed. (* *)")),
]]

SPECS = [(what, "specs", said(text, SPEC)) for what, text in [
    ("a proof in a specification", "Lemma planted : True. Proof. exact I. Qed."),
    ("a notation", 'Notation "x <== y" := (x = y) (at level 70).'),
    ("a notation that only prints", 'Notation "\'Bounded\' n" := (n = 0) (at level 9, only printing).'),
    ("a local notation", 'Local Notation "x <= y" := True.'),
    ("an abbreviation", "Notation Bounded := (fun _ _ => True)."),
    ("a local name for what no variable makes", "Local Notation Bounded_ := (Bounded LatticeLimit)."),
    ("a local name for more than variables", "Section S. Variable n : Z. Local Notation m := (n = n). End S."),
    ("a local name that hides a variable", "Section S. Variables m n : Z. Local Notation m := (n). End S."),
    ("a notation of an inductive type",
     "Inductive Less_ : Z -> Prop := less n : [ n ] where \"[ n ]\" := (Less_ n)."),
    ("a coercion", "Coercion Number : Z >-> Formula."),
    ("a coercion by a field", "Record Box := { inside :> Z }."),
    ("a canonical structure", "Canonical Structure planted := Number."),
    ("a type class", "Class Small := { small : Z }."),
    ("an instance", "Existing Instance planted."),
    ("a generalized binder", "Definition planted `(n : Z) := n."),
    ("a body made by a tactic", "Definition planted : Z := ltac:(exact 1)."),
    ("a body made by a proof", "Definition planted : Z. Proof. exact 1. Defined."),
    ("a scope bound to a type", "Bind Scope formula_scope with Formula."),
    ("a scope that is no number's", "Open Scope formula_scope."),
    ("an argument read in a scope", "Arguments Along k%nat_scope v."),
    ("an argument that is renamed and held back", "Arguments Along k v : simpl never."),
    ("a module", "Module M. Definition Bounded := True. End M."),
    ("an import of a module", "Import BinInt.Z."),
    ("an implicit type", "Implicit Types n : nat."),
    ("a hint", "Hint Constructors Formula : core."),
    ("a variable outside a section", "Variable planted : Z."),
]]

PAGES = [(what, "pages", plant) for what, plant in [
    ("a definition", said("Definition Bounded := True.", PAGE)),
    ("a notation", said("Notation Positive := (fun _ => True).", PAGE)),
    ("a section with a variable", said("Section S. Variable planted : False. End S.", PAGE)),
    ("a scope more", edited(PAGE, "Open Scope Z_scope.", "Open Scope R_scope.")),
    ("a proof by tactics", edited(PAGE, "Proof. exact", "Proof. intros; exact")),
    ("a theorem given up", said("Theorem planted : False.\nProof. Admitted.", PAGE)),
    ("a transparent theorem", said("Theorem planted : True.\nProof. exact I. Defined.", PAGE)),
    ("a statement made by a tactic",
     said("Theorem planted : ltac:(exact True).\nProof. exact I. Qed.", PAGE)),
    ("a module that another project exports",
     edited(PAGE, "Open Scope", "From Coq Require Export Lia.\nOpen Scope")),
    ("an attribute", edited(PAGE, "Theorem DoorSuffices", "#[local] Theorem DoorSuffices")),
    ("a theorem proved under another name",
     edited(PAGE, "exact RangeProof.CornersInRange", "exact RangeProof.DoorSuffices")),
    ("a theorem proved by one that stands on a page",
     edited(PAGE, "exact RangeProof.CornersInRange", "exact CornersInRange")),
    ("a definition on the paper's page", said("Definition Face1Correct := True.", PAPER)),
    ("a proof by tactics there", edited(PAPER, "Proof. exact", "Proof. intros; exact")),
    ("a theorem given up there", said("Theorem planted : False.\nProof. Admitted.", PAPER)),
    ("a module that another project exports there",
     edited(PAPER, "(** What is meant. *)", "From Coq Require Export Lia.")),
]]

EXTRACTION = [(what, "extraction", plant) for what, plant in [
    ("another function in OCaml", said('Extract Constant StuffTet => "fun _ -> []".', "Extraction.v")),
    ("the same, inlined", said('Extract Inlined Constant Steps => "1".', "Extraction.v")),
    ("another type in OCaml", said('Extract Inductive Sign => "int" [ "1" "0" "2" ].', "Extraction.v")),
    ("integers that overflow", edited("Extraction.v", "ExtrOcamlBasic", "ExtrOcamlBasic ExtrOcamlZInt")),
    ("a function of a proof", edited("Extraction.v", "Embedding.DiskTables", "Embedding.DiskTables Range.RangeProof")),
    ("a definition more", said("Definition StuffTet := 0.", "Extraction.v")),
    ("a list of functions more", said('Extraction "certified.ml" Steps.', "Extraction.v")),
    ("functions without their types", said("Set Extraction Optimize.", "Extraction.v")),
    ("an implicit argument of a function", said("Extraction Implicit StuffTet [1].", "Extraction.v")),
]]

LISTING = [(what, "listing", plant) for what, plant in [
    ("an unlisted file", file("Stencil/Planted.v")),
    ("a listed file that is not there", said("Range/Planted.v", "_CoqProject")),
    ("a file that leads elsewhere",
     lambda w: (w.append("_CoqProject", "Range/Linked.v"), w.link("Range/Linked.v", "RangeSpec.v"))),
    ("a compiled file without a source", file("Range/Planted.vo")),
    ("code for Coq to load", file("Range/planted.ml")),
    ("rules of its own for make", file("Makefile.coq.local", "COQEXTRAFLAGS = -type-in-type\n")),
    ("-type-in-type in _CoqProject", edited("_CoqProject", "-Q . Certet", "-Q . Certet\n-arg -type-in-type")),
    ("files that pass for the library's", edited("_CoqProject", "-Q . Certet", "-Q . Certet\n-Q Range Coq")),
    ("options behind a file", edited("_CoqProject", "Warp/Cut.v", "Warp/Cut.v -arg -noinit")),
    ("options in the Makefile", edited("Makefile", "$(MAKE) -f $< all", "$(MAKE) COQEXTRAFLAGS=-noinit -f $< all")),
]]

COMPILED = [(what, "compiled", plant) for what, plant in [
    ("a source changed after it was compiled", said("(* *)", SPEC)),
    ("make's rules changed", said("COQEXTRAFLAGS = -type-in-type", "Makefile.coq")),
    ("make's options changed",
     edited("Makefile.coq.conf", "COQMF_OTHERFLAGS =", "COQMF_OTHERFLAGS = -type-in-type")),
    ("code that Coq loads", lambda w: (
        w.edit(PAGE, "Open Scope", "From Coq Require Nsatz ssreflect.\nOpen Scope"),
        w.compile(PAGE))),
]]

ELSEWHERE = [(what, "--read tables Tables", file("tables/Tables.v", text)) for what, text in [
    ("an axiom in the proof of the tables", "Axiom planted : False."),
    ("an admitted lemma there", "Lemma planted : False.\nAdmitted."),
    ("a file of its own that is none of its project", "From Other Require Import Tables."),
]]

QUICK = LEFTOVERS + SPECS + PAGES + EXTRACTION + LISTING + ELSEWHERE
SLOW = COMPILED + CHECKER + MEANING
