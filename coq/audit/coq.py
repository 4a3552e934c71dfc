"""Asks Coq, and its independent checker, about the compiled proofs."""

import os
import re
import subprocess
from pathlib import Path

from rules import Refused
from terms import Printer, parse

# Nothing from outside may change what Coq reads.
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith("COQ") and k != "OCAMLRUNPARAM"}


class NoAnswer(Exception):
    """Coq does not accept a question; the message is Coq's."""


def run(command, folder):
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)


class Coq:
    """The compiled proofs in root, asked from a work folder of their own."""

    def __init__(self, root, work):
        self.root, self.work = root, Path(work)

    def compile(self, name, text):
        (self.work / f"{name}.v").write_text(text)
        answer = run(["coqc", "-q", "-Q", str(self.root), "Certet", "-Q", ".", "Audit", f"{name}.v"], self.work)
        if answer.returncode:
            raise NoAnswer(answer.stdout)
        return answer.stdout

    def ask(self, question, imports=""):
        """What Coq answers with the last page at hand, which has the others, but no short name of it."""
        return self.compile("Question", "From Certet Require Certificate.\nFrom Ltac2 Require Ltac2.\n"
                            f"{imports}\nSet Printing Width 78.\n{question}\n")

    def plugins(self):
        """The OCaml code that the compiled proofs make Coq load."""
        answer = self.compile("Plugins", "From Certet Require Certificate.\nPrint ML Modules.\n")
        return sorted(re.findall(r"\S+\.cm\w+", answer))

    def assumptions(self, theorems):
        """Coq's answer for each theorem, with axioms by their full names, and those names."""
        answer = self.ask("\n".join(f'Goal True. idtac "{t.split(".")[1]}". Abort. Print Assumptions Certet.{t}.'
                                    for t in theorems))
        # An axiom: a name that begins a line, and its type after it.
        short = sorted(set(re.findall(r"^(\S+)(?= :|\n +:)", answer, re.M)))
        full = dict(zip(short, self.full_names(short)))
        answer = re.sub(r"^(\S+)(?: :|\n +:)(?:.*\n)(?:\s.*\n)*", lambda m: full[m.group(1)] + "\n", answer,
                        flags=re.M)
        return answer, sorted(full.values())

    def full_names(self, short):
        """Names as Coq prints them, in full."""
        if not short:
            return []
        answer = self.walk_question("".join(f"Ltac2 Eval Message.print (name reference:({n})).\n" for n in short))
        return [line for line in answer.splitlines() if not line.startswith("- :")]

    def walk_question(self, question, imports=""):
        walk = Path(__file__).resolve().parent / "Walk.v"
        self.compile("Walk", walk.read_text())
        return self.ask(f"From Ltac2 Require Import Ltac2.\nFrom Audit Require Import Walk.\n{question}", imports)

    def walk(self, theorems, names, imports=""):
        """Statements, and all that they and these names reach: (name, kind, text)."""
        def references(qualified):
            return "[" + "; ".join(f"reference:({name})" for name in qualified) + "]"
        statements = references(f"Certet.{t}" for t in theorems)
        answer = self.walk_question(f"Ltac2 Eval walk {statements} {references(names)}.", imports)
        trees = [parse(line) for line in answer.splitlines() if line.startswith("(")]
        printer = Printer(trees)
        return [(tree[1], tree[0], printer.text(tree)) for tree in trees]

    def check(self, modules):
        """What coqchk finds in these modules; those of the standard library it takes as installed."""
        command = ["coqchk", "-silent", "-o", "-Q", ".", "Certet"]
        if "bytecode-compiler" in run(["coqchk", "--help"], self.root).stdout:
            command += ["-bytecode-compiler", "yes"]
        for module in modules:
            command += ["-norec", f"Certet.{module}"]
        answer = run(command, self.root)
        if answer.returncode:
            raise Refused(answer.stdout + "coqchk does not accept the compiled proofs.")
        return answer.stdout
