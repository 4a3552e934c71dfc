"""Runs a program in a folder and sees what it leaves behind."""

import dataclasses
import hashlib
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import time
import unittest

from program import CERTET

OK, CHECK_FAILED, USAGE, BAD_INPUT, EMPTY, TOO_LARGE, WRITE_FAILED = range(7)
INTERRUPTED = 130
SENTENCE = re.compile(r"\Acertet: [^\n]+\n\Z")


@dataclasses.dataclass
class Run:
    status: int  # negative: the signal that ended it
    out: str
    err: str
    peak: int  # bytes resident


def contents(folder):
    """What a folder holds: the digest of each file by its name."""
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest()
            if p.is_file() else "other" for p in sorted(folder.rglob("*"))}


def limits(address_space=None, file_size=None):
    """A `preexec_fn` that sets limits, in bytes."""
    def apply():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        for name, value in (("RLIMIT_AS", address_space), ("RLIMIT_FSIZE", file_size)):
            if value is not None:
                resource.setrlimit(getattr(resource, name), (value, value))
    return apply


class GuardedTest(unittest.TestCase):
    """Each test has an empty folder, `self.folder`, and a program, `self.program`."""

    program = CERTET

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def guarded(self, *arguments, prepare=limits(), signal_after=None, environment=None,
                folder=None, timeout=60):
        """Runs the program; `signal_after` is (a signal, seconds)."""
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            child = subprocess.Popen(
                [self.program, *map(str, arguments)], cwd=folder or self.folder, stdout=out,
                stderr=err, stdin=subprocess.DEVNULL, preexec_fn=prepare,
                env={**os.environ, **(environment or {})})
            started = time.monotonic()
            while True:
                pid, status, usage = os.wait4(child.pid, os.WNOHANG)
                if pid:
                    break
                elapsed = time.monotonic() - started
                if signal_after and elapsed >= signal_after[1]:
                    child.send_signal(signal_after[0])
                    signal_after = None
                if elapsed > timeout:
                    child.kill()
                    child.wait()
                    self.fail(f"{arguments} hangs")
                time.sleep(0.002)
            child.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0), err.seek(0)
            return Run(child.returncode, out.read().decode(errors="replace"),
                       err.read().decode(errors="replace"), usage.ru_maxrss * 1024)

    def assert_clean_failure(self, statuses, *arguments, **settings):
        """One of the statuses, one sentence, and a folder as it was."""
        before = contents(self.folder)
        run = self.guarded(*arguments, **settings)
        self.assert_failed(run, statuses, before)
        return run

    def assert_failed(self, run, statuses, before):
        self.assertIn(run.status, statuses, run.err[:300])
        self.assertRegex(run.err, SENTENCE)
        self.assertEqual(contents(self.folder), before)

    def assert_noticed(self, faults, refuse):
        """Each fault of a program is refused, in a folder of its own.

        Parameters
        ----------
        faults : of each a shell script in the place of the program, and words of what is said of it
        refuse : runs the program and fails
        """
        for script, words in faults:
            with self.subTest(script):
                self.setUp()
                (self.folder / "bin").mkdir()
                self.program = fake_program(self.folder / "bin", script)
                with self.assertRaisesRegex(AssertionError, words):
                    refuse()


def fake_program(folder, script):
    """A shell script in the place of `certet`; its arguments end with `-o OUTPUT`."""
    path = folder / "fake"
    path.write_text("#!/bin/sh\n" + script)
    path.chmod(0o755)
    return str(path)
