"""Every way to fail: one sentence, the documented status, nothing left behind."""

import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from images import voxels, write_meta, write_nifti, write_nrrd, write_plain_nrrd
from program import CERTET, TORUS, ProgramTest

CHECK_FAILED, USAGE, BAD_INPUT, EMPTY, TOO_LARGE, WRITE_FAILED = range(1, 7)
INTERRUPTED = 130
SIZE = (5, 5, 5)


class Usage(ProgramTest):
    def test_arguments(self):
        for words, arguments in (
                (["subcommand"], []),
                (["--expr"], ["mesh", "-o", "a.vtu"]),
                (["output"], ["mesh", "a.nrrd"]),
                (["--bounds"], ["mesh", "--expr", "x", "-o", "a.vtu"]),
                (["six"], ["mesh", "--expr", "x", "--bounds", "1,2,3", "-o", "a.vtu"]),
                (["bounds"], ["mesh", "--expr", "x", "--bounds", "1,1,1,0,0,0", "-o", "a.vtu"]),
                (["exclude"], ["mesh", "a.nrrd", *TORUS, "-o", "a.vtu"]),
                (["exclude"], ["mesh", "a.nrrd", "--shape", "sphere:1", "-o", "a.vtu"]),
                (["exclude"], ["mesh", *TORUS, "--shape", "sphere:1", "-o", "a.vtu"]),
                (["--shape"], ["mesh", "-o", "a.vtu"]),
                (["--labels"], ["mesh", "--shape", "sphere:1", "--labels", "1", "-o", "a.vtu"]),
                (["--iso"], ["mesh", *TORUS, "--iso", "1", "-o", "a.vtu"]),
                (["--bounds"], ["mesh", "a.nrrd", "--bounds", "0,0,0,1,1,1", "-o", "a.vtu"]),
                (["exclude"], ["mesh", *TORUS, "--size", "1", "--rel-size", "1", "-o", "a.vtu"]),
                (["exclude"], ["mesh", *TORUS, "--size", "1", "--target-tets", "1",
                               "-o", "a.vtu"]),
                (["exclude"], ["mesh", *TORUS, "--rel-size", "1", "--target-tets", "1",
                               "-o", "a.vtu"]),
                (["exclude"], ["mesh", "a.nrrd", "--iso", "1", "--labels", "1", "-o", "a.vtu"]),
                (["--cuts"], ["mesh", *TORUS, "--cuts", "random", "-o", "a.vtu"]),
                (["--margin"], ["mesh", *TORUS, "--margin", "0", "-o", "a.vtu"]),
                (["colour"], ["mesh", *TORUS, "--colour", "-o", "a.vtu"]),
                (["extension", "a.obj"], ["mesh", *TORUS, "-o", "a.obj"]),
                (["--compress"], ["mesh", *TORUS, "-o", "a.msh", "--compress"]),
                (["--label-names"], ["mesh", *TORUS, "-o", "a.msh", "--label-names", "n.txt"]),
                (["'-'", "standard output"], ["mesh", *TORUS, "-o", "-", "--format", "vtu"]),
                (["--format"], ["mesh", *TORUS, "-o", "a.vtu", "--format", "obj"])):
            with self.subTest(arguments):
                self.assert_fails(USAGE, words, *arguments)

    def test_size(self):
        for size in ("0", "-1", "nan", "inf", "wide", "1e"):
            with self.subTest(size):
                self.assert_fails(USAGE, ["--size"], "mesh", *TORUS, "--size", size,
                                  "-o", "a.vtu")

    def test_relative_size_and_target(self):
        for value in ("0", "-1", "nan", "wide", "1e", "1e400"):
            with self.subTest(value):
                self.assert_fails(USAGE, ["--rel-size"], "mesh", *TORUS, "--rel-size", value,
                                  "-o", "a.vtu")
        for value in ("0", "-1", "1.5", "1e6", "many", "99999999999999999999"):
            with self.subTest(value):
                self.assert_fails(USAGE, ["--target-tets"], "mesh", *TORUS, "--target-tets",
                                  value, "-o", "a.vtu")

    def test_shapes(self):
        for shape, words in (
                ("cone:1", ["sphere, torus, box"]), ("sphere", ["sphere:R"]),
                ("sphere:0", ["positive"]), ("sphere:1,2", ["2 numbers"]),
                ("sphere:x", ["'x'"]), ("torus:1,2", ["ring"]), ("box:1,1", ["box:a,b,c"]),
                ("cylinder:1", ["cylinder:R,H"]), ("gyroid:1,1", ["gap"])):
            with self.subTest(shape):
                self.assert_fails(USAGE, [f"'{shape}'", *words], "mesh", "--shape", shape,
                                  "-o", "a.vtu")
        self.assert_fails(USAGE, ["within the bounds"], "mesh", "--shape", "sphere:1",
                          "--bounds", "2,2,2,3,3,3", "-o", "a.vtu")

    def test_label_lists(self):
        for labels in ("", "1,", "a", "5-1", "1-2-3", "1 2"):
            with self.subTest(labels):
                self.assert_fails(USAGE, ["--labels"], "mesh", "a.nrrd",
                                  "--labels=" + (labels or ","), "-o", "a.vtu")

    def test_help_and_version(self):
        for arguments in (["--help"], ["mesh", "--help"], ["check", "--help"], ["--version"]):
            run = self.run_certet(*arguments)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn("certet", run.stdout)
        self.assertIn("130", self.run_certet("--help").stdout)


class Formulas(ProgramTest):
    def test_unreadable(self):
        for formula in ("x^2+", "foo(x)", "x y", "x=3", "1,2", "(x", "w", "sin()", "\"a\""):
            with self.subTest(formula):
                self.assert_fails(BAD_INPUT, [formula], "mesh", "--expr", formula,
                                  "--bounds", "0,0,0,1,1,1", "-o", "a.vtu")

    def test_position(self):
        self.assert_fails(BAD_INPUT, ["position 3"], "mesh", "--expr", "x+$",
                          "--bounds", "0,0,0,1,1,1", "-o", "a.vtu")

    def test_empty(self):
        for formula in ("1", "0/0", "x^2+y^2+z^2-0.0001"):
            with self.subTest(formula):
                self.assert_fails(EMPTY, ["inside"], "mesh", "--expr", formula, "--bounds",
                                  "0.1,0.1,0.1,1.1,1.1,1.1", "-o", "a.vtu")
        self.assert_fails(EMPTY, ["inside"], "mesh", "--expr", "1", "--bounds",
                          "0,0,0,1,1,1", "--target-tets", 1000, "-o", "a.vtu")


class Images(ProgramTest):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "a.nrrd"
        self.values = voxels(SIZE, lambda i, j, k: 1)

    def refused(self, status, *words, options=(), file="a.nrrd"):
        self.assert_fails(status, [file, *words], "mesh", file, *options, "-o", "a.vtu")

    def test_missing(self):
        self.refused(BAD_INPUT, "does not exist")
        self.refused(BAD_INPUT, "without a DICOM series", file=".")

    def test_other_files(self):
        for name in ("a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.png", "a"):
            (self.folder / name).write_bytes(b"hello\n" * 100)
            with self.subTest(name):
                self.refused(BAD_INPUT, file=name)
            (self.folder / name).write_bytes(b"")
            with self.subTest(name + " empty"):
                self.refused(BAD_INPUT, file=name)

    def test_truncated(self):
        write_nrrd(self.path, SIZE, self.values, cut=20)
        self.refused(BAD_INPUT, "truncated")
        noise = voxels((20, 20, 20), lambda i, j, k: (i * 7919 + j * 104729 + k * i * 31) % 30011)
        write_nrrd(self.path, (20, 20, 20), noise, packed=True, cut=2000)
        self.refused(BAD_INPUT, "truncated")
        for name in ("a.nii", "a.nii.gz"):
            write_nifti(self.folder / name, (20, 20, 20), noise, cut=2000)
            with self.subTest(name):
                self.refused(BAD_INPUT, "truncated", file=name)
        for packed in (False, True):
            write_meta(self.folder / "a.mha", (20, 20, 20), noise, packed=packed, cut=40)
            with self.subTest("a.mha", packed=packed):
                self.refused(BAD_INPUT, "truncated", file="a.mha")

    def test_damaged_stream(self):
        noise = voxels((20, 20, 20), lambda i, j, k: (i * 7919 + j * 104729 + k * i * 31) % 30011)
        write_nrrd(self.path, (20, 20, 20), noise, packed=True)
        data = bytearray(self.path.read_bytes())
        data[-3000:-2900] = bytes(100)
        self.path.write_bytes(data)
        self.refused(BAD_INPUT, "damaged")

    def test_header_beyond_the_file(self):
        write_nrrd(self.path, (2000, 2000, 2000), self.values)
        self.refused(BAD_INPUT, "too short")
        write_nrrd(self.path, (2 ** 40, 2 ** 40, 2 ** 40), self.values)
        self.refused(BAD_INPUT)

    def test_dimensions(self):
        write_plain_nrrd(self.path, (5, 5))
        self.refused(BAD_INPUT, "2 dimensions")
        write_plain_nrrd(self.path, (5, 5, 5, 2))
        self.refused(BAD_INPUT, "4 dimensions", "--volume N, from 0 to 1")
        write_meta(self.folder / "a.mha", SIZE, self.values * 3, channels=3)
        self.refused(BAD_INPUT, "3 numbers per voxel", "--volume", file="a.mha")

    def test_direction(self):
        for matrix in (((1, 0.1, 0), (0, 1, 0), (0, 0, 1)), ((1, 0, 0), (1, 0, 0), (0, 0, 1))):
            with self.subTest(matrix):
                write_nrrd(self.path, SIZE, self.values, directions=matrix)
                self.refused(BAD_INPUT)
        write_meta(self.folder / "a.mha", SIZE, self.values,
                   matrix=((1, 0.1, 0), (0, 1, 0), (0, 0, 1)))
        self.refused(BAD_INPUT, "orthonormal", "shear", "84.3 degrees", file="a.mha")

    def test_almost_orthonormal_is_fine(self):
        write_nrrd(self.path, SIZE, self.values,
                   directions=((1, 0.0001, 0), (0, 1, 0), (0, 0, 1)))
        self.mesh("a.nrrd", "-o", "a.vtu")

    def test_fractions_need_a_level(self):
        write_nrrd(self.path, SIZE, [0.5] * 125, kind="f")
        self.refused(USAGE, "--iso")
        self.refused(USAGE, "--iso", options=["--labels", "1"])

    def test_nan(self):
        values = [0.0] * 120 + [float("nan")] * 3 + [float("inf"), 1.0]
        write_nrrd(self.path, SIZE, values, kind="d")
        self.refused(BAD_INPUT, "4 voxels", "NaN", options=["--iso", "0.5"])

    def test_wide_labels(self):
        for kind in "Iq":
            write_nrrd(self.path, SIZE, [2 ** 31] * 125, kind=kind)
            with self.subTest(kind):
                self.refused(BAD_INPUT, "2147483648", "32 bits")

    def test_empty_selection(self):
        write_nrrd(self.path, SIZE, self.values)
        self.refused(EMPTY, "chosen", options=["--labels", "2-9"])
        self.refused(EMPTY, "above the level 1; the greatest is 1", options=["--iso", "1"])
        write_nrrd(self.path, SIZE, [0] * 125)
        self.refused(EMPTY, "other than 0")

    def test_input_is_output(self):
        write_nrrd(self.folder / "a.vtu", SIZE, self.values)
        (self.folder / "b.vtu").symlink_to("a.vtu")
        for name in ("a.vtu", "./a.vtu", "b.vtu"):
            self.assert_fails(USAGE, ["same file"], "mesh", "a.vtu", "-o", name)
        write_nrrd(self.path, SIZE, self.values)
        self.assert_fails(USAGE, ["same file"], "mesh", "a.nrrd", "-o", "c.vtu",
                          "--json", "a.nrrd")


class Limits(ProgramTest):
    def test_coordinate_range(self):
        self.assert_fails(TOO_LARGE, ["cells", "size"], "mesh", *TORUS, "--size", "1e-5",
                          "-o", "a.vtu")
        self.assert_fails(TOO_LARGE, ["1e-30"], "mesh", *TORUS, "--size", "1e-300",
                          "-o", "a.vtu")

    def test_far_from_the_origin(self):
        """Where numbers are half an edge apart, no mesh keeps its angles, which is no bug."""
        near, far = "4000000000000000", "4000000000000004"
        for cuts in ("bisect", "midpoint"):
            self.assert_fails(WRITE_FAILED, ["cannot write 'a.vtu'", "far from the origin",
                                             "double precision", "--origin 0"],
                              "mesh", "--expr", "-1", "--bounds", f"{near},0,0,{far},4,4",
                              "--size", "0.5", "--cuts", cuts, "-o", "a.vtu")

    def test_memory(self):
        self.assert_fails(TOO_LARGE, ["memory", "size"], "mesh", *TORUS, "--size", "2e-4",
                          "-o", "a.vtu")
        self.assert_fails(TOO_LARGE, ["memory"], "mesh", *TORUS, "--max-memory", "100K",
                          "-o", "a.vtu")
        self.assert_fails(TOO_LARGE, ["memory", "--target-tets"], "mesh", *TORUS,
                          "--target-tets", 10 ** 15, "-o", "a.vtu")

    def test_memory_of_voxels(self):
        write_nrrd(self.folder / "a.nrrd", (50, 50, 50), [1] * 125000)
        self.assert_fails(TOO_LARGE, ["a.nrrd", "bytes"], "mesh", "a.nrrd", "--max-memory",
                          "100K", "-o", "a.vtu")

    def test_memory_of_a_polymesh(self):
        """OpenFOAM's mesh is held whole, 120 bytes for each tetrahedron."""
        streamed = self.mesh(*TORUS, "--dry-run", "-o", "a.vtu")
        whole = self.mesh(*TORUS, "--dry-run", "-o", "polyMesh")
        least = whole["memory"]["least"]
        self.assertGreaterEqual(least - streamed["memory"]["least"], 120 * whole["mesh"]["tets"])
        self.assert_fails(TOO_LARGE, ["memory"], "mesh", *TORUS, "-o", "polyMesh", "--max-memory",
                          least - 1)

    def test_memory_of_slabs(self):
        least = self.mesh(*TORUS, "--dry-run")["memory"]["least"]
        self.assert_fails(TOO_LARGE, ["memory"], "mesh", *TORUS, "--max-memory", least - 1,
                          "-o", "a.vtu")


class Outputs(ProgramTest):
    def test_no_folder(self):
        self.assert_fails(WRITE_FAILED, ["none/a.vtu"], "mesh", *TORUS, "-o", "none/a.vtu")
        self.assert_fails(WRITE_FAILED, ["none/a.json"], "mesh", *TORUS, "-o", "a.vtu",
                          "--json", "none/a.json")

    def test_not_a_file(self):
        (self.folder / "a.vtu").mkdir()
        self.assert_fails(WRITE_FAILED, ["a.vtu"], "mesh", *TORUS, "-o", "a.vtu")
        os.mkfifo(self.folder / "b.vtu")
        self.assert_fails(WRITE_FAILED, ["b.vtu"], "mesh", *TORUS, "-o", "b.vtu")

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_no_permission(self):
        (self.folder / "closed").mkdir(0o500)
        self.assert_fails(WRITE_FAILED, ["closed/a.vtu"], "mesh", *TORUS, "-o", "closed/a.vtu")

    def test_disk_full_on_the_way(self):
        def small_files():
            import resource
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

        self.assert_fails(WRITE_FAILED, ["a.vtu"], "mesh", *TORUS, "-o", "a.vtu",
                          preexec_fn=small_files)

    def test_an_older_mesh_survives(self):
        (self.folder / "a.vtu").write_text("older")
        self.assert_fails(BAD_INPUT, [], "mesh", "none.nrrd", "-o", "a.vtu")
        self.assertEqual((self.folder / "a.vtu").read_text(), "older")

    def wait_until_caught(self, pid, sent):
        """A program that is still being loaded would be ended by the signal itself."""
        for _ in range(3000):
            status = pathlib.Path(f"/proc/{pid}/status").read_text()
            if int(re.search(r"^SigCgt:\s*(\w+)", status, re.MULTILINE)[1], 16) >> (sent - 1) & 1:
                return
            time.sleep(0.02)
        self.fail("the program catches no signal")

    def test_interrupted(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(sent):
                run = subprocess.Popen(
                    [CERTET, "mesh", *TORUS, "--size", "0.004", "-o", "a.vtu"],
                    cwd=self.folder, text=True, stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE)
                self.wait_until_caught(run.pid, sent)
                run.send_signal(sent)
                out, err = run.communicate(timeout=100)
                self.assertEqual(run.returncode, INTERRUPTED, err)
                self.assertEqual(out, "")
                self.assertRegex(err, r"\Acertet: [^\n]+\n\Z")
                self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
