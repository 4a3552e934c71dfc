"""Images beside surfaces, formulas and shapes; what is inside of one and not in another."""

import math
import unittest

import images
import surfaces
import vtu
from surface_program import SurfaceProgramTest

USAGE, BAD_INPUT, EMPTY = 2, 3, 4
BALL = 4 / 3 * math.pi


def distance(point, centre):
    return math.dist(point, centre)


class MixedTest(SurfaceProgramTest):
    SIZE, CENTRE, RADIUS = (20, 20, 20), (9.5, 9.5, 9.5), 7

    def values(self, value):
        return images.voxels(self.SIZE, lambda *at: value(distance(at, self.CENTRE), at))

    def setUp(self):
        """A ball of voxels, of two labels; the same ball in gray; an implant through its side."""
        super().setUp()
        self.labels = self.values(lambda r, at: 0 if r > self.RADIUS else 2 if at[0] < 9 else 5)
        images.write_nrrd(self.folder / "seg.nrrd", self.SIZE, self.labels, "B")
        gray = self.values(lambda r, at: round(100 * (10 - r)))
        images.write_nrrd(self.folder / "ct.nrrd", self.SIZE, gray)
        self.ball("implant.stl", (9.5, 9.5, 16.5), 4)

    def ball(self, name, centre, radius):
        points, faces = surfaces.sphere(radius)
        moved = [tuple(p + c for p, c in zip(point, centre)) for point in points]
        (self.folder / name).write_bytes(surfaces.stl((moved, faces)))

    def lens(self):
        """Of the implant's volume, what is in the ball, on whose surface its centre is."""
        d, r = self.RADIUS, 4
        return (math.pi * r**2 * (d * d + 2 * d * r - 3 * r * r + 2 * d * d + 6 * r * d - 3 * d * d)
                / (12 * d))

    def volumes(self, *arguments):
        report = self.mesh(*arguments, "-o", "a.vtu")
        self.check("a.vtu")
        return {r["name"]: r["volume"] for r in report["regions"]}, report


class ImagesAmongMaterials(MixedTest):
    def test_labels_and_an_implant(self):
        whole, implant = BALL * 343, BALL * 64
        volumes, report = self.volumes("seg.nrrd", "implant.stl")
        self.assertEqual([(r["label"], r["name"]) for r in report["regions"]],
                         [(2, "2"), (5, "5"), (6, "implant")])
        self.assertEqual(report["lattice"]["size"], 1)
        self.assertAlmostEqual(volumes["implant"], implant, delta=0.04 * implant)
        self.assertAlmostEqual(volumes["2"] + volumes["5"], whole - self.lens(), delta=0.03 * whole)
        self.assertEqual(set(vtu.numbers(self.folder / "a.vtu", "label")), {2, 5, 6})
        volumes, _ = self.volumes("seg.nrrd", "implant.stl", "--priority", "seg")
        self.assertAlmostEqual(volumes["2"] + volumes["5"], whole, delta=0.03 * whole)
        self.assertAlmostEqual(volumes["implant"], implant - self.lens(), delta=0.06 * implant)

    def test_an_image_as_one_material(self):
        whole = BALL * 343
        for image in ("seg.nrrd", "seg.nrrd@labels=2,5", "ct.nrrd@iso=300", "ct.nrrd@iso=300..2000"):
            volumes, report = self.volumes("--material", f"bone={image}", "implant.stl")
            self.assertEqual([(r["label"], r["name"]) for r in report["regions"]],
                             [(1, "implant"), (2, "bone")])
            self.assertAlmostEqual(volumes["bone"], whole, delta=0.03 * whole, msg=image)
        volumes, _ = self.volumes("--material", "half=seg.nrrd@labels=2", "implant.stl")
        self.assertLess(volumes["half"], 0.55 * whole)
        volumes, _ = self.volumes("ct.nrrd", "implant.stl", "--iso", "300", "--priority", "ct")
        self.assertAlmostEqual(volumes["ct"], whole, delta=0.03 * whole)

    def test_chosen_merged_and_named_labels(self):
        (self.folder / "names.txt").write_text("2 left\n5 right\n6 metal\n")
        volumes, _ = self.volumes("seg.nrrd", "implant.stl", "--label-names", "names.txt")
        self.assertEqual(set(volumes), {"left", "right", "metal"})
        volumes, report = self.volumes("seg.nrrd", "implant.stl", "--labels", "5")
        self.assertEqual([r["label"] for r in report["regions"]], [5, 6])
        volumes, report = self.volumes("seg.nrrd", "implant.stl", "--merge", "2=bone,5=bone")
        self.assertEqual([r["name"] for r in report["regions"]], ["bone", "implant"])

    def test_flat_faces_and_other_methods(self):
        for more in (["--smooth", "0"], ["--method", "midpoint"], ["--method", "paper"],
                     ["--smooth", "1.5"]):
            volumes, report = self.volumes("seg.nrrd", "implant.stl", *more)
            self.assertAlmostEqual(sum(volumes.values()), BALL * 407 - self.lens(), delta=80)

    def test_away_from_the_implant_the_mesh_is_the_image_s(self):
        """Points on the far side are the same as without it."""
        self.mesh("seg.nrrd", "-o", "alone.vtu")
        self.mesh("seg.nrrd", "implant.stl", "-o", "both.vtu")

        def far_points(name):
            numbers = list(vtu.numbers(self.folder / name, "Points"))
            points = zip(numbers[::3], numbers[1::3], numbers[2::3])
            return {tuple(round(c, 6) for c in p) for p in points if p[2] < 9}

        alone = far_points("alone.vtu")
        self.assertGreater(len(alone), 1000)
        self.assertEqual(alone, far_points("both.vtu"))

    def test_an_oblique_image_and_a_second_one(self):
        c, s = math.cos(0.4), math.sin(0.4)
        axes = ((c, s, 0), (-s, c, 0), (0, 0, 1))
        images.write_nrrd(self.folder / "turned.nrrd", self.SIZE, self.labels, "B", axes)
        whole = BALL * 343
        volumes, report = self.volumes("turned.nrrd", "--material", "other=seg.nrrd",
                                       "implant.stl")
        self.assertAlmostEqual(volumes["other"] + volumes["implant"],
                               whole + BALL * 64 - self.lens(), delta=0.04 * whole)
        self.assertEqual(report["warnings"], [])

    def test_same_bytes_for_every_thread_count_and_memory(self):
        for arguments in (["seg.nrrd", "implant.stl"], ["seg.nrrd", "--subtract", "implant.stl"]):
            reports = [self.mesh(*arguments, "-o", f"{n}.vtu", *more)
                       for n, more in enumerate((["--threads", "1"], ["--threads", "2"],
                                                 ["--max-memory", "6M"]))]
            self.assertEqual(len({r["mesh"]["checksum"] for r in reports}), 1)
            self.assertEqual(len({(self.folder / f"{n}.vtu").read_bytes() for n in range(3)}), 1)


class Frames(MixedTest):
    def test_surfaces_are_in_the_axes_of_the_output(self):
        """The image is in LPS, and the implant in RAS has x and y turned round."""
        lps, _ = self.volumes("seg.nrrd", "implant.stl")
        self.ball("implant.stl", (-9.5, -9.5, 16.5), 4)
        ras, report = self.volumes("seg.nrrd", "implant.stl", "--frame", "ras")
        self.assertEqual(report["output"]["frame"], "ras")
        for name, volume in lps.items():
            self.assertAlmostEqual(ras[name], volume, delta=1e-6 * volume)
        subtracted = self.mesh("seg.nrrd", "--subtract", "implant.stl", "--frame", "ras", "-o",
                               "b.vtu")
        self.assertAlmostEqual(subtracted["mesh"]["volume"], lps["2"] + lps["5"],
                               delta=0.01 * lps["2"])
        numbers = list(vtu.numbers(self.folder / "b.vtu", "Points"))
        self.assertLess(max(numbers[::3]), 0)

    def test_a_nifti_file(self):
        images.write_nifti(self.folder / "seg.nii", self.SIZE, self.labels)
        volumes, _ = self.volumes("seg.nii", "implant.stl", "--frame", "input")
        self.assertAlmostEqual(sum(volumes.values()), BALL * 407 - self.lens(), delta=40)


class InsideAndSubtract(MixedTest):
    def volume(self, *arguments):
        report = self.mesh(*arguments, "-o", "a.vtu")
        self.check("a.vtu")
        return report["mesh"]["volume"], report

    def test_labels_keep_their_numbers(self):
        volume, report = self.volume("seg.nrrd", "--subtract", "implant.stl")
        self.assertAlmostEqual(volume, BALL * 343 - self.lens(), delta=0.02 * volume)
        self.assertEqual([r["label"] for r in report["regions"]], [2, 5])
        self.assertEqual(report["input"]["subtract"], ["implant.stl"])
        volume, _ = self.volume("seg.nrrd", "--inside", "implant.stl")
        self.assertAlmostEqual(volume, self.lens(), delta=0.05 * volume)

    def test_gray_images(self):
        volume, _ = self.volume("ct.nrrd", "--iso", "300", "--subtract", "implant.stl")
        self.assertAlmostEqual(volume, BALL * 343 - self.lens(), delta=0.02 * volume)
        volume, _ = self.volume("implant.stl", "--inside", "ct.nrrd@iso=300", "--size", "0.5")
        self.assertAlmostEqual(volume, self.lens(), delta=0.04 * volume)

    def test_a_ball_without_a_cylinder(self):
        """What is left of a ball is the same for each kind of it."""
        left = BALL * (1 - 0.25)**1.5 * 8  # of radius 2, less a hole of radius 1
        self.ball("ball.stl", (0, 0, 0), 2)
        for ball in (["ball.stl"], ["--shape", "sphere:2"], ["--material", "b=sphere:2"],
                     ["--expr", "x^2+y^2+z^2-4", "--bounds=-3,-3,-3,3,3,3"]):
            volume, report = self.volume(*ball, "--subtract", "cylinder:1,6", "--size", "0.15")
            self.assertAlmostEqual(volume, left, delta=0.02 * left)
            self.assertEqual(report["warnings"], [], ball)
        volume, report = self.volume("ball.stl", "--subtract", "cylinder:1,6", "--subtract",
                                     "box:9,9,1", "--size", "0.15")
        self.assertLess(volume, 0.8 * left)
        self.assertEqual(report["mesh"]["pieces"]["by_faces"], 2)

    def test_a_gyroid_in_a_surface(self):
        """It needs no --bounds, and fills the box as the shape fills its own."""
        (self.folder / "box.stl").write_bytes(surfaces.stl(surfaces.cube((1, 2, 3), (3, 4, 5))))
        own = self.mesh("--shape", "gyroid:1,0.2", "-o", "g.vtu", "--size", "0.05")
        volume, _ = self.volume("--shape", "gyroid:1,0.2", "--inside", "box.stl", "--size", "0.05")
        self.assertAlmostEqual(volume, own["mesh"]["volume"], delta=0.02 * volume)
        gyroid = "sin(2*pi*x)*cos(2*pi*y)+sin(2*pi*y)*cos(2*pi*z)+sin(2*pi*z)*cos(2*pi*x)"
        volume, _ = self.volume("--expr", gyroid, "--inside", "box.stl", "--size", "0.05")
        self.assertAlmostEqual(volume, 4, delta=0.1)

    def test_all_materials_are_trimmed(self):
        volumes, report = self.volumes("--material", "ball=sphere:2", "--material", "core=sphere:1",
                                       "--subtract", "box:9,9,0.5", "--inside", "cylinder:1.5,9",
                                       "--size", "0.1")
        self.assertAlmostEqual(volumes["core"], BALL - math.pi * (0.5 - 0.25**3 * 2 / 3),
                               delta=0.08)
        self.assertEqual(report["mesh"]["pieces"]["by_faces"], 2)

    def test_refusals(self):
        self.ball("ball.stl", (90, 0, 0), 2)

        def refused(words, *arguments, status=USAGE):
            self.assert_fails(status, words, "mesh", *arguments, "-o", "out.vtu")

        refused(["inside"], "seg.nrrd", "--inside", "ball.stl", status=EMPTY)
        refused(["'none.stl'"], "seg.nrrd", "--inside", "none.stl", status=BAD_INPUT)
        refused(["'none.nrrd'"], "implant.stl", "--subtract", "none.nrrd", status=BAD_INPUT)
        refused(["--bounds"], "implant.stl", "--subtract", "x^2-1")
        refused(["@labels"], "seg.nrrd", "--subtract", "implant.stl@labels=1")
        refused(["@iso"], "seg.nrrd", "--subtract", "implant.stl@iso=1")
        refused(["--crop"], "implant.stl", "--subtract", "seg.nrrd", "--crop", "0,0,0,1,1,1")
        refused(["--labels", "none among"], "implant.stl", "--inside", "sphere:1", "--labels", "1")
        refused(["--frame", "does not tell"], "implant.stl", "--subtract", "seg.nrrd", "--frame",
                "ras")
        (self.folder / "again.nrrd").write_bytes((self.folder / "seg.nrrd").read_bytes())
        refused(["'seg' and 'again' both have label 2"], "seg.nrrd", "again.nrrd",
                status=BAD_INPUT)
        self.assert_fails(USAGE, ["same file", "'implant.stl'"], "mesh", "seg.nrrd", "--subtract",
                          "implant.stl", "-o", "implant.stl")


if __name__ == "__main__":
    unittest.main()
