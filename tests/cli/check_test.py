"""`certet check` finds what is wrong with a mesh, from its file alone."""

import json
import math
import re
import unittest

import vtu
from images import voxels, write_nrrd
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
        self.assertRegex(run.stdout, r"\Amesh +t.vtu\n.*\nverdict +valid, positive, conforming and closed\n")
        self.assert_one_screen(run.stdout)

    def assert_one_screen(self, table):
        self.assertLessEqual(table.count("\n"), 23, table)
        self.assertLessEqual(max(map(len, table.splitlines())), 110, table)

    def test_many_labels_fit_one_screen(self):
        """All of a few regions and interfaces; of many what one should know of, and how many
        there are; --json has all."""
        for labels, rows in ((3, 3), (40, 0)):
            size = (2 * labels, 6, 6)
            write_nrrd(self.folder / "a.nrrd", size, voxels(size, lambda i, j, k: 1 + i // 2))
            self.mesh("a.nrrd", "-o", "a.vtu")
            table = self.run_certet("check", "a.vtu").stdout
            self.assert_one_screen(table)
            self.assertEqual(len(re.findall(r"\n {11}\d+: .* tetrahedra, volume", table)), rows)
            self.assertEqual("each in one piece, and a manifold; --json has all" in table, rows == 0)
            self.assertRegex(table, rf"\nregions +{labels}, of volumes from")
            self.assertRegex(table, rf"\ninterfaces +{labels - 1} of ")
            report = self.check("a.vtu")
            self.assertEqual(len(report["regions"]), labels)
            self.assertEqual(len(report["interfaces"]), labels - 1)

    def test_regions_in_pieces_are_told_of_many(self):
        size = (24, 12, 6)
        scattered = lambda i, j, k: 1 if (i // 2 + j // 2) % 2 else 2 + i // 2
        write_nrrd(self.folder / "a.nrrd", size, voxels(size, scattered))
        self.mesh("a.nrrd", "-o", "a.vtu")
        report = self.check("a.vtu")
        several = [r for r in report["regions"] if r["pieces"] > 1 or
                   r["surface"]["nonmanifold"]["vertices"] > 0]
        self.assertGreater(len(several), 4)
        table = self.run_certet("check", "a.vtu").stdout
        self.assertRegex(table, r"\n {11}\d+: .* pieces by faces, ")
        self.assertIn(f"{len(several) - 4} more like these", table)

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

    def test_angles_are_told_and_judged(self):
        angles = self.check("t.vtu")["dihedral"]
        run = self.run_certet("check", "t.vtu")
        self.assertIn(f"{angles['min']:.3f}° to {angles['max']:.3f}°", run.stdout)
        for options, status in (
                (["--min-angle", angles["min"]], 0), (["--max-angle", angles["max"]], 0),
                (["--min-angle", angles["min"] + 0.0004], 0),
                (["--min-angle", angles["min"] + 0.001], 1),
                (["--max-angle", angles["max"] - 0.001], 1),
                (["--min-angle", angles["min"], "--max-angle", angles["max"]], 0)):
            run = self.run_certet("check", "t.vtu", *options, "--json", "-")
            self.assertEqual(run.returncode, status, options)
            report = json.loads(run.stdout)
            self.assertEqual(report["ok"], status == 0)
            self.assertEqual(len(report["failures"]), status)
            if status == 1:
                self.assertIn("dihedral angles", report["failures"][0])
        self.assert_fails(2, ["--min-angle"], "check", "t.vtu", "--min-angle", "20",
                          "--max-angle", "10")
        self.assert_fails(2, ["--max-angle"], "check", "t.vtu", "--max-angle", "181")

    def test_truncated(self):
        self.path.write_bytes(self.path.read_bytes()[:-1000])
        self.assert_fails(BAD_INPUT, ["t.vtu"], "check", "t.vtu")

    def test_missing(self):
        self.assert_fails(BAD_INPUT, ["none.vtu"], "check", "none.vtu")
        (self.folder / "x.vtu").write_text("hello")
        self.assert_fails(BAD_INPUT, ["x.vtu"], "check", "x.vtu")


class Run(ProgramTest):
    """A file is what a run wrote, or it is not."""

    FORMATS = (("t.vtu", "vtu"), ("t.vtu", "vtu-zlib"), ("t.mesh", "medit"),
               ("t.meshb", "meditb"), ("t.msh", "msh"), ("t.msh", "msh22"))

    def made(self, *arguments):
        run = self.mesh(*TORUS, "--size", "0.2", *arguments)
        (self.folder / "run.json").write_text(json.dumps(run))
        return run

    def against_run(self, file, run="run.json"):
        run = self.run_certet("check", file, "--run", run, "--json", "-")
        return run.returncode, json.loads(run.stdout)

    def test_every_format_holds_what_was_written(self):
        for name, form in self.FORMATS:
            with self.subTest(form):
                run = self.made("-o", name, "--format", form)
                status, report = self.against_run(name)
                self.assertEqual(status, 0, report["failures"])
                self.assertEqual(report["mesh"]["checksum"], run["mesh"]["file_checksum"])
                self.assertEqual(report["bounds"]["theorem"], run["guarantee"]["theorem"])
                for key in ("min", "max"):
                    self.assertEqual(report["bounds"][key], run["guarantee"][key + "_dihedral"])
        self.run_certet("convert", "t.msh", "c.mesh")
        self.assertEqual(self.against_run("c.mesh")[0], 0)
        run = self.run_certet("check", "t.vtu", "--run", "run.json")
        self.assertIn("what the run wrote, within theorem", run.stdout)

    def test_labels_in_any_order(self):
        size = (9, 8, 7)
        write_nrrd(self.folder / "a.nrrd", size,
                   voxels(size, lambda i, j, k: (i + j * k) // 9 % 4))
        for name, form in self.FORMATS:
            run = self.mesh("a.nrrd", "-o", name, "--format", form)
            (self.folder / "run.json").write_text(json.dumps(run))
            self.assertEqual(self.against_run(name)[0], 0, form)

    def test_a_vertex_moved_by_the_least(self):
        self.made("-o", "t.vtu")
        path = self.folder / "t.vtu"
        name = next(n for n in vtu.arrays(path)[1] if n.lower() == "points")
        x = vtu.points(path)[7][0]
        vtu.overwrite(path, name, 21, "d", math.nextafter(x, 9))
        status, report = self.against_run("t.vtu")
        self.assertEqual(status, 1)
        self.assertEqual(len(report["failures"]), 1)
        self.assertIn("are not those that the run of 'run.json' wrote", report["failures"][0])
        self.assertNotIn("theorem", report["bounds"])
        run = self.run_certet("check", "t.vtu", "--run", "run.json")
        self.assertNotIn("within theorem", run.stdout)

    def test_a_run_that_claims_too_much(self):
        run = self.made("-o", "t.vtu")

        def refused(words, change):
            other = json.loads(json.dumps(run))
            change(other)
            (self.folder / "other.json").write_text(json.dumps(other))
            self.assert_fails(BAD_INPUT, ["other.json", *words], "check", "t.vtu", "--run",
                              "other.json")
        refused(["other bounds"], lambda r: r["guarantee"].update(min_dihedral=30))
        refused(["theorem"], lambda r: r["guarantee"].update(theorem="MidpointBounds"))
        refused(["theorem"], lambda r: r["lattice"].update(cuts="midpoint"))
        refused(["theorem"], lambda r: r.update(theorem="MidpointBounds"))
        refused(["theorem"], lambda r: r["method"].update(name="embedding"))
        refused(["written"], lambda r: r["guarantee"].update(holds=False))
        refused(["file_checksum"], lambda r: r["mesh"].pop("file_checksum"))
        refused([], lambda r: r["mesh"].update(file_checksum="0x12"))
        refused(["another mesh"], lambda r: r["mesh"].update(tets=r["mesh"]["tets"] - 1))

    def test_a_run_of_an_older_version(self):
        """It named a guarantee where edges were cut in the middle, and no method."""
        run = self.made("-o", "t.vtu", "--cuts", "midpoint")
        del run["method"], run["theorem"]
        run["guarantee"].update(asked="angles", used="angles")
        (self.folder / "run.json").write_text(json.dumps(run))
        self.assertEqual(self.against_run("t.vtu")[0], 0)

    def test_the_run_of_other_bounds(self):
        # The file of one run, and the JSON of another with the same content by its word.
        midpoint = self.made("--cuts", "midpoint", "-o", "m.vtu")
        bisected = self.made("-o", "t.vtu")
        for key in ("points", "tets", "file_checksum"):
            midpoint["mesh"][key] = bisected["mesh"][key]
        (self.folder / "lie.json").write_text(json.dumps(midpoint))
        status, report = self.against_run("t.vtu", "lie.json")
        self.assertEqual(status, 1)
        self.assertIn("outside of the 30 to 135 of theorem MidpointBounds", report["failures"][0])


if __name__ == "__main__":
    unittest.main()
