"""From what a caller gives to arrays of floats."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import unknown
from ._exact import nearest

__all__ = ["floats", "named"]


def _columns(given: Any) -> list[Any]:
    """The names of the columns of a table of pandas, polars or Arrow, or of a structured array; none
    elsewhere."""
    if isinstance(given, np.ndarray):
        return list(given.dtype.names or ())
    for attribute in ("columns", "column_names"):
        columns = getattr(given, attribute, None)
        if columns is not None and not callable(columns) and all(isinstance(name, str) for name in columns):
            return list(columns)
    return []


def _names(given: Any) -> list[Any]:
    """The same, or the names of the entries of a mapping or a series."""
    if isinstance(given, Mapping):
        return list(given)
    index = getattr(given, "index", None)
    if index is None or callable(index) or hasattr(given, "columns"):
        return _columns(given)
    return list(index) if all(isinstance(name, str) for name in index) else []


def named(given: Any, variables: Sequence[str], others: Sequence[str], name: str = "x") -> Any:
    """What was given, in the order of the variables where it has names.

    Raises ``ValueError`` for a variable that no column or more than one has, and for a column of a name
    among ``others``, which mean something else in the field.
    """
    names = _names(given)
    if not names:
        return given
    for other in others:
        if other in names:
            raise ValueError(f"{name}: the column `{other}` is no variable, and rows are points; leave it out, and give {other} "
                             "by name")
    for variable in variables:
        if names.count(variable) != 1:
            wrong = unknown("column", variable, names) if variable not in names else f"there are two columns `{variable}`"
            raise ValueError(f"{name}: {wrong}")
    return np.stack([np.asarray(given[variable]) for variable in variables], axis=-1)


def floats(given: Any, name: str) -> np.ndarray[Any, Any]:
    """An array of float32, as it was, or else of float64, in C order.

    Fractions and text become the nearest floats. Raises ``TypeError`` where the numbers are no real
    ones, or their float64 would lose digits.
    """
    names = _columns(given)
    if names:
        raise TypeError(f"{name}: numbers are taken in order here, and these have the names {', '.join(map(str, names))}; "
                        "give their values as an array")
    array = np.asarray(given)
    if array.dtype.kind in "OU":
        array = np.array([nearest(value, name) for value in array.ravel()], dtype=float).reshape(array.shape)
    if array.dtype.kind not in "fiub" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: real numbers up to float64 are needed, and these are {array.dtype}")
    wanted = np.float32 if array.dtype == np.float32 else np.float64
    return np.ascontiguousarray(array, dtype=wanted).reshape(array.shape)
