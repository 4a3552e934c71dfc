"""Configures, builds and installs in scratch folders."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["CERTET_SOURCE"])
BUILD = pathlib.Path(os.environ["CERTET_BUILD"])
CMAKE = os.environ.get("CMAKE", "cmake")
EXAMPLES = SOURCE / "cpp" / "examples"


class PackageTest(unittest.TestCase):
    """Each test class has a folder, `self.folder`, shared by its tests."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    @classmethod
    def run_program(cls, *arguments, **settings):
        """Runs a program, which must succeed; returns its output."""
        run = subprocess.run([str(a) for a in arguments], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, timeout=1500, **settings)
        if run.returncode != 0:
            raise AssertionError(f"{arguments}: status {run.returncode}\n{run.stdout[-4000:]}")
        return run.stdout

    @classmethod
    def configure_and_build(cls, source, name, *options, target="all"):
        """Builds a project in a folder of its own, which is returned."""
        build = cls.folder / name
        cls.run_program(CMAKE, "-S", source, "-B", build, "-G", "Ninja", *options)
        cls.run_program(CMAKE, "--build", build, "-j", "2", "--target", target)
        return build
