"""A rank that fails or dies ends all of them, in one sentence, and leaves no file."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from images import voxels, write_nrrd
from job import CERTET_MPI, JobTest, command, said

USAGE, BAD_INPUT, TOO_LARGE, WRITE_FAILED = 2, 3, 5, 6
BALL = ["--shape", "sphere:1", "--size", "0.1"]


def ranks_of(job):
    """Process numbers of the ranks that a running mpirun has."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            status = (entry / "stat").read_text().rsplit(")", 1)[1].split()
            program = (entry / "exe").readlink()
        except OSError:
            continue
        if int(status[1]) == job.pid and program == pathlib.Path(CERTET_MPI).resolve():
            found.append(int(entry.name))
    return found


class Faults(JobTest):
    def assert_refused(self, status, words, run, before=()):
        self.assertEqual(run.returncode, status, run.stderr)
        sentences = said(run.stderr)
        self.assertEqual(len(sentences), 1, run.stderr)
        self.assertRegex(sentences[0], words)
        self.assertEqual({p.name for p in self.folder.iterdir()}, set(before))

    def job_of_each(self, before, ranks, *arguments):
        """Each process runs a line of shell before it becomes a rank."""
        line = command(ranks, *arguments)
        at = line.index(CERTET_MPI)
        line = [*line[:at], "sh", "-c", before + '; exec "$@"', "sh", *line[at:]]
        return subprocess.run(line, cwd=self.folder, capture_output=True, text=True, timeout=120)

    def test_an_input_that_is_not_there(self):
        self.assert_refused(BAD_INPUT, "none.nrrd", self.job(3, "mesh", "none.nrrd", "-o", "a.vtu"))

    def test_an_input_that_one_rank_cannot_see(self):
        """Each looks in a folder of its own; the second one's is empty."""
        for name in ("0", "1"):
            (self.folder / name).mkdir()
        size = (8, 8, 8)
        write_nrrd(self.folder / "0" / "cube.nrrd", size, voxels(size, lambda i, j, k: 1))
        run = self.job_of_each('cd "$OMPI_COMM_WORLD_RANK"', 2, "mesh", "cube.nrrd", "-o",
                               self.folder / "a.vtu")
        self.assert_refused(BAD_INPUT, "cube.nrrd", run, before=("0", "1"))

    def test_a_folder_that_is_not_there(self):
        self.assert_refused(WRITE_FAILED, "there is no such folder",
                            self.job(3, "mesh", *BALL, "-o", "none/a.vtu"))

    def test_a_disk_that_is_full_for_one(self):
        """The last rank may not write beyond so many bytes (8 MiB)."""
        run = self.job_of_each('[ "$OMPI_COMM_WORLD_RANK" != 2 ] || ulimit -f 16384', 3, "mesh",
                               "--shape", "sphere:1", "--size", "0.04", "-o", "a.vtu")
        self.assert_refused(WRITE_FAILED, "cannot write 'a.vtu'", run)

    def test_what_several_cannot_do(self):
        for more in (["-o", "a.msh"], ["-o", "a.vtu", "--optimise"], ["-o", "a.vtu", "--order", "2"],
                     ["-o", "a.vtu", "--distance"], ["-o", "a.vtu", "--features", "30"]):
            self.assert_refused(USAGE, "certet mesh does", self.job(2, "mesh", *BALL, *more))

    def test_wrong_usage(self):
        self.assert_refused(USAGE, "--no-such", self.job(2, "mesh", "--no-such"))

    def test_more_ranks_than_layers(self):
        run = self.job(7, "mesh", "--shape", "sphere:1", "--size", "2", "--margin", "1",
                       "-o", "a.vtu")
        self.assert_refused(USAGE, "7 ranks", run)

    def kill_one(self, which, number):
        """Once they write."""
        job = subprocess.Popen(command(3, "mesh", "--shape", "sphere:1", "--size", "0.015", "-o",
                                       "a.vtu", "--threads", "1"),
                               cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               text=True)
        self.addCleanup(job.stderr.close)
        end = time.monotonic() + 60
        while not list(self.folder.iterdir()):
            self.assertIsNone(job.poll(), "it ended before it wrote")
            self.assertLess(time.monotonic(), end, "it did not begin to write")
            time.sleep(0.005)
        ranks = sorted(ranks_of(job))
        self.assertEqual(len(ranks), 3)
        os.kill(ranks[which], number)
        err = job.communicate(timeout=60)[1]
        self.assertNotEqual(job.returncode, 0)
        self.assertEqual(said(err), [])  # mpirun has said which rank was killed
        # mpirun may be gone before the ranks that it has ended.
        end = time.monotonic() + 60
        while list(self.folder.iterdir()) and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(list(self.folder.iterdir()), [])
        for rank in ranks:
            self.assertFalse(pathlib.Path(f"/proc/{rank}/exe").exists(), "a rank lives on")
        return err

    def test_a_rank_that_is_killed(self):
        for which in (0, 2):
            self.assertRegex(self.kill_one(which, signal.SIGKILL), "signal 9")


if __name__ == "__main__":
    unittest.main()
