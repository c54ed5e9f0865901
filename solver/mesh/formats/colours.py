"""Colours of vertices between formats: red, green, blue, alpha from 0 to 1, as a screen has them.

Formats count them to 1, to 255 or more, and glTF in proportion to light.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from solver.types import FloatArray

_WHOLE = 255


def rgba(values: FloatArray, largest: float = 1.0) -> FloatArray:
    """(n, 4) colours from (n, 3 or 4) numbers up to `largest`; opaque where no alpha is given.

    What is no number is white.
    """
    result = np.ones((len(values), 4))
    result[:, : values.shape[1]] = values / largest
    return np.clip(np.where(np.isnan(result), 1.0, result), 0.0, 1.0)


def rgba_of_text(values: FloatArray) -> FloatArray:
    """As `rgba`, where the file does not say how far they count: to 1 unless one is above."""
    above = bool((values > 1).any())
    return rgba(values, _WHOLE if above else 1.0)


def whole(colours: FloatArray) -> NDArray[np.uint8]:
    """(n, 4) from 0 to 255."""
    return np.rint(_WHOLE * colours).astype(np.uint8)


def to_light(colours: FloatArray) -> FloatArray:
    """In proportion to light: the sRGB curve undone."""
    result, c = colours.copy(), colours[:, :3]
    result[:, :3] = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return result


def from_light(colours: FloatArray) -> FloatArray:
    """From numbers in proportion to light, by the sRGB curve."""
    result, c = colours.copy(), colours[:, :3]
    result[:, :3] = np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)
    return result
