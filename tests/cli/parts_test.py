"""Heavy libraries are in modules of the program, loaded when an input or output wants them."""

import os
import pathlib
import shutil
import subprocess
import unittest

import program
from images import write_nrrd, voxels
from program import ProgramTest
from surfaces import cube, stl

PARTS = pathlib.Path(program.CERTET).resolve().parents[1] / "lib" / "certet"
HEAVY = ("libITK", "libgdcm", "libhdf5", "libassimp", "libopenvdb", "libtiff")
BALL = ("--shape", "sphere:1", "--size", "0.5")


def loaded_by(file):
    """What the system's loader would load, by its own word."""
    environment = os.environ | {"LD_TRACE_LOADED_OBJECTS": "1"}
    loader = ["/lib64/ld-linux-x86-64.so.2"] if file.suffix == ".so" else []
    return subprocess.run([*loader, file], env=environment, text=True, capture_output=True,
                          check=True).stdout


@unittest.skipUnless(PARTS.is_dir(), "the program is linked with all that it needs")
class Parts(ProgramTest):
    def use_copy(self):
        """From here on, a copy of the program and its parts, in folders of its own."""
        bin_folder, self.parts = self.folder / "bin", self.folder / "lib" / "certet"
        bin_folder.mkdir()
        shutil.copytree(PARTS, self.parts)
        self.addCleanup(setattr, program, "CERTET", program.CERTET)
        program.CERTET = shutil.copy(program.CERTET, bin_folder)

    def test_starts_without_heavy_libraries(self):
        own = loaded_by(pathlib.Path(program.CERTET))
        self.assertIn("libstdc++", own)
        for library in HEAVY:
            self.assertNotIn(library, own)

    def test_each_heavy_library_is_in_a_part(self):
        """Else the test above would look for the wrong names."""
        parts = "".join(loaded_by(part) for part in PARTS.glob("*.so"))
        self.assertTrue([library for library in HEAVY if library in parts])

    def test_works_wherever_it_is_copied(self):
        self.use_copy()
        write_nrrd(self.folder / "a.nrrd", (6, 6, 6), voxels((6, 6, 6), lambda i, j, k: 1))
        self.mesh("a.nrrd", "-o", "a.vtu")
        (self.folder / "a.stl").write_bytes(stl(cube()))
        self.mesh("a.stl", "-o", "b.vtkhdf")

    def test_a_part_that_is_not_installed(self):
        self.use_copy()
        shutil.rmtree(self.parts)
        write_nrrd(self.folder / "a.nrrd", (6, 6, 6), voxels((6, 6, 6), lambda i, j, k: 1))
        (self.folder / "a.stl").write_bytes(stl(cube()))
        self.mesh(*BALL, "-o", "ball.vtu")
        self.assert_fails(2, ["certet-images"], "mesh", "a.nrrd", "-o", "a.vtu")
        self.assert_fails(2, ["certet-surfaces"], "mesh", "a.stl", "-o", "a.vtu")
        self.assert_fails(2, ["certet-hdf5"], "mesh", *BALL, "-o", "a.vtkhdf")
        self.assert_fails(2, ["certet-hdf5"], "mesh", *BALL, "-o", "a.xdmf")
        self.assert_fails(2, ["certet-hdf5"], "convert", "ball.vtu", "a.xdmf")

    def test_a_part_of_another_version(self):
        self.use_copy()
        version = self.run_certet("--version").stdout.split()[-1]
        part = self.parts / "certet-hdf5.so"
        old = b"\0" + version.encode() + b"\0"
        self.assertIn(old, part.read_bytes())
        part.write_bytes(part.read_bytes().replace(old, b"\0" + b"9" + old[2:]))
        self.assert_fails(2, ["certet-hdf5", version], "mesh", *BALL, "-o", "a.vtkhdf")

    def test_what_is_no_part(self):
        self.use_copy()
        (self.parts / "certet-hdf5.so").write_text("a text")
        self.assert_fails(2, ["certet-hdf5"], "mesh", *BALL, "-o", "a.vtkhdf")


if __name__ == "__main__":
    unittest.main()
