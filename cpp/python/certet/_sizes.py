"""Sizes that vary from place to place."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _certet

SizeField = Union[str, Callable[[NDArray[np.float64]], ArrayLike], tuple[Any, ...]]


def size_field(value: SizeField | None) -> _certet.SizeField | None:
    """A formula, a function of points, or an array of numbers with spacing and origin."""
    if value is None:
        return None
    if isinstance(value, str):
        return _certet.size_field_of_formula(value)
    if callable(value):
        return _certet.size_field_of_function(value)
    if isinstance(value, tuple) and 3 <= len(value) <= 4:
        array, spacing, origin, direction = (*value, None)[:4]
        if np.ndim(array) == 3:
            return _certet.size_field_of_image(
                _arguments.voxels(array, [], [], gray=True),
                _arguments.three("spacing", spacing, one_will_do=True),
                _arguments.three("origin", origin), _arguments.direction(direction))
    raise ValueError("size_field is a formula, a function of points, or (array, spacing, origin) or "
                     "(array, spacing, origin, direction) with an array of three axes")
