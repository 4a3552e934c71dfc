"""A machine that fails while the program runs: disk, memory, signals, slow reads."""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import threading
import unittest

from guarded import (BAD_INPUT, INTERRUPTED, OK, TOO_LARGE, USAGE, WRITE_FAILED,
                     GuardedTest, contents, limits)
from images import voxels, write_nrrd

SIZE = (24, 24, 24)
BALL = ["--shape", "sphere:1", "--size", "0.05"]
MEBI = 2 ** 20
SHORT_READS = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <unistd.h>
static ssize_t (*real)(int, void *, size_t);
static unsigned turn;
ssize_t read(int file, void *to, size_t size) {
  if (!real) real = (ssize_t (*)(int, void *, size_t))dlsym(RTLD_NEXT, "read");
  if (++turn % 13 == 0) { errno = EINTR; return -1; }
  return real(file, to, size < 7 ? size : 7);
}
"""


class FaultTest(GuardedTest):
    """`self.runs` are command lines by name, whose result is the file `out` + suffix."""

    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "a.nrrd", SIZE,
                   voxels(SIZE, lambda i, j, k: (i // 7 + j // 9 + k // 8) % 3))
        write_nrrd(self.folder / "sizes.nrrd", (9, 9, 9),
                   voxels((9, 9, 9), lambda i, j, k: 0.1 + 0.03 * i), kind="f",
                   directions=((0.3, 0, 0), (0, 0.3, 0), (0, 0, 0.3)), origin=(-1.2,) * 3)
        self.runs = {
            "image": ["mesh", "a.nrrd", "-o", "out.vtu"],
            "formula": ["mesh", "--expr", "x^2+y^2+z^2-1", "--bounds", "-1,-1,-1,1,1,1",
                        "--size", "0.1", "-o", "out.vtu"],
            "graded": ["mesh", *BALL, "--size-field", "sizes.nrrd", "-o", "out.vtu"],
            "check": ["check", "m.vtu"],
            "convert": ["convert", "m.vtu", "out.msh"],
            "report": ["report", "m.vtu", "-o", "out.html"],
        }

    def make_mesh(self, size="0.1"):
        run = self.guarded("mesh", "--shape", "sphere:1", "--size", size, "-o", "m.vtu")
        self.assertEqual(run.status, OK, run.err)

    def take_output(self, before):
        """What a run that succeeded has added, which is removed."""
        new = {name: digest for name, digest in contents(self.folder).items()
               if before.get(name) != digest}
        for name in new:
            self.assertRegex(name, r"\Aout\.\w+\Z")
            (self.folder / name).unlink()
        self.assertEqual(contents(self.folder), before)
        return new

    def succeeds_or_fails(self, truth, statuses, arguments, **settings):
        """The right bytes, or one of the statuses and no trace."""
        before = contents(self.folder)
        run = self.guarded(*arguments, **settings)
        if run.status == OK:
            self.assertEqual(self.take_output(before), truth)
        else:
            self.assert_failed(run, statuses, before)
        return run.status

    def truth(self, arguments):
        before = contents(self.folder)
        run = self.guarded(*arguments)
        self.assertEqual(run.status, OK, run.err)
        return self.take_output(before)


class Disk(FaultTest):
    def test_full(self):
        """A limit on the size of a file; with an older output in place."""
        self.make_mesh()
        for name in ("out.vtu", "out.msh", "out.html"):
            (self.folder / name).write_text("older")
        for name in ("image", "formula", "graded", "convert", "report"):
            for size in (512, 4096, 20_000):  # the sentence needs room too
                with self.subTest(name, size=size):
                    self.assert_clean_failure((WRITE_FAILED,), *self.runs[name],
                                              prepare=limits(file_size=size))

    def test_small_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "none", disk],
                                 capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("no disk can be mounted here")
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        for output in ("out.vtu", "out.msh", "out.mesh", "out.stl"):
            with self.subTest(output):
                self.assert_clean_failure((WRITE_FAILED,), "mesh", *BALL, "-o",
                                          f"disk/{output}")

    def test_standard_output_full(self):
        with open("/dev/full", "w") as full:
            run = subprocess.run([self.program, "mesh", *BALL, "--dry-run", "--json", "-"],
                                 stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(run.returncode, WRITE_FAILED)
        self.assertRegex(run.stderr, r"\Acertet: [^\n]+\n\Z")


class Targets(FaultTest):
    def test_closed_folder(self):
        """As a user who may not write there; root becomes nobody."""
        self.folder.chmod(0o555)
        program = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, program)
        program.chmod(0o755)
        shutil.copy(self.program, program / "certet")
        self.program = str(program / "certet")

        def become_nobody():
            if os.geteuid() == 0:
                os.setgid(65534)
                os.setuid(65534)

        self.assert_clean_failure((WRITE_FAILED,), "mesh", *BALL, "-o", "out.vtu",
                                  prepare=become_nobody)
        self.folder.chmod(0o755)

    def test_folder(self):
        self.make_mesh()
        for name in ("out.vtu", "out.msh", "out.html"):
            (self.folder / name).mkdir()
        for name in ("image", "convert", "report"):
            with self.subTest(name):
                self.assert_clean_failure((WRITE_FAILED,), *self.runs[name])

    def test_the_input(self):
        self.make_mesh()
        os.link(self.folder / "m.vtu", self.folder / "hard.vtu")
        os.symlink("m.vtu", self.folder / "soft.vtu")
        for name in ("m.vtu", "hard.vtu", "soft.vtu"):
            with self.subTest(name):
                self.assert_clean_failure((USAGE,), "convert", "m.vtu", name)


class Memory(FaultTest):
    """The address space, from too little to start with to enough."""

    STEPS = 24

    def test_sweep(self):
        self.make_mesh()
        for name, arguments in self.runs.items():
            truth, statuses = self.truth(arguments), set()
            for step in range(self.STEPS):
                # Below some 150 MB the libraries of images give up before the program begins.
                space = int(100 * MEBI * 20 ** (step / (self.STEPS - 1)))
                if self.guarded("--version", prepare=limits(address_space=space)).status:
                    continue
                with self.subTest(name, space=space):
                    statuses.add(self.succeeds_or_fails(
                        truth, (TOO_LARGE,), arguments, prepare=limits(address_space=space)))
            self.assertIn(OK, statuses, name)


class SignalsAtAnyTime(FaultTest):
    def test_random_moments(self):
        self.make_mesh("0.05")
        seed = int(os.environ.get("CERTET_SEED", random.randrange(2 ** 32)))
        print(f"seed {seed}")
        chance = random.Random(seed)
        truths = {name: self.truth(arguments) for name, arguments in self.runs.items()}
        for turn in range(40):
            name = chance.choice(sorted(self.runs))
            sent = chance.choice((signal.SIGINT, signal.SIGTERM))
            moment = chance.uniform(0, 0.3)
            with self.subTest(name, sent=sent, moment=moment):
                before = contents(self.folder)
                run = self.guarded(*self.runs[name], signal_after=(sent, moment))
                if run.status == -sent:  # before the program minds signals, or after
                    self.assertEqual(run.err, "")
                    self.take_output(before)
                elif run.status == OK:
                    self.assertEqual(self.take_output(before), truths[name])
                else:
                    self.assert_failed(run, (INTERRUPTED,), before)


class Reads(FaultTest):
    def test_short(self):
        compiler = shutil.which("cc")
        if not compiler:
            self.skipTest("there is no C compiler")
        with tempfile.TemporaryDirectory() as place:
            source = pathlib.Path(place) / "short.c"
            source.write_text(SHORT_READS)
            library = source.with_suffix(".so")
            subprocess.run([compiler, "-shared", "-fPIC", "-o", library, source, "-ldl"],
                           check=True)
            self.make_mesh("0.2")
            for name, arguments in self.runs.items():
                with self.subTest(name):
                    truth = self.truth(arguments)
                    self.assertEqual(OK, self.succeeds_or_fails(
                        truth, (), arguments, environment={"LD_PRELOAD": str(library)}))

    def test_pipe(self):
        """A mesh through a pipe: converted, or refused in good order."""
        self.make_mesh("0.2")
        data = (self.folder / "m.vtu").read_bytes()
        truth = self.truth(self.runs["convert"])
        os.mkfifo(self.folder / "p.vtu")

        def feed():
            try:
                (self.folder / "p.vtu").write_bytes(data)
            except BrokenPipeError:
                pass

        writer = threading.Thread(target=feed, daemon=True)
        writer.start()
        self.succeeds_or_fails(truth, (BAD_INPUT,), ["convert", "p.vtu", "out.msh"])


class FaultsNotices(FaultTest):
    """A program with each of the faults is refused."""

    FAULTS = (
        ("echo x > out.vtu\n", "digest"),
        ("exit 0\n", "digest"),
        ("echo x > .tmp\n", "tmp"),
        ("echo x >> a.nrrd\n", "a.nrrd"),
        ("echo x > out.vtu; echo 'certet: a.' >&2; exit 5\n", "out.vtu"),
        ("exit 5\n", "Regex didn't match"),
        ("kill -ABRT $$\n", "-6 not found"),
    )

    def test_faults(self):
        self.assert_noticed(self.FAULTS, lambda: self.succeeds_or_fails(
            {"out.vtu": "digest"}, (TOO_LARGE,), self.runs["image"]))


if __name__ == "__main__":
    unittest.main()
