"""Runs certet-mpi by mpirun."""

import os
import subprocess

from program import ProgramTest

MPIRUN = os.environ.get("MPIRUN", "mpirun")
CERTET_MPI = os.environ["CERTET_MPI"]
# More processes than processors, as root in a container, each wherever there is room.
OPTIONS = ["--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "--mca",
           "mpi_yield_when_idle", "1"]
SPEAKER = "certet-mpi: "


def command(ranks, *arguments):
    return [MPIRUN, *OPTIONS, "-n", str(ranks), CERTET_MPI, *map(str, arguments)]


def said(err):
    """What certet-mpi has said; mpirun says that a job has failed in words of its own."""
    return [line for line in err.splitlines() if line.startswith(SPEAKER)]


class JobTest(ProgramTest):
    def job(self, ranks, *arguments, timeout=120):
        return subprocess.run(command(ranks, *arguments), cwd=self.folder, capture_output=True,
                              text=True, timeout=timeout)
