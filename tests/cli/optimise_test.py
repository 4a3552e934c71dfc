"""Vertices that move for better angles, by --optimise."""

import unittest

import images
from program import TORUS, ProgramTest

SHAPE = ["--shape", "torus:1,0.4", "--size", "0.06"]


class Optimise(ProgramTest):
    def test_angles_grow_and_the_file_holds_them(self):
        before = self.mesh(*SHAPE, "-o", "before.vtu")
        after = self.mesh(*SHAPE, "-o", "after.vtu", "--optimise")
        told = after["optimised"]
        self.assertEqual(told["goal"], 25)
        self.assertGreater(told["short_before"], told["short_after"])
        self.assertGreater(told["moved"], told["moved_on_surface"])
        self.assertGreater(told["moved_on_surface"], 0)
        self.assertLessEqual(told["greatest_move_edges"], 0.5)
        self.assertLessEqual(told["greatest_move_on_surface_edges"], 0.25)
        self.assertEqual(told["left_surface"], 0)
        self.assertNotIn("optimised", before)
        self.assertNotIn("angles", before["guarantee"])
        self.assertEqual(after["guarantee"]["angles"], "checked")
        self.assertTrue(after["guarantee"]["holds"])
        self.assertGreater(after["dihedral"]["min"], before["dihedral"]["min"] + 3)
        self.assertLessEqual(after["dihedral"]["max"], before["dihedral"]["max"])
        for key in ("points", "tets", "pieces"):
            self.assertEqual(after["mesh"][key], before["mesh"][key])
        self.assertAlmostEqual(after["mesh"]["volume"] / before["mesh"]["volume"], 1, delta=0.002)
        checked = self.check("after.vtu")
        self.assertEqual(checked["mesh"]["checksum"], after["mesh"]["file_checksum"])

    def test_the_table_says_what_was_checked(self):
        run = self.run_certet("mesh", *SHAPE, "-o", "a.vtu", "--optimise")
        self.assertRegex(run.stdout, r"(?m)^optimised +[\d,]+ vertices moved in \d+ rounds")
        self.assertRegex(run.stdout, r"(?m)^checked +\d+\.\d+° to")

    def test_a_goal(self):
        less = self.mesh(*SHAPE, "-o", "a.vtu", "--optimise", "--optimise-to", "20")
        self.assertGreaterEqual(less["dihedral"]["min"], 20 - 1e-9)
        more = self.mesh(*SHAPE, "-o", "b.vtu", "--optimise", "--optimise-to", "28")
        self.assertGreater(more["optimised"]["moved"], less["optimised"]["moved"])

    def test_threads_and_formats(self):
        for extension in ("vtu", "msh", "stl"):
            files = [f"{n}.{extension}" for n in (1, 2, 3)]
            for threads, file in zip((1, 2, 4), files):
                self.mesh(*SHAPE, "-o", file, "--optimise", "--threads", threads)
            one = (self.folder / files[0]).read_bytes()
            for file in files[1:]:
                self.assertEqual((self.folder / file).read_bytes(), one)

    def test_labels(self):
        """Regions keep their tetrahedra, by every method, as the streamed mesh has them."""
        size = (14, 12, 10)
        images.write_nrrd(self.folder / "a.nrrd", size, images.voxels(
            size, lambda i, j, k: 0 if not (2 <= i < 12 and 2 <= j < 10 and 2 <= k < 8)
            else 7 if i > 6 and j > 5 else 3 if i < 6 and k < 5 else 1))
        for method in ("embedded", "paper"):
            before = self.mesh("a.nrrd", "--method", method, "-o", "a.vtu")
            after = self.mesh("a.nrrd", "--method", method, "-o", "b.vtu", "--optimise")
            self.assertGreater(after["optimised"]["moved"], 0)
            self.assertGreaterEqual(after["dihedral"]["min"], before["dihedral"]["min"])
            self.assertLess(after["optimised"]["short_after"], after["optimised"]["short_before"])
            self.assertEqual([r["tets"] for r in after["regions"]],
                             [r["tets"] for r in before["regions"]])
            self.check("b.vtu")

    def test_ten_nodes(self):
        report = self.mesh(*SHAPE, "-o", "a.vtu", "--optimise", "--order", "2", "--curved")
        self.assertGreaterEqual(report["order2"]["least_jacobian"], 0.25)
        self.check("a.vtu")

    def test_a_dry_run_moves_nothing(self):
        report = self.mesh(*SHAPE, "--optimise", "--dry-run")
        self.assertNotIn("optimised", report)

    def test_refused(self):
        self.assert_fails(2, ["--optimise", "midpoint"], "mesh", *SHAPE, "-o", "a.vtu",
                          "--optimise", "--method", "midpoint")
        self.assert_fails(2, ["--optimise-to", "--optimise"], "mesh", *SHAPE, "-o", "a.vtu",
                          "--optimise-to", "20")
        for angle in ("61", "0", "-3", "steep"):
            self.assert_fails(2, ["--optimise-to", angle], "mesh", *SHAPE, "-o", "a.vtu",
                              "--optimise", f"--optimise-to={angle}")

    def test_memory(self):
        self.assert_fails(5, ["to optimise the mesh needs"], "mesh", *TORUS, "--size", "0.01",
                          "-o", "a.vtu", "--optimise", "--max-memory", "60M")


if __name__ == "__main__":
    unittest.main()
