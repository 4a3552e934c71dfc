"""What `certet mesh` makes of surfaces as exporters write them: the solid, and a sentence about
what was done; or a refusal that names what is wrong."""

import math
import random
import unittest

import surface_defects as defects
import surfaces
from surface_program import SurfaceProgramTest

BAD_INPUT, USAGE, EMPTY = 3, 2, 4
TORUS = defects.turned(surfaces.torus(around=48, across=24))
CUBE = defects.turned(surfaces.cube())
WALL = (1, 3, 7, 5)  # of a cube, where x is high


def two_cubes():
    """Side by side; the wall between them is there once."""
    points, faces = surfaces.cube()
    return surfaces.join((points, [face for face in faces if face != WALL]),
                         surfaces.cube((1, 0, 0), (2, 1, 1)))


def eight_cubes():
    """In a block, with each wall once."""
    points, faces, seen = [], [], set()
    for n in range(8):
        low = (n & 1, n >> 1 & 1, n >> 2)
        its, quads = surfaces.cube(low, tuple(c + 1 for c in low))
        for quad in quads:
            corners = tuple(sorted(its[p] for p in quad))
            if corners not in seen:
                faces.append(tuple(len(points) + p for p in quad))
            seen.add(corners)
        points += its
    return points, faces


class RepairTest(SurfaceProgramTest):
    def assert_solid(self, surface, volume, words, *options, writers=surfaces.WRITERS,
                     within=0.012):
        """The volume, and notes of which each has its words, in all formats."""
        for name, writer in writers.items():
            with self.subTest(name=name, words=words):
                (self.folder / name).write_bytes(writer(surface))
                report = self.mesh(name, "-o", "a.vtu", "--rel-size", "0.03125", *options)
                self.assertEqual(len(report["input"]["notes"]), len(words),
                                 report["input"]["notes"])
                for note, word in zip(report["input"]["notes"], words):
                    self.assertIn(word, note)
                self.assertAlmostEqual(report["mesh"]["volume"], volume, delta=within * volume)
                self.assertTrue(report["guarantee"]["holds"])
                self.assertGreaterEqual(report["dihedral"]["min"], 9.27)
                self.assertLessEqual(report["dihedral"]["max"], 164.77)

    def assert_refused(self, surface, *words, options=()):
        for name, writer in surfaces.WRITERS.items():
            with self.subTest(name=name, words=words):
                (self.folder / name).write_bytes(writer(surface))
                self.assert_fails(BAD_INPUT, [name, *words], "mesh", name, "-o", "a.vtu",
                                  *options)


class Welding(RepairTest):
    def test_clean_surfaces_have_no_notes(self):
        self.assert_solid(TORUS, surfaces.volume(TORUS), [])
        self.assert_solid(defects.soup(TORUS), surfaces.volume(TORUS), [])

    def test_corners_that_differ(self):
        volume = surfaces.volume(TORUS)
        for amount in (1e-8, 1e-7, 1e-6, 3e-6):
            self.assert_solid(defects.noisy(TORUS, amount), volume, ["were welded"],
                              writers={"a.stl": surfaces.stl, "a.obj": surfaces.obj})
        self.assert_solid(defects.noisy(surfaces.cube(), 1e-17), 1, ["no farther than 1.73e-09"],
                          within=1e-9)
        self.assert_solid(defects.noisy(surfaces.cube((10, 10, 10), (11, 11, 11)), 1e-6), 1,
                          ["were welded"], within=1e-5)

    def test_far_from_the_origin(self):
        """There a float is rounded by more than the tolerances."""
        far = defects.turned(surfaces.torus(around=48, across=24), (1000, -500, 300))
        self.assert_solid(defects.noisy(far, 6e-5), surfaces.volume(far), ["no farther than 0.0002"],
                          writers={"a.stl": surfaces.stl, "a.obj": surfaces.obj})

    def test_features_are_not_welded(self):
        """A plate thinner than the greatest tolerance, with a T-junction: it stays a plate."""
        plate = defects.with_t_junctions(surfaces.cube((0, 0, 0), (1, 1, 1e-5)), 1)
        (self.folder / "a.obj").write_bytes(surfaces.obj(plate))
        run = self.run_certet("mesh", "a.obj", "--size", "0.02", "-o", "a.vtu")
        self.assertNotIn("weld", run.stderr + run.stdout)


class Triangles(RepairTest):
    def test_repeated(self):
        volume = surfaces.volume(TORUS)
        for count in (1, 30, 2304):
            self.assert_solid(defects.repeated(TORUS, count), volume, ["another"],
                              writers={"a.stl": surfaces.stl, "a.ply": surfaces.ply})
        self.assert_solid(defects.repeated(defects.repeated(TORUS, 40), 40), volume, ["another"],
                          writers={"a.stl": surfaces.stl})

    def test_repeated_the_other_way_around(self):
        """Some triangles, or all: a solid whose every face has both its sides."""
        volume = surfaces.volume(TORUS)
        for count in (1, 30, 2304):
            self.assert_solid(defects.repeated(TORUS, count, turn=True), volume, ["another"],
                              writers={"a.stl": surfaces.stl, "a.ply": surfaces.ply})

    def test_degenerate(self):
        self.assert_solid(defects.with_degenerate(TORUS, 20), surfaces.volume(TORUS),
                          ["40 triangles"])

    def test_turned(self):
        self.assert_solid(defects.partly_turned(TORUS, 300), surfaces.volume(TORUS),
                          ["300 triangles"])
        # A cavity stays one, whatever its triangles say.
        hollow = surfaces.join(surfaces.cube((0, 0, 0), (4, 4, 4)),
                               surfaces.inside_out(surfaces.cube((1, 1, 1), (3, 3, 3))))
        self.assert_solid(defects.turned(defects.partly_turned(hollow, 4)), 56, ["4 triangles"])

    def test_all_at_once(self):
        surface = defects.partly_turned(TORUS, 200)
        surface = defects.repeated(defects.with_degenerate(surface, 10), 10)
        surface = defects.noisy(defects.with_t_junctions(surface, 20), 1e-7)
        self.assert_solid(surface, surfaces.volume(TORUS),
                          ["welded", "without an area", "another", "split", "turned"])


class TJunctions(RepairTest):
    def test_on_one_edge_and_on_many(self):
        self.assert_solid(defects.with_t_junctions(CUBE, 9), 1, ["9 edges"])
        self.assert_solid(defects.with_t_junctions(TORUS, 100), surfaces.volume(TORUS),
                          ["100 edges"])

    def test_several_on_one_edge(self):
        surface = defects.with_t_junctions(defects.with_t_junctions(CUBE, 9), 9, seed=7)
        self.assert_solid(surface, 1, ["split"])

    def test_beside_corners_that_differ(self):
        self.assert_solid(defects.noisy(defects.with_t_junctions(CUBE, 9), 1e-6), 1,
                          ["welded", "split"])


class Walls(RepairTest):
    def test_two_solids_share_a_wall_stored_once(self):
        self.assert_solid(defects.turned(two_cubes()), 2, ["2 triangles"])

    def test_whichever_way_it_runs(self):
        points, faces = two_cubes()
        other = [face[::-1] if n % 2 else face for n, face in enumerate(faces)]
        self.assert_solid(defects.turned((points, other)), 2, ["turned", "2 triangles"],
                          writers={"a.stl": surfaces.stl})

    def test_stored_twice(self):
        both = surfaces.join(surfaces.cube(), surfaces.cube((1, 0, 0), (2, 1, 1)))
        self.assert_solid(defects.turned(both), 2, ["another"])

    def test_walls_that_cross(self):
        self.assert_solid(defects.turned(eight_cubes()), 8, ["24 triangles"])

    def test_a_cavity_stays(self):
        hollow = surfaces.join(two_cubes(), surfaces.inside_out(
            surfaces.cube((0.25, 0.25, 0.25), (0.75, 0.75, 0.75))))
        self.assert_solid(defects.turned(hollow), 1.875, ["2 triangles"])

    def test_solids_that_touch_along_an_edge(self):
        both = surfaces.join(surfaces.cube(), surfaces.cube((1, 1, 0), (2, 2, 1)))
        self.assert_solid(defects.turned(both), 2, [])
        self.assert_solid(defects.turned(defects.partly_turned(both, 9)), 2, ["turned"])


class Holes(RepairTest):
    def test_refused(self):
        points, faces = defects.in_triangles(surfaces.cube())
        self.assert_refused((points, faces[1:]), "open", "3 edges", "1 hole", "1.41 across",
                            "--repair closes it")
        self.assert_refused(defects.with_holes(TORUS, 20), "20 holes", "the largest 0.236 across",
                            "--repair closes them")

    def test_closed(self):
        points, faces = defects.in_triangles(surfaces.cube())
        self.assert_solid((points, faces[1:]), 1, ["1 hole"], "--repair", within=1e-9)
        points, faces = CUBE
        self.assert_solid((points, faces[1:]), 1, ["1 hole of"], "--repair")
        self.assert_solid(defects.with_holes(TORUS, 20), surfaces.volume(TORUS),
                          ["20 holes"], "--repair")

    def test_tube_without_ends(self):
        """An end far from the other is closed flat."""
        for across in (24, 96):
            points, faces = surfaces.torus(around=48, across=across)
            faces = [face for n, face in enumerate(faces) if n // across % 48 >= 12]
            volume = surfaces.volume(surfaces.torus(around=48, across=across)) * 36 / 48
            self.assert_solid((points, faces), volume, ["2 holes"], "--repair",
                              writers={"a.stl": surfaces.stl})

    def test_gaps_are_bridged(self):
        """Rings are missing from a torus: its pieces go on from one to the next."""
        torus = surfaces.torus(around=48, across=24)
        faces = [face for n, face in enumerate(torus[1]) if n // 24 % 12 != 0]
        self.assert_solid((torus[0], faces), surfaces.volume(torus), ["8 holes"], "--repair",
                          writers={"a.stl": surfaces.stl}, within=0.02)

    def test_windows(self):
        faces = [face for n, face in enumerate(TORUS[1]) if n // 24 % 12 > 2 or n % 12 > 2]
        self.assert_solid((TORUS[0], faces), surfaces.volume(TORUS), ["8 holes"], "--repair",
                          writers={"a.stl": surfaces.stl, "a.ply": surfaces.ply})

    def test_ball_without_a_cap(self):
        points, faces = surfaces.sphere(rounds=4)
        low = [face for face in faces if max(points[p][2] for p in face) < 0.7]
        rim = max(points[p][2] for face in low for p in face)
        volume = surfaces.volume((points, faces)) - math.pi / 3 * (1 - rim) ** 2 * (2 + rim)
        self.assert_solid(defects.turned((points, low)), volume, ["1 hole"], "--repair",
                          writers={"a.stl": surfaces.stl}, within=0.02)

    def test_triangles_all_apart(self):
        """Each a little smaller, or much."""
        for surface, share, holes, within in (CUBE, 0.99, 12, 0.012), (TORUS, 0.99, 2304, 0.012), \
                (TORUS, 0.9, 2304, 0.02):
            apart = defects.apart(surface, share)
            self.assert_solid(apart, surfaces.volume(surface), [f"{holes} holes"], "--repair",
                              writers={"a.stl": surfaces.stl}, within=within)

    def test_as_scanned(self):
        """Open below, with holes, noise, and a patch that was scanned twice."""
        ball = surfaces.sphere(rounds=4)
        points = [tuple(c * (1 + 0.1 * math.sin(5 * x) * math.cos(4 * y)) for c in (x, y, z))
                  for x, y, z in ball[0]]
        faces = [face for face in ball[1] if max(points[p][2] for p in face) > -0.8]
        kept = set(faces)
        low = [face for face in ball[1] if face not in kept]
        volume = surfaces.volume((points, ball[1])) - surfaces.volume(defects.lidded(points, low))
        scan = defects.with_holes((points, faces), 60)
        again = [(x + 1e-4, y, z) for x, y, z in points]
        scan = surfaces.join(scan, (again, [f for f in faces if min(points[p][0] for p in f) > 0.5]))
        self.assert_solid(scan, volume, ["holes"], "--repair", writers={"a.stl": surfaces.stl},
                          within=0.03)

    def test_what_winds_around_nothing(self):
        """A sheet; triangles that face any way; a strip with one side is a unit test's."""
        flat = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
        (self.folder / "a.stl").write_bytes(surfaces.stl(defects.turned(flat)))
        self.assert_fails(EMPTY, ["a.stl", "encloses nothing", "0.500 on average"], "mesh",
                          "a.stl", "--repair", "-o", "a.vtu")
        chance = random.Random(7)
        points = [tuple(chance.random() for _ in range(3)) for _ in range(300)]
        anyhow = points, [(3 * n, 3 * n + 1, 3 * n + 2) for n in range(100)]
        (self.folder / "a.stl").write_bytes(surfaces.stl(anyhow))
        self.assert_fails(BAD_INPUT, ["a.stl", "do not agree which side is out"], "mesh",
                          "a.stl", "--repair", "-o", "a.vtu")

    def test_apart_and_turned(self):
        """A fifth of the triangles face the other way, and no edge says so."""
        apart = defects.partly_turned(defects.apart(TORUS, 0.98), 460)
        self.assert_solid(apart, surfaces.volume(TORUS), ["460 triangles", "2304 holes"],
                          "--repair", writers={"a.stl": surfaces.stl}, within=0.015)

    def test_same_bytes_for_threads_and_streams(self):
        surface = defects.with_holes(defects.apart(TORUS, 0.97), 200)
        (self.folder / "a.stl").write_bytes(surfaces.stl(surface))
        size = ["--repair", "--rel-size", "0.03125"]
        first = self.mesh("a.stl", *size, "--threads", 1, "-o", "1.vtu")
        self.mesh("a.stl", *size, "--threads", 2, "-o", "2.vtu")
        self.mesh("a.stl", *size, "--threads", 3, "--max-memory", first["memory"]["least"], "-o",
                  "3.vtu")
        for name in ("2.vtu", "3.vtu"):
            self.assertEqual((self.folder / "1.vtu").read_bytes(), (self.folder / name).read_bytes())

    def test_with_other_defects(self):
        surface = defects.with_holes(defects.partly_turned(TORUS, 200), 20)
        self.assert_solid(defects.noisy(surface, 1e-7), surfaces.volume(TORUS),
                          ["welded", "turned", "20 holes"], "--repair")

    def test_sheet_that_bounds_nothing(self):
        fin = ([(1, 0, 0), (2, 0, 0), (2, 0, 1), (1, 0, 1)], [(0, 1, 2, 3)])
        surface = defects.turned(surfaces.join(surfaces.cube(), fin))
        self.assert_refused(surface, "a sheet that bounds nothing", "--repair drops it")
        self.assert_solid(surface, 1, ["2 triangles"], "--repair")

    def test_option_goes_with_surfaces(self):
        self.assert_fails(USAGE, ["--repair"], "mesh", "--shape", "sphere:1", "--repair", "-o",
                          "a.vtu")

    def test_notes_in_the_table(self):
        points, faces = surfaces.cube()
        (self.folder / "a.stl").write_bytes(surfaces.stl((points, faces[1:])))
        run = self.run_certet("mesh", "a.stl", "--repair", "-o", "a.vtu")
        self.assertRegex(run.stdout, r"note +1 hole of 'a.stl'")
        self.check("a.vtu")


if __name__ == "__main__":
    unittest.main()
