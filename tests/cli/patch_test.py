"""Patches of the boundary: sides of the box, those that are named, and how large they are."""

import math
import re
import unittest

from images import voxels, write_nrrd
from program import ProgramTest

USAGE = 2
SIDES = ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")
BALL = ("--expr", "x^2+y^2+z^2-1", "--bounds", "-2,-2,-0.5,2,2,2", "--size", "0.1")
BOX = ("--expr=-1", "--bounds", "-1,-1.5,-2,1,1.5,2", "--size", "0.2")


def named(text):
    """The names of Gmsh's physical surfaces, by their numbers."""
    return {int(n): name for n, name in re.findall(r'^2 (\d+) "([^"]*)"$', text, re.M)}


class Patches(ProgramTest):
    def areas(self, *arguments):
        told = self.mesh(*arguments)
        return {one["name"]: one["area"] for one in told.get("patches", [])}

    def test_all_sides_of_a_box(self):
        areas = self.areas(*BOX, "-o", "a.msh", "--format", "msh22")
        self.assertEqual(set(areas) - {"surface"}, set(SIDES))
        text = (self.folder / "a.msh").read_text()
        self.assertEqual({n: name for n, name in named(text).items() if name != "surface"},
                         dict(enumerate(SIDES, 3)))
        for side, area in zip(SIDES, (12, 12, 8, 8, 6, 6)):
            self.assertLess(abs(areas[side] / area - 1), 0.15, side)
        run = self.run_certet("mesh", *BOX, "-o", "a.msh")
        self.assertRegex(run.stdout, r"(?m)^patch +zmax: [\d,]+ triangles, area [\d.]+$")

    def test_a_flat_side_has_its_area(self):
        areas = self.areas(*BALL, "-o", "a.inp")
        self.assertEqual(set(areas), {"surface", "zmin"})
        # Triangles that have a corner on the ball, along the rim, belong to the surface.
        disk = 0.75 * math.pi
        self.assertLess(areas["zmin"], disk)
        self.assertGreater(areas["zmin"], disk - 0.1 * 2 * math.pi * math.sqrt(0.75))
        self.assertLess(abs((areas["surface"] + areas["zmin"]) / (3 * math.pi + disk) - 1), 0.02)

    def test_what_is_cut_off_nowhere_has_none(self):
        told = self.mesh("--shape", "sphere:1", "--size", "0.2", "-o", "a.msh", "--format", "msh22")
        self.assertNotIn("patches", told)
        self.assertEqual(named((self.folder / "a.msh").read_text()), {1: "surface"})

    def test_a_full_image_has_all_sides(self):
        """Points of the lattice lie in the faces of the voxels."""
        shape, faces = (10, 5, 4), (20, 20, 40, 40, 50, 50)
        for axes in ({}, {"directions": ((1, 0, 0), (0, 1, 0), (0, 0, -1))}):
            write_nrrd(self.folder / "a.nrrd", shape, voxels(shape, lambda i, j, k: 1 + int(i > 4)),
                       kind="B", **axes)
            for method in ("embedded", "midpoint", "paper"):
                for smooth in ((), ("--smooth", 0)):
                    with self.subTest(axes=axes, method=method, smooth=smooth):
                        areas = self.areas("a.nrrd", "-o", "a.inp", "--method", method, *smooth)
                        self.assertEqual(set(areas) - {"surface"}, set(SIDES))
                        for side, area in zip(SIDES, faces):
                            self.assertGreater(areas[side], 0.75 * area, side)
                            self.assertLess(areas[side], 1.25 * area, side)

    def test_scale_and_frame_are_those_of_the_output(self):
        write_nrrd(self.folder / "a.nrrd", (8, 9, 10),
                   voxels((8, 9, 10), lambda i, j, k: int(i < 5)), kind="B")
        lps, ras, large = (self.areas("a.nrrd", "-o", "a.msh", *more) for more in
                           ((), ("--frame", "ras"), ("--scale", 10)))
        self.assertIn("xmin", lps)
        self.assertNotIn("xmax", lps)
        self.assertEqual(lps["xmin"], ras["xmax"])
        self.assertEqual(lps["ymin"], ras["ymax"])
        self.assertEqual(lps["zmin"], ras["zmin"])
        for name, area in lps.items():
            self.assertAlmostEqual(large[name] / area, 100, places=6)

    def test_names(self):
        plain = self.areas(*BALL, "-o", "a.msh")
        areas = self.areas(*BALL, "-o", "a.msh", "--format", "msh22", "--patch", "floor=zmin",
                           "--patch", "wall=surface", "--patch", "top=z:1")
        self.assertEqual(list(areas), ["floor", "wall", "top"])
        self.assertEqual(areas["floor"], plain["zmin"])
        self.assertAlmostEqual(areas["wall"] + areas["top"], plain["surface"], places=9)
        self.assertLess(areas["top"], 2 * math.pi * 0.05)  # a cap half an edge high
        self.assertGreater(areas["top"], math.pi * 0.05)
        self.assertEqual(named((self.folder / "a.msh").read_text()),
                         {9: "floor", 10: "wall", 11: "top"})

    def test_names_come_through_every_format_that_has_names(self):
        names = ("--patch", "floor=zmin", "--patch", "top=z:1")
        for name, words in (("a.inp", "NAME={}\n"), ("a.feb", '<Surface name="{}">'),
                            ("a.bdf", "$ points of {}\n"), ("a.k", "*SET_SEGMENT_TITLE\n{}\n"),
                            ("a.mfem", "is {}\n"), ("a.msh", '"{}"')):
            self.mesh(*BALL, "-o", name, *names)
            text = (self.folder / name).read_bytes().decode(errors="replace")
            for patch in ("surface", "floor", "top"):
                self.assertIn(words.format(patch), text, name)
            self.assertNotIn("zmin", text)
        for name in ("a.inp", "a.feb", "a.bdf", "a.k", "a.mfem"):
            run = self.run_certet("convert", "a.msh", "c" + name)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual((self.folder / name).read_bytes(),
                             (self.folder / ("c" + name)).read_bytes(), name)

    def test_numbers_come_back(self):
        """Through a format that has no names."""
        write_nrrd(self.folder / "a.nrrd", (8, 9, 10),
                   voxels((8, 9, 10), lambda i, j, k: 1 + int(i > 3) + int(k > 5)), kind="B")
        for source in ("a.mesh", "a.meshb"):
            for options in ((), ("--patch", "inlet=xmin", "--patch", "patch_10=ymin")):
                self.mesh("a.nrrd", "-o", source, *options)
                self.mesh("a.nrrd", "-o", "a.msh", *options)
                for target in ("b.mesh", "b.meshb"):
                    with self.subTest(source=source, target=target, options=options):
                        self.mesh("a.nrrd", "-o", "c" + target, *options)
                        self.run_certet("convert", source, target)
                        self.assertEqual((self.folder / target).read_bytes(),
                                         (self.folder / ("c" + target)).read_bytes())
                self.run_certet("convert", source, "b.msh", "--format", "msh22")
                names = named((self.folder / "b.msh").read_text(errors="replace"))
                self.assertEqual([names.get(n) for n in (3, 4, 9)],
                                 [None, "xmax", "patch_9"] if options else
                                 ["xmin", "xmax", names[9]])

    def test_interfaces_are_checked_behind_patches(self):
        write_nrrd(self.folder / "a.nrrd", (8, 9, 10),
                   voxels((8, 9, 10), lambda i, j, k: 1 + int(i > 3)), kind="B")
        for name in ("a.mesh", "a.msh"):
            for options in ((), ("--patch", "inlet=xmin")):
                self.mesh("a.nrrd", "-o", name, *options)
                self.assertTrue(self.check(name)["ok"])

    def test_formats_that_have_none(self):
        for name in ("a.vtu", "a.stl", "a.ply"):
            self.assert_fails(USAGE, ["--patch"], "mesh", *BALL, "-o", name, "--patch", "a=zmin")
            self.assertNotIn("patches", self.mesh(*BALL, "-o", name))
            (self.folder / name).unlink()

    def test_refusals(self):
        for patch, words in (("a", ["inlet=xmin"]), ("=xmin", ["letter"]),
                             ("1=xmin", ["letter"]), ("zmin=xmin", ["zmin"]),
                             ("a=bottom", ["bottom", "xmin"]), ("a=z:", ["z:"]),
                             ("a=z:inf", ["z:inf"]), ("a=xmin", ["no patch 'xmin'"]),
                             ("a=z:3", ["z:3", "0.05", "from z = -0.5"])):
            with self.subTest(patch):
                self.assert_fails(USAGE, words, "mesh", *BALL, "-o", "a.msh", "--patch", patch)
        for patches in (("a=zmin", "A=surface"), ("a=zmin", "b=zmin")):
            self.assert_fails(USAGE, ["'A'" if "A" in patches[1] else "'a'"], "mesh", *BALL,
                              "-o", "a.msh", "--patch", patches[0], "--patch", patches[1])


if __name__ == "__main__":
    unittest.main()
