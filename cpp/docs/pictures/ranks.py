"""How points are numbered: by row, kind and rank, with words of bits and counts of bits."""

from svg import INK, INSIDE, LINE, PAPER, SOFT, explained

BITS = 16  # of a word, which has 64
ACCENT = "#b03a8c"


def solid(i, j, grid):
    """A row of signs that is worth looking at: inside is +."""
    x, y = i + 0.5 * grid, j + 0.5 * grid
    return (x - 5.3) ** 2 + (y + 1.9) ** 2 < 15.2 or (x - 12.4) ** 2 + (y + 0.9) ** 2 < 2.25


def kinds():
    """The kinds of points that the picture shows: name, its mask as a list of bits."""
    even = [solid(i, 0, 0) for i in range(BITS + 1)]
    odd = [solid(i, 0, 1) for i in range(BITS + 1)]
    above = [solid(i, 1, 0) for i in range(BITS + 1)]
    cut = lambda a, b: [p != q for p, q in zip(a, b)]
    return [("even corners", even[:BITS]), ("odd corners", odd[:BITS]),
            ("cuts even → even, along x", cut(even[:BITS], even[1:])),
            ("cuts even → even, along y", cut(even[:BITS], above[:BITS])),
            ("cuts odd → odd, along x", cut(odd[:BITS], odd[1:])),
            ("cuts odd → even, corner 0", cut(odd[:BITS], even[:BITS])),
            ("cuts odd → even, corner 1", cut(odd[:BITS], even[1:]))]


def draw(_):
    picture = explained(1080, 628, "Numbering by rank",
                        "Numbering by rank: a point's number is computed, never looked up", (
        "The points of a row (j, k) stand kind by kind: corners of each grid, then the cuts of each family of edges. "
        "A kind has a",
        "word of bits for every 64 indices i: bit i is set where the index owns a point of that kind. Before a word "
        "come as many points",
        "as the row has in the kinds and words before it. (Here a word has 16 bits, and 7 of the 16 kinds are "
        "shown.)"))
    left, top, cell, high = 330, 168, 33, 34
    picture.indices(left, top - 12, cell, BITS)
    picture.text((left - 18, top - 12), "index i", 12, SOFT, "end")
    picture.text((left + cell * BITS + 50, top - 12), "before", 13, INK, "middle", "700")
    picture.text((left + cell * BITS + 120, top - 12), "popcount", 13, INK, "middle", "700")
    shown, bit = 3, 12
    before, rows = 0, kinds()
    for n, (name, mask) in enumerate(rows):
        y = top + (high + 7) * n
        picture.text((left - 18, y + 22), name, 14, INK, "end", "700" if n == shown else "400")
        rank = 0
        for i in range(BITS):
            x = left + cell * i
            part = n == shown and i < bit
            picture.rect(x + 1, y, cell - 2, high, "#fbe9f5" if part else PAPER, LINE, 3)
            if mask[i]:
                chosen = n == shown and i == bit
                colour = ACCENT if chosen else INSIDE if n < 2 else "#c0392b"
                picture.rect(x + 4, y + 3, cell - 8, high - 6, colour, "none", 3)
                picture.text((x + cell / 2, y + 22), str(before + rank), 13, PAPER, "middle", "700", mono=True)
                rank += 1
        picture.text((left + cell * BITS + 50, y + 22), str(before), 14, INK, "middle",
                     "700" if n == shown else "400", mono=True)
        picture.text((left + cell * BITS + 120, y + 22), str(rank), 14, SOFT, "middle", mono=True)
        if n == shown:
            found = (before, sum(mask[:bit]))
            middle = y + high
        before += rank
    total = before
    # The brace under the bits below.
    x0, x1 = left + 2, left + cell * bit - 2
    picture.line((x0, middle + 4), (x1, middle + 4), ACCENT, 2.4)
    y = top + (high + 7) * len(rows) + 28
    picture.text((30, y), f"The cut that index {bit} owns along y:", 15, INK, weight="700")
    picture.text((30, y + 30), "number = first point of row (j, k) + before + popcount(mask & below(b))", 16, INK, mono=True)
    picture.text((106, y + 56), f"= first point of row (j, k) + {found[0]} + {found[1]}", 16, ACCENT, mono=True)
    picture.lines((30, y + 84), (
        f"The colour behind a row marks below({bit}), the bits before it, of which {found[1]} are set. The row has {total} "
        "points in all.",
        "Whoever meets the edge from another index, of the row before or the layer before, shifts the index to the "
        "owner's and gets the same number."))
    picture.height = int(y + 124)
    return picture
