"""What users pass, as what the library takes.  What is neither is a ValueError, in words."""

from __future__ import annotations

import operator
import reprlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float, float]
Range = tuple[int, int]
Merge = tuple[int, int, int, str]

_LEAST, _GREATEST = -2**31, 2**31 - 1  # labels


def number(name: str, value: Any) -> float:
    """A finite number."""
    wide = np.asarray(value)
    if wide.ndim != 0 or wide.dtype.kind not in "biuf" or not np.isfinite(wide):
        raise ValueError(f"{name} is a finite number, not {_shown(value)}")
    return float(wide)


def whole(name: str, value: Any) -> int:
    """A whole number, of whatever type."""
    try:
        if isinstance(value, (float, np.floating)) and float(value).is_integer():
            return int(value)
        return operator.index(value)
    except TypeError:
        raise ValueError(f"{name} is a whole number, not {_shown(value)}") from None


def batch(value: Any) -> int:
    number = whole("batch", value)
    if number < 1:
        raise ValueError(f"batch is a number of points, at least 1, not {number}")
    return number


def count(name: str, value: Any) -> int:
    """A whole number of at least 1."""
    number = whole(name, value)
    if not 1 <= number < 2**63:
        raise ValueError(f"{name} is a whole number of at least 1, not {number}")
    return number


def keep(value: Any) -> str:
    """Which pieces stay, as the command's --keep has it."""
    return value if isinstance(value, str) else str(count("keep", value))


def angle(name: str, value: Any) -> float:
    """Degrees, from 1 to 179."""
    try:
        degrees = float(value)
    except (TypeError, ValueError):
        degrees = float("nan")
    if isinstance(value, (bool, np.bool_)) or not 1 <= degrees <= 179:
        raise ValueError(f"{name} is 'auto', 'off' or an angle from 1 to 179 degrees, "
                         f"not {_shown(value)}")
    return degrees


def word(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{name} is a word, not {_shown(value)}")
    return value


def patches(where: Any) -> list[tuple[str, str]]:
    """Names of patches and where they are, each as a word of the command line."""
    if not isinstance(where, Mapping):
        raise ValueError(f"patches are named by a dict, not {_shown(where)}")
    return [(word("the name of a patch", name), _place(name, place))
            for name, place in where.items()]


def _place(name: str, place: Any) -> str:
    if isinstance(place, str):
        return place
    try:
        axis, at = place
    except (TypeError, ValueError):
        raise ValueError(f"the patch {name!r} is a word or an axis and a coordinate, "
                         f"not {_shown(place)}") from None
    return f"{word('the axis of a patch', axis)}:{number('the coordinate of a patch', at)!r}"


def size(value: Any) -> float:
    """The library takes 0 for its own choice; a user who writes 0 is mistaken."""
    if value is None:
        return 0.0
    if not number("size", value) > 0:
        raise ValueError(f"size must be a positive number, not {_shown(value)}")
    return float(value)


def three(name: str, value: Any, *, one_will_do: bool = False) -> Point:
    """Three numbers; one is taken for all three where that makes sense."""
    numbers = _real(name, value)
    if numbers.ndim == 0 and one_will_do:
        numbers = np.full(3, numbers)
    if numbers.shape != (3,):
        raise ValueError(f"{name} is three numbers, not {_shown(value)}")
    x, y, z = numbers.tolist()
    return x, y, z


def shape(value: Any) -> tuple[int, int, int]:
    """Of an array with three axes."""
    if not hasattr(value, "__len__") or isinstance(value, str) or len(value) != 3:
        raise ValueError(f"a shape is three whole numbers, not {_shown(value)}")
    x, y, z = (whole("a shape's number", one) for one in value)
    if min(x, y, z) < 1:
        raise ValueError(f"a shape is three positive numbers, not {_shown(value)}")
    if max(x, y, z) > 2**18:
        raise MemoryError(f"a shape has at most {2**18} voxels along an axis, not {max(x, y, z)}")
    return x, y, z


def bounds(value: Any) -> tuple[Point, Point]:
    """Two corners, or the six numbers of the command's --bounds."""
    numbers = _real("bounds", value)
    if numbers.shape == (6,):
        numbers = numbers.reshape(2, 3)
    if numbers.shape != (2, 3):
        raise ValueError("bounds is ((x0, y0, z0), (x1, y1, z1)) or x0, y0, z0, x1, y1, z1, "
                         f"not {_shown(value)}")
    return three("bounds", numbers[0]), three("bounds", numbers[1])


def direction(value: Any) -> list[list[float]]:
    axes = np.eye(3) if value is None else _real("direction", value)
    if axes.shape != (3, 3):
        raise ValueError(f"direction is three rows of three numbers, not {_shown(value)}")
    rows: list[list[float]] = axes.tolist()
    return rows


def labels(value: Any) -> list[Range]:
    """Labels and pairs (first, last) of them, or one label; none: all but 0."""
    if value is None:
        return []
    if _is_one(value):
        value = [value]
    if isinstance(value, (str, bytes, dict)):
        raise ValueError(f"labels is a list of labels and pairs (first, last), like [1, (5, 9)], "
                         f"not {_shown(value)}")
    ranges = [_range(one) for one in value]
    if not ranges:
        raise ValueError("labels is empty: no voxel is chosen")
    return ranges


def levels(value: Any) -> tuple[float, float] | None:
    """What gray values are above and below, which may be infinite: of a number, or of a pair of
    which one may be None."""
    if value is None:
        return None
    if isinstance(value, tuple) and len(value) == 2 and value != (None, None):
        above, below = value
        return (-np.inf if above is None else number("iso", above),
                np.inf if below is None else number("iso", below))
    if isinstance(value, (tuple, list)):
        raise ValueError(f"iso is a number or a pair (above, below), not {_shown(value)}")
    return number("iso", value), np.inf


def merges(value: Any) -> list[Merge]:
    """Labels, or pairs (first, last) of them, and what they become: a label or a name."""
    if value is None:
        return []
    if not isinstance(value, dict):
        raise ValueError("merge is a dict of labels and pairs (first, last) to labels and names, "
                         f"like {{(1, 5): 'bone', 7: 9}}, not {_shown(value)}")
    result: list[Merge] = []
    named: dict[str, int] = {}
    for labels_before, after in value.items():
        first, last = _range(labels_before)
        if isinstance(after, str):
            result.append((first, last, named.setdefault(after, first), after))
        else:
            result.append((first, last, whole("a label", after), ""))
    return result


def voxels(array: Any, ranges: list[Range], merged: list[Merge], *, gray: bool) -> NDArray[Any]:
    """An array of a type that images have.  What is masked is outside; floating point numbers
    are labels where all are whole and the image is not gray."""
    mask = np.ma.getmask(array)
    array = np.asarray(np.ma.getdata(array))
    kind, bytes_each = array.dtype.kind, array.dtype.itemsize
    if kind == "c":
        raise ValueError("the array's numbers are complex: take .real of it, or abs(...)")
    if kind not in "biuf":
        raise ValueError(f"the array's numbers are of type '{array.dtype}', which no image has")
    if gray and np.any(mask):
        raise ValueError("what is masked has no value to put a level beside: give it one with "
                         "array.filled(value), below iso where it is outside")
    if kind == "f":
        array = array.astype(np.float64 if bytes_each > 4 else np.float32, copy=False)
        if not gray:
            array = _whole_labels(array, mask)
    elif bytes_each == 8:
        array = array.astype(np.float64) if gray else _narrow_labels(array, mask)
    if np.any(mask):
        array = np.where(mask, _no_label(ranges, merged), array)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def signs(function: Callable[[NDArray[np.float64]], Any],
           ) -> Callable[[NDArray[np.float64]], NDArray[Any]]:
    """The function with numbers that are negative inside: True is inside, what is masked is
    outside, complex numbers are refused."""
    def level(points: NDArray[np.float64]) -> NDArray[Any]:
        values = function(points)
        mask = np.ma.getmask(values)
        values = np.asarray(np.ma.getdata(values))
        if values.dtype.kind == "b":
            values = np.where(values, -1.0, 1.0)
        elif values.dtype.kind not in "iuf":
            raise ValueError(f"the function gave values of type '{values.dtype}', where numbers "
                             "that are negative inside, or truth values that are True there, "
                             "are wanted")
        return np.where(mask, np.nan, values) if np.any(mask) else values

    return level


def points(value: Any) -> NDArray[np.float64]:
    return _real("points", value)


def triangles(value: Any) -> NDArray[np.int64]:
    numbers = np.asarray(value)
    if np.any(np.ma.getmask(value)) or numbers.dtype.kind not in "iuf" or (
            numbers.dtype.kind == "f" and not np.equal(numbers, np.floor(numbers)).all()):
        raise ValueError(f"triangles are whole numbers of points, not {_shown(value)}")
    return numbers.astype(np.int64)


def _real(name: str, value: Any) -> NDArray[np.float64]:
    """Real numbers of any shape; no imaginary part, mask or text is dropped on the way."""
    try:
        numbers = np.asarray(value)
    except ValueError:  # rows of different lengths
        numbers = np.asarray(None)
    if numbers.dtype.kind == "c":
        raise ValueError(f"{name} has complex numbers, where real ones are wanted")
    if numbers.dtype.kind not in "biuf":
        raise ValueError(f"{name} is made of numbers, not {_shown(value)}")
    if np.any(np.ma.getmask(value)):
        raise ValueError(f"{name} has masked numbers, which have no place")
    return numbers.astype(np.float64)


def _is_one(value: Any) -> bool:
    return value.ndim == 0 if isinstance(value, np.ndarray) else not hasattr(value, "__iter__")


def _range(value: Any) -> Range:
    if _is_one(value):
        label = whole("a label", value)
        return label, label
    ends = [whole("a label", end) for end in value]
    if len(ends) != 2 or ends[0] > ends[1]:
        raise ValueError(f"a range of labels is (first, last), not {_shown(value)}")
    return ends[0], ends[1]


def _whole_labels(array: NDArray[Any], mask: Any) -> NDArray[Any]:
    with np.errstate(invalid="ignore"):
        misfits = ~((array == np.floor(array)) & (array >= _LEAST) & (array <= _GREATEST)) & ~mask
    if misfits.any():
        first = np.unravel_index(misfits.argmax(), array.shape)
        raise ValueError(
            f"the array has {misfits.sum()} voxels that are no labels, for they are not whole "
            f"numbers of 32 bits, the first {array[first]} at {[int(i) for i in first]}; iso=V "
            "takes what is above a value")
    return np.where(mask, 0, array).astype(np.int32) if np.any(mask) else array.astype(np.int32)


def _narrow_labels(array: NDArray[Any], mask: Any) -> NDArray[Any]:
    kept = array[~mask] if np.any(mask) else array
    for label in (kept.min(), kept.max()) if kept.size else ():
        if not _LEAST <= label <= _GREATEST:
            raise ValueError(f"the array has label {label}, which does not fit 32 bits with a sign")
    return array.astype(np.int32)


def _no_label(ranges: list[Range], merged: list[Merge]) -> np.int32:
    """A label that is not chosen, and does not become one that is."""
    taken = [*ranges, *(merge[:2] for merge in merged)]
    ends = [0]
    if ranges:
        ends += [end for first, last in taken for end in (first - 1, last + 1)]
    for label in ends:
        if _LEAST <= label <= _GREATEST and not any(a <= label <= b for a, b in taken):
            return np.int32(label)
    raise ValueError("all labels are chosen or merged, so that none is left for what is masked")


def _shown(value: Any) -> str:
    return reprlib.repr(value).replace("\n", " ")
