"""Triangle surfaces, and files of them."""

import math
import struct


def cube(low=(0, 0, 0), high=(1, 1, 1)):
    """Points and quads, anticlockwise seen from outside."""
    points = [tuple(high[a] if corner >> a & 1 else low[a] for a in range(3))
              for corner in range(8)]
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return points, quads


def torus(major=1.0, minor=0.4, around=96, across=48):
    points = []
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            ring = major + minor * math.cos(v)
            points.append((ring * math.cos(u), ring * math.sin(u), minor * math.sin(v)))
    quads = []
    for i in range(around):
        for j in range(across):
            k, l = (i + 1) % around, (j + 1) % across
            quads.append((i * across + j, k * across + j, k * across + l, i * across + l))
    return points, quads


def octahedron(center=(0, 0, 0), radius=1.0):
    x, y, z = center
    points = [(x + radius, y, z), (x - radius, y, z), (x, y + radius, z),
              (x, y - radius, z), (x, y, z + radius), (x, y, z - radius)]
    return points, [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4),
                    (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]


def sphere(radius=1.0, rounds=4):
    """An octahedron, its triangles cut in four and its points moved out."""
    points, faces = octahedron()
    for _ in range(rounds):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                sums = [p + q for p, q in zip(points[a], points[b])]
                length = math.sqrt(sum(s * s for s in sums))
                points.append(tuple(s / length for s in sums))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return [tuple(radius * c for c in p) for p in points], faces


def triangles(faces):
    return [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]


def join(*surfaces):
    points, faces = [], []
    for more, its in surfaces:
        faces += [tuple(len(points) + p for p in f) for f in its]
        points = points + list(more)
    return points, faces


def inside_out(surface):
    return surface[0], [f[::-1] for f in surface[1]]


def volume(surface):
    points, faces = surface
    six = 0.0
    for a, b, c in ([points[p] for p in t] for t in triangles(faces)):
        six += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return six / 6


def stl(surface):
    points, faces = surface
    flat = triangles(faces)
    head = b"certet".ljust(80, b"\0") + struct.pack("<I", len(flat))
    return head + b"".join(
        struct.pack("<12fH", 0, 0, 0, *points[a], *points[b], *points[c], 0)
        for a, b, c in flat)


def ascii_stl(surface):
    points, faces = surface
    lines = ["solid part"]
    for t in triangles(faces):
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex %.9g %.9g %.9g" % points[p] for p in t]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid part", ""]).encode()


def obj(surface):
    points, faces = surface
    lines = ["v %.9g %.9g %.9g" % p for p in points]
    lines += ["f " + " ".join(str(p + 1) for p in f) for f in faces]
    return "\n".join(lines + [""]).encode()


def off(surface):
    points, faces = surface
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += ["%.9g %.9g %.9g" % p for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines + [""]).encode()


def ply_header(form, points, faces):
    return (f"ply\nformat {form} 1.0\nelement vertex {points}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n")


def ply(surface):
    points, faces = surface
    head = ply_header("binary_little_endian", len(points), len(faces)).encode()
    return (head + b"".join(struct.pack("<3f", *p) for p in points)
            + b"".join(struct.pack(f"<B{len(f)}i", len(f), *f) for f in faces))


def ascii_ply(surface):
    points, faces = surface
    lines = ["%.9g %.9g %.9g" % p for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return (ply_header("ascii", len(points), len(faces)) + "\n".join(lines + [""])).encode()


WRITERS = {"binary.stl": stl, "ascii.stl": ascii_stl, "a.obj": obj, "a.off": off,
           "binary.ply": ply, "ascii.ply": ascii_ply}
