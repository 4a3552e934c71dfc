"""Drawings as SVG: what all pictures have in common."""

from math import cos, radians, sin

INSIDE, SURFACE, OUTSIDE = "#1f6fb2", "#e08a00", "#8a939c"
INK, SOFT, LINE, PAPER = "#1c2733", "#5b6773", "#c3cad1", "#ffffff"
SIGN_COLOUR = {"+": INSIDE, "0": SURFACE, "-": OUTSIDE}
TET_COLOURS = ["#4f9bd9", "#57b894", "#c98bd0"]


def number(x):
    """With one decimal, and none where it is 0, so that files do not depend on rounding."""
    text = f"{x:.1f}"
    return "0" if text in ("-0.0", "0.0") else text.removesuffix(".0")


class Picture:
    def __init__(self, width, height, title):
        self.width, self.height, self.title, self.parts = width, height, title, []

    def add(self, name, content=None, **attributes):
        text = "".join(f' {key.rstrip("_").replace("_", "-")}="{number(v) if isinstance(v, (int, float)) else v}"'
                       for key, v in attributes.items())
        self.parts.append(f"<{name}{text}/>" if content is None else f"<{name}{text}>{content}</{name}>")

    def line(self, a, b, colour=INK, width=1.5, **more):
        self.add("line", x1=a[0], y1=a[1], x2=b[0], y2=b[1], stroke=colour, stroke_width=width,
                 stroke_linecap="round", **more)

    def polygon(self, points, fill, opacity=1, stroke="none", width=1, **more):
        self.add("polygon", points=" ".join(f"{number(x)},{number(y)}" for x, y in points), fill=fill,
                 fill_opacity=str(opacity), stroke=stroke, stroke_width=width, stroke_linejoin="round", **more)

    def rect(self, x, y, width, height, fill="none", stroke="none", radius=0, **more):
        self.add("rect", x=x, y=y, width=width, height=height, rx=radius, fill=fill, stroke=stroke, **more)

    def dot(self, at, radius, fill, stroke="none", width=1.5):
        self.add("circle", cx=at[0], cy=at[1], r=radius, fill=fill, stroke=stroke, stroke_width=width)

    def text(self, at, words, size=14, colour=INK, anchor="start", weight="400", mono=False, halo=False):
        words = words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        more = {"font_family": "DejaVu Sans Mono, monospace"} if mono else {}
        if halo:
            more |= {"stroke": PAPER, "stroke_width": 3, "paint_order": "stroke", "stroke_linejoin": "round"}
        self.add("text", words, x=at[0], y=at[1], font_size=size, fill=colour, text_anchor=anchor,
                 font_weight=weight, **more)

    def lines(self, at, lines):
        """Sentences below one another."""
        for n, words in enumerate(lines):
            self.text((at[0], at[1] + 20 * n), words, 13.5, SOFT)

    def indices(self, left, y, cell, count):
        """Above the cells of a row: 0 to count - 1."""
        for i in range(count):
            self.text((left + cell * (i + 0.5), y), str(i), 12, SOFT, "middle", mono=True)

    def arrow(self, a, b, colour=INK, width=1.8):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = (dx * dx + dy * dy) ** 0.5
        ux, uy, head = dx / length, dy / length, 4 + 2 * width
        base = (b[0] - head * ux, b[1] - head * uy)
        self.line(a, base, colour, width)
        self.polygon([b, (base[0] - 0.45 * head * uy, base[1] + 0.45 * head * ux),
                      (base[0] + 0.45 * head * uy, base[1] - 0.45 * head * ux)], colour)

    def sign(self, at, sign, radius=6):
        """A point inside (+), on the surface (0) or outside (-)."""
        if sign == "-":
            self.dot(at, radius - 0.8, PAPER, OUTSIDE, 1.6)
        else:
            self.dot(at, radius, SIGN_COLOUR[sign], PAPER, 1)

    def heading(self, at, words):
        self.text(at, words, 17, INK, weight="700")

    def __str__(self):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                f'width="{self.width}" height="{self.height}" font-family="DejaVu Sans, Helvetica, Arial, sans-serif">\n'
                f"<title>{self.title}</title>\n"
                f'<rect width="{self.width}" height="{self.height}" fill="{PAPER}"/>\n'
                + "\n".join(self.parts) + "\n</svg>\n")


class View:
    """A parallel projection; `depth` grows away from the eye."""

    def __init__(self, centre, scale, turn=-24, tilt=18, at=(0, 0, 0)):
        self.centre, self.scale, self.at = centre, scale, at
        self.c, self.s = cos(radians(turn)), sin(radians(turn))
        self.ct, self.st = cos(radians(tilt)), sin(radians(tilt))

    def _turned(self, p):
        x, y, z = (a - b for a, b in zip(p, self.at))
        return self.c * x - self.s * y, self.s * x + self.c * y, z

    def __call__(self, p):
        x, y, z = self._turned(p)
        return self.centre[0] + self.scale * x, self.centre[1] - self.scale * (self.ct * z + self.st * y)

    def depth(self, p):
        _, y, z = self._turned(p)
        return self.ct * y - self.st * z


def mean(points):
    return tuple(sum(c) / len(points) for c in zip(*points))


def between(a, b, t):
    return tuple(x + t * (y - x) for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def tetrahedron(picture, view, corners, fill, opacity=0.55, edge=INK, width=1.4):
    """Its faces from back to front; the hidden ones show through."""
    faces = [[corners[n] for n in range(4) if n != across] for across in range(4)]
    for face in sorted(faces, key=lambda f: -view.depth(mean(f))):
        picture.polygon([view(p) for p in face], fill, opacity, edge, width)


def explained(width, height, title, heading, lines):
    """A picture with a heading, and sentences below it."""
    picture = Picture(width, height, title)
    picture.heading((30, 40), heading)
    picture.lines((30, 66), lines)
    return picture
