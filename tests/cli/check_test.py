"""`certet check` finds what is wrong with a mesh, from its file alone."""

import json
import unittest

import vtu
from program import TORUS, ProgramTest

BAD_INPUT = 3


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "t.vtu"
        self.mesh(*TORUS, "--size", "0.15", "-o", "t.vtu")

    def broken(self):
        run = self.run_certet("check", "t.vtu", "--json", "-")
        self.assertEqual(run.returncode, 1, run.stderr)
        report = json.loads(run.stdout)
        self.assertFalse(report["ok"])
        self.assertTrue(report["failures"])
        return report["mesh"]

    def index_code(self):
        kind = vtu.arrays(self.path)[1]["connectivity"][2]
        return "i" if kind.endswith("32") else "q"

    def test_sound(self):
        self.assertTrue(self.check("t.vtu")["ok"])
        run = self.run_certet("check", "t.vtu")
        self.assertEqual(run.returncode, 0)
        self.assertIn("verdict", run.stdout)

    def test_turned_tetrahedron(self):
        tet = vtu.tets(self.path)[7]
        for item, corner in ((28, tet[1]), (29, tet[0])):
            vtu.overwrite(self.path, "connectivity", item, self.index_code(), corner)
        self.assertGreaterEqual(self.broken()["nonpositive_tets"], 1)

    def test_index_beyond_the_points(self):
        vtu.overwrite(self.path, "connectivity", 40, self.index_code(), 10 ** 8)
        run = self.run_certet("check", "t.vtu")
        self.assertIn(run.returncode, (1, BAD_INPUT))

    def test_tetrahedron_twice(self):
        for item, corner in enumerate(vtu.tets(self.path)[12]):
            vtu.overwrite(self.path, "connectivity", 44 + item, self.index_code(), corner)
        self.assertGreater(self.broken()["overfull_faces"], 0)

    def test_nan_point(self):
        name = next(n for n in vtu.arrays(self.path)[1] if n.lower() == "points")
        vtu.overwrite(self.path, name, 5, "d", float("nan"))
        self.assertEqual(self.broken()["nonfinite_points"], 1)

    def test_truncated(self):
        self.path.write_bytes(self.path.read_bytes()[:-1000])
        self.assert_fails(BAD_INPUT, ["t.vtu"], "check", "t.vtu")

    def test_missing(self):
        self.assert_fails(BAD_INPUT, ["none.vtu"], "check", "none.vtu")
        (self.folder / "x.vtu").write_text("hello")
        self.assert_fails(BAD_INPUT, ["x.vtu"], "check", "x.vtu")


if __name__ == "__main__":
    unittest.main()
