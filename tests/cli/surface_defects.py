"""What exporters do to surfaces."""

import math
import random

from surfaces import triangles


def turned(surface, shift=(0, 0, 0)):
    """A rotation that leaves no edge along an axis."""
    points = []
    for x, y, z in surface[0]:
        x, y = x * math.cos(0.7) - y * math.sin(0.7), x * math.sin(0.7) + y * math.cos(0.7)
        y, z = y * math.cos(0.4) - z * math.sin(0.4), y * math.sin(0.4) + z * math.cos(0.4)
        points.append((x + shift[0], y + shift[1], z + shift[2]))
    return points, surface[1]


def in_triangles(surface):
    return list(surface[0]), list(triangles(surface[1]))


def soup(surface):
    """Triangles that share no point."""
    points, faces = in_triangles(surface)
    return ([points[p] for face in faces for p in face],
            [(3 * n, 3 * n + 1, 3 * n + 2) for n in range(len(faces))])


def noisy(surface, amount, seed=1):
    """Each triangle has its corners a little elsewhere."""
    chance = random.Random(seed)
    points, faces = soup(surface)
    return [tuple(c + chance.uniform(-amount, amount) for c in p) for p in points], faces


def repeated(surface, count, turn=False, seed=2):
    points, faces = in_triangles(surface)
    return points, faces + [face[::-1] if turn else face
                            for face in random.Random(seed).sample(faces, count)]


def with_degenerate(surface, count, seed=3):
    """Twice as many more triangles without an area: lines there and back, and three points of
    an edge."""
    points, faces = in_triangles(surface)
    for a, b, _ in random.Random(seed).sample(faces, count):
        points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
        faces += [(a, b, a), (a, len(points) - 1, b)]
    return points, faces


def with_t_junctions(surface, count, seed=4):
    """Triangles cut in two, and their neighbours not."""
    points, faces = in_triangles(surface)
    for n in random.Random(seed).sample(range(len(faces)), count):
        a, b, c = faces[n]
        share = (0.5, 0.3, 0.71)[n % 3]
        points.append(tuple(x + share * (y - x) for x, y in zip(points[a], points[b])))
        faces[n] = (a, len(points) - 1, c)
        faces.append((len(points) - 1, b, c))
    return points, faces


def partly_turned(surface, count, seed=5):
    points, faces = in_triangles(surface)
    for n in random.Random(seed).sample(range(len(faces)), count):
        faces[n] = faces[n][::-1]
    return points, faces


def with_holes(surface, count, seed=6):
    points, faces = in_triangles(surface)
    for n in sorted(random.Random(seed).sample(range(len(faces)), count), reverse=True):
        del faces[n]
    return points, faces


def apart(surface, share):
    """Triangles that share no point, each shrunk to its middle."""
    points, faces = soup(surface)
    moved = []
    for face in faces:
        middle = [sum(points[p][a] for p in face) / 3 for a in range(3)]
        moved += [tuple(m + share * (c - m) for c, m in zip(points[p], middle)) for p in face]
    return moved, faces


def lidded(points, faces):
    """With a fan over the one hole, around its middle."""
    edges = {(f[i], f[i - 1]) for f in faces for i in range(len(f))}
    rim = [(b, a) for a, b in edges if (b, a) not in edges]
    middle = tuple(sum(points[a][i] for a, _ in rim) / len(rim) for i in range(3))
    return points + [middle], list(faces) + [(b, a, len(points)) for a, b in rim]
