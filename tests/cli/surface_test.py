"""What `certet mesh` makes of surfaces and volumes."""

import math
import unittest

import surfaces
from surface_program import SurfaceProgramTest
from volumes import WithVolumes

USAGE, BAD_INPUT, EMPTY = 2, 3, 4


class SurfaceTest(SurfaceProgramTest):
    def write(self, name, data):
        (self.folder / name).write_bytes(data)
        return name

    def obj(self, surface, name="a.obj"):
        return self.write(name, surfaces.obj(surface))


class Formats(SurfaceTest):
    def test_cube_is_exact(self):
        for name, writer in surfaces.WRITERS.items():
            with self.subTest(name):
                self.write(name, writer(surfaces.cube((1, 2, 3), (2, 3, 4))))
                report = self.mesh(name, "-o", "a.vtu", "--size", "0.125")
                self.assertEqual(report["input"], {"kind": "surface", "name": name, "notes": []})
                self.assertAlmostEqual(report["mesh"]["volume"], 1, delta=1e-12)
                self.assertTrue(report["guarantee"]["holds"])
                self.check("a.vtu")

    def test_all_formats_give_the_same_torus(self):
        exact = surfaces.volume(surfaces.torus())
        for name, writer in surfaces.WRITERS.items():
            with self.subTest(name):
                self.write(name, writer(surfaces.torus()))
                volume = self.mesh(name, "--size", "0.05", "-o", "a.vtu")["mesh"]["volume"]
                self.assertAlmostEqual(volume, exact, delta=0.005 * exact)

    def test_error_falls_with_the_square_of_the_size(self):
        sphere = surfaces.sphere()
        self.write("s.stl", surfaces.stl(sphere))
        for size in (0.2, 0.1, 0.05):
            volume = self.mesh("s.stl", "--size", size, "-o", "a.vtu")["mesh"]["volume"]
            self.assertLess(abs(volume - surfaces.volume(sphere)), 1.2 * size * size)

    def test_same_bytes_for_every_thread_count(self):
        self.write("t.stl", surfaces.stl(surfaces.torus()))
        for threads in (1, 2, 8):
            self.mesh("t.stl", "--threads", threads, "-o", f"{threads}.vtu")
        first = (self.folder / "1.vtu").read_bytes()
        for threads in (2, 8):
            self.assertEqual(first, (self.folder / f"{threads}.vtu").read_bytes())


class Defects(SurfaceTest):
    def notes(self, surface, *words):
        report = self.mesh(self.obj(surface), "--size", "0.1", "-o", "a.vtu")
        self.assertEqual(len(report["input"]["notes"]), len(words))
        for note, word in zip(report["input"]["notes"], words):
            self.assertIn(word, note)
        return report["mesh"]["volume"]

    def test_open(self):
        points, faces = surfaces.cube()
        self.obj((points, faces[1:]))
        self.assert_fails(BAD_INPUT, ["open", "4 edges", "(0, 0, 0.5)"], "mesh", "a.obj", "-o",
                          "a.vtu")

    def test_inside_out(self):
        volume = self.notes(surfaces.inside_out(surfaces.cube()), "inside out")
        self.assertAlmostEqual(volume, 1, delta=0.01)

    def test_overlapping(self):
        both = surfaces.join(surfaces.cube(), surfaces.cube((0.5, 0.5, 0.5), (1.5, 1.5, 1.5)))
        self.assertAlmostEqual(self.notes(both, "passes through itself"), 1.875, delta=0.02)

    def test_cavity(self):
        hollow = surfaces.join(surfaces.cube(), surfaces.inside_out(
            surfaces.cube((0.25, 0.25, 0.25), (0.75, 0.75, 0.75))))
        self.assertAlmostEqual(self.notes(hollow), 0.875, delta=0.02)

    def test_disagreeing_triangles(self):
        points, faces = surfaces.cube()
        self.assertAlmostEqual(self.notes((points, [faces[0][::-1]] + faces[1:]), "2 triangles"), 1,
                               delta=0.01)


class Hostile(SurfaceTest):
    def assert_refused(self, name, data, *words):
        with self.subTest(name=name, words=words):
            self.write(name, data)
            self.assert_fails(BAD_INPUT, [name, *words], "mesh", name, "-o", "a.vtu")

    def test_announced_counts(self):
        self.assert_refused("a.stl", b"\0" * 80 + b"\xff\xff\xff\xff", "too short", "4294967295")
        self.assert_refused("b.stl", surfaces.stl(surfaces.cube())[:-1], "too short")
        self.assert_refused("c.stl", b"\0" * 10, "too short")
        huge = surfaces.ply_header("binary_little_endian", 2000000000, 1).encode()
        self.assert_refused("a.ply", huge, "too short", "2000000000")
        self.assert_refused("b.ply", surfaces.ply_header("ascii", 4, 10 ** 30).encode(), "short")
        self.assert_refused("b.off", b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "too short")
        self.assert_refused("a.off", b"OFF\n1000000000 1 0\n0 0 0\n", "too short")

    def test_no_surface(self):
        for name in ("a.stl", "a.obj", "a.ply", "a.off"):
            self.assert_refused(name, b"", "empty")
            self.assert_refused(name, b"solid nothing\nendsolid nothing\n")
            self.assert_refused(name, bytes(range(256)) * 4)
        self.assert_fails(BAD_INPUT, ["none.stl"], "mesh", "none.stl", "-o", "a.vtu")

    def test_wrong_numbers(self):
        self.assert_refused("a.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
        self.assert_refused("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        self.assert_refused("b.obj", b"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")

    def test_rows_of_other_lengths(self):
        """A row of a PLY file with more numbers than its header declares, or with fewer."""
        text = surfaces.ascii_ply(surfaces.cube()).decode().splitlines()
        first = text.index("end_header") + 1
        for row, element, number in ((first + 2, "vertex", 3), (first + 8, "face", 1)):
            for line, how in ((text[row] + " 7", "more"), (text[row][:-2], "fewer")):
                lines = text[:row] + [line] + text[row + 1:]
                self.assert_refused("a.ply", "\n".join(lines + [""]).encode(),
                                    f"row {number} of the", element, how)

    def test_keywords_of_off(self):
        rest = surfaces.off(surfaces.cube())[len("OFF"):]
        for keyword, words in ((b"OFF8", ["'OFF8'"]), (b"XOFF", ["'XOFF'", "keyword"]),
                               (b"4OFF", ["three coordinates"]), (b"nOFF", ["three coordinates"]),
                               (b"OFF BINARY", ["binary OFF"])):
            self.assert_refused("a.off", keyword + rest, *words)
        glued = surfaces.off(surfaces.cube()).replace(b"OFF\n8", b"OFF8")
        self.assert_refused("a.off", glued, "'OFF8'", "not apart")
        for keyword in (b"OFF", b"off", b"COFF", b"NOFF", b"STOFF", b"STCNOFF"):
            self.write("a.off", keyword + rest)
            self.assertAlmostEqual(
                self.mesh("a.off", "-o", "a.vtu")["mesh"]["volume"], 1, delta=1e-9)
            (self.folder / "a.vtu").unlink()

    def test_obj_names_the_line(self):
        points = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        for data, *words in ((points + b"f 1 2 9\n", "line 4", "point 9", "there are 3"),
                             (points + b"f 1 2 0\n", "line 4", "point 0"),
                             (points + b"f -1 -2 -4\n", "line 4", "point -4"),
                             (points + b"f 1 2 x\n", "line 4", "'x'"),
                             (b"v 0 0\n" + points + b"f 1 2 3\n", "line 1", "three numbers"),
                             (b"v 0 0 y\n" + points + b"f 1 2 3\n", "line 1", "'y'")):
            self.assert_refused("a.obj", data, *words)

    def test_stl_names_the_line(self):
        whole = surfaces.ascii_stl(surfaces.cube()).decode()
        self.assert_refused("a.stl", whole.replace("vertex 0 0 0", "vertex 0 0", 1).encode(),
                            "line 4", "three numbers")
        self.assert_refused("a.stl", whole.replace("vertex 0 0 0\n", "", 1).encode(), "line 2",
                            "2 points")
        self.assert_refused("a.stl", whole[:whole.index("endfacet")].encode(), "line 2",
                            "cut off")
        self.assert_refused("a.stl", b"<html><body>not found</body></html>" * 9, "text", "solid")

    def test_flat(self):
        self.obj(([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (2, 1, 0)]))
        self.assert_fails(EMPTY, ["a.obj"], "mesh", "a.obj", "-o", "a.vtu")

    def test_options(self):
        self.obj(surfaces.cube())
        for option in (("--iso", "1"), ("--labels", "1"), ("--grid", "a")):
            self.assert_fails(USAGE, [option[0]], "mesh", "a.obj", "-o", "a.vtu", *option)


class Volumes(WithVolumes, SurfaceProgramTest):
    def test_level_set(self):
        report = self.mesh("ball.vdb", "-o", "a.vtu")
        self.assertEqual(report["input"]["kind"], "volume")
        self.assertAlmostEqual(report["mesh"]["volume"], 4 / 3 * math.pi * 8, delta=0.1)
        self.check("a.vtu")
        larger = self.mesh("ball.vdb", "--iso", "0.1", "-o", "b.vtu")
        self.assertAlmostEqual(larger["mesh"]["volume"], 4 / 3 * math.pi * 2.1 ** 3, delta=0.2)
        self.mesh("ball.vdb", "-o", "c.vtu", "--threads", 8)
        self.assertEqual((self.folder / "a.vtu").read_bytes(),
                         (self.folder / "c.vtu").read_bytes())

    def test_fog(self):
        report = self.mesh("fog.vdb", "--iso", "0.5", "-o", "a.vtu")
        # Half of the fog is half of the narrow band inside.
        self.assertAlmostEqual(report["mesh"]["volume"], 4 / 3 * math.pi * 1.85 ** 3, delta=0.3)
        named = self.mesh("several.vdb", "--iso", "0.5", "--grid", "thick", "-o", "b.vtu")
        self.assertEqual(named["mesh"], report["mesh"])

    def test_refusals(self):
        for status, words, arguments in (
                (USAGE, ["--iso"], ["fog.vdb"]),
                (USAGE, ["narrow band"], ["ball.vdb", "--iso", "5"]),
                (BAD_INPUT, ["thick, thin"], ["several.vdb", "--iso", "1"]),
                (BAD_INPUT, ["named 'x'"], ["ball.vdb", "--grid", "x"]),
                (BAD_INPUT, ["no grid"], ["vectors.vdb"]),
                (EMPTY, ["inside"], ["fog.vdb", "--iso", "2"]),
                (BAD_INPUT, ["none.vdb"], ["none.vdb"])):
            with self.subTest(arguments):
                self.assert_fails(status, words, "mesh", *arguments, "-o", "a.vtu")

    def test_damaged(self):
        whole = (self.folder / "ball.vdb").read_bytes()
        for length in (0, 10, 100, len(whole) // 2, len(whole) - 20):
            (self.folder / "cut.vdb").write_bytes(whole[:length])
            with self.subTest(length):
                self.assert_fails(BAD_INPUT, ["cut.vdb"], "mesh", "cut.vdb", "-o", "a.vtu")

    def test_numbers_that_lie(self):
        """What OpenVDB would believe: versions, lengths of texts, counts, and places."""
        whole = (self.folder / "ball.vdb").read_bytes()
        background = whole.index(b"UniformScaleMap") + 15 + 15 * 8 + 4
        name = whole.index(b"ball") - 4
        for words, place, number in (
                (["221"], 8, 221), (["230", "newer"], 8, 230),
                (["metadata"], 57, 2**31), (["grids"], 61, 2**30), (["negative"], 61, 2**32 - 1),
                (["letters"], name, 2**32 - 16), (["buffers"], background - 4, 7),
                (["tiles"], background + 4, 2**32 - 1), (["nodes"], background + 8, 2**30),
                (["node"], background + 12, 5)):
            data = bytearray(whole)
            data[place:place + 4] = number.to_bytes(4, "little")
            (self.folder / "lie.vdb").write_bytes(data)
            with self.subTest(words):
                self.assert_fails(BAD_INPUT, ["lie.vdb", *words], "mesh", "lie.vdb", "-o", "a.vtu")


if __name__ == "__main__":
    unittest.main()
