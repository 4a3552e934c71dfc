"""Reads PNG with eight bits a channel, by the standard library alone."""

import struct
import zlib


def read(data):
    """(width, height, channels, rows); each row is a bytearray."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack_from(">IIBB", body)
        elif kind == b"IDAT":
            packed += body
    assert depth == 8
    channels = {2: 3, 6: 4}[color]
    raw, stride = zlib.decompress(packed), width * channels
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        above = _unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above,
                            channels)
        rows.append(above)
    return width, height, channels, rows


def _unfiltered(kind, row, above, channels):
    for i in range(len(row)):
        left = row[i - channels] if i >= channels else 0
        up = above[i]
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        elif kind == 4:
            corner = above[i - channels] if i >= channels else 0
            p = left + up - corner
            guess = min((abs(p - left), 0, left), (abs(p - up), 1, up),
                        (abs(p - corner), 2, corner))[2]
        else:
            guess = 0
        row[i] = (row[i] + guess) & 255
    return row


def pixels(data):
    """All pixels, row by row, as tuples."""
    _, _, channels, rows = read(data)
    return [tuple(row[i:i + channels]) for row in rows for i in range(0, len(row), channels)]
