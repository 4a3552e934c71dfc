"""What `certet mesh` makes of formulas and images."""

import json
import math
import unittest

import vtu
from images import voxels, write_meta, write_nifti, write_nrrd
from program import TORUS, ProgramTest

KEYS = {
    "certet": None, "command": None, "dry_run": None,
    "input": {"kind", "name", "notes"},
    "output": {"file", "format", "bytes", "origin", "frame", "scale"},
    "lattice": {"cells", "size", "cuts"},
    "method": {"name", "violated", "stayed", "shortened", "missed", "clamped"},
    "mesh": {"points", "tets", "volume", "checksum", "file_checksum", "pieces", "nonmanifold"},
    "dihedral": {"min", "max", "lattice_min", "lattice_max", "rounding", "histogram"},
    "features": {"asked", "chosen", "why"},
    "theorem": None,
    "guarantee": {"asked", "used", "theorem", "min_dihedral", "max_dihedral",
                  "inverted_tets", "holds"},
    "seconds": {"read", "sample", "cut", "warp", "count", "pieces", "emit", "measure", "write",
                "total"},
    "warnings": None,
    "memory": {"limit", "needed", "least", "peak"},
}


def center(corners):
    return tuple(sum(c[a] for c in corners) / 4 for a in range(3))


class Formula(ProgramTest):
    def test_torus(self):
        report = self.mesh(*TORUS, "-o", "torus.vtu")
        self.assertEqual(self.files(), ["torus.vtu"])
        self.assertGreater(report["mesh"]["tets"], 100_000)
        exact = 2 * math.pi ** 2 * 0.4 ** 2
        self.assertAlmostEqual(report["mesh"]["volume"], exact, delta=0.02 * exact)
        self.assertTrue(report["guarantee"]["holds"])
        self.assertEqual(report["output"]["bytes"], (self.folder / "torus.vtu").stat().st_size)
        checked = self.check("torus.vtu")
        self.assertEqual(checked["mesh"]["tets"], report["mesh"]["tets"])
        for key in ("min", "max"):
            self.assertAlmostEqual(checked["dihedral"][key], report["dihedral"][key], delta=1e-6)
        # Rounded coordinates take angles of exactly 60 degrees to the bin below;
        # the report counts before rounding.
        pairs = zip(checked["dihedral"]["histogram"], report["dihedral"]["histogram"])
        moved = sum(abs(a - b) for a, b in pairs)
        self.assertLess(moved, 0.01 * sum(report["dihedral"]["histogram"]))

    def test_json_keys(self):
        report = self.mesh(*TORUS, "--size", "0.2", "-o", "torus.vtu")
        self.assertEqual(set(report), set(KEYS))
        for key, inner in KEYS.items():
            if inner:
                self.assertEqual(set(report[key]), inner, key)
        self.assertEqual(len(report["dihedral"]["histogram"]), 36)
        self.assertEqual(sum(report["dihedral"]["histogram"]), 6 * report["mesh"]["tets"])

    def test_json_file_and_table(self):
        run = self.run_certet("mesh", *TORUS, "-o", "t.vtu", "--json", "t.json")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.files(), ["t.json", "t.vtu"])
        self.assertEqual(set(json.loads((self.folder / "t.json").read_text())), set(KEYS))
        for word in ("tetrahedra", "dihedral", "theorem", "seconds", "peak"):
            self.assertIn(word, run.stdout)

    def test_bounds_close_the_solid(self):
        self.mesh("--expr", "-1", "--bounds", "0,0,0,1,2,1", "--size", "0.1", "-o", "box.vtu")
        self.assertAlmostEqual(self.check("box.vtu")["mesh"]["volume"], 2, delta=0.02)

    def test_bounds_may_cut_it(self):
        report = self.mesh("--expr", "x^2+y^2+z^2-1", "--bounds", "-2,-2,0,2,2,2",
                           "--size", "0.1", "-o", "half.vtu")
        self.assertAlmostEqual(report["mesh"]["volume"], 2 * math.pi / 3, delta=0.1)
        self.check("half.vtu")

    def test_functions_people_expect(self):
        for formula in ("max(abs(x),abs(y),abs(z))-0.5", "hypot(x,y,z)-pi/6",
                        "pow(x,2)+y^2+clamp(z,-9,9)^2-exp(log(0.25))",
                        "floor(x)+ceil(x)*0+x^2+y^2+z^2-0.5+1*atan2(0,1)"):
            with self.subTest(formula):
                self.mesh("--expr", formula, "--bounds", "-1,-1,-1,1,1,1", "--size", "0.2",
                          "-o", "f.vtu")

    def test_nan_is_outside(self):
        report = self.mesh("--expr", "sqrt(x)-2+y^2+z^2", "--bounds", "-1,-1,-1,1,1,1",
                           "--size", "0.1", "-o", "root.vtu")
        self.assertLess(report["mesh"]["volume"], 4.1)
        self.check("root.vtu")

    def test_every_method_says_so(self):
        theorems = {"embedded": ("SettledBoundsInDegrees", 10.77), "angles": ("DihedralBounds", 10.77),
                    "embedding": ("DihedralBoundsEmbedding", 9.27),
                    "midpoint": ("MidpointBounds", 30), "key": ("CertifiedKeySweptMesh", 11.18)}
        for choice, method in (
                ((), "key"), (("--method", "key"), "key"), (("--method", "embedded"), "embedded"),
                (("--method", "paper"), "angles"), (("--guarantee", "angles"), "angles"),
                (("--method", "paper", "--guarantee", "embedding"), "embedding"),
                (("--guarantee", "embedding"), "embedding"),
                (("--method", "midpoint"), "midpoint"), (("--cuts", "midpoint"), "midpoint"),
                (("--cuts", "midpoint", "--guarantee", "embedding"), "midpoint")):
            theorem, low = theorems[method]
            with self.subTest(choice):
                report = self.mesh(*TORUS, *choice, "--size", "0.1", "-o", "t.vtu")
                self.assertGreaterEqual(report["dihedral"]["min"], low - 1e-6)
                self.assertEqual((report["method"]["name"], report["theorem"]), (method, theorem))
                self.assertEqual({key: report["guarantee"][key]
                                  for key in ("asked", "used", "theorem", "min_dihedral")},
                                 {"asked": method, "used": method, "theorem": theorem,
                                  "min_dihedral": low})
                table = self.run_certet("mesh", *TORUS, *choice, "--size", "0.1", "-o",
                                        "t.vtu").stdout
                self.assertRegex(table, rf"\nmethod +{method}: ")
                self.assertEqual('"angles"' in json.dumps(report), method == "angles")

    def test_the_method_used_in_the_end_is_the_one_told(self):
        """The faces of voxels make `angles` turn over tetrahedra that are dropped."""
        size = (12, 12, 12)
        write_nrrd(self.folder / "a.nrrd", size,
                   voxels(size, lambda i, j, k: int((i * 7 + j * 3 + k * 5) % 11 < 6)))
        paper = ("a.nrrd", "--method", "paper", "-o", "t.vtu")
        report = self.mesh(*paper)
        self.assertGreater(report["guarantee"]["inverted_tets"], 0)
        self.assertEqual(
            (report["guarantee"]["asked"], report["method"]["name"], report["theorem"]),
            ("angles", "embedding", "DihedralBoundsEmbedding"))
        table = self.run_certet("mesh", *paper).stdout
        self.assertRegex(table, r"\nmethod +embedding: .*\(angles inverted \d+ dropped")

    def test_methods_that_contradict(self):
        for choice in (("--method", "embedded", "--cuts", "midpoint"),
                       ("--method", "embedded", "--guarantee", "angles"),
                       ("--method", "midpoint", "--cuts", "bisect"),
                       ("--method", "paper", "--cuts", "midpoint")):
            run = self.run_certet("mesh", *TORUS, *choice, "-o", "t.vtu")
            self.assertEqual((run.returncode, self.files()), (2, []), run.stderr)
            self.assertIn("exclude each other", run.stderr)

    def test_medit(self):
        report = self.mesh(*TORUS, "--size", "0.2", "-o", "t.mesh")
        self.assertEqual(report["output"]["format"], "medit")
        self.check("t.mesh")


class SameBytes(ProgramTest):
    def test_threads_and_memory(self):
        size = ["--size", "0.03"]
        first = self.mesh(*TORUS, *size, "--threads", 1, "-o", "1.vtu")
        least = first["memory"]["least"]
        again = self.mesh(*TORUS, *size, "--threads", 2, "-o", "2.vtu")
        tight = self.mesh(*TORUS, *size, "--threads", 3, "--max-memory", least, "-o", "3.vtu")
        self.assertLess(tight["memory"]["needed"], first["memory"]["needed"])
        reference = (self.folder / "1.vtu").read_bytes()
        for name in ("2.vtu", "3.vtu"):
            self.assertEqual(reference, (self.folder / name).read_bytes(), name)
        for other in (again, tight):
            for key in ("mesh", "dihedral"):
                self.assertEqual(first[key], other[key])

    def test_labels_too(self):
        write_nrrd(self.folder / "a.nrrd", (20, 21, 22),
                   voxels((20, 21, 22), lambda i, j, k: (i * j + k) % 7 // 2))
        first = self.mesh("a.nrrd", "--threads", 1, "-o", "1.vtu")
        self.mesh("a.nrrd", "--threads", 2, "--max-memory", first["memory"]["least"],
                  "-o", "2.vtu")
        self.assertEqual((self.folder / "1.vtu").read_bytes(),
                         (self.folder / "2.vtu").read_bytes())

    def test_checksum_tells_meshes_apart(self):
        one = self.mesh(*TORUS, "--size", "0.2", "-o", "t.vtu")["mesh"]["checksum"]
        two = self.mesh(*TORUS, "--size", "0.2001", "-o", "t.vtu")["mesh"]["checksum"]
        self.assertNotEqual(one, two)


class DryRun(ProgramTest):
    def test_numbers_are_the_real_ones(self):
        dry = self.mesh(*TORUS, "--dry-run", "-o", "t.vtu")
        self.assertEqual(self.files(), [])
        real = self.mesh(*TORUS, "-o", "t.vtu")
        for outer, inner in (("mesh", "points"), ("mesh", "tets"), ("output", "bytes"),
                             ("memory", "least"), ("memory", "needed")):
            self.assertEqual(dry[outer][inner], real[outer][inner])
        self.assertEqual((self.folder / "t.vtu").stat().st_size, dry["output"]["bytes"])


class Labels(ProgramTest):
    """Two bricks, label 3 and label 7, side by side along the first axis."""

    size = (8, 6, 5)

    def brick(self, name, directions, origin=(0, 0, 0), writer=write_nrrd):
        values = voxels(self.size, lambda i, j, k: 3 if i < 4 else 7)
        writer(self.folder / name, self.size, values, directions=directions, origin=origin)

    def world(self, directions, origin, voxel):
        return tuple(origin[r] + sum(directions[a][r] * voxel[a] for a in range(3))
                     for r in range(3))

    def assert_lies_on_its_voxels(self, file, directions, origin, near, farthest=0.45):
        """Tetrahedra have the label of the voxel around their centroids, but for those `near` the
        wall between the bricks; along its rim, where the outside is a third, up to `farthest`."""
        points = vtu.points(self.folder / file)
        tets = vtu.tets(self.folder / file)
        labels = vtu.numbers(self.folder / file, "label")
        lengths = [sum(c * c for c in d) for d in directions]
        self.assertEqual(set(labels), {3, 7})
        rim = 0
        for tet, label in zip(tets, labels):
            at = center([points[n] for n in tet])
            along = sum((at[r] - origin[r]) * directions[0][r] for r in range(3)) / lengths[0]
            right = label == (3 if along < 3.5 else 7)
            rim += not right and abs(along - 3.5) > near
            self.assertTrue(right or abs(along - 3.5) < farthest)
        self.assertLess(rim, 0.04 * len(tets))
        for a in range(3):  # the solid ends where the image does
            alongs = [sum((p[r] - origin[r]) * directions[a][r] for r in range(3)) / lengths[a]
                      for p in points]
            self.assertAlmostEqual(min(alongs), -0.5, delta=0.3)
            self.assertAlmostEqual(max(alongs), self.size[a] - 0.5, delta=0.3)

    def test_directions(self):
        cases = {
            "plain": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
            "left-handed": ((1, 0, 0), (0, 1, 0), (0, 0, -1)),
            "mirrored x": ((-1, 0, 0), (0, 1, 0), (0, 0, 1)),
            "permuted": ((0, 1, 0), (0, 0, -1), (1, 0, 0)),
            "cyclic": ((0, 2, 0), (0, 0, 2), (2, 0, 0)),
            "turned": ((0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1)),
            "anisotropic": ((0.5, 0, 0), (0, 1.0, 0), (0, 0, -2.0)),
        }
        origin = (10, -20, 5)
        for name, directions in cases.items():
            for cuts, smooth, near, farthest in (
                    ("midpoint", ("--smooth", "0"), 0.26, 0.45),
                    ("bisect", ("--smooth", "0"), 0.05, 0.45), ("bisect", (), 0.05, 0.55)):
                with self.subTest(name, cuts=cuts, smooth=smooth):
                    self.brick("b.nrrd", directions, origin)
                    report = self.mesh("b.nrrd", "--cuts", cuts, *smooth, "-o", "b.vtu")
                    self.assertEqual(report["input"]["kind"], "labels")
                    self.check("b.vtu")
                    edges = [math.dist((0, 0, 0), d) for d in directions]
                    exact = math.prod(e * n for e, n in zip(edges, self.size))
                    self.assertAlmostEqual(report["mesh"]["volume"], exact, delta=0.25 * exact)
                    if name != "anisotropic":
                        self.assert_lies_on_its_voxels("b.vtu", directions, origin,
                                                       near, farthest)

    def test_touching_the_border_is_closed(self):
        self.brick("b.nrrd", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        self.mesh("b.nrrd", "--margin", 1, "--cuts", "bisect", "-o", "b.vtu")
        self.check("b.vtu")

    def test_midpoint_cuts_have_30_degrees(self):
        self.brick("b.nrrd", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        report = self.mesh("b.nrrd", "--cuts", "midpoint", "-o", "b.vtu")
        self.assertAlmostEqual(report["dihedral"]["min"], 30, places=9)

    def test_30_degrees_are_counted_as_such(self):
        report = self.mesh(*TORUS, "--size", "0.0701", "--cuts", "midpoint", "-o", "t.vtu")
        histogram = report["dihedral"]["histogram"]
        self.assertEqual(sum(histogram[:6]), 0)
        self.assertGreater(histogram[6], 0)
        self.assertGreater(histogram[27], 0)  # 135 degrees
        self.assertEqual(sum(histogram[28:]), 0)

    def test_choice(self):
        values = voxels((9, 9, 9), lambda i, j, k: i * 200)  # 0, 200, ..., 1600
        write_nrrd(self.folder / "s.nrrd", (9, 9, 9), values)
        self.mesh("s.nrrd", "-o", "all.vtu")
        self.assertEqual(set(vtu.numbers(self.folder / "all.vtu", "label")),
                         {200 * i for i in range(1, 9)})
        self.mesh("s.nrrd", "--labels", "400,900-1300", "-o", "some.vtu")
        self.assertEqual(set(vtu.numbers(self.folder / "some.vtu", "label")),
                         {400, 1000, 1200})
        self.check("some.vtu")
        self.mesh("s.nrrd", "--labels", "0", "-o", "zero.vtu")
        self.assertEqual(set(vtu.numbers(self.folder / "zero.vtu", "label")), {0})

    def test_types(self):
        for kind in "BbHhIiq":
            with self.subTest(kind):
                write_nrrd(self.folder / "t.nrrd", (4, 4, 4),
                           voxels((4, 4, 4), lambda i, j, k: 5), kind=kind)
                self.mesh("t.nrrd", "-o", "t.vtu")
                self.assertEqual(set(vtu.numbers(self.folder / "t.vtu", "label")), {5})

    def test_size_may_be_any(self):
        self.brick("b.nrrd", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        for size in ("0.37", "0.5", "1.5", "2"):
            with self.subTest(size):
                self.mesh("b.nrrd", "--size", size, "-o", "b.vtu")
                self.check("b.vtu")

    def test_formats_agree(self):
        values = voxels(self.size, lambda i, j, k: 3 if i < 4 else 7)
        write_nrrd(self.folder / "a.nrrd", self.size, values, packed=True)
        write_meta(self.folder / "a.mha", self.size, values)
        one = self.mesh("a.nrrd", "-o", "1.vtu")
        two = self.mesh("a.mha", "-o", "2.vtu")
        self.assertEqual((self.folder / "1.vtu").read_bytes(),
                         (self.folder / "2.vtu").read_bytes())
        for name in ("a.nii", "a.nii.gz"):
            write_nifti(self.folder / name, self.size, values)
            three = self.mesh(name, "-o", "3.vtu")
            self.assertEqual(three["mesh"]["tets"], one["mesh"]["tets"])
            # NIfTI is RAS: its x and y run against the world's, which is LPS.
            xs = [p[0] for p in vtu.points(self.folder / "3.vtu")]
            self.assertAlmostEqual(min(xs), -7.5, delta=0.3)
        self.assertEqual(one["mesh"]["checksum"], two["mesh"]["checksum"])


class Level(ProgramTest):
    def test_ball(self):
        size, spacing, radius = (24, 24, 12), (1, 1, 2), 9

        def value(i, j, k):
            return radius - math.dist((i, j, 2 * k), (11.5, 11.5, 11))

        write_meta(self.folder / "ball.mha", size, voxels(size, value), kind="f",
                   spacing=spacing)
        report = self.mesh("ball.mha", "--iso", "0", "-o", "ball.vtu")
        exact = 4 / 3 * math.pi * radius ** 3
        self.assertAlmostEqual(report["mesh"]["volume"], exact, delta=0.05 * exact)
        self.assertEqual(report["input"]["kind"], "level")
        self.check("ball.vtu")
        xs = [p[0] for p in vtu.points(self.folder / "ball.vtu")]
        self.assertAlmostEqual(max(xs), 11.5 + radius, delta=0.2)

    def test_integers_and_the_border(self):
        write_nrrd(self.folder / "g.nrrd", (9, 9, 9), voxels((9, 9, 9), lambda i, j, k: 10 * i))
        self.mesh("g.nrrd", "--iso", "40", "-o", "g.vtu")
        self.check("g.vtu")
        points = vtu.points(self.folder / "g.vtu")
        self.assertAlmostEqual(min(p[0] for p in points), 4, delta=1e-4)
        self.assertAlmostEqual(max(p[0] for p in points), 8.5, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
