"""`certet report` makes a page that tells the truth, in a real browser."""

import base64
import collections
import json
import pathlib
import re
import subprocess
import tempfile
import unittest

import browser
import images
import png
import vtu
from program import CERTET, TORUS, ProgramTest

USAGE, BAD_INPUT, WRITE_FAILED = 2, 3, 6


def certet(folder, *arguments):
    return subprocess.run([CERTET, *arguments], cwd=folder, text=True, capture_output=True,
                          timeout=300)


class InBrowser(unittest.TestCase):
    """One page in one browser; each test loads it anew."""

    @classmethod
    def show(cls):
        """The page t.html of the folder."""
        if "id=\"canvas\"" not in (cls.folder / "t.html").read_text():
            raise unittest.SkipTest("the view was not built in")
        cls.driver = browser.start()
        cls.addClassCleanup(cls.driver.quit)

    @classmethod
    def make_folder(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def setUp(self):
        self.load()

    def load(self):
        self.driver.get_log("browser"), self.driver.get_log("performance")
        self.driver.get((self.folder / "t.html").as_uri())

    def js(self, script):
        return self.driver.execute_script(script)

    def choose(self, selector):
        self.js(f"document.querySelector('{selector}').click()")

    def triangles(self):
        return int(self.js("return document.getElementById('drawn').dataset.value"))

    def move_plane(self, place):
        self.js("const p = document.getElementById('plane');"
                f"p.value = {place}; p.dispatchEvent(new Event('input'))")

    def pixels(self):
        """Of the canvas, with transparency, after the next frame."""
        url = self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() =>"
            "done(document.getElementById('canvas').toDataURL())))")
        return png.pixels(base64.b64decode(url.split(",")[1]))

    def drawn_colors(self):
        return collections.Counter(p[:3] for p in self.pixels() if p[3] == 255)

class Page(InBrowser):
    """Of one region."""

    @classmethod
    def setUpClass(cls):
        cls.make_folder()
        cls.made_by = json.loads(certet(cls.folder, "mesh", *TORUS, "--size", "0.15", "-o", "t<i>.vtu",
                                    "--json", "-").stdout)
        (cls.folder / "run.json").write_text(json.dumps(cls.made_by))
        cls.check = json.loads(certet(cls.folder, "check", "t<i>.vtu", "--json", "-").stdout)
        made = certet(cls.folder, "report", "t<i>.vtu", "--run", "run.json", "-o", "t.html")
        assert (made.returncode, made.stdout, made.stderr) == (0, "", ""), made
        cls.show()

    def test_asks_for_nothing_and_complains_of_nothing(self):
        self.pixels()
        self.choose("input[name=axis][value=\"0\"]")
        self.pixels()
        self.assertEqual(self.driver.get_log("browser"), [])
        asked = [url for url in browser.requests(self.driver) if not url.startswith("data:")]
        self.assertEqual(asked, [(self.folder / "t.html").as_uri()])

    def test_numbers_are_those_of_the_check(self):
        def shown(key):
            return self.js(f"return document.querySelector('[data-key={key}]').dataset.value")
        mesh, dihedral = self.check["mesh"], self.check["dihedral"]
        for key in ("tets", "points", "boundary_faces", "nonpositive_tets"):
            self.assertEqual(int(shown(key)), mesh[key], key)
        self.assertEqual(float(shown("volume")), mesh["volume"])
        self.assertEqual(float(shown("min")), dihedral["min"])
        self.assertEqual(float(shown("max")), dihedral["max"])
        bars = self.js("return [...document.querySelectorAll('#dihedral rect')]"
                       ".map((bar) => Number(bar.dataset.count))")
        self.assertEqual(bars, [count for count in dihedral["histogram"] if count > 0])
        edges = self.js("return [...document.querySelectorAll('#edges rect, svg#edges rect')]"
                        ".map((bar) => Number(bar.dataset.count))")
        self.assertEqual(sum(edges), 6 * mesh["tets"])

    def test_run_is_told(self):
        text = self.js("return document.body.innerText")
        for words in (self.made_by["mesh"]["checksum"], self.made_by["guarantee"]["theorem"], "t<i>.vtu",
                      "Valid, positive, conforming and closed"):
            self.assertIn(words, text)
        marks = self.js("return [...document.querySelectorAll('text.bound')]"
                        ".map((mark) => mark.textContent)")
        self.assertEqual(marks, ["11.18°", "157.1°"])

    def test_surface_is_drawn(self):
        self.assertEqual(self.triangles(), self.check["mesh"]["boundary_faces"])
        pixels = self.pixels()
        drawn = sum(p[3] == 255 for p in pixels)
        self.assertGreater(drawn, len(pixels) / 20)
        self.assertLess(drawn, len(pixels) * 0.9)
        self.assertGreater(len(self.drawn_colors()), 50)

    def test_plane_cuts(self):
        self.choose("input[name=axis][value=\"0\"]")
        half = self.triangles()
        whole = self.check["mesh"]["boundary_faces"]
        self.assertTrue(whole * 0.4 < half < whole * 0.9, half)
        counts = []
        for place in (2, 10, 25, 36):
            self.move_plane(place)
            counts.append(self.triangles())
        self.assertEqual(counts, sorted(counts))
        self.assertEqual(len(set(counts)), 4)

    def test_two_sides_share_their_cut(self):
        whole = self.check["mesh"]["boundary_faces"]
        for axis in "012":
            self.choose(f"input[name=axis][value=\"{axis}\"]")
            self.move_plane(15)
            one = self.triangles()
            self.choose("#flip")
            cut = one + self.triangles() - whole
            self.assertGreater(cut, 0)
            self.assertEqual(cut % 2, 0, "the cut belongs to both sides")

    def test_colors_switch(self):
        before = self.drawn_colors()
        self.choose("input[name=color][value=angle]")
        after = self.drawn_colors()

        def red(colors):
            return sum(n for (r, g, b), n in colors.items() if r > b + 50)
        self.assertEqual(red(before), 0)
        self.assertGreater(red(after), 100)
        self.assertTrue(self.js("return document.getElementById('legend-region').hidden"))
        self.assertFalse(self.js("return document.getElementById('legend-angle').hidden"))

    def test_edges_can_be_hidden(self):
        def dark(colors):
            return sum(n for color, n in colors.items() if max(color) < 100)
        before = dark(self.drawn_colors())
        self.choose("#edges")
        self.assertLess(dark(self.drawn_colors()), before / 2)

    def test_narrow_screen(self):
        browser.phone(self.driver)
        self.addCleanup(self.driver.execute_cdp_cmd, "Emulation.clearDeviceMetricsOverride", {})
        self.load()
        self.assertEqual(self.js("return document.documentElement.scrollWidth"), 360)
        self.assertGreater(len(self.drawn_colors()), 50)


class Parts(InBrowser):
    """Of three regions, one of them inside another and one beside it."""

    @classmethod
    def setUpClass(cls):
        cls.make_folder()
        size = (14, 14, 14)

        def label(i, j, k):
            return 0 if not 2 <= i < 12 else 5 if i < 4 else 9 if 5 <= min(j, k) and max(
                i, j, k) < 9 else 2

        images.write_nrrd(cls.folder / "a.nrrd", size, images.voxels(size, label), kind="B")
        (cls.folder / "names.txt").write_text("2 <big>\n5 flat\n9 inner\n")
        certet(cls.folder, "mesh", "a.nrrd", "-o", "t.msh", "--label-names", "names.txt")
        cls.check = json.loads(certet(cls.folder, "check", "t.msh", "--json", "-").stdout)
        made = certet(cls.folder, "report", "t.msh", "-o", "t.html")
        assert (made.returncode, made.stdout, made.stderr) == (0, "", ""), made
        cls.show()

    def part(self, value):
        self.js(f"const p = document.getElementById('part'); p.value = '{value}';"
                "p.dispatchEvent(new Event('change'))")
        return self.triangles()

    def test_a_part_alone_is_drawn(self):
        self.assertEqual(self.driver.get_log("browser"), [])
        self.assertEqual(self.triangles(), self.check["mesh"]["boundary_faces"])
        for place, region in enumerate(self.check["regions"]):
            self.assertEqual(self.part(f"r{place}"), region["surface"]["faces"])
        places = {region["label"]: place for place, region in enumerate(self.check["regions"])}
        for interface in self.check["interfaces"]:
            a, b = (places[label] for label in interface["labels"])
            self.assertEqual(self.part(f"i{a},{b}"), interface["triangles"])
        self.assertEqual(self.part("interfaces"),
                         sum(i["triangles"] for i in self.check["interfaces"]))
        self.assertEqual(self.part("all"), self.check["mesh"]["boundary_faces"])
        self.assertEqual(self.driver.get_log("browser"), [])

    def test_a_part_is_cut_open(self):
        whole = self.part("r0")
        self.choose("input[name=axis][value=\"1\"]")
        one = self.triangles()
        self.choose("#flip")
        self.assertGreater(one + self.triangles(), whole)
        self.assertGreater(len(self.drawn_colors()), 20)

    def test_tables_have_names_and_measures(self):
        rows = self.js("return [...document.querySelectorAll('#regions tbody tr, #interfaces tbody tr')]"
                       ".map((row) => row.innerText)")
        self.assertEqual(len(rows), len(self.check["regions"]) + len(self.check["interfaces"]))
        self.assertIn("<big> (2)", rows[0])
        self.assertTrue(any("<big> (2) | inner (9)" in row for row in rows))


class WithoutWebGL(unittest.TestCase):
    def test_says_so_and_shows_the_rest(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            certet(folder, "mesh", *TORUS, "--size", "0.3", "-o", "t.vtu")
            certet(folder, "report", "t.vtu", "-o", "t.html")
            driver = browser.start(webgl=False)
            try:
                driver.get((folder / "t.html").as_uri())
                text = driver.execute_script("return document.body.innerText")
                self.assertEqual(driver.get_log("browser"), [])
                self.assertIn("no WebGL", text)
                self.assertIn("Which theorem covers this mesh is not known", text)
                self.assertEqual(driver.execute_script(
                    "return document.querySelectorAll('svg rect').length > 20"), True)
            finally:
                driver.quit()


class Command(ProgramTest):
    """What needs no browser."""

    def setUp(self):
        super().setUp()
        run = self.mesh(*TORUS, "--size", "0.3", "-o", "t.vtu")
        (self.folder / "run.json").write_text(json.dumps(run))

    def test_broken_mesh_has_a_page(self):
        tet = vtu.tets(self.folder / "t.vtu")[7]
        kind = vtu.arrays(self.folder / "t.vtu")[1]["connectivity"][2]
        for item, corner in ((28, tet[1]), (29, tet[0])):
            vtu.overwrite(self.folder / "t.vtu", "connectivity", item,
                          "i" if kind.endswith("32") else "q", corner)
        run = self.run_certet("report", "t.vtu", "-o", "t.html")
        self.assertEqual(run.returncode, 1)
        page = (self.folder / "t.html").read_text()
        self.assertIn("Broken:", page)
        self.assertNotIn("conforming and closed", page)

    def test_same_bytes(self):
        for name in "ab":
            self.assertEqual(
                self.run_certet("report", "t.vtu", "-o", name + ".html").returncode, 0)
        self.assertEqual((self.folder / "a.html").read_bytes(),
                         (self.folder / "b.html").read_bytes())

    def test_bounds_by_options(self):
        for options, shown in ((["--cuts", "midpoint"], ["30°", "135°"]),
                               (["--guarantee", "embedding"], ["9.27°", "161.5°"]), ([], [])):
            self.run_certet("report", "t.vtu", "-o", "t.html", *options)
            page = (self.folder / "t.html").read_text()
            self.assertEqual(re.findall(r'<text class="bound"[^>]*>([^<]*)<', page), shown)

    def report(self, *options):
        run = self.run_certet("report", "t.vtu", "-o", "t.html", *options)
        return run.returncode, (self.folder / "t.html").read_text()

    def test_a_theorem_is_named_where_it_covers_the_file(self):
        theorem = json.loads((self.folder / "run.json").read_text())["guarantee"]["theorem"]
        status, page = self.report("--run", "run.json")
        self.assertEqual(status, 0)
        self.assertIn(theorem, page)
        self.assertIn("<th>proven</th>", page)
        for options in ([], ["--guarantee", "angles"]):
            status, page = self.report(*options)
            self.assertEqual(status, 0)
            self.assertNotIn(theorem, page)
            self.assertNotIn("<th>proven</th>", page)

    def test_a_moved_vertex_is_not_vouched_for(self):
        path = self.folder / "t.vtu"
        name = next(n for n in vtu.arrays(path)[1] if n.lower() == "points")
        tet = vtu.tets(path)[7]
        points = vtu.points(path)
        # Nearly upon the plane of the others.
        for axis in range(3):
            middle = sum(points[p][axis] for p in tet[:3]) / 3
            vtu.overwrite(path, name, 3 * tet[3] + axis, "d",
                          middle + 0.01 * (points[tet[3]][axis] - middle))
        status, page = self.report("--run", "run.json")
        self.assertEqual(status, 1)
        self.assertIn("Broken:", page)
        self.assertIn("are not those that the run of", page)
        for words in ("<th>proven</th>", "DihedralBounds", "<th>lattice</th>"):
            self.assertFalse(words in page, words)
        least = float(re.search(r'data-key="min" data-value="([^"]*)"', page)[1])
        self.assertLess(least, 5)

    def test_bounds_that_the_file_breaks(self):
        status, page = self.report("--cuts", "midpoint")
        self.assertEqual(status, 1)
        self.assertIn("outside of the 30 to 135 of a mesh made as it is said", page)

    def test_refusals(self):
        def fails(status, words, *arguments):
            self.assert_fails(status, words, "report", *arguments)
        (self.folder / "other.json").write_text("{}")
        (self.folder / "no.json").write_text("hello")
        run = json.loads((self.folder / "run.json").read_text())
        run["mesh"]["tets"] += 1
        (self.folder / "wrong.json").write_text(json.dumps(run))
        fails(USAGE, ["same file"], "t.vtu", "-o", "t.vtu")
        fails(USAGE, ["same file"], "t.vtu", "-o", "run.json", "--run", "run.json")
        fails(USAGE, ["--run"], "t.vtu", "-o", "t.html", "--run", "run.json", "--cuts", "bisect")
        fails(BAD_INPUT, ["none.vtu"], "none.vtu", "-o", "t.html")
        for name in ("other.json", "no.json", "wrong.json", "none.json"):
            fails(BAD_INPUT, [name], "t.vtu", "-o", "t.html", "--run", name)
        fails(WRITE_FAILED, ["nowhere"], "t.vtu", "-o", "nowhere/t.html")


if __name__ == "__main__":
    unittest.main()
