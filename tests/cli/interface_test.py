"""Labels that meet: one mesh, cut where they do, and the surfaces between them."""

import json
import struct
import unittest

import images
import vtu
from program import ProgramTest

SIZE = (26, 24, 22)
BALLS = {1: ((13, 12, 11), 9.2), 2: ((10, 12, 11), 4.1), 3: ((18, 13, 11), 4.7)}


def label(i, j, k):
    """A large ball, one inside of it, and one through its surface; the later one wins."""
    found = 0
    for name, (centre, radius) in BALLS.items():
        if sum((a + 0.5 - c) ** 2 for a, c in zip((i, j, k), centre)) < radius ** 2:
            found = name
    return found


def triangles_of(file):
    """The triangles of a binary STL file, as tuples of points."""
    data = file.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    rows = [struct.unpack_from("<12f", data, 84 + 50 * i)[3:] for i in range(count)]
    return [(row[0:3], row[3:6], row[6:9]) for row in rows]


def enclosed(triangles):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6


def open_edges(triangles):
    forward = [e for a, b, c in triangles for e in ((a, b), (b, c), (c, a))]
    backward = {(b, a) for a, b in forward}
    return [e for e in forward if e not in backward]


class Interfaces(ProgramTest):
    def setUp(self):
        super().setUp()
        images.write_nrrd(self.folder / "a.nrrd", SIZE, images.voxels(SIZE, label), kind="B")
        (self.folder / "names.txt").write_text("1 bone\n2 marrow\n3 tumour\n")

    def surface(self, which, *options):
        self.mesh("a.nrrd", "-o", "s.stl", "--surface", which, *options)
        return triangles_of(self.folder / "s.stl")

    def test_volumes_are_those_of_the_voxels(self):
        for method, smooth, share in (("embedded", [], 0.015), ("midpoint", [], 0.03),
                                      ("embedded", ["--smooth", "0"], 0.02),
                                      ("midpoint", ["--smooth", "0"], 0.02)):
            report = self.mesh("a.nrrd", "-o", "a.vtu", "--method", method, *smooth)
            self.assertEqual([r["label"] for r in report["regions"]], [1, 2, 3])
            for region in report["regions"]:
                self.assertEqual(region["voxel_volume"], region["voxels"])
                self.assertAlmostEqual(region["volume"], region["voxels"],
                                       delta=share * region["voxels"])
            self.assertAlmostEqual(sum(r["volume"] for r in report["regions"]),
                                   report["mesh"]["volume"], delta=1e-6)

    def test_the_theorem_is_that_on_several_materials(self):
        for method, theorem in (("embedded", "MaterialDihedralBoundsInDegrees"),
                                ("midpoint", "MaterialMidpointBoundsInDegrees"),
                                ("paper", "DihedralBounds")):
            run = self.run_certet("mesh", "a.nrrd", "-o", "a.vtu", "--method", method, "--json",
                                  "run.json")
            self.assertEqual(run.returncode, 0, run.stderr)
            report = json.loads((self.folder / "run.json").read_text())
            self.assertTrue(report["theorem"].startswith(theorem), report["theorem"])
            self.assertIn("theorem " + report["theorem"], run.stdout)
            check = self.run_certet("check", "a.vtu", "--run", "run.json")
            self.assertEqual(check.returncode, 0, check.stderr)
            self.assertIn("within theorem " + theorem, check.stdout)
        # Of one label it is the one on a solid.
        report = self.mesh("a.nrrd", "-o", "a.vtu", "--labels", "2")
        self.assertEqual(report["theorem"], "SettledBoundsInDegrees")

    def test_the_surface_of_a_region_is_closed_around_it(self):
        report = self.mesh("a.nrrd", "-o", "a.vtu")
        for region in report["regions"]:
            triangles = self.surface(str(region["label"]))
            self.assertEqual(open_edges(triangles), [])
            self.assertAlmostEqual(enclosed(triangles), region["volume"],
                                   delta=1e-4 * region["volume"])

    def test_the_surfaces_of_two_are_that_of_both_but_for_the_interface(self):
        alone = [self.surface(one) for one in ("1", "3")]
        between = self.surface("1,3")
        self.assertEqual(self.surface("3,1"), between)
        self.assertEqual(self.surface("bone,tumour", "--label-names", "names.txt"), between)
        rims = {frozenset(e) for e in open_edges(between)}
        self.assertTrue(rims)
        as_seen = {frozenset(t) for t in between}
        for triangles in alone:
            self.assertLessEqual(as_seen, {frozenset(t) for t in triangles})

    def test_the_paper_cuts_none(self):
        report = self.mesh("a.nrrd", "-o", "a.vtu", "--method", "paper")
        labels = vtu.numbers(self.folder / "a.vtu", "label")
        self.assertEqual(sorted(set(labels)), [1, 2, 3])
        self.assert_refused(2, "do not touch", "a.nrrd", "-o", "s.stl", "--method", "paper",
                            "--surface", "1,2")

    def test_refusals(self):
        self.assert_refused(2, "no region 9", "a.nrrd", "-o", "s.stl", "--surface", "9")
        self.assert_refused(2, "'skin'", "a.nrrd", "-o", "s.stl", "--surface", "skin")
        self.assert_refused(2, ".stl and .ply", "a.nrrd", "-o", "s.vtu", "--surface", "1")
        self.assertEqual(self.files(), ["a.nrrd", "names.txt"])

    def assert_refused(self, status, words, *arguments):
        run = self.run_certet("mesh", *arguments)
        self.assertEqual(run.returncode, status, run.stderr)
        self.assertIn(words, run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)

    def test_the_same_for_threads_and_memory(self):
        sums = {self.mesh("a.nrrd", "-o", "a.msh", "--threads", threads)["mesh"]["checksum"]
                for threads in ("1", "2", "5")}
        self.assertEqual(len(sums), 1)


if __name__ == "__main__":
    unittest.main()
