"""Labels: those that were asked for and are not there, and their numbers in other formats."""

import json
import re
import unittest

import vtu
from images import voxels, write_nrrd
from program import ProgramTest

SIZE = (12, 10, 8)


def three(i, j, k):
    return 0 if k in (0, 7) else -4 if i < 4 else 0 if i == 4 else 3


class LabelTest(ProgramTest):
    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "a.nrrd", SIZE, voxels(SIZE, three))

    def warned(self, *arguments):
        """Runs the program; returns the warnings on stderr, which its JSON has too."""
        run = self.run_certet(*arguments, "--json", "r.json")
        self.assertEqual(run.returncode, 0, run.stderr)
        told = json.loads((self.folder / "r.json").read_text())["warnings"]
        self.assertEqual(run.stderr, "".join(f"certet: warning: {text}\n" for text in told))
        for text in told:
            self.assertIn(text, run.stdout)
        return told


class Labels(LabelTest):
    def test_absent_ones_are_named(self):
        for labels, absent in (("3,7", "7"), ("3,7,-4,8,9", "7, 8 or 9"), ("-4-9", None), ("3", None),
                               ("1-9,5", "5"), ("3," + ",".join(map(str, range(10, 21))),
                                                "10, 11, 12, 13, 14, 15, 16, 17, or 3 others that "
                                                "were asked for")):
            told = self.warned("mesh", "a.nrrd", f"--labels={labels}", "-o", "a.vtu")
            self.assertEqual(told, [f"no voxel of 'a.nrrd' has label {absent}"] if absent else [])

    def test_numbers_in_gmsh(self):
        """0, 3 and -4: all keep theirs where they can, and come back."""
        chosen = ("mesh", "a.nrrd", "--labels=-9-9")
        self.assertEqual(self.warned(*chosen, "-o", "a.vtu"), [])
        labels = vtu.numbers(self.folder / "a.vtu", "label")
        self.assertEqual(set(labels), {-4, 0, 3})
        for format in ("msh", "msh22"):
            (told,) = self.warned(*chosen, "-o", "a.msh", "--format", format)
            self.assertIn("label -4 has the number 4, label 0 has the number 5;", told)
            self.assertEqual(self.warned("convert", "a.msh", "b.vtu"), [])
            self.assertEqual(vtu.numbers(self.folder / "b.vtu", "label"), labels)
            (again,) = self.warned("convert", "a.vtu", "b.msh", "--format", format)
            self.assertEqual(again, told)
        groups = re.findall(rb'3 (\d+) "(\w+)"', (self.folder / "a.msh").read_bytes())
        self.assertEqual(groups, [(b"4", b"region_minus_4"), (b"5", b"region_0"), (b"3", b"region_3")])


class Merged(LabelTest):
    def labels(self, *options):
        self.mesh("a.nrrd", "-o", "m.msh", "--format", "msh22", *options)
        self.run_certet("convert", "m.msh", "m.vtu")
        names = dict(re.findall(r'3 (\d+) "([^"]+)"', (self.folder / "m.msh").read_text()))
        return vtu.numbers(self.folder / "m.vtu", "label"), names

    def test_labels_become_one(self):
        plain, _ = self.labels("--labels=-9--1,1-9")
        # Each is read as it was, and chosen as it becomes.
        self.assertEqual(self.labels("--merge=-4=2")[0], [2 if n == -4 else n for n in plain])
        self.assertEqual(self.labels("--merge=-4=3,3=5")[0], [3 if n == -4 else 5 for n in plain])
        self.assertEqual(set(self.labels("--merge=-4=7", "--labels", "7")[0]), {7})
        one, names = self.labels("--merge=3=bone,-4=bone")
        self.assertEqual((set(one), names), ({3}, {"3": "bone"}))
        (self.folder / "m.txt").write_text("# scan 7\n-4 = marrow # inside\n\n3=8\n")
        (self.folder / "n.txt").write_text("-4 liver\n8 gut\n")
        labels, names = self.labels("--merge", "@m.txt", "--label-names", "n.txt")
        self.assertEqual(labels, [8 if n == 3 else n for n in plain])
        self.assertEqual(names, {"9": "marrow", "8": "gut"})

    def test_refusals(self):
        for text in ("1", "1=", "=2", "1-=2", "5-2=1", "1=2,", "x=2", "99999999999=1"):
            self.assert_fails(2, ["merged like"], "mesh", "a.nrrd", f"--merge={text}", "-o", "b.vtu")
        self.assert_fails(2, ["3", "twice"], "mesh", "a.nrrd", "--merge=1-5=1,3=2", "-o", "b.vtu")
        (self.folder / "m.txt").write_text("1=2\nliver\n")
        self.assert_fails(3, ["m.txt", "liver"], "mesh", "a.nrrd", "--merge=@m.txt", "-o", "b.vtu")
        self.assert_fails(3, ["no.txt"], "mesh", "a.nrrd", "--merge=@no.txt", "-o", "b.vtu")
        self.assert_fails(2, ["--merge"], "mesh", "a.nrrd", "--merge=1=2", "--iso=1", "-o", "b.vtu")


class Levels(ProgramTest):
    def setUp(self):
        super().setUp()
        # Rounded, so that no voxel is at a level.
        write_nrrd(self.folder / "g.nrrd", (20, 20, 20), voxels((20, 20, 20), lambda i, j, k: (
            round(100 * ((i - 9.5) ** 2 + (j - 9.5) ** 2 + (k - 9.5) ** 2) ** 0.5))))

    def volume(self, iso):
        return self.mesh("g.nrrd", f"--iso={iso}", "-o", "g.vtu")["mesh"]["volume"]

    def test_volumes(self):
        ball = 4.18879 * 8 ** 3
        self.assertAlmostEqual(self.volume("..800"), ball, delta=0.02 * ball)
        shell = ball - 4.18879 * 4 ** 3
        self.assertAlmostEqual(self.volume("400..800"), shell, delta=0.02 * shell)
        self.assertEqual(self.volume("800.."), self.volume("800"))
        self.assertAlmostEqual(self.volume("800") + self.volume("..800"), 8000, delta=60)

    def test_no_sheet_between_voxels(self):
        write_nrrd(self.folder / "g.nrrd", (12, 12, 12), voxels((12, 12, 12), lambda i, j, k: (
            500 if (i, j, k) == (5, 5, 5) else 1000 if i > 7 else 0)))
        report = self.mesh("g.nrrd", "--iso", "300..700", "--size", "0.25", "-o", "g.vtu")
        self.assertEqual(report["mesh"]["pieces"]["by_faces"], 1)
        self.assertLess(report["mesh"]["volume"], 1)

    def test_refusals(self):
        for iso in ("..", "5..2", "5..5", "a..b", "1...2"):
            self.assert_fails(2, ["--iso"], "mesh", "g.nrrd", f"--iso={iso}", "-o", "b.vtu")


class Formulas(ProgramTest):
    def test_from_a_file(self):
        """27 cells of a truss, more than a command line or one formula of muParser can hold."""
        cells = [(i, j, k) for i in range(3) for j in range(3) for k in range(3)]
        bars = [f"length(max(abs({a} - {p}) - 0.5, 0), {b} - {q}, {c} - {r}) - 0.1"
                for i, j, k in cells for a, p, b, q, c, r in
                (("x", i, "y", j, "z", k), ("y", j, "z", k, "x", i), ("z", k, "x", i, "y", j))]
        padding = " " * 1700
        parts = [f"b{n} = {bar}{padding}; # bar {n}\n" for n, bar in enumerate(bars)]
        union = "min(" + ",\n ".join(f"b{n}" for n in range(len(bars))) + ")"
        (self.folder / "t.txt").write_text("# a truss\n" + "".join(parts) + union + "\n")
        self.assertGreater((self.folder / "t.txt").stat().st_size, 131072)
        place = ("--bounds", "-1,-1,-1,3,3,3", "--size", "0.25", "-o", "a.vtu")
        told = self.mesh("--expr", "@t.txt", *place)
        self.assertEqual(told["input"]["name"], "@t.txt")
        plain = self.mesh("--expr", "min(" + ",".join(bars) + ")", *place)
        self.assertEqual(told["mesh"]["checksum"], plain["mesh"]["checksum"])

    def test_definitions(self):
        place = ("--bounds", "-2,-2,-2,2,2,2", "--size", "0.3", "-o", "a.vtu")
        plain = self.mesh("--expr", "hypot(x,y)-1+(hypot(x,y)>2)", *place)["mesh"]["checksum"]
        named = self.mesh("--expr", "r = hypot(x,y) ;far=r>2;r-1+far", *place)["mesh"]["checksum"]
        self.assertEqual(named, plain)
        for formula, words in (("r-1; x", ["definition"]), ("r = x;", ["cannot be read"]),
                               ("r == x; x", ["definition"]),
                               ("r = q; q = x; r", ["q"]), ("r = x; r = y; r", ["defined already"]), ("x = y; x", ["defined already"]),
                               ("r = ; x", ["cannot be read"]), ("1r = x; x", ["definition"])):
            self.assert_fails(3, words, "mesh", "--expr", formula, *place[:-1], "b.vtu")
        (self.folder / "e.txt").write_text("# nothing\n")
        self.assert_fails(3, ["e.txt", "formula"], "mesh", "--expr", "@e.txt", *place[:-1], "b.vtu")
        self.assert_fails(3, ["no.txt"], "mesh", "--expr", "@no.txt", *place[:-1], "b.vtu")


    def test_a_message_quotes_no_more_than_a_part(self):
        long = "x^2+y^2+z^2+(" + "+".join(f"0*{n}" for n in range(900)) + ")"
        bounds = ("--bounds", "-1,-1,-1,1,1,1", "--size", "0.5", "-o", "a.vtu")
        for formula in (long + "+9", long + "+nix", long + "+" + "n" * 2000):
            run = self.run_certet("mesh", "--expr", formula, *bounds)
            self.assertNotEqual(run.returncode, 0)
            self.assertLess(len(run.stderr), 700)
            self.assertEqual(run.stderr.count("\n"), 1)
        self.assertIn("nnn", run.stderr)
        report = self.mesh("--expr", long + "-0.8", *bounds)
        self.assertEqual(report["input"]["name"], long + "-0.8")
        self.assertLess(max(map(len, report["warnings"]), default=0), 700)


if __name__ == "__main__":
    unittest.main()
