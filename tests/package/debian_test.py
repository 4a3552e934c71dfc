"""The Debian packages hold what they should, and what they hold runs."""

import os
import shutil
import subprocess
import unittest

from project import BUILD, CMAKE, PackageTest


@unittest.skipIf(shutil.which("dpkg-deb") is None or shutil.which("dpkg-shlibdeps") is None,
                 "not a Debian with dpkg-dev")
class Debian(PackageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cpack = os.path.join(os.path.dirname(CMAKE), "cpack")
        cls.run_program(cpack, "-G", "DEB", "--config", BUILD / "CPackConfig.cmake",
                        "-B", cls.folder)
        cls.command, = cls.folder.glob("certet_*.deb")
        cls.development, = cls.folder.glob("libcertet-dev_*.deb")
        cls.mpi = list(cls.folder.glob("certet-mpi_*.deb"))
        cls.parts = sorted(set(cls.folder.glob("certet-*.deb")) - set(cls.mpi))

    def listed(self, package, *files):
        listing = self.run_program("dpkg-deb", "-c", package)
        for file in files:
            self.assertIn(file, listing)

    def test_contents(self):
        self.listed(self.command, "./usr/bin/certet", "man1/certet.1", "man1/certet-mesh.1",
                    "bash-completion/completions/certet", "doc/certet/copyright")
        self.listed(self.development, "include/certet/stuffing.hpp", "certetConfig.cmake",
                    "pkgconfig/certet.pc", "doc/libcertet-dev/copyright")

    def test_dependencies(self):
        depends = self.run_program("dpkg-deb", "-f", self.command, "Depends")
        self.assertIn("libc6", depends)

    def test_parts(self):
        """What is heavy is in a package of its own, and only that one needs the library."""
        depends = self.run_program("dpkg-deb", "-f", self.command, "Depends")
        recommends = self.run_program("dpkg-deb", "-f", self.command, "Recommends")
        self.assertTrue(self.parts)
        for part in self.parts:
            name = part.name.split("_")[0]
            self.assertIn(name, recommends)
            self.listed(part, f"/certet/{name}.so", f"doc/{name}/copyright")
            own = self.run_program("dpkg-deb", "-f", part, "Depends")
            self.assertIn("certet (=", own)
            heavy = next(library for library in ("hdf5", "insighttoolkit", "assimp", "openvdb")
                         if library in own)
            self.assertNotIn(heavy, depends)

    def test_mpi(self):
        """The program of many processes, which alone needs MPI."""
        if not self.mpi:
            self.skipTest("it was not built")
        self.listed(self.mpi[0], "./usr/bin/certet-mpi", "doc/certet-mpi/copyright")
        self.assertIn("openmpi", self.run_program("dpkg-deb", "-f", self.mpi[0], "Depends"))
        for package in (self.command, *self.parts):
            self.assertNotIn("openmpi", self.run_program("dpkg-deb", "-f", package, "Depends"))

    def test_runs_from_a_scratch_root(self):
        root = self.folder / "root"
        self.run_program("dpkg", "-x", self.command, root)
        certet = root / "usr" / "bin" / "certet"
        self.assertIn("certet", self.run_program(certet, "--version"))
        mesh = (certet, "mesh", "--shape", "sphere:1", "--size", "0.5", "-o")
        self.run_program(*mesh, self.folder / "ball.vtu")
        lacks = subprocess.run([*mesh, self.folder / "ball.vtkhdf"], text=True, capture_output=True)
        self.assertEqual(lacks.returncode, 2, lacks)
        self.assertIn("certet-hdf5", lacks.stderr)
        self.assertFalse((self.folder / "ball.vtkhdf").exists())
        for part in self.parts:
            self.run_program("dpkg", "-x", part, root)
        self.run_program(*mesh, self.folder / "ball.vtkhdf")
        self.assertTrue((self.folder / "ball.vtkhdf").exists())


if __name__ == "__main__":
    unittest.main()
