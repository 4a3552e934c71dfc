"""Pieces of the mesh: counted, dropped, and small ones that stay."""

import unittest
from itertools import product

import vtu
from images import voxels, write_nrrd
from program import ProgramTest

USAGE, EMPTY = 2, 4


def pieces(path, corners):
    """How many tetrahedra each piece has, joined by so many corners; by brute force, growing."""
    parent, shared = [], {}

    def find(n):
        while parent[n] != n:
            n = parent[n]
        return n

    for n, tet in enumerate(vtu.tets(path)):
        parent.append(n)
        for out in range(4):
            share = frozenset(tet[:out] + tet[out + 1:]) if corners == 3 else tet[out]
            if share in shared:
                parent[find(n)] = find(shared[share])
            shared[share] = n
    roots = [find(n) for n in range(len(parent))]
    return sorted(roots.count(root) for root in set(roots))


class PiecesTest(ProgramTest):
    def write(self, value, size, **settings):
        write_nrrd(self.folder / "a.nrrd", size, voxels(size, value), **settings)

    def same_pieces(self, report, file="a.vtu"):
        """Of the run, of `check` and of the file itself."""
        by_faces, by_vertices = pieces(self.folder / file, 3), pieces(self.folder / file, 1)
        expected = {"by_faces": len(by_faces), "by_vertices": len(by_vertices),
                    "largest_tets": by_faces[-1]}
        self.assertEqual(report["mesh"]["pieces"], expected)
        checked = self.check(file)
        self.assertEqual(checked["mesh"]["pieces"], expected)
        self.assertEqual({key: checked["mesh"]["nonmanifold"][key] for key in ("edges", "vertices")},
                         {key: report["mesh"]["nonmanifold"][key] for key in ("edges", "vertices")})
        if "regions" in checked and all("pieces_by_vertices" in r for r in report["regions"]):
            of_labels = {r["label"]: (r["pieces"], r["pieces_by_vertices"])
                         for r in checked["regions"]}
            told = {r["label"]: (r["pieces"], r["pieces_by_vertices"]) for r in report["regions"]
                    if r["tets"] > 0}
            self.assertEqual(told, of_labels)
        return expected


def steps(i, j, k):
    """A block, a rod along x, and a dot."""
    if 3 <= i < 9 and 3 <= j < 9 and 3 <= k < 9:
        return 5
    if 1 <= i < 15 and j == 12 and k == 12:
        return 6
    return 7 if (i, j, k) == (13, 3, 13) else 0


class Counted(PiecesTest):
    def test_lone_voxels_mesh(self):
        """Each makes a piece, at spacings that are not the size, too."""
        dots = set(product((2, 6, 10), repeat=3))
        for spacing in ((1, 1, 1), (1, 1, 1.1), (1, 1.3, 1.3), (0.5, 0.5, 0.6)):
            directions = tuple(tuple(s if a == b else 0 for b in range(3)) for a, s in enumerate(spacing))
            self.write(lambda i, j, k: int((i, j, k) in dots), (13, 13, 13), directions=directions)
            with self.subTest(spacing):
                report = self.mesh("a.nrrd", "-o", "a.vtu")
                self.assertEqual(self.same_pieces(report)["by_faces"], 27)
                self.assertEqual([w for w in report["warnings"] if "volume" not in w], [])

    def test_of_every_domain(self):
        for words in (("--shape", "sphere:1", "--size", "0.2"),
                      ("--expr", "min(sqrt((x-1)^2+y^2+z^2),sqrt((x+1)^2+y^2+z^2))-0.5",
                       "--bounds=-2,-1,-1,2,1,1", "--size", "0.15")):
            self.same_pieces(self.mesh(*words, "-o", "a.vtu"))
        self.write(steps, (16, 16, 16))
        report = self.mesh("a.nrrd", "--label-pieces", "-o", "a.vtu")
        self.assertEqual(self.same_pieces(report)["by_faces"], 3)
        self.assertEqual([(r["pieces"], r["pieces_by_vertices"]) for r in report["regions"]],
                         3 * [(1, 1)])
        self.assertEqual(self.same_pieces(self.mesh("a.nrrd", "--iso", "1", "-o", "a.vtu"))["by_faces"], 3)

    def test_faults_of_the_surface_are_placed(self):
        """Two blocks that share an edge, cut in the middle."""
        self.write(lambda i, j, k: int((2 <= i < 5 and 2 <= j < 5 or 5 <= i < 8 and 5 <= j < 8) and 2 <= k < 6),
                   (10, 10, 8))
        report = self.mesh("a.nrrd", "-o", "a.vtu")
        self.assertEqual(report["mesh"]["nonmanifold"],
                         {"edges": 0, "vertices": 0, "edge_places": [], "vertex_places": []})
        self.same_pieces(report)
        report = self.mesh("a.nrrd", "--method", "paper", "-o", "a.vtu")
        self.same_pieces(report)
        faults = report["mesh"]["nonmanifold"]
        self.assertEqual(len(faults["vertex_places"]), min(8, faults["vertices"]))
        self.assertEqual(len(faults["edge_places"]), min(8, faults["edges"]))
        self.assertGreater(faults["edges"], 0)
        for x, y, _ in faults["edge_places"] + faults["vertex_places"]:
            self.assertLess(max(abs(x - 4.5), abs(y - 4.5)), 0.5)


class Keep(PiecesTest):
    def test_drops_and_says_so(self):
        self.write(steps, (16, 16, 16))
        whole = self.mesh("a.nrrd", "-o", "whole.vtu")
        sizes = pieces(self.folder / "whole.vtu", 3)
        for rule, stay in (("largest", sizes[2:]), ("2", sizes[1:]), ("9", sizes), ("percolating:x", sizes[1:2])):
            with self.subTest(rule):
                report = self.mesh("a.nrrd", "--keep", rule, "-o", "a.vtu")
                self.assertEqual(pieces(self.folder / "a.vtu", 3), stay)
                self.same_pieces(report)
                dropped = report["dropped"]
                self.assertEqual((dropped["keep"], dropped["pieces"], dropped["kept"], dropped["tets"]),
                                 (rule, 3 - len(stay), len(stay), sum(sizes) - sum(stay)))
                self.assertAlmostEqual(dropped["volume"] + report["mesh"]["volume"],
                                       whole["mesh"]["volume"])
                self.assertEqual([w for w in report["warnings"] if "volume" not in w and "dropped" not in w], [])

    def test_same_bytes_for_every_thread_count(self):
        self.write(steps, (16, 16, 16))
        found = set()
        for threads in ("1", "2", "3"):
            self.mesh("a.nrrd", "--keep", "2", "--threads", threads, "-o", "a.vtu")
            found.add((self.folder / "a.vtu").read_bytes())
        self.assertEqual(len(found), 1)

    def test_nothing_that_goes_through(self):
        self.write(lambda i, j, k: int((i, j, k) in ((2, 2, 2), (2, 2, 9))), (5, 5, 12))
        self.assert_fails(EMPTY, ["2 pieces", "percolating:z"], "mesh", "a.nrrd", "--keep",
                          "percolating:z", "-o", "a.vtu")
        self.assertEqual(self.files(), ["a.nrrd"])

    def test_refused(self):
        self.write(steps, (16, 16, 16))
        for value in ("0", "-1", "most", "percolating", "percolating:w", "percolating:xy", "2.5"):
            self.assert_fails(USAGE, ["--keep"], "mesh", "a.nrrd", "--keep=" + value, "-o", "a.vtu")


class Level(PiecesTest):
    def test_a_size_that_keeps_the_pieces_is_found(self):
        """Two plates of gray joined by a neck of one voxel; the size was tried."""
        def plates(i, j, k):
            if 2 <= i < 12 and 2 <= j < 12 and (k in range(2, 6) or k in range(10, 14)):
                return 100
            return 100 * int((i, j) == (7, 7) and 6 <= k < 10)

        self.write(plates, (14, 14, 16), origin=(3, -5, 7))
        report = self.mesh("a.nrrd", "--iso", "50", "--size", "3.1", "-o", "a.vtu")
        told = [w for w in report["warnings"] if "the solid has 2 pieces" in w]
        size = told[0].split("--size ")[1].split()[0]
        report = self.mesh("a.nrrd", "--iso", "50", "--size", size, "-o", "a.vtu")
        self.assertEqual(self.same_pieces(report)["by_faces"], 1)
        self.assertEqual([w for w in report["warnings"] if "pieces" in w], [])


if __name__ == "__main__":
    unittest.main()
