"""Graded interiors, by --grade, --max-size, --interior-size and --size-field."""

import math
import unittest

import vtu
from images import voxels, write_nrrd
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
        for method, expected in (("embedded", 10_309_704), ("key", 10_351_952)):
            run = self.mesh("--shape", "torus:1,0.4", "--size", "0.0155", "--method", method,
                            "--grade", "3", "--dry-run")
            uniform = run["mesh"]["graded"]["uniform_tets"]
            self.assertEqual(uniform, expected)
            self.assertLess(run["mesh"]["tets"], 0.151 * uniform)
            if method == "embedded":
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
                (("--interior-size", "7=1"), "label 7, which the mesh has not"),
                (("--size-field", "0.1", "--optimise"), "do not go with --optimise"),
                (("--size-field", "sphere:1"), "takes a formula or an image"),
                (("--size-field", "a.stl"), "takes a formula or an image")):
            self.assert_fails(2, [sentence], "mesh", *SHAPE, "-o", "a.vtu", *options)
        self.assert_fails(2, ["not with --method paper"], "mesh", "--material", "a=sphere:1",
                          "--material", "b=sphere:0.5", "--size", "0.1", "--method", "paper",
                          "--grade", "1", "-o", "a.vtu")


BALL = ["--shape", "sphere:1", "--size", "0.05"]
STEEP = 0.25


def wanted(x, y, z):
    """As the formula below has it."""
    return max(0.04, 0.1037 + STEEP * x)


FORMULA = f"max(0.04, 0.1037 + {STEEP}*x)"


class SizeField(ProgramTest):
    def write_sizes(self, name, value, side=11, reach=1.1):
        """An image of sizes over a cube around the ball."""
        step = 2 * reach / (side - 1)
        at = lambda n: -reach + step * n
        write_nrrd(self.folder / name, (side,) * 3,
                   voxels((side,) * 3, lambda i, j, k: value(at(i), at(j), at(k))), kind="d",
                   directions=((step, 0, 0), (0, step, 0), (0, 0, step)), origin=(-reach,) * 3)

    def test_the_same_size_everywhere_is_max_size(self):
        self.write_sizes("sizes.nrrd", lambda x, y, z: 0.2)
        plain = self.mesh(*BALL, "--max-size", "0.2", "-o", "a.vtu")
        for field in ("0.2", "sizes.nrrd"):
            told = self.mesh(*BALL, "--size-field", field, "-o", "b.vtu")
            self.assertEqual(told["mesh"]["file_checksum"], plain["mesh"]["file_checksum"])

    def test_no_tetrahedron_is_larger_than_wanted(self):
        run = self.mesh(*BALL, "--size-field", FORMULA, "-o", "a.vtu")
        self.assertEqual(run["mesh"]["graded"]["size_field"], FORMULA)
        self.check("a.vtu")
        all_levels = self.mesh(*BALL, "--grade", "3", "--dry-run")
        self.assertGreater(run["mesh"]["tets"], all_levels["mesh"]["tets"])
        self.assertLess(run["mesh"]["tets"], run["mesh"]["graded"]["uniform_tets"])
        points = vtu.points(self.folder / "a.vtu")
        large = 0
        for tet in vtu.tets(self.folder / "a.vtu"):
            corners = [points[n] for n in tet]
            longest = max(math.dist(a, b) for a in corners for b in corners)
            # Of one size at the surface, where edges move; else sizes hold at centres of cells,
            # for long edges, of which pyramids have diagonals.
            if longest > 0.05 * 1.5:
                least = min(wanted(*corner) for corner in corners)
                self.assertLessEqual(longest, math.sqrt(2) * (least + STEEP * 0.05))
                large += longest > 0.15
        self.assertGreater(large, 10)

    def test_an_image_is_the_formula_that_it_was_made_of(self):
        self.write_sizes("sizes.nrrd", lambda x, y, z: 0.311 + 0.17 * x - 0.11 * y + 0.05 * z)
        by_image = self.mesh(*BALL, "--size-field", "sizes.nrrd", "-o", "a.vtu")
        by_formula = self.mesh(*BALL, "--size-field", "0.311 + 0.17*x - 0.11*y + 0.05*z",
                               "-o", "b.vtu")
        self.assertEqual(by_image["mesh"]["file_checksum"], by_formula["mesh"]["file_checksum"])

    def test_threads_and_streaming(self):
        files = [f"{n}.vtu" for n in (1, 2, 3)]
        for threads, file in zip((1, 2, 3), files):
            self.mesh(*BALL, "--size-field", FORMULA, "-o", file, "--threads", threads)
        self.assertEqual(len({(self.folder / file).read_bytes() for file in files}), 1)

    def test_other_options_say_how_many_levels_at_most(self):
        most = self.mesh(*BALL, "--size-field", "9", "--grade", "1", "--dry-run")
        self.assertEqual(most["mesh"]["graded"]["levels"], 1)
        plain = self.mesh(*BALL, "--grade", "1", "--dry-run")
        self.assertEqual(most["mesh"]["tets"], plain["mesh"]["tets"])

    def test_a_formula_in_a_file_and_the_table(self):
        (self.folder / "sizes.txt").write_text("# fine in the middle\n0.05 + hypot(x, y, z) / 4\n")
        run = self.run_certet("mesh", *BALL, "--size-field", "@sizes.txt", "-o", "a.vtu")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("within the size field @sizes.txt", run.stdout)

    def test_what_is_refused(self):
        self.write_sizes("small.nrrd", lambda x, y, z: 0.2, reach=0.4)
        self.write_sizes("zero.nrrd", lambda x, y, z: x)
        for field, words in (
                ("x", ["formula 'x', is -", " at (", "positive"]),
                ("0", ["formula '0', is 0 at ("]),
                ("sqrt(x)", ["formula 'sqrt(x)', is ", "nan at ("]),
                ("x +", ["formula"]),
                ("small.nrrd", ["image 'small.nrrd', does not cover the shape: (", "is beyond it"]),
                ("zero.nrrd", ["image 'zero.nrrd', is -", " at ("]),
                ("nowhere.nrrd", ["nowhere.nrrd"])):
            self.assert_fails(3, words, "mesh", *BALL, "-o", "a.vtu", "--size-field", field)


if __name__ == "__main__":
    unittest.main()
