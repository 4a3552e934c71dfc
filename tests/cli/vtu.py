"""Reads and damages .vtu files as `certet` writes them: raw appended data, each
array behind a 64-bit count of its bytes."""

import re
import struct


def arrays(path):
    """Name -> (offset of the numbers in the file, bytes, VTK type)."""
    data = path.read_bytes()
    start = data.index(b'<AppendedData encoding="raw">')
    start = data.index(b"_", start) + 1
    head = data[:start].decode()
    found = {}
    for tag in re.findall(r"<DataArray[^>]*>", head):
        fields = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        at = start + int(fields["offset"])
        (count,) = struct.unpack_from("<Q", data, at)
        found[fields.get("Name", "points")] = (at + 8, count, fields["type"])
    return data, found


def numbers(path, name):
    data, found = arrays(path)
    at, count, kind = found[name]
    code = {"Float64": "d", "Int32": "i", "UInt32": "I", "Int64": "q", "UInt64": "Q",
            "UInt8": "B", "Int8": "b"}[kind]
    return list(struct.unpack_from(f"<{count // struct.calcsize(code)}{code}", data, at))


def points(path):
    flat = numbers(path, "points") if "points" in arrays(path)[1] else numbers(path, "Points")
    return list(zip(flat[0::3], flat[1::3], flat[2::3]))


def tets(path):
    flat = numbers(path, "connectivity")
    return list(zip(flat[0::4], flat[1::4], flat[2::4], flat[3::4]))


def overwrite(path, name, item, code, value):
    """Puts `value` in the place of one number of an array."""
    data, found = arrays(path)
    data = bytearray(data)
    struct.pack_into("<" + code, data, found[name][0] + item * struct.calcsize(code), value)
    path.write_bytes(data)
