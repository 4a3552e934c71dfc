"""`certet convert` keeps the mesh, whatever the formats on the way."""

import json
import unittest

import vtu
from images import voxels, write_nrrd
from program import TORUS, ProgramTest

USAGE, BAD_INPUT, WRITE_FAILED = 2, 3, 6
READABLE = {"vtu": "x.vtu", "vtu-zlib": "x.vtu", "medit": "x.mesh", "meditb": "x.meshb",
            "msh": "x.msh", "msh22": "x.msh"}
WRITTEN = {"inp": "x.inp", "feb": "x.feb", "bdf": "x.bdf", "k": "x.k", "mfem": "x.mfem", "xdmf": "x.xdmf", "vtkhdf": "x.vtkhdf",
           "tetgen": "x.node", "polymesh": "polyMesh", "vtp": "x.vtp", "stl": "x.stl", "ply": "x.ply"}


class Convert(ProgramTest):
    def convert(self, source, target, *options):
        run = self.run_certet("convert", source, target, *options, "--json", "-")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)["mesh"]

    def setUp(self):
        super().setUp()
        write_nrrd(self.folder / "a.nrrd", (9, 8, 7),
                   voxels((9, 8, 7), lambda i, j, k: (i + j * k) // 9 % 4))
        self.mesh("a.nrrd", "-o", "a.vtu")

    def test_every_pair(self):
        truth = self.convert("a.vtu", "b.vtu")
        labels = vtu.numbers(self.folder / "a.vtu", "label")
        self.assertEqual(truth["regions"], len(set(labels)))
        for one, first in READABLE.items():
            with self.subTest(one):
                self.assertEqual(self.convert("a.vtu", first, "--format", one), truth)
                self.assertEqual(self.convert(first, "back.vtu"), truth)
                self.assertEqual(vtu.numbers(self.folder / "back.vtu", "label"), labels)
                # Which way the axes go, .vtu alone can tell.
                told = b"" if "vtu" in one else b"<!-- SPACE=LPS -->\n"
                self.assertEqual((self.folder / "back.vtu").read_bytes(),
                                 (self.folder / "a.vtu").read_bytes().replace(told, b"", 1))
                for other, second in READABLE.items():
                    if first != second:
                        self.assertEqual(
                            self.convert(first, "y" + second, "--format", other), truth)
                for other, second in WRITTEN.items():
                    self.assertEqual(self.convert(first, second), truth)
                self.assertTrue(self.check(first)["ok"])

    def test_the_same_as_written_at_once(self):
        for name in ("m.mesh", "m.meshb", "m.stl"):
            self.mesh("--expr", TORUS[1], "--bounds", "-2,-2,-2,2,2,2", "--size", "0.2",
                      "-o", name)
            self.mesh("--expr", TORUS[1], "--bounds", "-2,-2,-2,2,2,2", "--size", "0.2",
                      "-o", "m.vtu")
            self.convert("m.vtu", "c" + name)
            self.assertEqual((self.folder / name).read_bytes(),
                             (self.folder / ("c" + name)).read_bytes(), name)

    def test_patches_are_kept(self):
        sphere = ("--expr", "x^2+y^2+z^2-1", "--bounds", "-0.7,-2,-2,2,2,2", "--size", "0.3")
        for name in ("b.inp", "b.feb", "b.mesh", "b.node", "b.msh"):
            self.mesh(*sphere, "-o", name)
        for format, source in READABLE.items():
            if "vtu" in format:
                continue  # has no patches
            self.mesh(*sphere, "-o", source, "--format", format)
            for name in ("b.inp", "b.feb", "b.mesh", "b.node", "b.msh"):
                with self.subTest(source=format, target=name):
                    self.convert(source, "c" + name)
                    for file in (name, name.replace("node", "face")):
                        self.assertEqual((self.folder / ("c" + file)).read_bytes(),
                                         (self.folder / file).read_bytes())
        self.convert("b.mesh", "d.mesh")
        text = (self.folder / "d.mesh").read_text()
        rows = text[text.index("Triangles"):].split("\n")[2:-1]
        patches = {row.split()[-1] for row in rows if len(row.split()) == 4}
        self.assertEqual(patches, {"1", "3"})  # xmin

    def test_other_numbers_are_no_patches(self):
        self.mesh("--expr", "x^2+y^2+z^2-1", "--bounds", "-0.7,-2,-2,2,2,2", "--size", "0.3",
                  "-o", "b.mesh")
        text = (self.folder / "b.mesh").read_text()
        at = text.index("Triangles")
        first = text[at:].split("\n")[2]
        (self.folder / "e.mesh").write_text(
            text[:at] + text[at:].replace(first, first[:-1] + "8", 1))
        self.convert("e.mesh", "e.inp")  # the first triangle does not look upwards
        for name in ("border", "xmin", "zmax"):
            self.assertNotIn(name, (self.folder / "e.inp").read_text())

    def test_names_are_kept(self):
        (self.folder / "names.txt").write_text("1 Liver\n2 Spleen\n3 Gut\n")
        self.convert("a.vtu", "n.msh", "--label-names", "names.txt")
        self.convert("n.msh", "n.feb")
        text = (self.folder / "n.feb").read_text()
        for name in ("Liver", "Spleen", "Gut"):
            self.assertIn(f'name="{name}"', text)

    def test_failures(self):
        self.assert_fails(USAGE, ["same file"], "convert", "a.vtu", "./a.vtu")
        self.assert_fails(USAGE, ["extension", "x.obj"], "convert", "a.vtu", "x.obj")
        self.assert_fails(USAGE, ["--compress"], "convert", "a.vtu", "x.msh", "--compress")
        self.assert_fails(BAD_INPUT, ["none.vtu"], "convert", "none.vtu", "x.msh")
        self.assert_fails(BAD_INPUT, ["extension", ".msh"], "convert", "a.nrrd", "x.msh")
        self.assert_fails(WRITE_FAILED, ["no/x.msh"], "convert", "a.vtu", "no/x.msh")
        (self.folder / "x.ele").mkdir()
        self.assert_fails(WRITE_FAILED, ["x.ele"], "convert", "a.vtu", "x.node")
        (self.folder / "bad.txt").write_text("1 a\nliver\n")
        self.assert_fails(BAD_INPUT, ["bad.txt", "line 2"], "convert", "a.vtu", "x.msh",
                          "--label-names", "bad.txt")

    def test_an_index_beyond_the_points(self):
        vtu.overwrite(self.folder / "a.vtu", "connectivity", 40, "i", 10 ** 8)
        self.assert_fails(BAD_INPUT, ["a.vtu", "not there"], "convert", "a.vtu", "x.msh")

    def test_damaged_files(self):
        for name in ("a.msh", "a.meshb", "a.mesh"):
            self.convert("a.vtu", name)
            whole = (self.folder / name).read_bytes()
            for length in range(0, len(whole) - 4, len(whole) // 40):
                (self.folder / name).write_bytes(whole[:length])
                self.assert_fails(BAD_INPUT, [name], "check", name)


if __name__ == "__main__":
    unittest.main()
