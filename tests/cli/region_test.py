"""Labels that get lost, come apart or grow together; smoothing; cropping."""

import math
import unittest

import vtu
from images import voxels, write_nrrd
from program import ProgramTest

USAGE, EMPTY = 2, 4
SIZE = (24, 20, 22)


def bars(i, j, k):
    """1: a block; 2: a wire of one voxel; 3: two plates joined by a neck of one."""
    if 2 <= i < 10 and 2 <= j < 18 and 2 <= k < 20:
        return 1
    if (j, k) == (4, 4) and i >= 12:
        return 2
    if 12 <= i < 22 and 8 <= j < 18 and (k in range(8, 12) or k in range(16, 20)):
        return 3
    return 3 if (i, j) == (17, 13) and 12 <= k < 16 else 0


def count_pieces(path, label):
    """Of the tetrahedra with a label, joined by their faces; by brute force."""
    labels = vtu.numbers(path, "label")
    parent, faces = {}, {}

    def find(n):
        while parent[n] != n:
            n = parent[n]
        return n

    for n, tet in enumerate(vtu.tets(path)):
        if labels[n] != label:
            continue
        parent[n] = n
        for out in range(4):
            face = frozenset(tet[:out] + tet[out + 1:])
            if face in faces:
                parent[find(n)] = find(faces[face])
            faces[face] = n
    return sum(parent[n] == n for n in parent)


class RegionTest(ProgramTest):
    def write(self, value=bars, size=SIZE, step=1.0, name="a.nrrd"):
        write_nrrd(self.folder / name, size, voxels(size, value), origin=(3, -5, 7),
                   directions=((step, 0, 0), (0, step, 0), (0, 0, step)))

    def regions(self, report):
        return {region["label"]: region for region in report["regions"]}


class Lost(RegionTest):
    def test_nothing_is_lost_at_the_voxels_size(self):
        self.write()
        for size in ("1", "0.6"):
            report = self.mesh("a.nrrd", "--size", size, "-o", "a.vtu")
            self.assertEqual([w for w in report["warnings"] if "label" in w], [])
            labels = vtu.numbers(self.folder / "a.vtu", "label")
            for label, region in self.regions(report).items():
                self.assertEqual(region["tets"], labels.count(label))
                self.assertEqual(count_pieces(self.folder / "a.vtu", label), 1)

    def test_a_lost_label_is_named_with_the_size_that_keeps_it(self):
        self.write()
        report = self.mesh("a.nrrd", "--size", "5", "-o", "a.vtu")
        self.assertEqual(self.regions(report)[2]["tets"], 0)
        [warning] = [w for w in report["warnings"] if w.startswith("label 2")]
        self.assertIn("is not in the mesh", warning)
        size = warning.split("--size ")[1].split()[0]
        self.assertGreater(float(size), 0.45)
        report = self.mesh("a.nrrd", "--size", size, "-o", "a.vtu")
        self.assertGreater(self.regions(report)[2]["tets"], 0)
        self.assertEqual(report["warnings"], [])

    def test_a_split_label_is_named(self):
        self.write()
        report = self.mesh("a.nrrd", "--size", "3.1", "-o", "a.vtu")
        self.assertEqual(self.regions(report)[3]["pieces"], 2)
        self.assertEqual(self.regions(report)[3]["image_pieces"],
                         {"by_corners": 1, "by_faces": 1})
        self.assertEqual(count_pieces(self.folder / "a.vtu", 3), 2)
        self.assertTrue([w for w in report["warnings"]
                         if w.startswith("label 3 has 2 pieces in the mesh, 1 in the image")])

    def test_pieces_are_those_of_the_mesh(self):
        """One label and no warping, so that pieces of lattice points and of
        tetrahedra are the same."""
        self.write(lambda i, j, k: int((i * 7 + j * 5 + k * 3 + i * j * k) % 11 < 3))
        for size in ("1.3", "1.7", "2.4"):
            report = self.mesh("a.nrrd", "--size", size, "--cuts", "midpoint", "-o", "a.vtu")
            self.assertGreater(self.regions(report)[1]["pieces"], 5)
            self.assertEqual(self.regions(report)[1]["pieces"],
                             count_pieces(self.folder / "a.vtu", 1))

    def test_pieces_of_the_image(self):
        corners = {(2, 2, 2), (3, 3, 3), (4, 4, 3), (9, 9, 9), (9, 9, 10)}
        self.write(lambda i, j, k: int((i, j, k) in corners))
        report = self.mesh("a.nrrd", "--size", "1.01", "-o", "a.vtu")
        self.assertEqual(self.regions(report)[1]["image_pieces"],
                         {"by_corners": 2, "by_faces": 4})

    def test_level(self):
        self.write(lambda i, j, k: 100 * (bars(i, j, k) == 3))
        report = self.mesh("a.nrrd", "--iso", "50", "--size", "3.1", "-o", "a.vtu")
        self.assertIn("the solid has 2 pieces", report["warnings"][0])

    def test_warnings_are_sentences_on_stderr(self):
        self.write()
        run = self.run_certet("mesh", "a.nrrd", "--size", "5", "-o", "a.vtu")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"\A(certet: warning: [^\n]+\n)+\Z")
        self.assertIn("label 2", run.stdout)

    def test_many_lost_labels_are_counted(self):
        self.write(lambda i, j, k: 1 + i + 24 * (j // 2) if 4 <= k < 9 else 0)
        report = self.mesh("a.nrrd", "--size", "4.5", "-o", "a.vtu")
        self.assertLess(len(report["warnings"]), 21)  # the volume has one too
        self.assertIn("more labels are not in the mesh", " ".join(report["warnings"]))


class Smooth(RegionTest):
    def ball(self, radius=8, spacing=(1, 1, 1)):
        size = tuple(round(24 / s) for s in spacing)

        def value(i, j, k):
            at = [n * s - 11.5 for n, s in zip((i, j, k), spacing)]
            return (4 if at[0] < 0 else 9) if math.hypot(*at) < radius else 0

        write_nrrd(self.folder / "a.nrrd", size, voxels(size, value),
                   directions=((spacing[0], 0, 0), (0, spacing[1], 0), (0, 0, spacing[2])))

    def roughness(self):
        """How far the surface is from a ball, on average."""
        faces = {}
        for tet in vtu.tets(self.folder / "a.vtu"):
            for out in range(4):
                face = frozenset(tet[:out] + tet[out + 1:])
                faces[face] = faces.get(face, 0) + 1
        points = vtu.points(self.folder / "a.vtu")
        surface = {n for face, count in faces.items() if count == 1 for n in face}
        radii = [math.dist(points[n], (11.5,) * 3) for n in surface]
        mean = sum(radii) / len(radii)
        return math.sqrt(sum((r - mean) ** 2 for r in radii) / len(radii))

    def test_no_staircase(self):
        for spacing in ((1, 1, 1), (1, 1, 2)):
            self.ball(spacing=spacing)
            report = self.mesh("a.nrrd", "--smooth", "0", "-o", "a.vtu")
            self.assertNotIn("smoothing", report)
            rough = self.roughness()
            for options, sigma in (([], None), (["--smooth", "1.2"], 1.2),
                                   (["--smooth", "1.2", "--method", "paper"], 1.2)):
                report = self.mesh("a.nrrd", *options, "-o", "a.vtu")
                self.check("a.vtu")
                self.assertLess(self.roughness(), 0.6 * rough, options)
                self.assertEqual(set(vtu.numbers(self.folder / "a.vtu", "label")), {4, 9})
                smoothing = report["smoothing"]
                self.assertEqual(smoothing.get("sigma"), sigma)
                self.assertAlmostEqual(smoothing["mesh_volume"], report["mesh"]["volume"])
                self.assertLess(abs(smoothing["change"]), 0.1 if "paper" in options else 0.01)
                self.assertAlmostEqual(
                    smoothing["voxel_volume"],
                    spacing[2] * sum(r["voxels"] for r in report["regions"]))
                for region in report["regions"]:
                    self.assertAlmostEqual(region["change_percent"],
                                           100 * (region["volume"] / region["voxel_volume"] - 1))
                    if "paper" not in options:
                        self.assertLess(abs(region["change_percent"]), 2)

    def test_one_label_is_smooth_too(self):
        write_nrrd(self.folder / "a.nrrd", (24, 24, 24), voxels((24, 24, 24), lambda *at: int(
            math.dist(at, (11.5,) * 3) < 8)))
        self.mesh("a.nrrd", "--smooth", "0", "-o", "a.vtu")
        rough = self.roughness()
        report = self.mesh("a.nrrd", "-o", "a.vtu")
        self.assertLess(self.roughness(), 0.4 * rough)
        self.assertLess(abs(report["regions"][0]["change_percent"]), 1)

    def test_by_default_a_crop_has_no_change_of_volume(self):
        self.ball()
        report = self.mesh("a.nrrd", "--crop", "0,0,0,20,20,20", "-o", "a.vtu")
        for region in report["regions"]:
            self.assertNotIn("change_percent", region)

    def test_the_papers_method_is_flat_by_default(self):
        self.ball()
        meshes = []
        for options in ([], ["--smooth", "0"]):
            self.mesh("a.nrrd", "--method", "paper", *options, "-o", "a.vtu")
            meshes.append((self.folder / "a.vtu").read_bytes())
        self.assertTrue(meshes[0] == meshes[1])

    def test_labels_stay_on_their_side(self):
        self.ball()
        self.mesh("a.nrrd", "--smooth", "1", "-o", "a.vtu")
        points = vtu.points(self.folder / "a.vtu")
        for tet, label in zip(vtu.tets(self.folder / "a.vtu"),
                              vtu.numbers(self.folder / "a.vtu", "label")):
            x = sum(points[n][0] for n in tet) / 4
            if abs(x - 11.5) > 0.5:
                self.assertEqual(label, 4 if x < 11.5 else 9)

    def test_same_bytes_for_every_thread_count(self):
        self.ball()
        meshes = []
        for threads in (1, 2, 3):
            self.mesh("a.nrrd", "--smooth", "1.1", "--threads", threads, "-o", "a.vtu")
            meshes.append((self.folder / "a.vtu").read_bytes())
        self.assertTrue(meshes[0] == meshes[1] == meshes[2])
        self.mesh("a.nrrd", "--smooth", "1.15", "-o", "a.vtu")
        self.assertFalse(meshes[0] == (self.folder / "a.vtu").read_bytes())

    def test_a_solid_that_fills_the_image_stays(self):
        self.write(lambda i, j, k: 1, (8, 9, 10))
        for options in ([], ["--smooth", "2"], ["--smooth", "2", "--method", "paper"]):
            report = self.mesh("a.nrrd", *options, "-o", "a.vtu")
            self.assertLess(abs(report["smoothing"]["change"]), 0.03)  # at edges
            self.check("a.vtu")

    def test_what_smoothing_takes_away_is_named(self):
        self.write()
        report = self.mesh("a.nrrd", "--smooth", "1.5", "--method", "paper", "-o", "a.vtu")
        self.assertTrue([w for w in report["warnings"] if "label 2" in w and "--smooth" in w])
        for sigma in ("1.5", "3", "0.3"):
            report = self.mesh("a.nrrd", "--smooth", sigma, "-o", "a.vtu")
            self.assertEqual([w for w in report["warnings"] if "label" in w], [])

    def test_refused(self):
        self.write()
        for value in ("-1", "nan", "wide"):
            self.assert_fails(USAGE, ["--smooth"], "mesh", "a.nrrd", "--smooth=" + value,
                              "-o", "a.vtu")
        self.assert_fails(USAGE, ["--smooth"], "mesh", "a.nrrd", "--iso", "1", "--smooth", "1",
                          "-o", "a.vtu")
        self.assert_fails(USAGE, ["--smooth"], "mesh", "--shape", "sphere:1", "--smooth", "1",
                          "-o", "a.vtu")
        self.assert_fails(USAGE, ["4 voxels"], "mesh", "a.nrrd", "--smooth", "4.1", "-o", "a.vtu")
        paper = ("--method", "paper", "-o", "a.vtu")
        self.write(lambda i, j, k: 1, (3, 9, 9))
        self.assert_fails(USAGE, ["4 voxels"], "mesh", "a.nrrd", "--smooth", "1", *paper)
        self.write(lambda i, j, k: int((i, j, k) == (5, 5, 5)))
        self.assert_fails(EMPTY, ["smoothing"], "mesh", "a.nrrd", "--smooth", "3", *paper)


class Crop(RegionTest):
    BOX = (6, -2, 10.25, 12.75, 6.5, 20)

    def crop(self, *options, name="a.nrrd"):
        return self.mesh(name, *options, "--crop", ",".join(map(str, self.BOX)), "-o", "a.vtu")

    def expect_box(self):
        self.check("a.vtu")
        points = vtu.points(self.folder / "a.vtu")
        for a in range(3):
            at = [p[a] for p in points]
            self.assertAlmostEqual(min(at), self.BOX[a], delta=2e-4)
            self.assertAlmostEqual(max(at), self.BOX[a + 3], delta=2e-4)

    def test_closed_flat_at_the_box(self):
        self.write(lambda i, j, k: 5)
        for options in ([], ["--size", "0.7"], ["--margin", "1"], ["--smooth", "1"]):
            with self.subTest(options):
                report = self.crop(*options)
                self.expect_box()
                exact = math.prod(self.BOX[a + 3] - self.BOX[a] for a in range(3))
                self.assertAlmostEqual(report["mesh"]["volume"], exact, delta=0.03 * exact)

    def test_turned_and_mirrored_images(self):
        for directions in (((0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1)),
                           ((1, 0, 0), (0, 1, 0), (0, 0, -1)), ((0, 1, 0), (1, 0, 0), (0, 0, 1))):
            size = (60, 60, 60)
            centre = [0.5 * (a + b) for a, b in zip(self.BOX[:3], self.BOX[3:])]
            origin = [c - 29.5 * sum(d[r] for d in directions) for r, c in enumerate(centre)]
            write_nrrd(self.folder / "t.nrrd", size, [1] * 60 ** 3, kind="b",
                       directions=directions, origin=origin)
            with self.subTest(directions):
                self.crop(name="t.nrrd")
                self.expect_box()

    def patches(self, name, *options):
        """The numbers of the faces' patches: 1 the surface, 3 to 8 the sides of the box."""
        self.mesh(name, *options, "--crop", ",".join(map(str, self.BOX)), "-o", "a.mesh")
        lines = (self.folder / "a.mesh").read_text().split("\n")
        at = lines.index("Triangles")
        rows = lines[at + 2:at + 2 + int(lines[at + 1])]
        return [int(row.split()[3]) for row in rows]

    def test_faces_of_the_box_are_border(self):
        turned = ((0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1))
        for directions, origin in ((None, (3, -5, 7)), (turned, (8, -22, 7))):
            for value, all_border in ((lambda i, j, k: 1, True), (lambda i, j, k: k % 8 < 5, False)):
                write_nrrd(self.folder / "a.nrrd", (60, 60, 22),
                           voxels((60, 60, 22), lambda i, j, k: int(value(i, j, k))),
                           origin=origin, **({"directions": directions} if directions else {}))
                for cuts in ("bisect", "midpoint"):
                    with self.subTest(directions=directions, all_border=all_border, cuts=cuts):
                        found = self.patches("a.nrrd", "--cuts", cuts)
                        self.assertEqual(set(found), 
                                         set(range(3, 9)) if all_border else {1, 3, 4, 5, 6, 7})

    def test_inside_it_is_the_same_mesh(self):
        self.write()
        whole = self.mesh("a.nrrd", "--cuts", "midpoint", "-o", "w.vtu")
        self.assertEqual(self.mesh("a.nrrd", "--cuts", "midpoint", "--crop",
                                   "-99,-99,-99,99,99,99", "-o", "a.vtu")["mesh"]["volume"],
                         whole["mesh"]["volume"])

    def test_level(self):
        self.write(lambda i, j, k: 10 + i)
        self.crop("--iso", "5")
        self.expect_box()

    def test_refused(self):
        self.write()
        for words in ("0,0,0,1,1", "0,0,0,0,1,1", "a,0,0,1,1,1"):
            self.assert_fails(USAGE, ["crop"], "mesh", "a.nrrd", "--crop=" + words, "-o", "a.vtu")
        self.assert_fails(USAGE, ["--crop"], "mesh", "--shape", "sphere:1", "--crop",
                          "0,0,0,1,1,1", "-o", "a.vtu")
        self.assert_fails(EMPTY, ["box"], "mesh", "a.nrrd", "--crop", "90,90,90,99,99,99",
                          "-o", "a.vtu")


if __name__ == "__main__":
    unittest.main()
