"""Thin parts of images: the mesh keeps their pieces, and a surface that is a manifold."""

import collections
import itertools
import unittest

import images
import vtu
from program import ProgramTest


def pieces(tets, joined):
    """How many; `joined` gives what a tetrahedron has in common with others."""
    parent = list(range(len(tets)))

    def root(n):
        while parent[n] != n:
            parent[n] = parent[parent[n]]
            n = parent[n]
        return n

    first = {}
    for n, tet in enumerate(tets):
        for part in joined(sorted(tet)):
            parent[root(n)] = root(first.setdefault(part, n))
    return len({root(n) for n in range(len(tets))})


def faces(tet):
    return itertools.combinations(tet, 3)


def surface_edges(tets):
    """How many triangles of the surface each of its edges is in."""
    count = collections.Counter(face for tet in tets for face in faces(sorted(tet)))
    return collections.Counter(edge for face, sides in count.items() if sides == 1
                               for edge in itertools.combinations(face, 2))


class Thin(ProgramTest):
    def write(self, size, value, spacing=(1, 1, 1)):
        steps = [tuple(s if a == b else 0 for b in range(3)) for a, s in enumerate(spacing)]
        images.write_nrrd(self.folder / "a.nrrd", size, images.voxels(size, value), "B", steps)

    def assert_pieces(self, count, *options):
        report = self.mesh("a.nrrd", *options, "-o", "a.vtu")
        self.assertTrue(report["guarantee"]["holds"])
        self.assertEqual(report["guarantee"]["min_dihedral"], 10.77)
        tets = vtu.tets(self.folder / "a.vtu")
        self.assertEqual(pieces(tets, faces), count)
        self.assertEqual(pieces(tets, iter), count)
        self.assertEqual(set(surface_edges(tets).values()), {2})
        self.check("a.vtu")
        return report

    def test_lone_voxels(self):
        self.write((14, 14, 14), lambda *at: int(all(a in (3, 7, 11) for a in at)))
        self.assert_pieces(27)
        paper = self.run_certet("mesh", "a.nrrd", "--method", "paper", "-o", "b.vtu")
        self.assertEqual(paper.returncode, 4, paper.stderr)

    def test_vessel(self):
        """One voxel wide, and askew."""
        def vessel(i, j, k):
            at = 5 + k // 4
            return int(2 <= k < 22 and j == 6 and (i == at or (i == at + 1 and k % 4 == 3)))
        for spacing in ((1, 1, 1), (1, 1, 1.1), (1, 1, 1.3), (0.5, 0.5, 0.6), (1, 1.3, 1.3)):
            with self.subTest(spacing):
                self.write((16, 12, 24), vessel, spacing)
                self.assert_pieces(1)

    def test_bar_and_plate(self):
        self.write((8, 8, 36), lambda i, j, k: int(i == 3 and j == 3 and 2 <= k < 34), (1, 1, 1.1))
        self.assert_pieces(1)
        self.write((20, 20, 8), lambda i, j, k: int(k == 3 and 2 <= i < 18 and 2 <= j < 18))
        self.assert_pieces(1)

    def test_flat_walls(self):
        """Not smoothed, a box of voxels has its walls where they are, but for edges and corners."""
        self.write((16, 16, 16), lambda *at: int(all(3 <= a < 13 for a in at)))
        report = self.assert_pieces(1, "--smooth", "0")
        self.assertEqual(report["method"]["stayed"], 0)
        self.assertAlmostEqual(report["mesh"]["volume"], 1000, delta=2)
        walls = collections.Counter(max(abs(c - 7.5) for c in p)
                                    for p in vtu.points(self.folder / "a.vtu"))
        beyond = [far for far in walls if far > 5 + 1e-9]
        self.assertEqual(beyond, [])
        self.assertGreater(sum(n for far, n in walls.items() if abs(far - 5) < 1e-9), 400)


if __name__ == "__main__":
    unittest.main()
