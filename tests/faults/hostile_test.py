"""Files made to hurt: one sentence, a documented status, little memory, nothing left."""

import gzip
import itertools
import struct
import unittest
import zlib

from guarded import BAD_INPUT, EMPTY, OK, TOO_LARGE, USAGE, GuardedTest, limits
from images import IDENTITY, voxels, write_meta, write_nifti, write_nrrd

SIZE = (5, 5, 5)
ONES = [1] * 125
MEBI = 2 ** 20


class HostileTest(GuardedTest):
    def refused(self, file, *options, statuses=(BAD_INPUT, TOO_LARGE), command="mesh"):
        output = [] if command in ("check", "report") else ["-o", "out.msh"]
        arguments = [file, "out.msh"] if command == "convert" else [file, *options, *output]
        run = self.assert_clean_failure(statuses, command, *arguments,
                                        prepare=limits(address_space=4096 * MEBI))
        self.assertLess(run.peak, 400 * MEBI, arguments)


class Promises(HostileTest):
    """Headers of more voxels than any file holds, or than 64 bits can count."""

    SIZES = ((10 ** 6,) * 3, (2 ** 21,) * 3, (2 ** 32, 2 ** 32, 1), (2 ** 63, 2, 2),
             (-5, 5, 5), (0, 5, 5))

    def test_nrrd_and_meta(self):
        for size, packed in itertools.product(self.SIZES, (False, True)):
            with self.subTest(size=size, packed=packed):
                write_nrrd(self.folder / "a.nrrd", size, ONES, packed=packed)
                self.refused("a.nrrd")
                write_meta(self.folder / "a.mha", size, ONES, packed=packed)
                self.refused("a.mha")

    def test_wraps_to_five(self):
        """2^64 + 5 is 5 to whoever keeps 64 bits."""
        write_nrrd(self.folder / "a.nrrd", (2 ** 64 + 5, 5, 5), ONES)
        self.refused("a.nrrd")

    def test_nifti(self):
        for name in ("a.nii", "a.nii.gz"):
            for size in ((32767,) * 3, (-5, 5, 5), (0, 5, 5)):
                with self.subTest(name, size=size):
                    write_nifti(self.folder / name, size, ONES)
                    self.refused(name)


class MetaHeaders(HostileTest):
    """Headers that ITK would follow into a long loop or a large allocation."""

    def changed(self, before, after):
        path = self.folder / "a.mha"
        write_meta(path, SIZE, ONES, packed=True)
        data = path.read_bytes()
        self.assertIn(before, data)
        path.write_bytes(data.replace(before, after, 1))
        self.refused("a.mha")

    def test_packed_size(self):
        for size in (b"-1", b"18446744073709551615", b"1e18", b"nan", b"inf", b"1e400", b"x"):
            with self.subTest(size):
                self.changed(b"ElementDataFile",
                             b"CompressedDataSize = " + size + b"\nElementDataFile")

    def test_dimensions(self):
        for number in (b"4294967295", b"-3", b"nan", b"11"):
            with self.subTest(number):
                self.changed(b"NDims = 3", b"NDims = " + number)

    def test_not_lines(self):
        self.changed(b"ObjectType", b"word\nObjectType")
        self.changed(b"ObjectType", b"word = \0\nObjectType")

    def test_long_lines(self):
        self.changed(b"ElementType", b"E" * 300 + b" = 1\nElementType")
        self.changed(b"ElementType", b"Comment = " + b"c" * 40000 + b"\nElementType")

    def test_no_place(self):
        path = self.folder / "a.mha"
        write_meta(path, SIZE, ONES, packed=True)
        head = path.read_bytes().split(b" LOCAL")[0]
        for end in (b"", b" ", b" LOCAL", b" \n", b"\x17"):
            with self.subTest(end):
                path.write_bytes(head + end)
                self.refused("a.mha")


class Geometry(HostileTest):
    """Numbers that place no voxel anywhere."""

    def test_spacing(self):
        for number in ("nan", "inf", "0", "-inf"):
            with self.subTest(number):
                write_meta(self.folder / "a.mha", SIZE, ONES, spacing=(1, number, 1))
                self.refused("a.mha")
                write_nrrd(self.folder / "a.nrrd", SIZE, ONES,
                           directions=((1, 0, 0), (0, number, 0), (0, 0, 1)))
                self.refused("a.nrrd")

    def test_nifti(self):
        """Spacings; and the rotation and offset, at bytes 256 to 279."""
        for number, at in itertools.product(("nan", "inf", "-inf", "1e30"), (80, 84, 88)):
            with self.subTest(number, at=at):
                self.damaged_nifti("<f", at, float(number))
        for number, at in itertools.product(("nan", "inf"), range(256, 280, 4)):
            with self.subTest(number, at=at):
                self.damaged_nifti("<f", at, float(number))

    def damaged_nifti(self, kind, at, number):
        path = self.folder / "a.nii"
        write_nifti(path, SIZE, ONES)
        data = bytearray(path.read_bytes())
        struct.pack_into(kind, data, at, number)
        path.write_bytes(data)
        self.refused("a.nii")

    def test_other_versions(self):
        """A reader of version 1 takes every version's header for its own."""
        path = self.folder / "a.nii"
        for version in range(1, 10):
            write_nifti(path, SIZE, ONES)
            data = bytearray(path.read_bytes())
            struct.pack_into("<f", data, 84, float("nan"))
            data[344:348] = f"n+{version}\0".encode()
            path.write_bytes(data)
            with self.subTest(version):
                self.refused("a.nii")

    def test_big_endian_is_read(self):
        """The mesh of the same voxels, whatever their byte order."""
        cube = voxels(SIZE, lambda *place: int(all(1 <= x <= 3 for x in place)))
        meshes = []
        for order in "<>":
            write_nifti(self.folder / "a.nii", SIZE, cube, (1, 2, 3), order=order)
            run = self.guarded("mesh", "a.nii", "-o", "a.mesh")
            self.assertEqual(run.status, 0, run.err)
            meshes.append((self.folder / "a.mesh").read_bytes())
        self.assertGreater(len(meshes[0]), 1000)
        self.assertEqual(*meshes)

    def test_byte_orders(self):
        """A header whose length is in another byte order than the rest."""
        self.damaged_nifti(">i", 0, 348)
        write_nifti(self.folder / "a.nii", SIZE, ONES, order=">")
        data = bytearray((self.folder / "a.nii").read_bytes())
        struct.pack_into(">f", data, 80, float("nan"))
        (self.folder / "a.nii").write_bytes(data)
        self.refused("a.nii")
        data[0:4] = struct.pack("<i", 348)
        (self.folder / "a.nii").write_bytes(data)
        self.refused("a.nii")

    def test_origin(self):
        for number in ("nan", "inf", "-inf"):
            with self.subTest(number):
                write_nrrd(self.folder / "a.nrrd", SIZE, ONES, origin=(0, number, 0))
                self.refused("a.nrrd")

    def test_direction(self):
        rows = list(map(list, IDENTITY))
        for number, place in itertools.product(("nan", "inf", "1e308"), range(3)):
            rows[1] = [0, 1, 0]
            rows[1][place] = number
            with self.subTest(number, place=place):
                write_meta(self.folder / "a.mha", SIZE, ONES, matrix=rows)
                self.refused("a.mha")
        for matrix in (((0, 0, 0),) * 3, ((1, 1, 1),) * 3, ((1, 0, 0), (1, 1, 0), (0, 0, 1))):
            with self.subTest(matrix):
                write_meta(self.folder / "a.mha", SIZE, ONES, matrix=matrix)
                self.refused("a.mha")


class Scales(HostileTest):
    """Solids so small or large that their coordinates, volumes or angles are no numbers."""

    FAR = (5e-324, 1e-310, 1e-200, 1e-40, 1e40, 1e200, 1e300)
    NEAR = (1e-27, 1e27)

    def sources(self, scale):
        """An image, a surface, a formula and a shape, all about as large as `scale`."""
        write_meta(self.folder / "a.mha", SIZE, ONES, spacing=(scale,) * 3)
        corners = "".join(f"v {x} {y} {z}\n" for x, y, z in
                          ((0, 0, 0), (scale, 0, 0), (0, scale, 0), (0, 0, scale)))
        (self.folder / "a.obj").write_text(corners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        low, high = f"{-scale},{-scale},{-scale}", f"{scale},{scale},{scale}"
        yield ("a.mha",)
        yield ("a.obj",)
        yield (f"--shape=sphere:{scale}",)
        yield "--expr=x-y", f"--bounds={low},{high}"

    def test_too_far(self):
        for scale, source in itertools.product(self.FAR, range(4)):
            arguments = [*self.sources(scale)][source]
            with self.subTest(arguments, scale=scale):
                self.refused(*arguments, statuses=(USAGE, BAD_INPUT, EMPTY, TOO_LARGE))

    def test_far(self):
        """Sound as any other: the mesh is checked by what is in its file alone."""
        for scale, source in itertools.product(self.NEAR, range(4)):
            mesh = [*self.sources(scale)][source]
            for command in (("mesh", *mesh, "-o", "out.vtu"), ("check", "out.vtu")):
                with self.subTest(command, scale=scale):
                    run = self.guarded(*command)
                    self.assertEqual(run.status, OK, run.err)


class Bombs(HostileTest):
    """Small files that unpack to gigabytes."""

    @staticmethod
    def zeros(members):
        """A gzip stream of so many members, each 64 MiB of zeros."""
        packer = zlib.compressobj(9, zlib.DEFLATED, 31)
        block = bytes(MEBI)
        member = b"".join([packer.compress(block) for _ in range(64)] + [packer.flush()])
        return member * members

    def test_gzip(self):
        bomb = self.zeros(32)
        for size in (SIZE, (30000, 30000, 30000)):
            with self.subTest(size):
                path = self.folder / "a.nrrd"
                write_nrrd(path, size, [], packed=True)
                header = path.read_bytes().split(b"\n\n")[0] + b"\n\n"
                path.write_bytes(header + bomb)
                self.refused("a.nrrd", statuses=(BAD_INPUT, TOO_LARGE, EMPTY))
                path.unlink()
        (self.folder / "a.nii.gz").write_bytes(bomb)
        self.refused("a.nii.gz")
        write_nifti(self.folder / "a.nii", (32767,) * 3, [])
        head = (self.folder / "a.nii").read_bytes()
        (self.folder / "a.nii").unlink()
        (self.folder / "a.nii.gz").write_bytes(gzip.compress(head) + bomb)
        self.refused("a.nii.gz")


class Truncated(HostileTest):
    def test_at_many_places(self):
        noise = voxels((9, 9, 9), lambda i, j, k: (i * 7919 + j * 104729 + k * 31) % 30011)
        write_nrrd(self.folder / "b.nrrd", (9, 9, 9), noise, packed=True)
        write_nifti(self.folder / "b.nii.gz", (9, 9, 9), noise)
        write_meta(self.folder / "b.mha", (9, 9, 9), noise, packed=True)
        for name in ("b.nrrd", "b.nii.gz", "b.mha"):
            data = (self.folder / name).read_bytes()
            for n in range(12):
                keep = len(data) * n // 12
                with self.subTest(name, keep=keep):
                    (self.folder / name).write_bytes(data[:keep])
                    self.refused(name)
            (self.folder / name).unlink()


class Labels(HostileTest):
    def test_outside_the_type(self):
        write_nrrd(self.folder / "a.nrrd", SIZE, ONES, kind="B")
        for labels in ("300", "-7", "2147483647"):
            self.refused("a.nrrd", f"--labels={labels}", statuses=(EMPTY,))
        for labels in ("2147483648", "99999999999999999999"):
            self.refused("a.nrrd", f"--labels={labels}", statuses=(USAGE, EMPTY))


class Meshes(HostileTest):
    """Meshes that promise 10^18 tets."""

    MANY = 10 ** 18
    FILES = {
        "a.mesh": f"MeshVersionFormatted 2\nDimension 3\nVertices\n{MANY}\n0 0 0 0\n"
                  f"Tetrahedra\n{MANY}\n1 2 3 4 0\nEnd\n",
        "b.mesh": f"MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 0 0\n"
                  f"Tetrahedra\n{MANY}\n1 1 1 1 0\nEnd\n",
        "a.msh": f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {MANY} 1 {MANY}\n"
                 f"3 1 0 {MANY}\n1\n",
        "b.msh": f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{MANY}\n1 0 0 0\n",
        "a.vtu": '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
                 'byte_order="LittleEndian" header_type="UInt64">\n<UnstructuredGrid>\n'
                 f'<Piece NumberOfPoints="{MANY}" NumberOfCells="{MANY}">\n</Piece>\n'
                 '</UnstructuredGrid>\n</VTKFile>\n',
    }

    def test_promises(self):
        for name, text in self.FILES.items():
            (self.folder / name).write_text(text)
            for command in ("check", "convert"):
                with self.subTest(name, command=command):
                    self.refused(name, command=command)

    def test_packed_block(self):
        """The header of the first compressed block, with a size of 2^60."""
        run = self.guarded("mesh", "--shape", "sphere:1", "--compress", "-o", "a.vtu")
        self.assertEqual(run.status, 0, run.err)
        path = self.folder / "a.vtu"
        data = path.read_bytes()
        at = data.index(b"_", data.index(b"<AppendedData")) + 1
        for word in range(4):
            for value in (2 ** 60, 2 ** 64 - 1, 0):
                damaged = bytearray(data)
                struct.pack_into("<Q", damaged, at + 8 * word, value)
                if damaged == data:
                    continue
                path.write_bytes(damaged)
                with self.subTest(word=word, value=value):
                    self.refused("a.vtu", command="check")


class Surfaces(HostileTest):
    """Triangles that are promised, that are nowhere, or that name no vertex.  Each file is a
    closed tetrahedron but for one number."""

    MANY = 10 ** 18
    PLY = ("ply\nformat {kind} 1.0\nelement vertex {vertices}\nproperty float x\n"
           "property float y\nproperty float z\nelement face {faces}\n"
           "property list uchar int vertex_indices\nend_header\n")
    CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))

    @classmethod
    def lines(cls, before, z, last, first=0, corners="3"):
        """Vertices and faces as text; `z` is the last coordinate, `last` the last index."""
        places = [*map(list, cls.CORNERS)]
        places[3][2] = z
        faces = [[corners, *(i + first for i in face)] for face in cls.FACES]
        faces[3][3] = last
        vertex, face = before
        return "".join(kind + " ".join(map(str, row)) + "\n" for kind, rows in
                       ((vertex, places), (face, faces)) for row in rows)

    def off(self, vertices=4, faces=4, z=1, last=3, corners="3"):
        return f"OFF\n{vertices} {faces} 0\n{self.lines(('', ''), z, last, corners=corners)}".encode()

    def obj(self, z=1, last=4):
        return self.lines(("v ", "f "), z, last, first=1, corners="").encode()

    def ply(self, kind="ascii", vertices=4, faces=4):
        head = self.PLY.format(kind=kind, vertices=vertices, faces=faces).encode()
        if kind == "ascii":
            return head + self.lines(("", ""), 1, 3).encode()
        order = "<" if "little" in kind else ">"
        return (head + b"".join(struct.pack(order + "3f", *p) for p in self.CORNERS) +
                b"".join(struct.pack(order + "B3i", 3, *f) for f in self.FACES))

    def stl(self, count=4, z=1.0):
        places = [*map(list, self.CORNERS)]
        places[3][2] = z
        triangles = (struct.pack("<12fH", 0, 0, 0, *places[a], *places[b], *places[c], 0)
                     for a, b, c in self.FACES)
        return bytes(80) + struct.pack("<I", count) + b"".join(triangles)

    def meshed(self, name, data):
        (self.folder / name).write_bytes(data)
        run = self.guarded("mesh", name, "--size", "0.2", "-o", "out.msh")
        self.assertEqual(run.status, 0, run.err)
        (self.folder / "out.msh").unlink()
        (self.folder / name).unlink()

    def refused_as(self, name, data):
        (self.folder / name).write_bytes(data)
        with self.subTest(name, data=data[:80]):
            self.refused(name, "--size", "0.2")
        (self.folder / name).unlink()

    KINDS = ("ascii", "binary_little_endian", "binary_big_endian")

    def test_without_fault(self):
        self.meshed("a.off", self.off())
        self.meshed("a.obj", self.obj())
        self.meshed("a.stl", self.stl())
        for kind in self.KINDS:
            self.meshed("a.ply", self.ply(kind))

    def test_promises(self):
        for count in (2 ** 32 - 1, 10 ** 6, 5):
            self.refused_as("a.stl", self.stl(count))
        for number in (self.MANY, 2 ** 64 - 1, 2 ** 64 + 4, -4, "nan"):
            for kind in self.KINDS:
                self.refused_as("a.ply", self.ply(kind, vertices=number))
                self.refused_as("a.ply", self.ply(kind, faces=number))
            self.refused_as("a.off", self.off(vertices=number))
            self.refused_as("a.off", self.off(faces=number))

    def test_polygon_of_many_corners(self):
        for corners in (self.MANY, 2 ** 31, 2 ** 32 + 3, 4):
            self.refused_as("a.off", self.off(corners=corners))

    def test_nowhere(self):
        for number in ("nan", "inf", "-inf"):
            self.refused_as("a.off", self.off(z=number))
            self.refused_as("a.obj", self.obj(z=number))
            self.refused_as("a.stl", self.stl(z=float(number)))
        for number in ("1e300", "1e400"):
            self.refused_as("a.off", self.off(z=number))
            self.refused_as("a.obj", self.obj(z=number))

    def test_no_such_vertex(self):
        for number in (4, -1, 2 ** 31, 2 ** 32 + 3, self.MANY):
            self.refused_as("a.off", self.off(last=number))
        for number in (5, 0, 2 ** 31, 2 ** 32 + 4, self.MANY):
            self.refused_as("a.obj", self.obj(last=number))


class Pages(HostileTest):
    """TIFF stacks, one page after another."""

    @staticmethod
    def page(width, height, bits, next_page, data=b"x" * 64):
        """A little-endian file with one page, whose voxels lie at its end."""
        entries = ((256, width), (257, height), (258, bits), (259, 1), (262, 1), (273, 122),
                   (277, 1), (278, height), (279, min(len(data), 2 ** 32 - 1)))
        listed = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in entries)
        directory = struct.pack("<H", len(entries)) + listed + struct.pack("<I", next_page)
        return b"II*\0" + struct.pack("<I", 8) + directory + data

    def refused_page(self, *fields):
        (self.folder / "a.tif").write_bytes(self.page(*fields))
        with self.subTest(fields=fields):
            self.refused("a.tif")

    def test_promises(self):
        for width, height in ((2 ** 32 - 1, 2 ** 32 - 1), (2 ** 31, 2 ** 31), (2 ** 20, 2 ** 20),
                              (0, 8), (8, 0)):
            for bits in (8, 16, 32):
                self.refused_page(width, height, bits, 0)
        for bits in (0, 7, 2 ** 31):
            self.refused_page(8, 8, bits, 0)

    def test_pages_without_end(self):
        """The page that follows is the same, or lies outside the file."""
        for next_page in (8, 2 ** 32 - 1, 60):
            self.refused_page(8, 8, 8, next_page)

    def test_without_fault(self):
        (self.folder / "a.tif").write_bytes(self.page(8, 8, 8, 0))
        run = self.guarded("mesh", "a.tif", "-o", "out.msh")
        self.assertEqual(run.status, 0, run.err)


class Grids(HostileTest):
    """OpenVDB grids, cut short or with a word changed."""

    def test_damaged(self):
        path = self.folder / "a.vdb"
        for data in (b"", b" BDV", b" BDV" + bytes(4), b" BDV" + bytes(5000), b"\xff" * 5000):
            path.write_bytes(data)
            with self.subTest(data[:8], size=len(data)):
                self.refused("a.vdb")


class HostileNotices(HostileTest):
    """A program with each of the faults is refused."""

    FAULTS = (
        ("echo 'certet: a.' >&2; echo b >&2; exit 3\n", "Regex didn't match"),
        ("echo 'certet: a.' >&2; exit 1\n", "1 not found"),
        ("echo 'certet: a.' >&2; kill -SEGV $$\n", "-11 not found"),
        ("echo x > out.msh; echo 'certet: a.' >&2; exit 3\n", "out.msh"),
        ("echo x > .out.tmp; echo 'certet: a.' >&2; exit 3\n", "out.tmp"),
        ("echo x >> a.nrrd; echo 'certet: a.' >&2; exit 3\n", "a.nrrd"),
        ("python3 -c 'bytes(range(256)) * 2000000'; echo 'certet: a.' >&2; exit 3\n",
         "not less than"),
    )

    def test_faults(self):
        def refuse():
            (self.folder / "a.nrrd").write_text("input")
            self.refused("a.nrrd")

        self.assert_noticed(self.FAULTS, refuse)


if __name__ == "__main__":
    unittest.main()
