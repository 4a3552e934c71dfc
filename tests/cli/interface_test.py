"""Labels that meet: one mesh, cut where they do, and the surfaces between them."""

import json
import random
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


def area_of(triangle):
    a, b, c = triangle
    u, v = ([q[i] - a[i] for i in range(3)] for q in (b, c))
    cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return sum(x * x for x in cross) ** 0.5 / 2


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
        self.assertEqual(report["theorem"], "CertifiedKeySweptMesh")

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

    def test_all_interfaces_together(self):
        together = self.surface("interfaces")
        alone = [t for pair in ("1,2", "1,3", "2,3") for t in self.surface(pair)]
        self.assertEqual(sorted(map(sorted, together)), sorted(map(sorted, alone)))
        self.assert_refused(2, "no two regions", "a.nrrd", "-o", "s.stl", "--labels", "2",
                            "--surface", "interfaces")

    def check(self, name, status=0):
        run = self.run_certet("check", name, "--json", "check.json")
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run.stdout, json.loads((self.folder / "check.json").read_text())

    def test_every_way_through_the_formats_keeps_them(self):
        self.mesh("a.nrrd", "-o", "a.msh", "--label-names", "names.txt")
        for last in ("inp", "feb", "bdf", "k", "mfem", "xdmf", "vtp", "node"):
            self.convert("a.msh", f"direct.{last}")
        for via in (("b.vtu",), ("b.mesh",), ("b.meshb",), ("b.msh", "--format", "msh22")):
            self.convert("a.msh", *via)
            _, report = self.check(via[0])
            self.assertEqual([i["labels"] for i in report["interfaces"]], [[1, 2], [1, 3], [2, 3]])
            for last in ("inp", "feb", "bdf", "k", "mfem", "xdmf", "vtp", "node", "msh", "mesh", "meshb"):
                with self.subTest(via=via[0], last=last):
                    self.convert(via[0], f"c.{last}", "--label-names", "names.txt")
                    if last in ("msh", "mesh", "meshb"):
                        _, again = self.check(f"c.{last}")
                        self.assertEqual(again["interfaces"], [
                            i | {"names": j["names"]}
                            for i, j in zip(report["interfaces"], again["interfaces"])])
                        self.assertEqual(sum(s["missing"] + s["wrong"] for s in again["surfaces"]
                                             if "interface" in s), 0)
                        self.assertEqual(sum("interface" in s for s in again["surfaces"]), 3)
                        continue
                    files = ("node", "ele", "face") if last == "node" else (last,)
                    for kind in files:
                        # The .xdmf file names the .h5 file.
                        self.assertEqual((self.folder / f"c.{kind}").read_bytes()
                                         .replace(b">c.h5:", b">direct.h5:"),
                                         (self.folder / f"direct.{kind}").read_bytes())

    def convert(self, *arguments):
        run = self.run_certet("convert", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_check_tells_regions_and_interfaces(self):
        run = self.mesh("a.nrrd", "-o", "a.msh", "--label-names", "names.txt")
        table, report = self.check("a.msh")
        self.assertIn("bone | marrow: ", table)
        self.assertEqual([r["name"] for r in report["regions"]], ["bone", "marrow", "tumour"])
        for told, found in zip(run["regions"], report["regions"]):
            self.assertEqual((told["label"], told["tets"]), (found["label"], found["tets"]))
            self.assertAlmostEqual(told["volume"], found["volume"], places=6)
            self.assertEqual(found["surface"]["open_edges"], 0)
            self.assertGreater(found["dihedral"]["min"], 10.77)
        areas = {tuple(i["labels"]): i["area"] for i in report["interfaces"]}
        for pair, area in areas.items():
            triangles = self.surface(f"{pair[0]},{pair[1]}")
            self.assertEqual(len(triangles), next(
                i["triangles"] for i in report["interfaces"] if tuple(i["labels"]) == pair))
            self.assertAlmostEqual(sum(map(area_of, triangles)), area, delta=1e-3 * area)

    def test_surfaces_of_several_touch_themselves_in_points_alone(self):
        """Of noise, where two labels and the outside meet; of all labels as one there is none."""
        chosen = random.Random(5)
        size = (9, 9, 9)
        images.write_nrrd(self.folder / "n.nrrd", size,
                          images.voxels(size, lambda i, j, k: chosen.randint(0, 3)))
        for options in (("--smooth", "0"), (), ("--method", "midpoint")):
            report = self.mesh("n.nrrd", "-o", "n.vtu", *options)
            found = report["mesh"]["nonmanifold"]
            self.assertEqual(found["edges"], 0)
            self.assertGreater(found["vertices"], 0)
            self.assertIn("but for single points", report["guarantee"]["surface"])
            table, checked = self.check("n.vtu")
            self.assertEqual(checked["mesh"]["nonmanifold"]["vertices"], found["vertices"])
            self.assertIn(f"no manifold at 0 edges and {found['vertices']} vertices", table)
            for region in checked["regions"]:
                self.assertEqual(region["surface"]["open_edges"], 0)
                self.assertEqual(region["surface"]["nonmanifold"]["edges"], 0)
            one = self.mesh("n.nrrd", "-o", "o.vtu", "--merge", "1-3=1", *options)
            self.assertEqual(one["mesh"]["nonmanifold"]["vertices"], 0)
            self.assertNotIn("surface", one["guarantee"])

    def test_check_finds_what_the_file_has_wrong(self):
        self.mesh("a.nrrd", "-o", "a.mesh")
        text = (self.folder / "a.mesh").read_text()
        head, triangles = text.split("Triangles\n")
        count, *rows = triangles.split("End")[0].split("\n")[:-1]
        at = next(n for n, row in enumerate(rows) if row.endswith(" 4"))
        lacking = rows[:at] + rows[at + 1:]
        other = rows[:at] + [rows[at][:-1] + "5"] + rows[at + 1:]
        for planted, words in ((lacking, ("surface 4 lacks 1 of the",)),
                               (other, ("surface 4 lacks 1 of the", "surface 5 has 1 triangle"))):
            (self.folder / "b.mesh").write_text(
                head + f"Triangles\n{len(planted)}\n" + "\n".join(planted) + "\nEnd\n")
            table, report = self.check("b.mesh", status=1)
            for sentence in words:
                self.assertIn(sentence, table)
            self.assertFalse(report["ok"])

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

    def test_volumes_that_are_off_are_named(self):
        """Beyond 1 %, of labels of 1,000 voxels and more; where it is less nothing is said."""
        named = False
        for size in 1, 2, 2.6, 3.1:
            report = self.mesh("a.nrrd", "-o", "a.vtu", "--size", size)
            for region in report["regions"]:
                off = region["voxels"] >= 1000 and abs(region["change_percent"]) > 1
                told = [w for w in report["warnings"]
                        if f"volume of label {region['label']} than" in w]
                self.assertEqual(len(told), off, region)
                if off:
                    named = True
                    percent = abs(region["change_percent"])
                    side = "more" if region["change_percent"] > 0 else "less"
                    self.assertIn(f"{percent:.1f} % {side} volume", told[0])
                    self.assertIn("--size 0.9995 or less", told[0])
        self.assertTrue(named, "then nothing was tested")

    def test_the_same_for_threads_and_memory(self):
        sums = {self.mesh("a.nrrd", "-o", "a.msh", "--threads", threads)["mesh"]["checksum"]
                for threads in ("1", "2", "5")}
        self.assertEqual(len(sums), 1)


if __name__ == "__main__":
    unittest.main()
