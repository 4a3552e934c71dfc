"""Runs `certet` on surfaces, where it was built to read them."""

import surfaces
from program import ProgramTest


class SurfaceProgramTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "probe.stl").write_bytes(surfaces.stl(surfaces.cube()))
        probe = self.run_certet("mesh", "probe.stl", "--dry-run")
        if "not built in" in probe.stderr:
            self.skipTest("without assimp")
        (self.folder / "probe.stl").unlink()
