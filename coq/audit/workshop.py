"""A copy of the compiled proofs in which defects are planted one after another."""

import re
import shutil
import subprocess
from pathlib import Path

from coq import ENVIRONMENT
from listing import sources

THEOREM = re.compile(r"(?:\(\*\*(?:(?!\*\)).)*\*\)\s*)?(?:Theorem|Lemma|Corollary) (\w+) :.*?Qed\.", re.S)

# Theorems whose proofs compile at once, and that between them speak of places, orders, signs,
# degrees, volumes and ranges.
KEPT = ("FaceTriangleOnce", "MidpointBoundsInDegrees", "WarpedLatticePositive",
        "DoorSuffices", "CornersInRange")


class CannotPlant(Exception):
    """The selftest itself is at fault: the defect could not be planted."""


class Workshop:
    def __init__(self, original, folder):
        self.root = Path(folder) / "coq"
        shutil.copytree(original, self.root)
        self.before = {}  # what a changed file held, or None if there was none

    # -- planting --

    def keep(self, path):
        self.before.setdefault(path, path.read_bytes() if path.exists() else None)

    def write(self, file, text):
        path = self.root / file
        self.keep(path)
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)

    def append(self, file, text):
        self.write(file, (self.root / file).read_text() + text + "\n")

    def edit(self, file, old, new):
        text = (self.root / file).read_text()
        if old not in text:
            raise CannotPlant(f"{file} does not hold: {old}")
        self.write(file, text.replace(old, new, 1))

    def link(self, file, target):
        path = self.root / file
        self.keep(path)
        path.symlink_to(target)

    def compile(self, *files, options=()):
        for file in files:
            stem = (self.root / file).with_suffix("")
            for made in (".vo", ".vok", ".vos", ".glob"):
                self.keep(stem.with_suffix(made))
            self.keep(stem.with_name(f".{stem.name}.aux"))
            done = subprocess.run(["coqc", "-q", *options, "-Q", ".", "Certet", file], cwd=self.root,
                                  env=ENVIRONMENT, text=True, capture_output=True, check=False)
            if done.returncode:
                raise CannotPlant(f"Coq refuses {file} by itself:\n{done.stderr}")

    def restore(self):
        for path, content in self.before.items():
            if content is None:
                path.unlink(missing_ok=True)
            else:
                path.write_bytes(content)
        self.before = {}

    def settle(self):
        """What was planted so far stays."""
        self.before = {}

    # -- asking --

    def audit(self, *arguments):
        return subprocess.run([self.root / "audit/audit", *arguments], cwd=self.root, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    # -- smaller copies of the project --

    def shorten(self):
        """Leaves of the last page the theorems that are KEPT, which is then what was agreed, and
        of those before it none."""
        # No proofs but theirs; and nothing of Mesh, which would have to follow every change of a Spec.
        for page in ("WholeMeshCertificate.v", "MaterialCertificate.v", "GradingCertificate.v",
                     "C15Certificate.v", "KeyCertificate.v"):
            self.shorten_page(page, r"Export (?!.*(?:Degrees|Range|\bMesh\.))")
        self.shorten_page("Certificate.v", "Export (?!Mesh)")

    def shorten_page(self, page, left):
        text = (self.root / page).read_text()
        text = re.sub(rf"From Certet Require (?!{left})[^\n]*\n", "", text)
        text = THEOREM.sub(lambda t: t.group() if t.group(1) in KEPT else "", text)
        modules = {Path(file).stem: file[:-2].replace("/", ".") for file in sources(self.root)}
        proofs = sorted({modules[m] for m in re.findall(r"exact (\w+)\.", text)})
        if proofs:
            text = text.replace("\nOpen Scope", f"\nFrom Certet Require {' '.join(proofs)}.\nOpen Scope", 1)
        self.write(page, text)
        self.compile(page)

    def only(self, *files):
        """Leaves of _CoqProject these files."""
        self.write("_CoqProject", "\n".join(["-Q . Certet", *files, ""]))
