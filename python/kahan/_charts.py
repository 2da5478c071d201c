"""The axes of charts, scans and cycles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._exact import Number, exact, whole
from ._orbit import Array

__all__ = ["Range", "axes_of", "size"]

Range = str | tuple[Number, Number, int]
"""A range (low, high, count) that includes both ends, or text as in the command: "0:1:/20"."""

def size(values: Range | Array) -> int | None:
    """Returns the number of values of an axis; ``None`` for text, which the library evaluates."""
    if isinstance(values, str):
        return None
    return int(values[2]) if isinstance(values, tuple) else np.asarray(values).size


def axes_of(over: Mapping[str, Range | Array] | None, has_lists: bool = True) -> dict[str, str | list[str]]:
    """Returns the axes of a question, with exact numbers."""
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
