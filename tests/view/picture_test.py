"""`certet picture` draws what is there, the same every time, and refuses well."""

import unittest

import images
import png
from program import TORUS, ProgramTest

USAGE, BAD_INPUT, WRITE_FAILED = 2, 3, 6


class Picture(ProgramTest):
    def setUp(self):
        super().setUp()
        self.mesh(*TORUS, "--size", "0.25", "-o", "t.vtu")

    def draw(self, *arguments):
        run = self.run_certet("picture", "t.vtu", "-o", "t.png", *arguments)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        return (self.folder / "t.png").read_bytes()

    def test_shows_something_on_a_light_ground(self):
        data = self.draw("--size", "300x200")
        self.assertEqual(png.read(data)[:2], (300, 200))
        pixels = png.pixels(data)
        self.assertGreater(len(set(pixels)), 200)
        self.assertGreater(min(pixels[0]), 240)
        # The torus is blue and fills a good part.
        blue = sum(b > r + 30 for r, g, b in pixels)
        self.assertGreater(blue, len(pixels) / 10)

    def test_cut_shows_edges(self):
        def dark(*arguments):
            return sum(max(p) < 90 for p in png.pixels(
                self.draw("--view", "cut", "--clip", "y:0.5", "--size", "300x200", *arguments)))
        self.assertGreater(dark(), 300)

    def test_bytes_are_the_same(self):
        self.assertEqual(self.draw("--size", "200x100"), self.draw("--size", "200x100"))

    def test_cut_of_nothing_is_the_surface(self):
        surface = self.draw("--size", "200x150", "--view", "surface")
        self.assertEqual(surface, self.draw("--size", "200x150", "--view", "cut", "--clip", "x:1"))
        self.assertNotEqual(surface,
                            self.draw("--size", "200x150", "--view", "cut", "--clip", "x:0.5"))

    def test_colors(self):
        region = set(png.pixels(self.draw("--size", "200x100")))
        angle = set(png.pixels(self.draw("--size", "200x100", "--color", "angle")))
        self.assertFalse(any(r > b + 60 for r, g, b in region))
        self.assertTrue(any(r > b + 60 for r, g, b in angle))

    def test_distances(self):
        """Planted: the torus is farther along x, so that its ends there are dark and its sides are
        pale; below is a legend from pale to dark, with numbers."""
        moved = "(sqrt((x-0.1)^2+y^2)-1)^2+z^2-0.16"
        data = self.draw("--size", "400x400", "--view", "surface", "--clip", "z", "--color",
                         "distance", "--against", moved)
        width, _, channels, rows = png.read(data)
        light = [[sum(row[channels * x:channels * x + 3]) for x in range(width)] for row in rows]
        purple = sum(b > g + 30 and r > g for r, g, b in png.pixels(data))
        self.assertGreater(purple, 1000)
        # The legend: from light to dark along a row, with a number on each side.
        legend = light[380]
        start, end = width // 2 - 60, width // 2 + 60
        self.assertGreater(legend[start], legend[end] + 250)
        self.assertEqual(sorted(legend[start:end], reverse=True), legend[start:end])
        for side in (slice(0, width // 3 - 2), slice(2 * width // 3 + 2, width)):
            self.assertTrue(any(p < 400 for row in light[370:390] for p in row[side]))
        near = self.draw("--size", "400x400", "--view", "surface", "--clip", "z", "--color",
                         "distance", "--against", "(sqrt(x^2+y^2)-1)^2+z^2-0.16")
        self.assertNotEqual(data, near)
        self.assert_fails(USAGE, ["--against"], "picture", "t.vtu", "-o", "x.png", "--color", "distance")
        self.assert_fails(USAGE, ["--color distance"], "picture", "t.vtu", "-o", "x.png", "--against",
                          "torus:1,0.4")

    def test_labels_are_cut_flat_with_lines_between(self):
        """Two labels one over the other: a flat cut has one straight line between their colours."""
        size = (16, 16, 16)
        images.write_nrrd(self.folder / "a.nrrd", size,
                          images.voxels(size, lambda i, j, k: 1 if k < 8 else 2), kind="B")
        self.mesh("a.nrrd", "-o", "t.vtu")
        view = ("--view", "cut", "--clip", "y:0.5", "--size", "300x300")
        flat = self.draw(*view)
        self.assertEqual(flat, self.draw(*view, "--cut", "flat"))
        self.assertNotEqual(flat, self.draw(*view, "--cut", "whole"))
        pixels = png.pixels(flat)

        def kind(pixel):
            red, _, blue = pixel
            return "dark" if max(pixel) < 130 else "lower" if blue > red + 20 else (
                "upper" if red > blue + 20 else None)
        columns = 0
        for x in range(100, 180):
            kinds = [kind(pixels[300 * y + x]) for y in range(300)]
            seen = [k for k, before in zip(kinds, [None] + kinds) if k and k != before]
            columns += "upper" in seen and "lower" in seen and "dark" in seen[
                seen.index("upper"):len(seen) - seen[::-1].index("lower")]
        self.assertGreater(columns, 70)

    def test_refusals(self):
        def fails(status, words, *arguments):
            self.assert_fails(status, words, "picture", *arguments)
        fails(USAGE, ["--size"], "t.vtu", "-o", "p.png", "--size", "100")
        fails(USAGE, ["16 to 8192"], "t.vtu", "-o", "p.png", "--size", "9000x10")
        fails(USAGE, ["--clip"], "t.vtu", "-o", "p.png", "--clip", "w")
        fails(USAGE, ["fraction"], "t.vtu", "-o", "p.png", "--clip", "x:1.5")
        fails(USAGE, [".png"], "t.vtu", "-o", "p.jpg")
        fails(USAGE, ["same file"], "t.vtu", "-o", "t.vtu")
        fails(BAD_INPUT, ["none.vtu"], "none.vtu", "-o", "p.png")
        fails(WRITE_FAILED, ["nowhere"], "t.vtu", "-o", "nowhere/p.png")


if __name__ == "__main__":
    unittest.main()
