"""What users pass to the Python package: taken for what it means, or refused in words."""

import pathlib
import tempfile
import unittest
import warnings

import certet
import numpy as np

SQUARE = ((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1))


def ball(points):
    return (points**2).sum(1) - 1


def block(n=10, low=2, high=8):
    voxels = np.zeros((n, n, n), np.int16)
    voxels[low:high, low:high, low:high] = 1
    return voxels


def volume(mesh):
    return mesh.quality().volume


class Warned(unittest.TestCase):
    def told(self, make):
        """What is made, and the sentences that were warned of, which point to this file; but for
        those on volume and pieces."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            warnings.simplefilter("ignore", certet.LossWarning)
            made = make()
        for warning in caught:
            self.assertEqual(pathlib.Path(warning.filename).name, "arguments_test.py")
        return made, [str(w.message) for w in caught]

    def test_lost_labels(self):
        voxels = block(24, 4, 20)
        voxels[2:4, 0:2, 0:2], voxels[0, 10, 12] = 5, 9
        for make in (lambda: certet.mesh_image(voxels, size=6), lambda: certet.mesh(voxels, size=6)):
            mesh, sentences = self.told(make)
            self.assertEqual(set(mesh.labels), {1})
            self.assertEqual(sentences, [
                "label 5 (8 voxels) is not in the mesh; size=0.9995 or less keeps it",
                "label 9 (1 voxels) is not in the mesh; size=0.4998 or less keeps it"])
            self.assertEqual(mesh.warnings, sentences)
        mesh, sentences = self.told(lambda: certet.mesh_image(voxels, size=0.4998))
        self.assertEqual((set(mesh.labels), sentences), ({1, 5, 9}, []))

    def test_labels_that_are_not_there(self):
        for labels, sentences in [([1, 7], ["no voxel of 'array' has label 7"]),
                                  ([1, 7, 8], ["no voxel of 'array' has label 7 or 8"]),
                                  ([(1, 9)], []), ([(1, 9), 3], ["no voxel of 'array' has label 3"])]:
            self.assertEqual(self.told(lambda: certet.mesh_image(block(), labels=labels))[1], sentences)

    def test_gray_values(self):
        noise = np.random.default_rng(1).integers(1, 200, (20, 20, 20))
        sentences = self.told(lambda: certet.mesh_image(noise))[1]
        self.assertRegex(sentences[0], "gray values.*iso=V")

    def test_numbers_of_labels_in_gmsh(self):
        voxels = block()
        voxels[5:] *= -3
        mesh, sentences = self.told(lambda: certet.mesh_image(voxels))
        self.assertEqual(sentences, [])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.msh"
            sentences = self.told(lambda: certet.write(mesh, file))[1]
            self.assertRegex(sentences[0], "label -3 has the number 2;")
            np.testing.assert_array_equal(certet.read(file).labels, mesh.labels)
            self.assertEqual(self.told(lambda: certet.write(mesh, file.with_suffix(".vtu")))[1], [])


class Voxels(unittest.TestCase):
    def test_what_is_masked_is_outside(self):
        voxels = np.ones((6, 7, 5), int)
        mask = np.zeros(voxels.shape, bool)
        mask[3:] = True
        truth = certet.mesh_image(np.where(mask, 0, voxels))
        self.assertAlmostEqual(volume(truth), 105, delta=4)
        for masked in (np.ma.array(voxels, mask=mask), np.ma.array(voxels.astype(float), mask=mask),
                       np.ma.masked_greater(np.where(mask, 2**40, voxels), 1)):
            self.assertEqual(certet.mesh_image(masked).checksum, truth.checksum)
        chosen = certet.mesh_image(np.ma.array(voxels, mask=mask), labels=[(0, 1)])
        self.assertEqual(chosen.checksum, truth.checksum)
        self.assertAlmostEqual(volume(certet.mesh_image(np.ma.array(voxels))), 210, delta=8)

    def test_whole_numbers_of_any_type_are_labels(self):
        truth = certet.mesh_image(block()).checksum
        for kind in ("?", "i1", "u8", "f2", "f4", "f8", "g", ">i2", ">i4", ">f8", "i8"):
            with self.subTest(kind):
                self.assertEqual(certet.mesh_image(block().astype(kind)).checksum, truth)
        self.assertEqual(certet.mesh_image(block().tolist()).checksum, truth)

    def test_gray_values_of_any_type(self):
        gray = 10.0 * block()
        truth = certet.mesh_image(gray, iso=5).checksum
        for kind in ("u1", "i8", "f2", "f4", ">f8", "g"):
            self.assertEqual(certet.mesh_image(gray.astype(kind), iso=np.float32(5)).checksum, truth)
        self.assertEqual(certet.mesh_image(gray.astype("i8") * 2**40, iso=5 * 2**40).checksum, truth)

    def test_levels(self):
        """Between two, and below one: as of the negative."""
        grid = np.indices((20, 20, 20)) - 9.5
        distance = np.sqrt((grid**2).sum(0))
        shell = volume(certet.mesh_image(distance, iso=(4.0, 8.0)))
        self.assertAlmostEqual(shell, 4 / 3 * np.pi * (8**3 - 4**3), delta=0.02 * shell)
        below = certet.mesh_image(distance, iso=(None, 6))
        self.assertEqual(below.checksum, certet.mesh_image(-distance, iso=-6).checksum)
        self.assertEqual(certet.mesh_image(distance, iso=(6, None)).checksum,
                         certet.mesh_image(distance, iso=6).checksum)

    def test_merged_labels(self):
        voxels = block()
        voxels[4:6] *= 2
        voxels[6:] *= 3
        mesh = certet.mesh_image(voxels, merge={(1, 2): "bone", 3: 9})
        truth = certet.mesh_image(np.where(voxels == 3, 9, np.minimum(voxels, 1)))
        self.assertEqual((mesh.checksum, mesh.names), (truth.checksum, {1: "bone"}))
        np.testing.assert_array_equal(mesh.labels, truth.labels)
        swapped = certet.mesh_image(voxels, merge={1: 3, 3: 1}, labels=3)
        self.assertEqual(swapped.checksum, certet.mesh_image(voxels, labels=1).checksum)
        masked = np.ma.array(voxels, mask=voxels == 3)
        self.assertEqual(set(certet.mesh_image(masked, merge={2: 1}).labels), {1})

    def test_one_number_for_all(self):
        mesh = certet.mesh_image(block(), spacing=2.0)
        self.assertEqual(mesh.checksum, certet.mesh_image(block(), spacing=(2, 2, 2)).checksum)
        flat = certet.mesh_image(block(), spacing=2.0, smooth=0)
        self.assertAlmostEqual(volume(flat), 8 * 216, delta=30)
        voxels = block()
        voxels[5:] *= 2
        for labels in (1, np.int8(1), 1.0, [1], (1,), {1}, np.array([1]), [(1, 1)], range(1, 2)):
            self.assertEqual(set(certet.mesh_image(voxels, labels=labels).labels), {1}, labels)


class Functions(unittest.TestCase):
    def test_truth_values_are_true_inside(self):
        truth = certet.mesh_function(ball, SQUARE, 0.2)
        for inside in (lambda p: ball(p) < 0, lambda p: list(map(bool, ball(p) < 0))):
            mesh = certet.mesh_function(inside, SQUARE, 0.2)
            self.assertAlmostEqual(volume(mesh), volume(truth), delta=0.01)

    def test_what_is_masked_is_outside(self):
        half = certet.mesh_function(lambda p: np.where(p[:, 0] > 0, np.nan, ball(p)), SQUARE, 0.2)
        masked = certet.mesh_function(lambda p: np.ma.array(ball(p), mask=p[:, 0] > 0), SQUARE, 0.2)
        self.assertEqual(masked.checksum, half.checksum)

    def test_whole_numbers_will_do(self):
        mesh = certet.mesh_function(lambda p: np.sign(ball(p)).astype(int), SQUARE, 0.2)
        self.assertGreater(volume(mesh), 3.9)

    def test_bounds_as_the_command_has_them(self):
        truth = certet.mesh_function(ball, SQUARE, 0.2).checksum
        for bounds in (SQUARE[0] + SQUARE[1], np.array(SQUARE), list(map(list, SQUARE))):
            self.assertEqual(certet.mesh_function(ball, bounds, 0.2).checksum, truth)


class Refused(unittest.TestCase):
    """A ValueError of one line that says what is wanted."""

    def refused(self, *words, **arguments):
        make = arguments.pop("make")
        with self.subTest(words), self.assertRaises(ValueError) as caught:
            make(**arguments)
        sentence = str(caught.exception)
        self.assertNotRegex(sentence, r"\n|incompatible|unpack|signature|Invoked")
        self.assertLess(len(sentence), 300)
        for word in words:
            self.assertIn(word, sentence)

    def test_images(self):
        masked = np.ma.array(block(), mask=block() == 0)
        huge = np.full((4, 4, 4), 2**64 - 1, np.uint64)
        for words, arguments in [
                (["labels", "(first, last)"], dict(labels="1")), (["whole"], dict(labels=[1.5])),
                (["labels"], dict(labels={1: "bone"})), (["range"], dict(labels=[(5, 2)])),
                (["range"], dict(labels=[(1, 2, 3)])), (["whole"], dict(labels=[None])),
                (["spacing", "three"], dict(spacing=(1, 1))), (["spacing"], dict(spacing="1")),
                (["spacing", "complex"], dict(spacing=1j)), (["spacing"], dict(spacing=None)),
                (["origin", "three"], dict(origin=0.0)), (["direction"], dict(direction=[1, 0, 0])),
                (["iso", "number"], dict(iso="3")), (["iso"], dict(iso=np.nan)),
                (["iso", "(above, below)"], dict(iso=[1, 2])), (["less than"], dict(iso=(2, 1))),
                (["iso"], dict(iso=(None, None))), (["merge", "dict"], dict(merge="1=2")),
                (["whole"], dict(merge={1: 2.5})), (["merged twice"], dict(merge={1: 2, (1, 3): 4})), (["size", "number"], dict(size="1")),
                (["size"], dict(size=(1, 1, 1))), (["margin", "whole"], dict(margin=1.5)),
                (["threads", "whole"], dict(threads="all")), (["method", "word"], dict(method=3)),
                (["masked", "filled"], dict(array=masked, iso=0.5)),
                (["complex"], dict(array=block() + 1j)), (["complex"], dict(array=block() + 1j, iso=1)),
                (["type"], dict(array=block().astype(str))), (["type"], dict(array="scan.nii")),
                (["32 bits", str(2**64 - 1)], dict(array=huge)),
                (["3 voxels", "0.5 at [1, 2, 3]"], dict(array=self.fractions())),
                (["nan"], dict(array=np.full((4, 4, 4), np.nan)))]:
            self.refused(*words, make=certet.mesh_image, **{"array": block(), **arguments})

    @staticmethod
    def fractions():
        voxels = block().astype(float)
        voxels[1, 2, 3] = voxels[4, 4, 4] = voxels[9, 9, 9] = 0.5
        return voxels

    def test_functions(self):
        for words, arguments in [
                (["bounds", "x0"], dict(bounds=1.0)), (["bounds"], dict(bounds=(1, 2, 3))),
                (["bounds"], dict(bounds=((0, 0), (1, 1)))), (["bounds"], dict(bounds="box")),
                (["bounds"], dict(bounds=((0, 0, 0), (1, 1)))),
                (["complex128", "negative inside"], dict(f=lambda p: ball(p) + 0j)),
                (["type"], dict(f=lambda p: None)), (["type"], dict(f=lambda p: ["a"] * len(p))),
                (["function"], dict(f=3))]:
            self.refused(*words, make=certet.mesh_function,
                         **{"f": ball, "bounds": SQUARE, "size": 0.4, **arguments})

    def test_surfaces(self):
        points, triangles = np.eye(4, 3), np.array([[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])
        for words, arguments in [
                (["points", "complex"], dict(points=points + 1j)),
                (["points", "masked"], dict(points=np.ma.array(points, mask=points == 1))),
                (["triangles", "whole"], dict(triangles=triangles + 0.5)),
                (["triangles"], dict(triangles="012")), (["shape"], dict(points=points[:, :2]))]:
            self.refused(*words, make=certet.mesh_surface,
                         **{"points": points, "triangles": triangles, **arguments})
        self.assertGreater(volume(certet.mesh_surface(points, triangles.astype(float), size=0.1)), 0)

    def test_what_is_no_mesh(self):
        for action in (certet.check, certet.quality, lambda mesh: certet.write(mesh, "a.vtu")):
            self.refused("certet.Mesh", "ndarray", make=action, mesh=np.zeros(3))


if __name__ == "__main__":
    unittest.main()
