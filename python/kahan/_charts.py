"""Axes of charts, scans and cycles, and the colors of charts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._exact import Number, exact, whole
from ._orbit import Array

__all__ = ["Range", "axes_of", "colors", "observable", "size"]

Range = str | tuple[Number, Number, int]
"""Values with both ends: (low, high, count), or text in the grammar of the command, as "0:1:/20"."""

_SINGLE = ("sali", "fli", "megno", "lyapunov", "lyapunov_error", "mean_log_det", "escape", "passed_poles")
"""The colors of charts that have no name of a field."""

_COLUMNS = {"escape": "escaped", "log_det": "mean_log_det"}


def colors(variables: Iterable[str], integrals: Iterable[str]) -> list[str]:
    """The columns that a chart can show."""
    variables = list(variables)
    of: dict[str, Iterable[Any]] = {name: variables for name in ("final", "least", "greatest", "rotation")}
    of |= {"drift": integrals, "spectrum": range(1, 1 + len(variables))}
    return [*_SINGLE, *(f"{start}_{name}" for start, names in of.items() for name in names)]


def observable(color: str) -> tuple[str, str]:
    """The observable of a color, and its column."""
    for start, name in (("drift", "drift"), ("spectrum_", "spectrum"), ("least_", "extrema"), ("greatest_", "extrema"),
                              ("rotation_", "rotation"), ("final_", "final"), ("mean_log_det", "log_det")):
        if color.startswith(start):
            return name, color
    return ("lyapunov" if color == "lyapunov_error" else color), _COLUMNS.get(color, color)


def size(values: Range | Array) -> int | None:
    """The number of values of an axis; ``None`` for text, whose values the library counts."""
    if isinstance(values, str):
        return None
    return int(values[2]) if isinstance(values, tuple) else np.asarray(values).size


def axes_of(over: Mapping[str, Range | Array] | None, has_lists: bool = True) -> dict[str, str | list[str]]:
    """The axes of a question, exactly."""
    def axis(name: str, values: Range | Array) -> str | list[str]:
        if isinstance(values, str):
            return values
        if not isinstance(values, tuple) and has_lists:
            return [exact(value, name) for value in np.asarray(values).ravel()]
        if not isinstance(values, tuple) or len(values) != 3:
            lists = "an array, " if has_lists else ""
            raise TypeError(f'over: {name} is (low, high, count), {lists}or text as "0:1:+1/10"')
        low, high, count = values
        return f"{exact(low, name)}:{exact(high, name)}:{whole(count, name)}"

    return {name: axis(name, values) for name, values in (over or {}).items()}
