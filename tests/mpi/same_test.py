"""Whatever the number of ranks and threads, the file is that of certet mesh, byte for byte."""

import json
import unittest

from images import voxels, write_nrrd
from job import JobTest

RANKS, THREADS = (1, 2, 3, 4, 7), (1, 2)
TORUS = ["--shape", "torus:1,0.4", "--size", "0.08"]
SAME = ("checksum", "file_checksum", "points", "tets", "volume")


class Same(JobTest):
    def setUp(self):
        super().setUp()
        size = (12, 14, 40)
        write_nrrd(self.folder / "seg.nrrd", size,
                   voxels(size, lambda i, j, k: (i // 4 + j // 5 + k // 6) % 3))

    def assert_same(self, *arguments):
        """For every number of ranks and threads."""
        one = self.mesh(*arguments, "-o", "one.vtu")
        expected = (self.folder / "one.vtu").read_bytes()
        for ranks in RANKS:
            for threads in THREADS:
                with self.subTest(ranks=ranks, threads=threads):
                    run = self.job(ranks, "mesh", *arguments, "--threads", threads, "-o", "all.vtu",
                                   "--json", "all.json")
                    self.assertEqual(run.returncode, 0, run.stderr)
                    all_ = json.loads((self.folder / "all.json").read_text())
                    self.assertTrue((self.folder / "all.vtu").read_bytes() == expected,
                                    "other bytes")
                    for key in SAME:
                        self.assertEqual(all_["mesh"][key], one["mesh"][key], key)
                    for key in ("dihedral", "guarantee", "lattice"):
                        self.assertEqual(all_[key], one[key], key)
                    told = all_["ranks"]
                    self.assertEqual(len(told), ranks)
                    self.assertEqual(sum(rank["tets"] for rank in told), one["mesh"]["tets"])
                    self.assertEqual(sum(rank["layers"] for rank in told),
                                     one["lattice"]["cells"][2])
        return one

    def test_embedded(self):
        self.assert_same(*TORUS, "--method", "embedded")

    def test_key(self):
        self.assert_same(*TORUS, "--method", "key")

    def test_midpoint(self):
        self.assert_same(*TORUS, "--method", "midpoint")

    def test_graded(self):
        one = self.assert_same("--shape", "sphere:1", "--size", "0.06", "--grade", "3")
        self.assertIn("graded", one["mesh"])

    def test_materials(self):
        one = self.assert_same("seg.nrrd", "--size", "1.3")
        self.assertEqual(len(one["regions"]), 2)

    def test_labels_by_the_papers_rule(self):
        self.assert_same("seg.nrrd", "--size", "1.3", "--method", "paper")


class Told(JobTest):
    def test_the_work_is_shared_out(self):
        """Most of a cone is at its base: equal layers would be unequal work."""
        cone = ["--expr", "(z+1)/4-sqrt(x^2+y^2)", "--bounds", "-1,-1,-1,1,1,1", "--size", "0.03",
                "--features", "off", "-o", "a.vtu", "--json", "a.json"]
        run = self.job(4, "mesh", *cone)
        self.assertEqual(run.returncode, 0, run.stderr)
        told = json.loads((self.folder / "a.json").read_text())
        tets = [rank["tets"] for rank in told["ranks"]]
        self.assertLess(max(tets), 1.35 * sum(tets) / 4, tets)
        self.assertNotIn("pieces", told["mesh"])
        self.assertRegex(run.stdout, r"(?m)^ranks +4, of ")
        self.assertEqual(run.stdout.count("checksum"), 1)

    def test_kept_pieces(self):
        two = ["--expr", "0.2-min((x-1)^2,(x+1)^2)-y^2-z^2", "--bounds", "-2,-1,-1,2,1,1",
               "--size", "0.1", "--keep", "1", "--features", "off"]
        self.mesh(*two, "-o", "one.vtu")
        run = self.job(3, "mesh", *two, "-o", "all.vtu")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.folder / "all.vtu").read_bytes(),
                         (self.folder / "one.vtu").read_bytes())


if __name__ == "__main__":
    unittest.main()
