"""Graded interiors, by --grade, --max-size and --interior-size."""

import unittest

from program import ProgramTest

SHAPE = ["--shape", "torus:1,0.4", "--size", "0.05"]


class Grade(ProgramTest):
    def test_fewer_tetrahedra_of_the_same_volume_and_boundary(self):
        before = self.mesh(*SHAPE, "-o", "before.vtu")
        boundary = self.check("before.vtu")["mesh"]["boundary_faces"]
        self.assertNotIn("graded", before["mesh"])
        last = before["mesh"]["tets"]
        for levels in (1, 2, 3):
            after = self.mesh(*SHAPE, "-o", "after.vtu", "--grade", levels)
            told = after["mesh"]["graded"]
            self.assertEqual(told["levels"], levels)
            self.assertEqual(told["uniform_tets"], before["mesh"]["tets"])
            self.assertAlmostEqual(told["greatest_edge"], 0.05 * 2**levels)
            self.assertEqual(told["interior"], {"theorem": "TransitionAnglesInDegrees",
                                                "min_dihedral": 45, "max_dihedral": 120})
            self.assertLessEqual(after["mesh"]["tets"], last)
            last = after["mesh"]["tets"]
            self.assertAlmostEqual(after["mesh"]["volume"], before["mesh"]["volume"], delta=1e-12)
            self.assertTrue(after["guarantee"]["holds"])
            checked = self.check("after.vtu")
            self.assertEqual(checked["mesh"]["checksum"], after["mesh"]["file_checksum"])
            self.assertEqual(checked["mesh"]["boundary_faces"], boundary)
        self.assertLess(last, 0.45 * before["mesh"]["tets"])

    def test_the_table_says_what_is_replaced(self):
        run = self.run_certet("mesh", *SHAPE, "-o", "a.vtu", "--grade", "2")
        self.assertRegex(run.stdout, r"(?m)^graded +2 levels, edges up to 0.2; in the place of [\d,]+")
        self.assertIn("45° to 120°, theorem TransitionAnglesInDegrees", run.stdout)

    def test_levels_of_0_are_no_grading(self):
        one = self.mesh(*SHAPE, "-o", "a.vtu")
        none = self.mesh(*SHAPE, "-o", "b.vtu", "--grade", "0")
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())
        self.assertEqual(one["mesh"], none["mesh"])

    def test_threads_memory_and_formats(self):
        for extension in ("vtu", "msh", "mesh"):
            files = [f"{n}.{extension}" for n in (1, 2, 3)]
            for threads, file in zip((1, 2, 3), files):
                self.mesh(*SHAPE, "-o", file, "--grade", "3", "--threads", threads)
            self.assertEqual(len({(self.folder / file).read_bytes() for file in files}), 1)

    def test_sizes(self):
        by_size = self.mesh(*SHAPE, "-o", "a.vtu", "--max-size", "0.3")
        by_levels = self.mesh(*SHAPE, "-o", "b.vtu", "--grade", "2")
        self.assertEqual(by_size["mesh"], by_levels["mesh"])
        small = self.mesh(*SHAPE, "-o", "c.vtu", "--max-size", "0.09")
        self.assertNotIn("graded", small["mesh"])

    def test_a_target_and_a_dry_run_count_what_is_graded(self):
        found = self.mesh("--shape", "sphere:1", "--target-tets", "20000", "--grade", "3",
                          "-o", "a.vtu")
        self.assertLess(abs(found["mesh"]["tets"] / 20000 - 1), 0.05)
        dry = self.mesh("--shape", "sphere:1", "--size", found["lattice"]["size"], "--grade", "3",
                        "--dry-run")
        self.assertEqual(dry["mesh"]["tets"], found["mesh"]["tets"])
        self.assertEqual(dry["mesh"]["graded"], found["mesh"]["graded"])

    def test_ten_million_become_one_and_a_half(self):
        run = self.mesh("--shape", "torus:1,0.4", "--size", "0.0155", "--grade", "3", "--dry-run")
        uniform = run["mesh"]["graded"]["uniform_tets"]
        self.assertEqual(uniform, 10_309_704)
        self.assertLess(run["mesh"]["tets"], 0.147 * uniform)

    def test_sizes_of_single_labels(self):
        solids = ["--material", "shell=sphere:1", "--material", "core=box:1.1,1.1,1.1",
                  "--size", "0.05", "-o", "a.vtu"]
        tets = {}
        for option in ((), ("--interior-size", "1=0.2"), ("--interior-size", "2=0.2"),
                       ("--interior-size", "1=0.2,2=0.2"), ("--grade", "2")):
            run = self.mesh(*solids, *option)
            tets[option] = [one["tets"] for one in run["regions"]]
            self.check("a.vtu")
        plain, first, second, both, grade = tets.values()
        self.assertEqual(both, grade)
        self.assertLess(first[0], plain[0])
        self.assertLess(second[1], plain[1])
        self.assertGreater(first[1], both[1])

    def test_middle_nodes_and_pieces(self):
        self.mesh(*SHAPE, "-o", "a.vtu", "--grade", "3", "--order", "2", "--curved")
        self.check("a.vtu")
        kept = self.mesh("--expr", "min(hypot(x,y,z)-0.8, hypot(x-1.7,y,z)-0.6)", "--bounds",
                         "-1,-1,-1,2.5,1,1", "--size", "0.06", "-o", "b.vtu", "--grade", "2",
                         "--keep", "largest")
        self.assertEqual(kept["mesh"]["pieces"]["by_faces"], 1)
        self.assertIn("graded", kept["mesh"])
        self.check("b.vtu")

    def test_what_is_refused(self):
        for options, sentence in (
                (("--grade", "2", "--optimise"), "do not go with --optimise"),
                (("--grade", "2", "--features", "30"), "do not go with --optimise or --features"),
                (("--grade", "2", "--max-size", "1"), "exclude each other"),
                (("--grade", "4"), "--grade"),
                (("--grade", "-1"), "--grade"),
                (("--interior-size", "3"), "--interior-size takes labels"),
                (("--interior-size", "1=1,1=2"), "twice"),
                (("--interior-size", "7=1"), "label 7, which the mesh has not")):
            self.assert_fails(2, [sentence], "mesh", *SHAPE, "-o", "a.vtu", *options)
        self.assert_fails(2, ["not with --method paper"], "mesh", "--material", "a=sphere:1",
                          "--material", "b=sphere:0.5", "--size", "0.1", "--method", "paper",
                          "--grade", "1", "-o", "a.vtu")


if __name__ == "__main__":
    unittest.main()
