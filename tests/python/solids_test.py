"""Solids, what is made of two of them, and which points are inside."""

import unittest

import certet
import numpy as np

BALL = 4 / 3 * np.pi


def cube(low, high):
    """Points and triangles of a box, anticlockwise seen from outside."""
    corners = np.array([[(low, high)[n >> a & 1][a] for a in range(3)] for n in range(8)], float)
    quads = np.array([(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1),
                      (4, 5, 7, 6)])
    return corners, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def ball_function(points):
    return np.linalg.norm(points, axis=1) - 1


UNIT = ((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1))


def scan(radius=7.0):
    """A ball of two labels in 20 x 20 x 20 voxels, whose centre is the origin; its options."""
    at = np.indices((20, 20, 20)) - 9.5
    labels = np.where((at**2).sum(0) > radius**2, 0, np.where(at[0] < 0, 2, 5)).astype(np.uint8)
    return labels, {"origin": (-9.5, -9.5, -9.5)}


class Operators(unittest.TestCase):
    def setUp(self):
        self.ball = certet.Solid(ball_function, bounds=UNIT)
        self.corner = certet.Solid(cube((0, 0, 0), (2, 2, 2)))

    def volume(self, solid):
        mesh = certet.mesh(solid, size=0.06)
        self.assertTrue(mesh.quality().holds)
        return mesh.quality().volume

    def test_volumes(self):
        for solid, volume in ((self.ball & self.corner, BALL / 8),
                              (self.ball | self.corner, 8 + 7 / 8 * BALL),
                              (self.ball - self.corner, 7 / 8 * BALL),
                              (self.corner - self.ball, 8 - BALL / 8)):
            self.assertAlmostEqual(self.volume(solid), volume, delta=0.02 * volume)

    def test_every_kind_of_ball(self):
        for solid in (certet.Solid("sphere:1"), certet.Solid("x^2+y^2+z^2-1", bounds=UNIT),
                      self.ball):
            self.assertAlmostEqual(self.volume(solid - certet.Solid("cylinder:0.5,4")),
                                   BALL * 0.75**1.5, delta=0.04)

    def test_labels_stay_apart(self):
        array, options = scan()
        seg, hole = certet.Solid(array, **options), certet.Solid("sphere:4")
        mesh = certet.mesh(seg - hole)
        self.assertEqual(set(mesh.labels), {2, 5})
        self.assertEqual(mesh.size, 1)
        self.assertAlmostEqual(mesh.quality().volume, np.count_nonzero(array) - BALL * 64,
                               delta=15)
        self.assertIsNone(certet.mesh(seg | hole).labels)
        gray = certet.Solid(np.where(array > 0, 100.0, 0.0), iso=50, **options)
        self.assertAlmostEqual(certet.mesh(gray & hole).quality().volume, BALL * 64, delta=6)
        flat = certet.Solid(array, smooth=0, labels=2, **options)
        self.assertEqual(set(certet.mesh(flat).labels), {2})

    def test_an_image_alone_is_as_mesh_image_has_it(self):
        array, options = scan()
        self.assertEqual(certet.mesh(certet.Solid(array, **options)).checksum,
                         certet.mesh(array, **options).checksum)

    def test_bounds_and_notes(self):
        np.testing.assert_array_equal((self.ball & self.corner).bounds, [[0, 0, 0], [1.1] * 3])
        points, triangles = cube((0, 0, 0), (1, 1, 1))
        with self.assertRaisesRegex(ValueError, "repair=True"):
            certet.Solid((points, triangles[:-1]))
        solid = certet.Solid((points, triangles[:-1]), repair=True)
        self.assertEqual(len((solid - self.ball).notes), len(solid.notes))
        self.assertEqual(certet.mesh(solid, size=0.2).notes, solid.notes)

    def test_refusals(self):
        for make, words in ((lambda: certet.Solid(ball_function), "needs bounds"),
                            (lambda: certet.Solid("x^2-1"), "needs bounds"),
                            (lambda: certet.Solid("sphere:-1"), "sphere"),
                            (lambda: self.ball & certet.Solid(cube((5, 5, 5), (6, 6, 6))),
                             "no place in common"),
                            (lambda: certet.Solid(np.ones((3, 3, 3)), iso=0.5, smooth=1), "iso")):
            with self.assertRaisesRegex(ValueError, words):
                make()
        with self.assertRaises(TypeError):
            self.ball - cube((0, 0, 0), (1, 1, 1))


class Inside(unittest.TestCase):
    def test_against_the_definition(self):
        points = np.random.default_rng(7).uniform(-1.5, 1.5, (20000, 3))
        radii = np.linalg.norm(points, axis=1)
        clear = abs(radii - 1) > 1e-6
        for solid in (certet.Solid("sphere:1"), certet.Solid(ball_function, bounds=UNIT)):
            found = certet.inside(solid, points)
            self.assertEqual(found.dtype, bool)
            np.testing.assert_array_equal(found[clear], (radii < 1)[clear])
        box = cube((-1, -0.5, 0), (0.5, 1, 1.25))
        expected = ((points > [-1, -0.5, 0]) & (points < [0.5, 1, 1.25])).all(1)
        np.testing.assert_array_equal(certet.inside(box, points), expected)
        # A box a little larger would not go unnoticed.
        self.assertTrue((certet.inside(cube((-1, -0.5, 0), (0.51, 1, 1.25)), points)
                         != expected).any())

    def test_shapes_of_arrays(self):
        solid = certet.Solid("sphere:1")
        self.assertEqual(certet.inside(solid, (0, 0, 0)).shape, ())
        self.assertTrue(certet.inside(solid, (0, 0, 0)))
        grid = certet.inside(solid, np.zeros((4, 5, 3)) + [0, 0, 2])
        self.assertEqual(grid.shape, (4, 5))
        self.assertFalse(grid.any())
        self.assertEqual(certet.inside(solid, np.zeros((0, 3))).shape, (0,))
        self.assertFalse(certet.inside(solid, (np.nan, 0, np.inf)))
        self.assertTrue(certet.inside(solid, (1, 0, 0)))
        with self.assertRaisesRegex(ValueError, r"\(\.\.\., 3\)"):
            certet.inside(solid, np.zeros((3, 2)))

    def test_voxels(self):
        array, options = scan()
        solid = certet.Solid(array, smooth=0, **options)
        at = (np.indices(array.shape).reshape(3, -1).T - 9.5) + 0.3
        np.testing.assert_array_equal(certet.inside(solid, at), array.reshape(-1) != 0)


class Materials(unittest.TestCase):
    def volumes(self, mesh):
        corners = mesh.points[mesh.tets]
        each = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        return {mesh.names.get(label, label): each[mesh.labels == label].sum()
                for label in np.unique(mesh.labels)}

    def test_labels_and_a_ball_by_priority(self):
        array, options = scan()
        seg, ball = certet.Solid(array, **options), certet.Solid("sphere:4")
        mesh = certet.mesh({"seg": seg, "ball": ball}, keep_labels=["seg"])
        found = self.volumes(mesh)
        self.assertEqual(set(mesh.labels), {2, 5, 6})
        self.assertAlmostEqual(found["ball"], BALL * 64, delta=6)
        self.assertAlmostEqual(found[2] + found[5], np.count_nonzero(array) - BALL * 64,
                               delta=20)
        found = self.volumes(certet.mesh({"seg": seg, "ball": ball}, priority=["seg"]))
        self.assertEqual(set(found), {"seg"})
        with self.assertRaisesRegex(ValueError, "'bone', which is no solid"):
            certet.mesh({"seg": seg}, keep_labels=["bone"])

    def test_texts_and_parts(self):
        mesh = certet.mesh({"ball": "sphere:1",
                            "half": certet.Solid("sphere:0.5") & certet.Solid("box:2,2,0.5")},
                           size=0.05)
        found = self.volumes(mesh)
        self.assertAlmostEqual(sum(found.values()), BALL, delta=0.05)
        self.assertAlmostEqual(found["half"], np.pi * (0.125 - 0.25**3 * 2 / 3), delta=0.02)

    def test_threads_do_not_matter(self):
        array, options = scan()
        solids = {"seg": certet.Solid(array, **options), "ball": "sphere:4"}
        self.assertEqual(*(certet.mesh(solids, threads=n).checksum for n in (1, 2)))


if __name__ == "__main__":
    unittest.main()
