"""Runs `certet` in a folder of its own."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

CERTET = os.environ.get("CERTET", "certet")
TORUS = ["--expr", "(sqrt(x^2+y^2)-1)^2+z^2-0.16", "--bounds", "-1.5,-1.5,-0.5,1.5,1.5,0.5"]


class ProgramTest(unittest.TestCase):
    """Each test has an empty folder, `self.folder`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_certet(self, *arguments, **settings):
        return subprocess.run(
            [CERTET, *map(str, arguments)], cwd=self.folder, text=True,
            capture_output=True, timeout=300, **settings)

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def mesh(self, *arguments):
        """Runs `certet mesh`, which must succeed; returns its JSON."""
        run = self.run_certet("mesh", *arguments, "--json", "-")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def check(self, file):
        """Runs `certet check`, which must succeed; returns its JSON."""
        run = self.run_certet("check", file, "--json", "-")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return json.loads(run.stdout)

    def assert_fails(self, status, words, *arguments, **settings):
        """One sentence on stderr with all the words, the status, and no new file."""
        before = self.files()
        run = self.run_certet(*arguments, **settings)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"\Acertet: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertEqual(self.files(), before)
