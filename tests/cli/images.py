"""Small images, written byte by byte."""

import gzip
import math
import struct
import zlib

NRRD_TYPES = {"B": "uchar", "b": "signed char", "H": "ushort", "h": "short",
              "I": "uint", "i": "int", "q": "longlong", "f": "float", "d": "double"}

IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def voxels(size, value):
    """Values in file order: the first axis runs fastest."""
    return [value(i, j, k) for k in range(size[2]) for j in range(size[1])
            for i in range(size[0])]


def write_nrrd(path, size, values, kind="h", directions=IDENTITY, origin=(0, 0, 0),
               packed=False, cut=0):
    """`directions` are the steps of the three axes, spacing included."""
    data = struct.pack(f"<{len(values)}{kind}", *values)
    if packed:
        data = gzip.compress(data)
    vectors = " ".join("(" + ",".join(map(str, v)) + ")" for v in directions)
    header = (f"NRRD0004\ntype: {NRRD_TYPES[kind]}\ndimension: {len(size)}\n"
              f"space: left-posterior-superior\nsizes: {' '.join(map(str, size))}\n"
              f"space directions: {vectors}\nendian: little\n"
              f"encoding: {'gzip' if packed else 'raw'}\n"
              f"space origin: ({','.join(map(str, origin))})\n\n")
    path.write_bytes(header.encode() + data[:len(data) - cut])


def read_bytes_of_nrrd(path):
    """The voxels of one whose numbers have a byte each, packed by gzip."""
    header, data = path.read_bytes().split(b"\n\n", 1)
    lines = header.decode().splitlines()
    assert "encoding: gzip" in lines and "type: unsigned char" in lines, header
    return list(gzip.decompress(data))


def write_plain_nrrd(path, size, kind="B"):
    """An image of any dimension, without a space."""
    count = math.prod(size)
    header = (f"NRRD0004\ntype: {NRRD_TYPES[kind]}\ndimension: {len(size)}\n"
              f"sizes: {' '.join(map(str, size))}\nendian: little\nencoding: raw\n\n")
    path.write_bytes(header.encode() + bytes(count * struct.calcsize(kind)))


def write_meta(path, size, values, kind="h", spacing=(1, 1, 1), matrix=IDENTITY, channels=1,
               packed=False, cut=0):
    types = {"B": "MET_UCHAR", "h": "MET_SHORT", "f": "MET_FLOAT"}
    data = struct.pack(f"<{len(values)}{kind}", *values)
    if packed:
        data = zlib.compress(data)
    header = (f"ObjectType = Image\nNDims = {len(size)}\nBinaryData = True\n"
              f"BinaryDataByteOrderMSB = False\nCompressedData = {packed}\n"
              f"TransformMatrix = {' '.join(str(x) for row in matrix for x in row)}\n"
              f"Offset = 0 0 0\nElementSpacing = {' '.join(map(str, spacing))}\n"
              f"DimSize = {' '.join(map(str, size))}\n"
              f"ElementNumberOfChannels = {channels}\n"
              f"ElementType = {types[kind]}\nElementDataFile = LOCAL\n")
    path.write_bytes(header.encode() + data[:len(data) - cut])


def write_nifti(path, size, values, spacing=(1, 1, 1), cut=0, order="<"):
    """int16 voxels; axes along the world's (RAS, so x and y turn round in LPS)."""
    header = bytearray(352)
    struct.pack_into(f"{order}i", header, 0, 348)
    struct.pack_into(f"{order}8h", header, 40, 3, *size, 1, 1, 1, 1)
    struct.pack_into(f"{order}2h", header, 70, 4, 16)
    struct.pack_into(f"{order}8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into(f"{order}2f", header, 108, 352, 1)
    struct.pack_into(f"{order}2h", header, 252, 1, 0)
    header[123] = 2  # millimetres
    header[344:348] = b"n+1\0"
    data = bytes(header) + struct.pack(f"{order}{len(values)}h", *values)
    if path.name.endswith(".gz"):
        data = gzip.compress(data)
    path.write_bytes(data[:len(data) - cut])
