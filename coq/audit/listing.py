"""Which files there are, and that what is compiled was made from them as agreed."""

import hashlib
import re
import tempfile
from pathlib import Path

from coq import run
from rules import PAGES, Refused, short_names

# Files that stand beside the listed sources.
BESIDE = {"Makefile", "README.md", "_CoqProject", "extract", "Extraction.v"} | {f"audit/{name}" for name in (
    "README.md", "audit", "coq.py", "listing.py", "rules.py", "selftest", "attacks.py", "workshop.py", "terms.py",
    "vernacular.py", "Walk.v", *(f"{about}.expected" for about in (
        "assumptions", "checker", "definitions", "library", "plugins", "statements")))}
GENERATED = {"Makefile.coq", "Makefile.coq.conf", ".Makefile.coq.d", ".lia.cache", ".nia.cache", ".nra.cache"}
COMPILED = re.compile(r"(.*/)?(\.(?P<hidden>\w+)\.aux|(?P<plain>\w+)\.(vo|vok|vos|glob))")

# What a .glob file may tell of: definitions, types with constructors and fields, theorems, sections
# with variables, and notations, which only proofs may hold.
DEFINED = {"def", "ind", "constr", "rec", "proj", "prf"}
KNOWN = DEFINED | {"sec", "var", "binder", "not", "abbrev", "scheme"}


def listed(root):
    return (root / "_CoqProject").read_text().split("\n")


def sources(root):
    """The files of the project, in the order of _CoqProject."""
    return [line for line in listed(root) if line.endswith(".v")]


def belongs(name, files):
    compiled = COMPILED.fullmatch(name)
    if not compiled:
        return name in files | BESIDE | GENERATED
    stem = (compiled.group(1) or "") + (compiled.group("hidden") or compiled.group("plain"))
    return stem + ".v" in files


def check_tree(root):
    """_CoqProject lists every source, every source is listed, and there is nothing else."""
    files = sources(root)
    present = {str(p.relative_to(root)) for p in root.rglob("*") if p.is_symlink() or not p.is_dir()}
    strange = sorted(name for name in present if not belongs(name, set(files)))
    if strange:
        raise Refused("\n".join(strange) + "\n_CoqProject lists no such file, and none belongs here.")
    missing = sorted(set(files) - present)
    if missing or len(files) != len(set(files)):
        raise Refused("\n".join(missing) + "\n_CoqProject lists a file that is not there, or one twice.")
    links = sorted(name for name in present if (root / name).is_symlink())
    if links:
        raise Refused("\n".join(links) + "\na link may lead out of what was agreed.")


def check_options(root):
    """Coq is run with no options but the name of the project."""
    options = [line for line in listed(root) if line and not re.fullmatch(r"(\w+/)*\w+\.v", line)]
    if options != ["-Q . Certet"]:
        raise Refused("\n".join(options) + "\n_CoqProject gives Coq other options than -Q . Certet.")
    odd = [line for line in (root / "Makefile").read_text().splitlines()
           if re.search(r"COQ[A-Z_]+|OTHERFLAGS|\binclude\b|\bcoqc\b|\bexport\b", line)]
    if odd:
        raise Refused("\n".join(odd) + "\nthe Makefile gives Coq options of its own.")


def check_compiled(root):
    """Everything was compiled from the sources as they are, and as _CoqProject says."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "_CoqProject").write_bytes((root / "_CoqProject").read_bytes())
        run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile.coq"], folder)
        for name in ("Makefile.coq", "Makefile.coq.conf"):
            if (Path(folder) / name).read_bytes() != (root / name).read_bytes():
                raise Refused(f"{name}\nthe proofs were made by other rules than coq_makefile gives.")
    for file in sources(root):
        digest = hashlib.md5((root / file).read_bytes()).hexdigest()
        if glob(root, file)[0] != f"DIGEST {digest}":
            raise Refused(f"{file}\nit was changed after it was compiled; run make.")


def glob(root, file):
    """The lines that Coq wrote of the names in a file when it compiled it."""
    path = (root / file).with_suffix(".glob")
    if not path.exists():
        raise Refused(f"{file}\nit is not compiled; run make.")
    return path.read_text(errors="surrogateescape").splitlines()


def check_names(root, exported):
    """No file declares what none may, and no two that readers import define the same name."""
    owner = {}
    for file in sources(root):
        for line in glob(root, file)[2:]:
            kind, _, _, name = (line.split(" ") + [""] * 4)[:4]
            if re.fullmatch(r"R\d+:\d+", kind):
                continue
            if kind not in KNOWN:
                raise Refused(f"{file}: {line}\nCoq calls this neither a definition, a type nor a theorem.")
            if file not in [*exported, *PAGES]:
                continue
            if kind == "abbrev" and name in short_names(root, file):
                continue
            if kind in ("not", "abbrev"):
                raise Refused(f"{file}: {line}\nCoq calls this a notation, and readers import it.")
            if kind not in DEFINED:
                continue
            if name in owner:
                raise Refused(f"{name}: {owner[name]}, {file}\ntwo files that readers import define one name.")
            owner[name] = file
