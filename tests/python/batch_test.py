"""How many points a function is called with."""

import unittest

import numpy as np

import certet

BOX = ((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1))


class Ball:
    """Remembers the sizes of its calls."""

    def __init__(self, middle=(0.0, 0.0, 0.0)):
        self.middle, self.sizes = np.asarray(middle), []

    def __call__(self, points):
        self.sizes.append(len(points))
        return ((points - self.middle) ** 2).sum(1) - 1


def ball(batch=None, **options):
    function = Ball()
    mesh = certet.mesh_function(function, BOX, 0.1, **({} if batch is None else {"batch": batch}),
                                **options)
    return function.sizes, mesh.checksum


class Batches(unittest.TestCase):
    def test_are_no_larger_than_asked_for(self):
        for batch in (7, 256, 1000, 100_000):
            sizes, _ = ball(batch)
            self.assertLessEqual(max(sizes), batch)

    def test_make_no_difference_to_the_mesh(self):
        expected = ball()[1]
        for batch in (1, 256, 257, 1000, 5000):
            for threads in (1, 2):
                with self.subTest(batch=batch, threads=threads):
                    self.assertEqual(ball(batch, threads=threads)[1], expected)

    def test_are_large_by_default(self):
        few, _ = ball()
        many, _ = ball(256)
        self.assertLess(len(few), len(many) / 5)
        self.assertGreater(sum(few) / len(few), 5 * sum(many) / len(many))

    def test_reach_solids_and_their_combinations(self):
        one, other = Ball(), Ball((0.5, 0, 0))
        solid = (certet.Solid(one, bounds=BOX)
                 - certet.Solid(other, bounds=((-0.6, -1.1, -1.1), (1.6, 1.1, 1.1)), batch=256))
        first = certet.mesh(solid, size=0.1)
        self.assertGreater(max(one.sizes), 1000)
        self.assertEqual(max(other.sizes), 256)  # what is asked of both is more
        again = certet.mesh(certet.Solid(Ball(), bounds=BOX, batch=256)
                            - certet.Solid(Ball((0.5, 0, 0)), batch=256,
                                           bounds=((-0.6, -1.1, -1.1), (1.6, 1.1, 1.1))), size=0.1)
        self.assertEqual(first.checksum, again.checksum)

    def test_are_whole_and_positive(self):
        for batch in (0, -1, 1.5, "many"):
            with self.subTest(batch=batch), self.assertRaisesRegex(ValueError, "batch is a"):
                ball(batch)


if __name__ == "__main__":
    unittest.main()
