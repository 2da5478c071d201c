"""From what a caller gives to arrays of floats."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._exact import nearest

__all__ = ["floats"]


def floats(given: Any, name: str) -> np.ndarray[Any, Any]:
    """An array of float32, as it was, or else of float64, in C order.

    Fractions and text become the nearest floats. Raises ``TypeError`` where the numbers are no real
    ones, or their float64 would lose digits.
    """
    array = np.asarray(given)
    if array.dtype.kind in "OU":
        array = np.array([nearest(value, name) for value in array.ravel()], dtype=float).reshape(array.shape)
    if array.dtype.kind not in "fiub" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: real numbers up to float64 are needed, and these are {array.dtype}")
    wanted = np.float32 if array.dtype == np.float32 else np.float64
    return np.ascontiguousarray(array, dtype=wanted).reshape(array.shape)
