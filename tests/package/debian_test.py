"""The Debian packages hold what they should, and what they hold runs."""

import os
import shutil
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

    def test_runs_from_a_scratch_root(self):
        root = self.folder / "root"
        self.run_program("dpkg", "-x", self.command, root)
        certet = root / "usr" / "bin" / "certet"
        self.assertIn("certet", self.run_program(certet, "--version"))


if __name__ == "__main__":
    unittest.main()
