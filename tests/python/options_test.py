"""Options that are the command's: sizes by counts, pieces that stay, crops, names and progress."""

import inspect
import io
import json
import os
import pickle
import subprocess
import sys
import tempfile
import types
import unittest
from contextlib import redirect_stderr
from unittest import mock

import certet
import numpy as np

BOX = ((-1.2,) * 3, (1.2,) * 3)


def ball(points):
    return np.linalg.norm(points, axis=1) - 1


def two_blocks():
    """A block of 1,000 voxels and one of 64, and between them nothing."""
    labels = np.zeros((24, 14, 14), np.uint8)
    labels[2:12, 2:12, 2:12] = 1
    labels[16:20, 2:6, 2:6] = 1
    return labels


class Counts(unittest.TestCase):
    def test_a_number_of_tetrahedra(self):
        mesh = certet.mesh(ball, bounds=BOX, target_tets=20_000)
        self.assertAlmostEqual(len(mesh.tets) / 20_000, 1, delta=0.02)

    def test_the_command_finds_the_same_size(self):
        mesh = certet.mesh(certet.Solid("sphere:1"), target_tets=5_000)
        with tempfile.TemporaryDirectory() as folder:
            report = os.path.join(folder, "a.json")
            subprocess.run([os.environ["CERTET"], "mesh", "--shape", "sphere:1", "--target-tets",
                            "5000", "-o", os.path.join(folder, "a.vtu"), "--json", report],
                           check=True, capture_output=True)
            with open(report) as file:
                told = json.load(file)
        self.assertEqual(len(mesh.tets), told["mesh"]["tets"])

    def test_graded_ones_are_counted_as_they_are(self):
        mesh = certet.mesh(ball, bounds=BOX, target_tets=20_000, grade=2)
        self.assertAlmostEqual(len(mesh.tets) / 20_000, 1, delta=0.02)

    def test_one_or_the_other(self):
        with self.assertRaisesRegex(ValueError, "target_tets finds the size"):
            certet.mesh(ball, bounds=BOX, size=0.1, target_tets=100)
        for wrong in (0, -3, "many", 1.5):
            with self.assertRaisesRegex(ValueError, "target_tets is a whole number"):
                certet.mesh(ball, bounds=BOX, target_tets=wrong)


class Keep(unittest.TestCase):
    def test_the_largest(self):
        both = certet.mesh(two_blocks(), smooth=0)
        self.assertIsNone(both.dropped)
        self.assertEqual(both.pieces().by_faces, 2)
        for rule in ("largest", 1, np.int64(1)):
            one = certet.mesh(two_blocks(), smooth=0, keep=rule)
            self.assertEqual(one.pieces().by_faces, 1)
            self.assertEqual((one.dropped.pieces, one.dropped.tets),
                             (1, len(both.tets) - len(one.tets)))
            volume = both.quality().volume - one.quality().volume
            self.assertAlmostEqual(one.dropped.volume, volume, places=9)
            self.assertEqual(one.losses, [])
        two = certet.mesh(two_blocks(), smooth=0, keep=2)
        self.assertEqual((two.checksum, two.dropped.pieces), (both.checksum, 0))

    def test_those_that_percolate(self):
        labels = np.zeros((20, 12, 12), np.uint8)
        labels[:, 2:6, 2:6] = 1
        labels[4:9, 8:11, 8:11] = 1
        mesh = certet.mesh(labels, keep="percolating:x", grade=1)
        self.assertEqual(mesh.pieces().by_faces, 1)
        with self.assertRaisesRegex(ValueError, "none of the 2 pieces is kept"):
            certet.mesh(labels, keep="percolating:y")

    def test_rules_that_are_none(self):
        for wrong in ("smallest", "percolating:", "percolating:xy", "percolating:w", "0", ""):
            with self.assertRaisesRegex(ValueError, "keep is 'largest', a number of pieces"):
                certet.mesh(two_blocks(), keep=wrong)
        for wrong in (0, -1, 1.5):
            with self.assertRaisesRegex(ValueError, "keep is a whole number"):
                certet.mesh(two_blocks(), keep=wrong)

    def test_a_copy_tells_the_same(self):
        mesh = certet.mesh(two_blocks(), smooth=0, keep=1)
        again = pickle.loads(pickle.dumps(mesh))
        for told in ("dropped", "warp", "losses"):
            self.assertEqual(getattr(again, told), getattr(mesh, told))


class Crop(unittest.TestCase):
    def test_only_what_is_in_the_box(self):
        mesh = certet.mesh(two_blocks(), smooth=0, crop=(0, 0, 0, 7.25, 20, 20))
        self.assertEqual(mesh.points[:, 0].max().round(3), 7.25)
        self.assertEqual({p.name for p in mesh.patches()}, {"surface", "xmax"})
        self.assertEqual(mesh.losses + mesh.warnings, [])

    def test_the_lattice_is_that_of_the_whole(self):
        """Points within both boxes are points of the mesh of the whole."""
        whole = certet.mesh(two_blocks())
        known = {tuple(p) for p in whole.points.round(9)}
        for crop in (((-5, -5, -5), (6.4, 30, 30)), ((6.4, -5, -5), (30, 30, 30))):
            part = certet.mesh(two_blocks(), crop=crop)
            away = np.abs(part.points[:, 0] - 6.4) > 2
            self.assertGreater(away.sum(), 100)
            self.assertLessEqual({tuple(p) for p in part.points[away].round(9)}, known)


class Patches(unittest.TestCase):
    def test_names_at_once(self):
        mesh = certet.mesh(two_blocks(), smooth=0, crop=((0, 0, 0), (7.25, 20, 20)),
                           patches={"inlet": "xmax", "floor": ("z", 1.5)})
        self.assertEqual({p.name for p in mesh.patches()}, {"surface", "inlet", "floor"})
        with self.assertRaises(ValueError):
            certet.mesh(two_blocks(), patches={"inlet": "xmax"})


class Progress(unittest.TestCase):
    def test_a_function_is_told(self):
        told = []
        certet.mesh(ball, bounds=BOX, size=0.02, progress=lambda *where: told.append(where))
        self.assertTrue(told)
        for stage, done, total in told:
            self.assertIn(stage, ("sample", "cut", "warp", "count", "emit"))
            self.assertTrue(0 <= done <= total)

    def test_what_it_raises_ends_the_run(self):
        def enough(stage, done, total):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "^enough$"):
            certet.mesh(ball, bounds=BOX, size=0.02, progress=enough)

    def test_a_bar_by_tqdm_or_without(self):
        bars = []

        class Bar:
            def __init__(self, total, desc, **_):
                self.total, self.desc, self.n, self.closed = total, desc, 0, False
                bars.append(self)

            def update(self, by):
                self.n += by

            def close(self):
                self.closed = True

        auto = types.ModuleType("tqdm.auto")
        auto.tqdm = Bar
        with mock.patch.dict(sys.modules, {"tqdm": types.ModuleType("tqdm"), "tqdm.auto": auto}):
            certet.mesh(ball, bounds=BOX, size=0.02, progress=True)
        self.assertTrue(bars)
        for bar in bars:
            self.assertLessEqual(bar.n, bar.total)
        with mock.patch.dict(sys.modules, {"tqdm.auto": None}), redirect_stderr(io.StringIO()) as err:
            certet.mesh(ball, bounds=BOX, size=0.05, progress=True)
        self.assertEqual(err.getvalue(), "")

    def test_neither(self):
        with self.assertRaisesRegex(ValueError, "progress is True, False or a function"):
            certet.mesh(ball, bounds=BOX, progress=3)


class Names(unittest.TestCase):
    def test_help_shows_all_options(self):
        for function in (certet.mesh_image, certet.mesh_function, certet.mesh_surface,
                         certet.mesh_solids):
            shown = inspect.signature(function).parameters
            self.assertLessEqual(set(certet.MeshOptions.__annotations__), set(shown))

    def test_an_option_that_is_none_is_named(self):
        with self.assertRaisesRegex(TypeError, "'sizes' is no option of a mesh"):
            certet.mesh(ball, bounds=BOX, sizes=3)


if __name__ == "__main__":
    unittest.main()
