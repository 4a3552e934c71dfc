"""Man pages and completion know every option that the help knows."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

CERTET = os.environ["CERTET"]
MANUAL = pathlib.Path(os.environ["CERTET_BUILD"]) / "manual"


def run(*arguments):
    return subprocess.run([str(a) for a in arguments], text=True, capture_output=True)


def help_of(*command):
    return run(CERTET, *command, "--help").stdout


def commands():
    listed = help_of().split("Subcommands:")[1].split("\n\n")[0]
    return re.findall(r"^  ([a-z][a-z-]*)", listed, re.MULTILINE)


def options(command):
    """The names at the beginning of the lines of the help."""
    lines = re.findall(r"^  (-.*)", help_of(*command), re.MULTILINE)
    return {name for line in lines
            for name in re.findall(r"(?<![\w-])--?[a-z][a-z-]*", line.split("  ")[0])}


def pages():
    return [(), *((name,) for name in commands())]


class ManPages(unittest.TestCase):
    def page(self, command):
        return MANUAL / "man1" / ("-".join(["certet", *command]) + ".1")

    def test_every_option(self):
        self.assertIn("mesh", commands())
        self.assertIn("--output", options(["mesh"]))
        for command in pages():
            text = self.page(command).read_text().replace("\\-", "-")
            for option in options(command):
                self.assertIn(f"\\fB{option}\\fR", text, command)

    @unittest.skipIf(shutil.which("mandoc") is None, "no mandoc")
    def test_lint(self):
        for command in pages():
            found = run("mandoc", "-Tlint", "-Wwarning", self.page(command))
            self.assertEqual(found.stdout + found.stderr, "")

    @unittest.skipIf(shutil.which("groff") is None, "no groff")
    def test_groff_has_no_complaint(self):
        for command in pages():
            found = run("groff", "-man", "-Tutf8", "-ww", self.page(command))
            self.assertEqual((found.returncode, found.stderr), (0, ""))


class Bash(unittest.TestCase):
    def complete(self, *words):
        script = (f"source {MANUAL}/bash/certet; COMP_WORDS=(certet {' '.join(words)}); "
                  "[ -n \"$1\" ] || COMP_WORDS+=(''); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); "
                  "_certet; printf '%s\\n' \"${COMPREPLY[@]}\"")
        found = run("bash", "-c", script, "-", words[-1] if words else "")
        self.assertEqual(found.stderr, "")
        return set(found.stdout.split())

    def test_commands(self):
        self.assertEqual(self.complete("me"), {"mesh"})
        self.assertEqual(self.complete(), set(commands()))

    def test_options(self):
        for command in commands():
            self.assertEqual(self.complete(command, "--"),
                             {o for o in options([command]) if o.startswith("--")})
            self.assertLessEqual(options([command]), self.complete(command, "-"))
        self.assertEqual(self.complete("mesh", "--out"), {"--output"})

    def test_choices(self):
        self.assertEqual(self.complete("mesh", "--cuts", "b"), {"bisect"})
        self.assertEqual(self.complete("convert", "--origin", ""), {"world", "0"})


class OtherShells(unittest.TestCase):
    def test_every_option(self):
        zsh = (MANUAL / "zsh" / "_certet").read_text()
        fish = (MANUAL / "fish" / "certet.fish").read_text()
        for command in pages():
            for option in options(command):
                self.assertIn(f"'{option}[", zsh)
                self.assertRegex(fish, rf"-[ls] {option.lstrip('-')}\b")

    def test_syntax(self):
        for shell, file in (("zsh", "zsh/_certet"), ("fish", "fish/certet.fish"),
                            ("bash", "bash/certet")):
            if shutil.which(shell):
                found = run(shell, "-n", MANUAL / file)
                self.assertEqual((found.returncode, found.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
