"""certet voxelise: meshes as voxels, and how they compare with the image that was meshed."""

import json
import resource
import unittest

from images import read_bytes_of_nrrd, voxels, write_nrrd
from program import TORUS, ProgramTest

SIZE = (24, 22, 20)


def balls(i, j, k):
    """Two that overlap."""
    if (i - 15) ** 2 + (j - 11) ** 2 + (k - 9) ** 2 < 36:
        return 9
    return 4 if (i - 9) ** 2 + (j - 10) ** 2 + (k - 10) ** 2 < 49 else 0


class Voxelise(ProgramTest):
    def setUp(self):
        super().setUp()
        self.labels = voxels(SIZE, balls)
        write_nrrd(self.folder / "a.nrrd", SIZE, self.labels,
                   directions=((0, 2, 0), (-1.5, 0, 0), (0, 0, 1)), origin=(7, -8, 9))

    def voxelise(self, *arguments, warnings=()):
        run = self.run_certet("voxelise", *arguments, "--json", "-")
        self.assertEqual(run.returncode, 0, run.stderr)
        told = json.loads(run.stdout)
        self.assertEqual(len(told["warnings"]), len(warnings), told["warnings"])
        for words, warning in zip(warnings, told["warnings"]):
            self.assertIn(words, warning)
            self.assertIn(f"certet: warning: {warning}\n", run.stderr)
        return told

    def test_a_label_image_comes_back(self):
        self.mesh("a.nrrd", "-o", "a.vtu")
        told = self.voxelise("a.vtu", "-o", "b.nrrd", "--compare", "a.nrrd")
        self.assertEqual(told["grid"]["size"], list(SIZE))
        self.assertEqual(told["grid"]["spacing"], [2, 1.5, 1])
        self.assertEqual([row["label"] for row in told["labels"]], [4, 9])
        made = read_bytes_of_nrrd(self.folder / "b.nrrd")
        for row in told["labels"]:
            label = row["label"]
            self.assertEqual(row["voxels"], made.count(label))
            self.assertEqual(row["image_voxels"], self.labels.count(label))
            both = sum(a == b == label for a, b in zip(made, self.labels))
            self.assertEqual(row["both"], both)
            self.assertAlmostEqual(row["dice"], 2 * both / (row["voxels"] + row["image_voxels"]))
            self.assertGreater(row["dice"], 0.98)
        self.assertEqual(told["compared"]["least_dice"], min(r["dice"] for r in told["labels"]))
        self.assertEqual(told["voxels"], {"held": len(made) - made.count(0), "held_twice": 0})

    def test_the_table_has_a_line_for_each_label(self):
        self.mesh("a.nrrd", "-o", "a.vtu")
        run = self.run_certet("voxelise", "a.vtu", "--compare", "a.nrrd")
        self.assertRegex(run.stdout, r"compared   with a\.nrrd: Dice \S+ on average over 2 labels")
        self.assertRegex(run.stdout, r"dice       [01]\.\d{4}  4: \d+ voxels, \d+ in the image\n"
                                     r" {11}[01]\.\d{4}  9: \d+ voxels, \d+ in the image\n")
        self.assertEqual(self.files(), ["a.nrrd", "a.vtu"])

    def test_the_same_from_every_format_and_for_all_threads(self):
        self.mesh("a.nrrd", "-o", "a.vtu")
        bytes_of = set()
        for name in ("a.vtu", "a.msh", "a.mesh", "a.meshb"):
            if name != "a.vtu":
                self.run_certet("convert", "a.vtu", name)
            for threads in (1, 3):
                self.voxelise(name, "-o", "b.nrrd", "--like", "a.nrrd", "--threads", threads)
                bytes_of.add((self.folder / "b.nrrd").read_bytes())
        self.assertEqual(len(bytes_of), 1)

    def test_formats_of_images(self):
        self.mesh("a.nrrd", "-o", "a.vtu")
        self.voxelise("a.vtu", "-o", "b.nrrd", "--like", "a.nrrd")
        for name in ("b.mha", "b.nii", "b.nii.gz"):
            self.voxelise("a.vtu", "-o", name, "--like", "a.nrrd")
            # The same voxels in the same places: the mesh has them all.
            for reference in ("b.nrrd", name):
                told = self.voxelise("a.vtu", "--compare", reference)
                self.assertEqual(told["compared"]["least_dice"], 1)

    def test_axes_to_the_right(self):
        self.mesh("a.nrrd", "-o", "ras.vtu", "--frame", "ras")
        self.mesh("a.nrrd", "-o", "ras.mesh", "--frame", "ras")
        self.mesh("a.nrrd", "-o", "lps.vtu")
        self.voxelise("lps.vtu", "-o", "b.nrrd", "--like", "a.nrrd")
        for arguments in (["ras.vtu"], ["ras.mesh", "--frame", "ras"]):
            told = self.voxelise(*arguments, "--compare", "b.nrrd")
            self.assertEqual(told["compared"]["least_dice"], 1)
        told = self.voxelise("ras.mesh", "--compare", "b.nrrd")
        self.assertLess(told["compared"]["least_dice"], 0.5, "a .mesh file does not tell")

    def test_a_grid_around_the_mesh(self):
        mesh = self.mesh(*TORUS, "--size", "0.1", "-o", "a.vtu")["mesh"]
        told = self.voxelise("a.vtu", "-o", "b.mha", "--spacing", "0.05,0.05,0.04")
        self.assertAlmostEqual(told["voxels"]["held"] * 0.05 * 0.05 * 0.04, mesh["volume"], delta=0.02)
        self.assertEqual([row["label"] for row in told["labels"]], [1])

    def test_a_mesh_that_overlaps_itself(self):
        corners = "0 0 0 0\n9 0 0 0\n0 9 0 0\n0 0 9 0\n"
        (self.folder / "twice.mesh").write_text(
            f"MeshVersionFormatted 2\nDimension 3\nVertices\n4\n{corners}"
            "Tetrahedra\n2\n1 2 3 4 0\n1 2 3 4 5\nEnd\n")
        told = self.voxelise("twice.mesh", "-o", "b.nrrd", "--spacing", "1,1,1",
                             warnings=["several tetrahedra", "region 0"])
        self.assertEqual(told["voxels"]["held"], told["voxels"]["held_twice"])
        self.assertEqual(told["labels"], [], "the first tetrahedron has the voxels")

    def test_what_is_refused(self):
        self.mesh("a.nrrd", "-o", "a.vtu")
        write_nrrd(self.folder / "other.nrrd", (3, 3, 3), [1] * 27)
        like = ("--like", "a.nrrd")
        for status, words, arguments in (
                (2, ["needs an output"], like),
                (2, ["--like IMAGE or --spacing"], ("-o", "b.nrrd")),
                (2, ["exclude"], ("-o", "b.nrrd", "--spacing", "1,1,1", *like)),
                (2, ["exclude"], ("--compare", "a.nrrd", "--spacing", "1,1,1")),
                (2, [".nii.gz", "b.png"], ("-o", "b.png", *like)),
                (2, ["replace the input 'a.nrrd'"], ("-o", "a.nrrd", *like)),
                (2, ["same file"], ("-o", "b.nrrd", "--json", "b.nrrd", *like)),
                (2, ["positive"], ("-o", "b.nrrd", "--spacing", "1,0,1")),
                (5, ["too small"], ("-o", "b.nrrd", "--spacing", "1,1e-9,1")),
                (6, ["no such folder"], ("-o", "none/b.nrrd", *like)),
                (3, ["none.nrrd"], ("-o", "b.nrrd", "--like", "none.nrrd")),
                (3, ["differ in size"], ("--compare", "other.nrrd", *like))):
            with self.subTest(arguments):
                self.assert_fails(status, words, "voxelise", "a.vtu", *arguments)
        self.assert_fails(3, ["none.vtu"], "voxelise", "none.vtu", "-o", "b.nrrd", *like)

    def test_a_full_disk(self):
        self.mesh("a.nrrd", "-o", "a.vtu")

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))

        for name in ("b.nrrd", "b.mha", "b.nii", "b.nii.gz"):
            with self.subTest(name):
                (self.folder / name).write_text("older")
                self.assert_fails(6, [name, "cannot be written"], "voxelise", "a.vtu", "-o", name,
                                  "--spacing", "0.3,0.3,0.3", preexec_fn=small_files)
                self.assertEqual((self.folder / name).read_text(), "older")


if __name__ == "__main__":
    unittest.main()
