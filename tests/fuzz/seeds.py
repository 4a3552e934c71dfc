#!/usr/bin/env python3
"""Writes the corpus: small good inputs for every target.

    seeds.py CERTET CORPUS_FOLDER

Files that are there already, such as those of earlier findings, stay.  Inputs of
readers of several formats begin with one byte that chooses the format.
"""
import gzip
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

certet, corpus = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])


def put(target, name, content, choice=None):
    folder = corpus / target
    folder.mkdir(parents=True, exist_ok=True)
    first = b"" if choice is None else bytes([choice])
    (folder / name).write_bytes(first + content)


def meshes(folder):
    """One of a formula, one with labels, in every format that can be read."""
    image = folder / "labels.mha"
    image.write_bytes(mha((3, 3, 3), bytes([1] * 9 + [2] * 18)))
    for source, name in ((["--shape", "box:1,1,1", "--size", "1"], "box"),
                         ([str(image), "--size", "1.5"], "labels")):
        for choice, form in ((0, "vtu"), (0, "vtu-zlib"), (1, "medit"), (2, "meditb"),
                             (3, "msh"), (3, "msh22")):
            file = folder / (name + (".vtu", ".mesh", ".meshb", ".msh")[choice])
            subprocess.run([certet, "mesh", *source, "--format", form, "-o", file],
                           check=True, stdout=subprocess.DEVNULL)
            put("mesh_file", f"{name}.{form}", file.read_bytes(), choice)
    run = folder / "run.json"
    subprocess.run([certet, "mesh", "--shape", "box:1,1,1", "--size", "1", "-o", "a.vtu",
                    "--json", run], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    put("run_file", "box.json", run.read_bytes())


def mha(size, voxels, compressed=False):
    data = zlib.compress(voxels) if compressed else voxels
    header = ("ObjectType = Image\nNDims = 3\nBinaryData = True\n"
              "BinaryDataByteOrderMSB = False\n"
              + (f"CompressedData = True\nCompressedDataSize = {len(data)}\n" if compressed else "")
              + "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
              "ElementSpacing = 1 1 1\nDimSize = %d %d %d\n"
              "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" % size)
    return header.encode() + data


def nifti(size, voxels, datatype, bits):
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, *size, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, datatype, bits)
    struct.pack_into("<8f", head, 76, 1, 1, 1, 1, 0, 0, 0, 0)
    struct.pack_into("<f", head, 108, 352)
    struct.pack_into("<2f", head, 112, 1, 0)
    struct.pack_into("<2h", head, 252, 1, 0)  # a quaternion
    head[344:348] = b"n+1\0"
    return bytes(head) + voxels


def nrrd(size, voxels, encoding):
    header = ("NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\n"
              "sizes: %d %d %d\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
              "kinds: domain domain domain\nendian: little\nencoding: " % size
              + encoding + "\nspace origin: (0,0,0)\n\n").encode()
    return header + (gzip.compress(voxels, mtime=0) if encoding == "gzip" else voxels)


def tiff(width, height, pages):
    """Pages of bytes, one strip each."""
    out = bytearray(b"II*\0" + struct.pack("<I", 8))
    for page in range(pages):
        tags = [(256, 3, width), (257, 3, height), (258, 3, 8), (259, 3, 1), (262, 3, 1),
                (273, 4, len(out) + 2 + 10 * 12 + 4), (277, 3, 1), (278, 3, height),
                (279, 4, width * height), (339, 3, 1)]
        last = page == pages - 1
        out += struct.pack("<H", len(tags))
        for tag, kind, value in tags:
            out += struct.pack("<HHII", tag, kind, 1, value)
        out += struct.pack("<I", 0 if last else len(out) + 4 + width * height)
        out += bytes([page + 1] * (width * height))
    return bytes(out)


def short(number):
    return struct.pack("<H", number)


def dicom_element(implicit, group, number, kind, value):
    value = value.encode() if isinstance(value, str) else value
    value += (b"\0" if kind in ("UI", "OB") else b" ") * (len(value) % 2)
    head = struct.pack("<HH", group, number)
    if implicit:
        return head + struct.pack("<I", len(value)) + value
    if kind in ("OB", "OW", "SQ"):
        return head + kind.encode() + struct.pack("<HI", 0, len(value)) + value
    return head + kind.encode() + struct.pack("<H", len(value)) + value


def dicom_frames(implicit=False, segments=False):
    """Three frames of 4 x 3 voxels with functional groups; of one bit for segments."""
    def element(*e):
        return dicom_element(implicit, *e)

    def sequence(group, number, *items):
        data = b"".join(struct.pack("<HHI", 0xfffe, 0xe000, len(i)) + i for i in items)
        return element(group, number, "SQ", data)

    kind = "1.2.840.10008.5.1.4.1.1." + ("66.4" if segments else "2.1")
    syntax = "1.2.840.10008.1.2" + ("" if implicit else ".1")
    meta = b"".join(dicom_element(False, 2, number, "UI", value) for number, value in
                    ((2, kind), (3, "1.2.3.1"), (0x10, syntax)))
    bits = 1 if segments else 16
    body = [element(*e) for e in (
        (8, 0x16, "UI", kind), (8, 0x18, "UI", "1.2.3.1"), (8, 0x60, "CS", "CT"),
        (0x20, 0xd, "UI", "1.2"), (0x20, 0xe, "UI", "1.2.3"), (0x28, 2, "US", short(1)),
        (0x28, 4, "CS", "MONOCHROME2"), (0x28, 8, "IS", "3"), (0x28, 0x10, "US", short(3)),
        (0x28, 0x11, "US", short(4)), (0x28, 0x100, "US", short(bits)),
        (0x28, 0x101, "US", short(bits)), (0x28, 0x102, "US", short(bits - 1)),
        (0x28, 0x103, "US", short(0)))]
    if segments:
        body += [element(0x62, 1, "CS", "BINARY"), sequence(0x62, 2, *(
            element(0x62, 4, "US", short(n)) + element(0x62, 5, "LO", f"part {n}")
            for n in (1, 2)))]
    shared = (sequence(0x20, 0x9116, element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")) +
              sequence(0x28, 0x9110, element(0x18, 0x50, "DS", "2") + element(0x18, 0x88, "DS", "2")
                       + element(0x28, 0x30, "DS", "1\\1")) +
              sequence(0x28, 0x9145, element(0x28, 0x1052, "DS", "-3")
                       + element(0x28, 0x1053, "DS", "0.5")))
    frames = []
    for n in range(3):
        frame = sequence(0x20, 0x9113, element(0x20, 0x32, "DS", f"0\\0\\{2 * n}"))
        if segments:
            frame += sequence(0x62, 0xa, element(0x62, 0xb, "US", short(1 + n // 2)))
        frames.append(frame)
    body += [sequence(0x5200, 0x9229, shared), sequence(0x5200, 0x9230, *frames)]
    voxels = b"\xa5\x5a\xff\x0f\x3c\0" if segments else struct.pack("<36H", *range(36))
    return (bytes(128) + b"DICM" + dicom_element(False, 2, 0, "UL", struct.pack("<I", len(meta)))
            + meta + b"".join(body) + element(0x7fe0, 0x10, "OB" if segments else "OW", voxels))


def dicom_slice(along, implicit=False, packed=False):
    """4 x 3 voxels of 16 bits; a sequence of one item among the elements."""
    def element(group, number, kind, value, implicit=implicit):
        return dicom_element(implicit, group, number, kind, value)

    image = "1.2.840.10008.5.1.4.1.1.2"  # CT
    syntax = "1.2.840.10008.1.2" + ("" if implicit else ".5" if packed else ".1")
    meta = b"".join(element(2, number, "UI", value, False) for number, value in
                    ((2, image), (3, f"1.2.3.{along}"), (0x10, syntax)))
    item = element(8, 0x1150, "UI", image)
    body = [(8, 0x16, "UI", image), (8, 0x18, "UI", f"1.2.3.{along}"), (8, 0x60, "CS", "CT"),
            (8, 0x1140, "SQ", struct.pack("<HHI", 0xfffe, 0xe000, len(item)) + item),
            (0x18, 0x50, "DS", "2"), (0x20, 0xd, "UI", "1.2"), (0x20, 0xe, "UI", "1.2.3"),
            (0x20, 0x13, "IS", str(along)), (0x20, 0x32, "DS", f"0\\0\\{2 * along}"),
            (0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"), (0x28, 2, "US", short(1)),
            (0x28, 4, "CS", "MONOCHROME2"), (0x28, 0x10, "US", short(3)), (0x28, 0x11, "US", short(4)),
            (0x28, 0x30, "DS", "1\\1"), (0x28, 0x100, "US", short(16)), (0x28, 0x101, "US", short(16)),
            (0x28, 0x102, "US", short(15)), (0x28, 0x103, "US", short(1)),
            (0x28, 0x1052, "DS", "0"), (0x28, 0x1053, "DS", "1")]
    voxels = struct.pack("<12h", *range(12))
    if packed:  # runs, the high bytes before the low ones, behind an empty table of offsets
        rows = b"".join(bytes([11]) + voxels[half::2] + b"\0" for half in (1, 0))
        runs = struct.pack("<16I", 2, 64, 78, *[0] * 13) + rows
        fragment = struct.pack("<HHI", 0xfffe, 0xe000, len(runs)) + runs
        voxels = (struct.pack("<HHI", 0xfffe, 0xe000, 0) + fragment +
                  struct.pack("<HHI", 0xfffe, 0xe0dd, 0))
        last = struct.pack("<HH2sHI", 0x7fe0, 0x10, b"OB", 0, 0xffffffff) + voxels
    else:
        last = element(0x7fe0, 0x10, "OW", voxels)
    return (bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta)), False) + meta
            + b"".join(element(*e) for e in body) + last)


def nifti_2(size, voxels, datatype, bits, slope):
    """Of version 2, with a matrix, a slope and an intercept; two volumes."""
    head = bytearray(544)
    struct.pack_into("<i8s2h", head, 0, 540, b"n+2\0\r\n\032\n", datatype, bits)
    struct.pack_into("<8q", head, 16, 4, *size, 2, 1, 1, 1)
    struct.pack_into("<8d", head, 104, 1, 1, 1, 1, 1, 1, 1, 1)
    struct.pack_into("<q2d", head, 168, 544, slope, 1)
    struct.pack_into("<2i", head, 344, 1, 2)
    struct.pack_into("<12d", head, 400, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0)
    struct.pack_into("<i", head, 500, 2)
    return bytes(head) + voxels * 2


def segments():
    """Two layers of 3D Slicer that overlap."""
    head = ("NRRD0004\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\n"
            "sizes: 2 3 4 2\nkinds: list domain domain domain\n"
            "space directions: none (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n")
    for n in range(2):
        head += (f"Segment{n}_ID:=S{n}\nSegment{n}_LabelValue:=1\nSegment{n}_Layer:={n}\n"
                 f"Segment{n}_Name:=part {n}\n")
    return head.encode() + b"\n" + bytes(n % 3 != 0 for n in range(48))


def bits_tiff():
    """A page of 11 x 3 voxels of one bit."""
    tags = ((256, 3, 11), (257, 3, 3), (258, 3, 1), (259, 3, 1), (262, 3, 0), (273, 4, 8),
            (277, 3, 1), (278, 3, 3), (279, 4, 6))
    return (b"II*\0" + struct.pack("<I", 14) + b"\xaa\xa0\x55\x40\xff\xe0"
            + struct.pack("<H", len(tags))
            + b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags)
            + bytes(4))


def images():
    for name, settings in (("explicit", {}), ("implicit", {"implicit": True}),
                           ("packed", {"packed": True})):
        put("dicom", name, dicom_slice(1, **settings) + dicom_slice(2, **settings))
    size, voxels = (3, 4, 2), bytes(range(24))
    floats = struct.pack("<24f", *range(24))
    put("image", "bytes.nii", nifti(size, voxels, 2, 8), 0)
    put("image", "floats.nii", nifti(size, floats, 16, 32), 0)
    put("image", "bytes.nii.gz", gzip.compress(nifti(size, voxels, 2, 8), mtime=0), 1)
    put("image", "raw.nrrd", nrrd(size, voxels, "raw"), 2)
    put("image", "gzip.nrrd", nrrd(size, voxels, "gzip"), 2)
    put("image", "ascii.nrrd", nrrd(size, b" ".join(b"%d" % v for v in voxels), "ascii"), 2)
    put("image", "raw.mha", mha(size, voxels), 3)
    put("image", "zlib.mha", mha(size, voxels, True), 3)
    put("image", "pages.tif", tiff(4, 3, 3), 4)
    put("image", "scaled-2.nii", nifti_2(size, voxels, 2, 8, 0.5), 0)
    put("image", "packed-2.nii.gz", gzip.compress(nifti_2(size, floats, 16, 32, 0), mtime=0), 1)
    put("image", "layers.nrrd", segments(), 2)
    put("image", "text.mha", mha(size, b" ".join(b"%d" % v for v in voxels)).replace(
        b"BinaryData = True", b"BinaryData = False"), 3)
    put("image", "no-size.mha", mha(size, voxels, True).replace(b"CompressedDataSize", b"Comment"), 3)
    put("image", "channels.mha", mha(size, voxels * 2).replace(
        b"ElementType", b"ElementNumberOfChannels = 2\nElementType"), 3)
    put("image", "bits.tif", bits_tiff(), 4)
    for name, settings in (("frames", {}), ("frames-implicit", {"implicit": True}),
                           ("segments", {"segments": True})):
        put("image", name + ".dcm", dicom_frames(**settings), 5)


POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def words(rows, before=""):
    return "".join(before + " ".join(map(str, row)) + "\n" for row in rows)


def ply(form):
    header = (f"ply\nformat {form} 1.0\ncomment small\nelement vertex 4\nproperty float x\n"
              "property float y\nproperty float z\nelement face 4\n"
              "property list uchar int vertex_indices\nend_header\n")
    if form == "ascii":
        return (header + words(POINTS) + words(FACES, "3 ")).encode()
    end = "<" if "little" in form else ">"
    return (header.encode() + b"".join(struct.pack(end + "3f", *p) for p in POINTS)
            + b"".join(struct.pack(end + "B3i", 3, *f) for f in FACES))


def surfaces():
    corners = [[POINTS[p] for p in face] for face in FACES]
    binary = bytes(80) + struct.pack("<I", 4)
    text = "solid tet\n"
    for triangle in corners:
        binary += struct.pack("<12fH", 0, 0, 0, *sum(triangle, ()), 0)
        text += ("facet normal 0 0 0\nouter loop\n" + words(triangle, "vertex ")
                 + "endloop\nendfacet\n")
    put("surface", "binary.stl", binary, 0)
    put("surface", "text.stl", (text + "endsolid tet\n").encode(), 0)
    ones = [tuple(p + 1 for p in face) for face in FACES]
    put("surface", "tet.obj", (words(POINTS, "v ") + words(ones, "f ")).encode(), 1)
    put("surface", "groups.obj", ("o a\n" + words(POINTS, "v ") + "vn 0 0 1\nvt 0 0\ng b\ns 1\n"
        + "f 1/1/1 3/1/1 2/1/1\nf -4//1 -3//1 -1//1\n" + words(ones[2:], "f ")).encode(), 1)
    for form in ("ascii", "binary_little_endian", "binary_big_endian"):
        put("surface", form + ".ply", ply(form), 2)
    put("surface", "tet.off", ("OFF\n# small\n4 4 6\n" + words(POINTS)
                               + words(FACES, "3 ")).encode(), 3)


def repairable():
    """A tetrahedron as exporters write it; the last byte chooses whether holes are closed."""
    def text(name, triangles, tail=""):
        put("surface", name, ("solid tet\n" + "".join(
            "facet normal 0 0 0\nouter loop\n" + words(t, "vertex ") + "endloop\nendfacet\n"
            for t in triangles) + "endsolid tet\n" + tail).encode(), 0)

    whole = [tuple(POINTS[p] for p in face) for face in FACES]
    low, high, middle = POINTS[0], POINTS[1], (0.5, 0, 0)
    text("noise.stl", [tuple(tuple(c + 1e-7 * ((7 * n + 3 * k + a) % 5 - 2)
                                   for a, c in enumerate(p)) for k, p in enumerate(t))
                       for n, t in enumerate(whole)])
    text("repeated.stl", whole + [whole[0], whole[1][::-1]])
    text("degenerate.stl", whole + [(low, middle, high), (low, high, low)])
    text("t-junction.stl", [(low, POINTS[2], middle), (middle, POINTS[2], high)] + whole[1:])
    text("turned.stl", [whole[0][::-1]] + whole[1:])
    text("hole.stl", whole[1:])
    text("hole-closed.stl", whole[1:], "!")
    fin = [((0, 0, 0), (1, 0, 0), (0.5, -1, -1))]
    text("sheet-closed.stl", whole + fin, "!")
    other = (1, 1, 1)
    text("wall.stl", whole + [(POINTS[1], POINTS[2], other), (POINTS[2], POINTS[3], other),
                              (POINTS[3], POINTS[1], other)])
    rows = ply("ascii").decode().splitlines()
    put("surface", "damaged-long-row.ply",
        "\n".join(rows[:-1] + [rows[-1] + " 5", ""]).encode(), 2)
    put("surface", "damaged-keyword.off", b"OFF4 4 6\n" + words(POINTS).encode(), 3)
    put("surface", "damaged-index.obj", (words(POINTS, "v ") + "f 1 2 9\n").encode(), 1)


def texts():
    for number, formula in enumerate([
            "x^2+y^2+z^2-0.64", "-log(exp(-8*(x-1))+exp(-8*y))/8", "min(max(x,-y),z^-2)",
            "x<0.5 && y>=z || not(x==y) ? -1 : sqrt(x)", "clamp(x,-1,1)+mix(x,y,z)-if(x,pi,e)",
            "sum(x,y,z)*avg(x,y)/hypot(x,y,z)-fmod(x,0.3)+atan2(y,x)-pow(x,3)",
            "floor(x*3)+tan(y)*acosh(z+2)-rint(1e300*x)", "abs(sin(7*x))+1e-3"]):
        put("formula", f"{number}.txt", formula.encode())
    put("label_names", "snap.txt", b'# labels\n 7 255 0 0 1 1 1 "Left thalamus"\n'
        b'-8 0 0 0 0 0 0 "b"\n')
    put("label_names", "colours.ctbl", b"# Color\n7 Left_thalamus 255 0 0 255\n8 b 1 2 3 0\n")
    put("label_names", "names.txt", b"1 Left thalamus\r\n2 Precentral_L 2001\r\n\n3\tc\n")
    lines = {
        "image": "mesh a.nii --labels 1,5-9,-3--1 --spacing 1,1,0.5 --smooth 0.5 --crop "
                 "0,0,0,1e1,2,3 --max-memory 1.5G --size .5 -o b.vtu --compress --label-names c",
        "shape": "mesh --shape gyroid:1,0.1,2 --bounds -1,-1,-1,1,1,1 --rel-size 0.1 --dry-run "
                 "--cuts midpoint --guarantee embedding --margin 3 --json -",
        "torus": "mesh --shape torus:1,0.4 --target-tets 1000 --format tetgen -o a.node",
        "formula": "mesh --expr x^2-1 --bounds -2,-2,-2,2,2,2 -o a.msh --threads 1",
        "iso": "mesh v.vdb --grid density --iso 0.5 -o a.inp",
        "check": "check a.vtu --json -", "convert": "convert a.vtu -o b.msh --format msh22",
        "picture": "picture a.vtu -o b.png", "report": "report a.vtu --run a.json -o a.html",
        "help": "mesh --help", "version": "--version"}
    for name, line in lines.items():
        put("options", name + ".txt", line.replace(" ", "\n").encode())


def cores():
    """Every choice of options; cells of 3 to 5 along the axes."""
    for number in range(8):
        content = bytes([number, 0b100100 ^ number * 9])
        content += bytes((number * 37 + i * i * 11 + i // 3) % 256 for i in range(60 + 7 * number))
        put("core", f"{number}.bin", content)


with tempfile.TemporaryDirectory() as name:
    meshes(pathlib.Path(name))
images()
surfaces()
repairable()
texts()
cores()
put("planted_reader", "seed.txt", b"L1")
