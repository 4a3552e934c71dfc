"""Diagonals that follow the cuts, by --method key and by default."""

import unittest

from program import ProgramTest

TORUS = ["--shape", "torus:1,0.4", "--size", "0.07"]
BALLS = ["--material", "shell=sphere:1", "--material", "core=sphere:0.5", "--size", "0.1"]


class Key(ProgramTest):
    def test_the_bounds_are_those_of_its_theorem(self):
        report = self.mesh(*TORUS, "-o", "a.vtu", "--method", "key")
        self.assertEqual(report["method"]["name"], "key")
        self.assertEqual(report["method"]["shortened"], 0)
        self.assertEqual(report["theorem"], "CertifiedKeySweptMesh")
        guarantee = report["guarantee"]
        self.assertEqual((guarantee["asked"], guarantee["used"]), ("key", "key"))
        self.assertEqual((guarantee["min_dihedral"], guarantee["max_dihedral"]), (11.18, 157.13))
        self.assertTrue(guarantee["holds"])
        self.assertGreater(report["dihedral"]["min"], 11.18)
        self.assertLess(report["dihedral"]["max"], 157.13)
        self.run_certet("mesh", *TORUS, "-o", "b.vtu", "--method", "key", "--json", "b.json")
        run = self.run_certet("check", "b.vtu", "--run", "b.json")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("CertifiedKeySweptMesh", run.stdout)

    def test_the_mesh_is_another_and_the_same_for_threads_memory_and_grading(self):
        boundary = []
        sums = {self.mesh(*TORUS, "-o", "a.vtu", "--method", "key", *more)["mesh"]["checksum"]
                for more in ([], ["--threads", "1"], ["--threads", "8"], ["--max-memory", "8M"])}
        self.assertEqual(len(sums), 1)
        plain = self.mesh(*TORUS, "-o", "a.vtu")
        self.assertIn(plain["mesh"]["checksum"], sums)
        self.assertEqual(plain["guarantee"]["asked"], "key")
        other = self.mesh(*TORUS, "-o", "a.vtu", "--method", "embedded")
        self.assertNotIn(other["mesh"]["checksum"], sums)
        for grade in ("0", "2"):
            report = self.mesh(*TORUS, "-o", "b.vtu", "--method", "key", "--grade", grade)
            self.assertTrue(report["guarantee"]["holds"])
            boundary.append(self.check("b.vtu")["mesh"]["boundary_faces"])
        self.assertEqual(boundary[0], boundary[1])

    def test_the_table_names_it(self):
        told = self.run_certet("mesh", *TORUS, "-o", "a.vtu", "--method", "key").stdout
        self.assertIn("11.180° to 157.130°, theorem CertifiedKeySweptMesh", told)
        self.assertRegex(told, "method +key: diagonals follow the cuts")
        self.assertIn("vertices too close to the surface stayed, 0 moves shortened", told)

    def test_several_materials_are_meshed_by_embedded(self):
        report = self.mesh(*BALLS, "-o", "a.vtu", "--method", "key")
        self.assertEqual((report["guarantee"]["asked"], report["guarantee"]["used"]),
                         ("key", "embedded"))
        self.assertEqual(report["theorem"], "MaterialDihedralBoundsInDegrees")
        asked = self.mesh(*BALLS, "-o", "b.vtu", "--method", "embedded")
        self.assertEqual(report["mesh"]["checksum"], asked["mesh"]["checksum"])
        plain = self.mesh(*BALLS, "-o", "b.vtu")
        self.assertEqual((plain["mesh"], plain["guarantee"]), (report["mesh"], report["guarantee"]))
        for choice in ((), ("--method", "key")):
            told = self.run_certet("mesh", *BALLS, "-o", "a.vtu", *choice).stdout
            self.assertIn("(key is of one material, and here several meet)", told)

    def test_what_is_refused(self):
        for option, value in (("--guarantee", "angles"), ("--cuts", "midpoint")):
            self.assert_fails(2, ["exclude each other"], "mesh", *TORUS, "-o", "a.vtu",
                              "--method", "key", option, value)


if __name__ == "__main__":
    unittest.main()
