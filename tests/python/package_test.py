"""The Python package: what it makes, what it refuses, and how it is stopped."""

import gc
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import certet
import numpy as np
from read_back import read_back

TORUS_VOLUME = 2 * np.pi**2 * 0.4**2


def torus(points):
    ring = np.hypot(points[:, 0], points[:, 1]) - 1
    return ring**2 + points[:, 2] ** 2 - 0.16


BOX = ((-1.5, -1.5, -0.5), (1.5, 1.5, 0.5))


def ball(n=24, radius=9.0):
    grid = np.indices((n, n, n)) - (n - 1) / 2
    return (np.sqrt((grid**2).sum(0)) < radius).astype(np.uint8)


def volumes(mesh):
    p = mesh.points[mesh.tets]
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def cube(low, high):
    """Points and triangles of a box, anticlockwise seen from outside."""
    corners = np.array([[(low, high)[n >> a & 1][a] for a in range(3)] for n in range(8)], float)
    quads = np.array([(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1),
                      (4, 5, 7, 6)])
    return corners, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


class Solids(unittest.TestCase):
    """Several in one mesh."""

    boxes = {"left": cube((0, 0, 0), (1, 1, 1)), "right": cube((1, 0, 0), (3, 1, 1))}

    def volumes(self, mesh):
        return {mesh.names[n]: volumes(mesh)[mesh.labels == n].sum() for n in np.unique(mesh.labels)}

    def test_boxes_with_a_common_wall(self):
        mesh = certet.mesh(self.boxes, size=0.1)
        self.assertEqual(mesh.names, {1: "left", 2: "right"})
        found = self.volumes(mesh)
        self.assertAlmostEqual(found["left"], 1, delta=0.02)
        self.assertAlmostEqual(found["right"], 2, delta=0.02)
        self.assertTrue(mesh.quality().holds)
        self.assertEqual(mesh.quality().theorem, "MaterialDihedralBoundsInDegrees")
        self.assertEqual(certet.check(mesh).failures, [])
        self.assertEqual(mesh.pieces().regions, {1: (1, 1), 2: (1, 1)})

    def test_functions_and_triangles_and_who_is_stronger(self):
        solids = {"ball": lambda p: (p**2).sum(1) - 1, "box": cube((0, 0, 0), (2, 1, 1))}
        box = ((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1))
        eighth = np.pi / 6
        found = self.volumes(certet.mesh(solids, bounds=box, size=0.08))
        self.assertAlmostEqual(found["ball"], 7 * eighth, delta=0.05)
        self.assertAlmostEqual(found["box"], 2, delta=0.05)
        found = self.volumes(certet.mesh(solids, bounds=box, size=0.08, priority=["ball"]))
        self.assertAlmostEqual(found["ball"], 8 * eighth, delta=0.05)
        self.assertAlmostEqual(found["box"], 2 - eighth, delta=0.05)

    def test_names_go_out(self):
        mesh = certet.mesh(self.boxes, size=0.25)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "a.msh")
            certet.write(mesh, file)
            self.assertEqual(certet.read(file).names, {1: "left", 2: "right"})

    def test_threads_do_not_matter(self):
        meshes = [certet.mesh(self.boxes, size=0.1, threads=n) for n in (1, 2, 8)]
        self.assertEqual(len({m.checksum for m in meshes}), 1)

    def test_open_surfaces_are_refused_or_repaired(self):
        points, triangles = self.boxes["left"]
        solids = {"open": (points, triangles[:-1]), "right": self.boxes["right"]}
        with self.assertRaisesRegex(ValueError, "'open'.*repair=True"):
            certet.mesh(solids, size=0.25)
        self.assertIn("'open'", certet.mesh(solids, size=0.25, repair=True).notes[0])

    def test_refusals(self):
        for solids, words, options in (
                ({}, "no solid", {}),
                (self.boxes, "'top'", {"priority": ["top"]}),
                ({"f": lambda p: p[:, 0]}, "'f' needs bounds", {}),
                ({"a": 3}, "'a' is neither", {}),
                ({"": self.boxes["left"]}, "no name", {})):
            with self.assertRaisesRegex(ValueError, words):
                certet.mesh_solids(solids, **options)

    def test_what_a_function_raises_is_raised(self):
        def broken(points):
            raise LookupError("no such place")

        with self.assertRaisesRegex(LookupError, "no such place"):
            certet.mesh({"a": broken}, bounds=BOX)


class Losses(unittest.TestCase):
    def test_of_every_kind(self):
        """A volume that the lattice does not hold, or pieces; both are as the command has them."""
        peak = np.zeros((12, 12, 12))
        peak[3:8, 3:8, 3:8] = 3
        peak[10, 2, 2] = 1
        shell = lambda p: np.abs(np.linalg.norm(p, axis=1) - 1) - 0.02
        vessel = np.zeros((8, 8, 20), np.uint8)
        vessel[4, 4, 2:18] = 1
        for words, mesh in (
                ("has 1 piece, and the shape 2; size=", lambda: certet.mesh(peak, iso=0.9)),
                ("of the volume of 'function'", lambda: certet.mesh(
                    shell, bounds=((-1.5,) * 3, (1.5,) * 3), size=0.3)),
                ("of the volume of 'array', .* of 16;", lambda: certet.mesh(
                    vessel, method="embedding", size=0.9))):
            with self.subTest(words), self.assertWarnsRegex(certet.LossWarning, words):
                mesh()

    def test_what_is_not_compared_is_noted(self):
        """Of a function every cell of a finer lattice would be asked about."""
        mesh = certet.mesh(lambda p: (p**2).sum(1) - 1, bounds=((-1.1,) * 3, (1.1,) * 3), size=0.05)
        self.assertRegex(mesh.notes[0], "not compared with those of finer samples: at size 0.025 ")
        self.assertEqual(certet.mesh(ball()).notes, [])

    def test_none_where_all_is_kept(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for mesh in (certet.mesh(torus, bounds=BOX, size=0.1), certet.mesh(ball()),
                         certet.mesh(ball().astype(float), iso=0.5)):
                self.assertEqual(mesh.losses, [])

    def test_what_became_of_vertices(self):
        """As the JSON of the command has it."""
        dots = np.zeros((14, 14, 14), np.uint8)
        dots[3:12:4, 3:12:4, 3:12] = 1
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", certet.LossWarning)
            warp = certet.mesh(dots, spacing=(1, 1.1, 1.2), smooth=0).warp
        self.assertGreater(warp.stayed, 0)
        self.assertGreater(warp.violated, warp.stayed)
        self.assertGreater(warp.clamped_cuts, 0)
        self.assertLessEqual(0, warp.rms)
        self.assertLessEqual(warp.rms, warp.greatest)
        self.assertLess(warp.greatest_edges, 0.4)
        self.assertEqual(set(certet.mesh(ball(), method="midpoint").warp), {0})


def three_materials():
    """A ball, one in it, and one through its surface."""
    labels = ball().astype(np.int16)
    grid = np.indices(labels.shape)
    for label, centre, radius in ((2, (10, 11, 11), 5.0), (7, (17, 12, 11), 4.5)):
        at = grid - np.reshape(centre, (3, 1, 1, 1))
        labels[(at**2).sum(0) < radius**2] = label
    return labels


def area_of(corners):
    a, b, c = np.moveaxis(corners, 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


class Interfaces(unittest.TestCase):
    def setUp(self):
        self.mesh = certet.mesh(three_materials(), spacing=(1, 1.5, 1.25))

    def faces_between(self, one, other):
        """The faces that tetrahedra of two labels share, each by its points."""
        mesh = self.mesh
        faces = [{frozenset(row) for corners in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
                  for row in mesh.tets[mesh.labels == label][:, corners].tolist()}
                 for label in (one, other)]
        return faces[0] & faces[1]

    def test_are_what_labels_share(self):
        found = self.mesh.interfaces()
        self.assertEqual([i.labels for i in found], [(1, 2), (1, 7), (2, 7)])
        for interface in found:
            self.assertEqual(interface.names, tuple(map(str, interface.labels)))
            self.assertEqual(interface.triangles.shape[1:], (3,))
            self.assertTrue(np.issubdtype(interface.triangles.dtype, np.integer))
            self.assertFalse(interface.triangles.flags.owndata)
            shared = self.faces_between(*interface.labels)
            self.assertEqual({frozenset(t) for t in interface.triangles.tolist()}, shared)
            self.assertEqual(len(interface.triangles), len(shared))
            corners = self.mesh.points[interface.triangles]
            self.assertAlmostEqual(area_of(corners), interface.area, places=9)

    def test_are_seen_from_the_greater_label(self):
        """The surface of label 2, put together, encloses its volume."""
        found = {i.labels: i.triangles for i in certet.interfaces(self.mesh)}
        around = np.concatenate([found[1, 2][:, ::-1], found[2, 7]])
        corners = self.mesh.points[around]
        enclosed = np.linalg.det(corners - corners[0, 0]).sum() / 6
        own = volumes(self.mesh)[self.mesh.labels == 2].sum()
        self.assertAlmostEqual(enclosed, own, places=6)

    def test_outlive_the_mesh(self):
        found = self.mesh.interfaces()
        before = [i.triangles.copy() for i in found]
        self.mesh = None
        gc.collect()
        for interface, copy in zip(found, before):
            self.assertTrue(np.array_equal(interface.triangles, copy))

    def test_of_a_file_are_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.vtu", "a.mesh"):
                file = pathlib.Path(folder) / name
                certet.write(self.mesh, file)
                for here, there in zip(self.mesh.interfaces(), certet.read(file).interfaces()):
                    self.assertEqual(here.labels, there.labels)
                    self.assertTrue(np.array_equal(here.triangles, there.triangles))
                    self.assertAlmostEqual(here.area, there.area, places=9)

    def test_are_none_without_labels_that_touch(self):
        self.assertEqual(certet.mesh(ball()).interfaces(), [])
        self.assertEqual(certet.mesh(three_materials(), method="angles").interfaces(), [])
        self.assertEqual(certet.mesh_function(torus, BOX, 0.2).interfaces(), [])


class Functions(unittest.TestCase):
    def test_torus(self):
        mesh = certet.mesh_function(torus, BOX, 0.1)
        self.assertTrue((volumes(mesh) > 0).all())
        self.assertAlmostEqual(volumes(mesh).sum(), TORUS_VOLUME, delta=0.02 * TORUS_VOLUME)
        quality = mesh.quality()
        self.assertTrue(quality.holds)
        self.assertEqual(quality.tets, len(mesh.tets))
        self.assertEqual(quality.histogram.sum(), 6 * len(mesh.tets))
        self.assertIsNone(mesh.labels)

    def test_the_same_mesh_as_the_command_makes(self):
        mesh = certet.mesh_function(torus, BOX, 0.1)
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "r.json"
            # Both add, multiply and take roots in the same order.
            subprocess.run(
                [os.environ["CERTET"], "mesh", "--expr", "(sqrt(x*x+y*y)-1)^2+z^2-0.16",
                 "--bounds=-1.5,-1.5,-0.5,1.5,1.5,0.5", "--size", "0.1", "--json", report,
                 "-o", pathlib.Path(folder) / "t.vtu"], check=True, stdout=subprocess.DEVNULL)
            import json
            told = json.loads(report.read_text())
        exact = certet.mesh_function(
            lambda p: (np.sqrt(p[:, 0] ** 2 + p[:, 1] ** 2) - 1) ** 2 + p[:, 2] ** 2 - 0.16,
            BOX, 0.1)
        self.assertEqual(int(told["mesh"]["checksum"], 16), exact.checksum)
        self.assertEqual(told["mesh"]["tets"], len(mesh.tets))

    def test_threads_do_not_matter(self):
        meshes = [certet.mesh_function(torus, BOX, 0.2, threads=n) for n in (1, 2, 8)]
        self.assertEqual(len({m.checksum for m in meshes}), 1)

    def test_what_the_function_raises_is_raised(self):
        def broken(points):
            raise LookupError("no such place")

        with self.assertRaisesRegex(LookupError, "no such place"):
            certet.mesh_function(broken, BOX, 0.1)

    def test_too_few_numbers(self):
        with self.assertRaisesRegex(ValueError, "gave 1 numbers"):
            certet.mesh_function(lambda p: [1.0], BOX, 0.1)

    def test_nan_is_outside(self):
        with self.assertRaisesRegex(ValueError, "nothing is inside"):
            certet.mesh_function(lambda p: np.full(len(p), np.nan), BOX, 0.1)

    def test_ctrl_c(self):
        def slow(points):
            time.sleep(0.001)
            return torus(points)

        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            certet.mesh_function(slow, BOX, 0.005)
        self.assertLess(time.monotonic() - start, 60)  # and not the hours of the whole run

    def test_other_threads_run_meanwhile(self):
        counted = []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted.append(None)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        certet.mesh_image(ball(48, 20.0), size=0.5)
        stop.set()
        thread.join()
        self.assertGreater(len(counted), 3)


class Images(unittest.TestCase):
    def test_labels(self):
        voxels = ball().astype(np.int16)
        voxels[12:] *= 7
        mesh = certet.mesh_image(voxels)
        self.assertEqual(set(np.unique(mesh.labels)), {1, 7})
        self.assertAlmostEqual(volumes(mesh).sum(), (voxels > 0).sum(), delta=0.1 * voxels.astype(bool).sum())
        # Label 7 is where the first index is great.
        centres = mesh.points[mesh.tets].mean(1)
        self.assertGreater(centres[mesh.labels == 7][:, 0].mean(), 14)
        self.assertLess(centres[mesh.labels == 1][:, 0].mean(), 9)

    def test_smooth(self):
        """Smooth by default; flat faces have three directions only."""
        def flat_share(**options):
            mesh = certet.mesh_image(ball(), **options)
            inner = np.sort(np.concatenate([mesh.tets[:, [b for b in range(4) if b != a]]
                                            for a in range(4)]), 1)
            faces, count = np.unique(inner, axis=0, return_counts=True)
            p = mesh.points[faces[count == 1]]
            normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
            normals /= np.linalg.norm(normals, axis=1)[:, None]
            return (np.abs(normals).max(1) > 0.999).mean()
        self.assertGreater(flat_share(smooth=0), 0.3)
        self.assertLess(flat_share(), 0.1)
        self.assertLess(flat_share(smooth=1.5), 0.1)
        self.assertEqual(flat_share(method="angles"), flat_share(method="angles", smooth=0))
        checksums = {certet.mesh_image(ball(), smooth=s).checksum for s in (None, 0, 0.7, 1.5)}
        self.assertEqual(len(checksums), 4)

    def test_pieces(self):
        voxels = np.zeros((20, 12, 12), np.int16)
        voxels[2:6, 2:10, 2:10], voxels[6:9, 2:10, 2:10], voxels[13:17, 5:8, 5:8] = 3, 4, 4
        pieces = certet.mesh_image(voxels).pieces()
        self.assertEqual((pieces.by_faces, pieces.by_vertices), (2, 2))
        self.assertEqual(pieces.regions, {3: (1, 1), 4: (2, 2)})
        self.assertEqual((pieces.nonmanifold_edges, pieces.nonmanifold_vertices), (0, 0))
        self.assertEqual(pieces.vertex_places.shape, (0, 3))
        self.assertGreater(pieces.largest_tets, 1000)

    def test_chosen_labels(self):
        voxels = ball().astype(np.int64)
        voxels[12:] *= 7
        one = certet.mesh_image(voxels, labels=[1])
        self.assertEqual(set(np.unique(one.labels)), {1})
        both = certet.mesh_image(voxels, labels=[(1, 7)])
        self.assertEqual(set(np.unique(both.labels)), {1, 7})

    def test_place(self):
        turned = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        mesh = certet.mesh_image(ball(), spacing=(1, 2, 3), origin=(10, 20, 30), direction=turned)
        middle = np.array((10, 20, 30)) + turned @ (np.array((1, 2, 3)) * 11.5)
        np.testing.assert_allclose((mesh.points.min(0) + mesh.points.max(0)) / 2, middle, atol=0.5)
        self.assertTrue((volumes(mesh) > 0).all())

    def test_left_handed(self):
        mesh = certet.mesh_image(ball(), direction=np.diag((1, 1, -1)))
        self.assertTrue((volumes(mesh) > 0).all())
        self.assertLess(mesh.points[:, 2].max(), 1)

    def test_order_of_memory_does_not_matter(self):
        voxels = ball()
        voxels[:4] = 0
        meshes = [certet.mesh_image(a) for a in (voxels, np.asfortranarray(voxels), voxels[::-1][::-1])]
        self.assertEqual(len({m.checksum for m in meshes}), 1)

    def test_level(self):
        grid = np.indices((20, 20, 20)) - 9.5
        distance = np.sqrt((grid**2).sum(0))
        mesh = certet.mesh_image(-distance, iso=-6.0)
        self.assertAlmostEqual(volumes(mesh).sum(), 4 / 3 * np.pi * 216, delta=20)
        self.assertIsNone(mesh.labels)

    def test_midpoint(self):
        quality = certet.mesh_image(ball(), cuts="midpoint").quality()
        self.assertEqual(quality.theorem, "MidpointBounds")
        self.assertGreaterEqual(quality.min_dihedral, 30 - 1e-6)

    def test_methods(self):
        theorems = {"embedded": "SettledBoundsInDegrees", "angles": "DihedralBounds", "embedding": "DihedralBoundsEmbedding",
                    "midpoint": "MidpointBounds", "key": "CertifiedKeySweptMesh"}
        for method, theorem in theorems.items():
            mesh = certet.mesh_function(lambda p: (p**2).sum(1) - 1, ((-1.5,) * 3, (1.5,) * 3),
                                        0.25, method=method)
            self.assertEqual((mesh.method, mesh.guarantee), (method, method))
            self.assertEqual(mesh.quality().theorem, theorem)
        older = certet.mesh_image(ball(), cuts="midpoint")
        self.assertEqual(older.method, "midpoint")
        self.assertEqual(older.checksum, certet.mesh_image(ball(), method="midpoint").checksum)
        self.assertEqual(certet.mesh_image(ball(), guarantee="embedding").method, "embedding")

    def test_diagonals_that_follow_the_cuts(self):
        def level(p):
            return np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1, p[:, 2]) - 0.4
        bounds = ((-1.5, -1.5, -0.5), (1.5, 1.5, 0.5))
        key = certet.mesh_function(level, bounds, 0.1, method="key")
        self.assertEqual(key.checksum, certet.mesh_function(level, bounds, 0.1, method="key",
                                                            threads=1).checksum)
        self.assertEqual(key.checksum, certet.mesh_function(level, bounds, 0.1).checksum)
        self.assertNotEqual(key.checksum, certet.mesh_function(level, bounds, 0.1,
                                                               method="embedded").checksum)
        quality = key.quality()
        self.assertTrue(quality.holds)
        self.assertGreater(quality.min_dihedral, 11.18)
        self.assertLess(quality.max_dihedral, 157.13)
        self.assertEqual(key.warp.shortened, 0)
        two = ball().astype(np.uint8)
        two[: len(two) // 2] *= 2
        parted = certet.mesh_image(two, method="key")
        self.assertEqual(parted.method, "embedded")
        self.assertEqual(parted.checksum, certet.mesh_image(two).checksum)
        self.assertEqual(parted.checksum, certet.mesh_image(two, method="embedded").checksum)

    def test_far_from_the_origin(self):
        """Bounds that are attained are crossed by rounding alone, which is no fault; what
        doubles cannot hold is one."""
        def quality(origin, voxel):
            return certet.mesh_image(ball(), cuts="midpoint", smooth=0, spacing=(voxel,) * 3,
                                     origin=(origin,) * 3).quality()
        rounded = quality(1e6, 0.01)
        self.assertLess(rounded.min_dihedral, 30 - 1e-6)
        self.assertTrue(rounded.holds)
        self.assertFalse(quality(1e12, 0.01).holds)
        self.assertFalse(quality(1e16, 1).holds)

    def test_refusals(self):
        for arguments, sentence in [
            (dict(array=np.zeros((4, 4))), "2 dimensions"),
            (dict(array=np.zeros((4, 4, 0), np.uint8)), "no voxels"),
            (dict(array=np.zeros((4, 4, 4), complex)), "complex"),
            (dict(array=ball() * 0.5), "not whole numbers"),
            (dict(array=np.zeros((4, 4, 4), np.uint8)), "other than 0"),
            (dict(array=ball(), spacing=(1, 0, 1)), "spacing"),
            (dict(array=ball(), direction=np.ones((3, 3))), "orthonormal"),
            (dict(array=ball(), size=-1), "positive"),
            (dict(array=ball(), margin=0), "margin"),
            (dict(array=ball(), labels=[1], iso=1), "exclude"),
            (dict(array=ball(), labels=[]), "empty"),
            (dict(array=ball(), smooth=1, iso=1), "exclude"),
            (dict(array=ball(), smooth=-1), "positive"),
            (dict(array=ball(), smooth=5), "4 voxels"),
            (dict(array=ball(), smooth=1, method="angles"), "cut labels apart"),
            (dict(array=ball(), cuts="middle"), "'midpoint'"),
            (dict(array=ball(), method="paper"), "embedded, angles, embedding, midpoint, key"),
            (dict(array=ball(), method="embedded", cuts="midpoint"), "one or the others"),
            (dict(array=np.full((4, 4, 4), 2**40)), "32 bits"),
        ]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                certet.mesh_image(**arguments)
        with self.assertRaises(MemoryError):
            certet.mesh_image(ball(), size=1e-6)


class Files(unittest.TestCase):
    def test_every_kind_of_shape_to_a_file_and_back(self):
        cube = Surfaces.points, Surfaces.triangles
        shapes = [(ball(), dict(method="midpoint")), (cube, dict(size=0.25)),
                  (lambda p: (p**2).sum(1) - 1, dict(bounds=((-2, -2, 0), (2, 2, 2)), size=0.25))]
        for shape, options in shapes:
            mesh = certet.mesh(shape, **options)
            self.assertEqual(certet.check(mesh).failures, [])
            for back in read_back(self, mesh, ("a.vtu", "a.mesh", "a.meshb", "a.msh")):
                np.testing.assert_array_equal(back.points, mesh.points)
                np.testing.assert_array_equal(back.tets, mesh.tets)
                if mesh.labels is not None:
                    np.testing.assert_array_equal(back.labels, mesh.labels)
                report = certet.check(back)
                self.assertEqual((report.failures, report.tets), ([], len(mesh.tets)))
                found = certet.quality(back)
                self.assertAlmostEqual(found.min_dihedral, certet.quality(mesh).min_dihedral)
                self.assertIsNone(found.theorem)

    def test_refusals(self):
        mesh = certet.mesh(ball())
        with tempfile.TemporaryDirectory() as folder:
            for words, action in [
                    ("a.xyz", lambda: certet.write(mesh, f"{folder}/a.xyz")),
                    ("none of", lambda: certet.write(mesh, f"{folder}/a.vtu", "xyz")),
                    ("cannot", lambda: certet.write(mesh, f"{folder}/none/a.vtu")),
                    ("none.vtu", lambda: certet.read(f"{folder}/none.vtu"))]:
                with self.assertRaisesRegex(ValueError, words):
                    action()
            self.assertEqual(os.listdir(folder), [])


class Surfaces(unittest.TestCase):
    points = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    triangles = np.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
                          [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]])

    def test_cube(self):
        mesh = certet.mesh_surface(self.points, self.triangles, size=0.125)
        self.assertAlmostEqual(volumes(mesh).sum(), 1, delta=0.05)
        self.assertTrue(mesh.quality().holds)

    def test_repair(self):
        self.assertEqual(certet.mesh_surface(self.points, self.triangles, size=0.125).notes, [])
        repeated = np.concatenate([self.triangles, self.triangles[:3]])
        mesh = certet.mesh_surface(self.points, repeated, size=0.125)
        self.assertRegex(mesh.notes[0], "3 triangles")
        noise = np.random.default_rng(1).uniform(-1e-6, 1e-6, (36, 3))
        soup = self.points[self.triangles.ravel()] + noise
        mesh = certet.mesh_surface(soup, np.arange(36).reshape(12, 3), size=0.125)
        self.assertRegex(mesh.notes[0], "welded")
        self.assertAlmostEqual(mesh.quality().volume, 1, delta=1e-5)
        mesh = certet.mesh_surface(self.points, self.triangles[1:], size=0.125, repair=True)
        self.assertRegex(mesh.notes[0], "1 hole")
        self.assertAlmostEqual(mesh.quality().volume, 1, delta=1e-9)

    def test_default_size_follows_thin_parts(self):
        mesh = certet.mesh_surface(self.points * (1, 1, 0.04), self.triangles)
        self.assertAlmostEqual(mesh.size, 0.01, delta=1e-6)

    def test_pieces_that_the_lattice_does_not_find_are_told(self):
        """At the line that called, with a size that keeps them."""
        points = np.concatenate([self.points, self.points * 0.05 + 1.33])
        triangles = np.concatenate([self.triangles, self.triangles + len(self.points)])
        for call in (certet.mesh_surface, lambda *a, **k: certet.mesh(a, **k)):
            with self.assertWarnsRegex(certet.LossWarning, "1 piece, and the shape 2; size=") as told:
                mesh = call(points, triangles, size=0.25)
            self.assertEqual(pathlib.Path(told.filename).name, "package_test.py")
            self.assertIn(str(told.warning), mesh.losses)
        size = float(re.search("size=([0-9.e-]+)", mesh.losses[0])[1])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(certet.mesh_surface(points, triangles, size=size).pieces().by_faces, 2)

    def test_refusals(self):
        for triangles, sentence in [(self.triangles[1:], "1 hole.*repair=True"), (self.triangles + 5, "point"),
                                    (self.triangles[:, :2], "shape")]:
            with self.subTest(sentence), self.assertRaisesRegex(ValueError, sentence):
                certet.mesh_surface(self.points, triangles)


class Arrays(unittest.TestCase):
    def test_they_share_memory_and_keep_it_alive(self):
        mesh = certet.mesh_function(torus, BOX, 0.2)
        points, tets, positions = mesh.points, mesh.tets, mesh.positions
        self.assertTrue(np.shares_memory(points, mesh.points))
        self.assertFalse(points.flags.owndata)
        copies = points.copy(), tets.copy(), positions.copy()
        del mesh
        gc.collect()
        for array, copy in zip((points, tets, positions), copies):
            np.testing.assert_array_equal(array, copy)

    def test_exact_positions(self):
        mesh = certet.mesh_function(torus, BOX, 0.2)
        world = mesh.origin + mesh.size / 2**17 * mesh.positions @ mesh.axes.T
        np.testing.assert_allclose(mesh.points, world, atol=1e-12)

    def test_meshio(self):
        mesh = certet.mesh_image(ball())
        other = mesh.to_meshio()
        self.assertEqual(len(other.cells[0].data), len(mesh.tets))
        np.testing.assert_array_equal(other.cell_data["label"][0], mesh.labels)

    def test_a_planted_bug_is_seen(self):
        mesh = certet.mesh_function(torus, BOX, 0.2)
        turned = mesh.tets.copy()
        turned[0, [0, 1]] = turned[0, [1, 0]]
        p = mesh.points[turned]
        self.assertFalse((np.linalg.det(p[:, 1:] - p[:, :1]) > 0).all())


class Examples(unittest.TestCase):
    def test_they_run(self):
        for script in pathlib.Path(os.environ["CERTET_EXAMPLES"]).glob("python/*.py"):
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([sys.executable, script], cwd=folder, capture_output=True,
                                      text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("tetrahedra", done.stdout)


if __name__ == "__main__":
    unittest.main()
