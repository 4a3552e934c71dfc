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


def count_groups(items, neighbours):
    """Of items that are joined to their neighbours, as far as these are items."""
    left, groups = set(items), 0
    while left:
        groups += 1
        reached = [left.pop()]
        while reached:
            found = {n for n in neighbours(reached.pop()) if n in left}
            left -= found
            reached += found
    return groups


def steps(at, reach):
    """The places around one, whose steps along the axes are so many in all."""
    for step in itertools.product((-1, 0, 1), repeat=3):
        if 0 < sum(map(abs, step)) <= reach:
            yield tuple(a + s for a, s in zip(at, step))


def shape_of_voxels(size, inside):
    """Pieces by faces, tunnels, cavities, by the Euler number of what voxels that share faces
    span: points, edges, squares and cubes between their centres."""
    euler = 0
    for at in inside:
        for corner in range(8):
            axes = [a for a in range(3) if corner >> a & 1]
            cell = itertools.product(*[(0, 1) if a in axes else (0,) for a in range(3)])
            if all(tuple(a + s for a, s in zip(at, step)) in inside for step in cell):
                euler += (-1) ** len(axes)
    around = itertools.product(*(range(-1, s + 1) for s in size))
    outside = {at for at in around if at not in inside}
    pieces = count_groups(inside, lambda at: steps(at, 1))
    cavities = count_groups(outside, lambda at: steps(at, 3)) - 1
    return pieces, pieces + cavities - euler, cavities


def shape_of_mesh(tets):
    """The same of a mesh whose surface is a manifold: each piece has one more surface than it
    has cavities."""
    tets = [tuple(sorted(tet)) for tet in tets]
    triangles = collections.Counter(face for tet in tets for face in faces(tet))
    edges = {edge for face in triangles for edge in itertools.combinations(face, 2)}
    euler = len({p for tet in tets for p in tet}) - len(edges) + len(triangles) - len(tets)
    surface = [face for face, sides in triangles.items() if sides == 1]
    along = collections.defaultdict(list)
    for face in surface:
        for edge in itertools.combinations(face, 2):
            along[edge].append(face)
    surfaces = count_groups(surface, lambda face: (
        other for edge in itertools.combinations(face, 2) for other in along[edge]))
    whole = pieces(tets, faces)
    return whole, surfaces - euler, surfaces - whole


def surface_edges(tets):
    """How many triangles of the surface each of its edges is in."""
    count = collections.Counter(face for tet in tets for face in faces(sorted(tet)))
    return collections.Counter(edge for face, sides in count.items() if sides == 1
                               for edge in itertools.combinations(face, 2))


class ThinTest(ProgramTest):
    def write(self, size, value, spacing=(1, 1, 1)):
        steps = [tuple(s if a == b else 0 for b in range(3)) for a, s in enumerate(spacing)]
        images.write_nrrd(self.folder / "a.nrrd", size, images.voxels(size, value), "B", steps)

    def assert_pieces(self, count, *options):
        report = self.mesh("a.nrrd", *options, "-o", "a.vtu")
        self.assertTrue(report["guarantee"]["holds"])
        self.assertEqual(report["guarantee"]["min_dihedral"], 11.18)
        tets = vtu.tets(self.folder / "a.vtu")
        self.assertEqual(pieces(tets, faces), count)
        self.assertEqual(pieces(tets, iter), count)
        self.assertEqual(set(surface_edges(tets).values()), {2})
        self.check("a.vtu")
        return report


class Thin(ThinTest):
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


VOXEL_WALLS = ()  # what asks for surfaces along the walls of voxels: the default
VESSEL = {(4 + k // 4 + (k % 4 == 3 and n), 4, k) for k in range(2, 14) for n in (0, 1)}
BARS = {(2, 2, k) for k in range(1, 11)} | {(i, 6, 6) for i in range(1, 9)}
SHELL = {at for at in itertools.product(range(10), repeat=3)
         if 2.4 <= sum((a - 4.5) ** 2 for a in at) ** 0.5 < 4.5}
PORES = set(itertools.product(range(1, 8), repeat=3)) - {
    (2, 2, 2), (4, 4, 4), (6, 4, 2), (6, 4, 3), (3, 6, 1), (3, 6, 2), (5, 1, 6), (5, 2, 6)}
TUNNELS = set(itertools.product(range(1, 7), repeat=3)) - {
    (3, 3, k) for k in range(1, 7)} - {(i, 5, 2) for i in range(1, 7)}


class Shapes(ThinTest):
    """Pieces, tunnels and cavities of thin voxels, and of their meshes, counted anew."""

    def assert_shape(self, inside, expected):
        size = tuple(max(at[a] for at in inside) + 2 for a in range(3))
        self.assertEqual(shape_of_voxels(size, inside), expected)
        for spacing in ((1, 1, 1), (1, 1, 1.1), (1, 1.15, 1.2), (1, 1.3, 1.3), (0.5, 0.5, 0.6)):
            with self.subTest(spacing):
                self.write(size, lambda *at: int(at in inside), spacing)
                report = self.mesh("a.nrrd", *VOXEL_WALLS, "-o", "a.vtu")
                self.assertEqual(report["guarantee"]["min_dihedral"], 11.18)
                tets = vtu.tets(self.folder / "a.vtu")
                self.assertEqual(set(surface_edges(tets).values()), {2})
                self.assertEqual(shape_of_mesh(tets), expected)
                self.assertEqual([w for w in report["warnings"] if "pieces" in w], [])

    def test_vessel(self):
        self.assert_shape(VESSEL, (1, 0, 0))

    def test_bars(self):
        self.assert_shape(BARS, (2, 0, 0))

    def test_lone_voxels(self):
        self.assert_shape(set(itertools.product((1, 4), repeat=3)), (8, 0, 0))

    def test_shell_of_two_voxels(self):
        self.assert_shape(SHELL, (1, 0, 1))

    def test_pores(self):
        """Some inside, some open to the outside, each of one voxel or two."""
        self.assert_shape(PORES, (1, 0, 3))

    def test_tunnels(self):
        self.assert_shape(TUNNELS, (1, 2, 0))

    def test_a_lump_has_its_volume(self):
        """Within a hundredth, at the size of the voxels."""
        def lump(*at):
            x, y, z = ((a - 10) / 7 for a in at)
            return int(x * x + y * y + z * z + 0.3 * x * y * z + 0.4 * x * y < 1)
        for spacing in ((1, 1, 1), (1, 1, 1.2)):
            self.write((21, 21, 21), lump, spacing)
            report = self.mesh("a.nrrd", *VOXEL_WALLS, "-o", "a.vtu")
            region, = report["regions"]
            self.assertAlmostEqual(region["volume"], region["voxel_volume"],
                                   delta=0.01 * region["voxel_volume"])


if __name__ == "__main__":
    unittest.main()
