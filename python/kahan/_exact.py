"""Exact numbers on their way to a question and back."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from fractions import Fraction
from numbers import Integral, Rational
from typing import Any, Union

import numpy as np

__all__ = ["Number", "answer", "exact", "point"]

Number = Union[int, float, Fraction, str]
"""A number as it is given: a float means the decimal that Python prints, 0.1 is 1/10."""

_EXACT = re.compile(r"-?\d+(/\d+)?")


def exact(value: Any, name: str) -> str:
    """The number as text that is read exactly.

    >>> exact(0.1, "eps"), exact(np.float32(0.1), "eps"), exact(Fraction(1, 3), "eps"), exact("-2/7", "eps")
    ('0.1', '0.1', '1/3', '-2/7')
    """
    if isinstance(value, str):
        return value
    if isinstance(value, np.floating) and np.isfinite(value):
        return str(value)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        raise TypeError(f"{name}: a number is needed, not {value}")
    if isinstance(value, Integral):
        return _whole(int(value))
    if isinstance(value, Rational):
        return f"{_whole(int(value.numerator))}/{_whole(int(value.denominator))}"
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError(f"{name}: {value} is no number to compute with")
        return repr(value)
    # SymPy's numbers.
    p, q = getattr(value, "p", None), getattr(value, "q", None)
    if isinstance(p, int) and isinstance(q, int):
        return f"{_whole(p)}/{_whole(q)}"
    if hasattr(value, "__float__") and not isinstance(value, np.ndarray):
        return exact(float(value), name)
    raise TypeError(f"{name}: a number is needed, not {type(value).__name__}")


def point(values: Any, name: str = "x") -> list[str]:
    """The coordinates of a point."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise TypeError(f"{name}: a point is a list or an array with a coordinate for each variable")
    return [exact(value, name) for value in values]


def _whole(value: int) -> str:
    """Digits of an integer, however many: Python itself refuses more than some thousand."""
    try:
        return str(value)
    except ValueError:
        from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, Context

        return f"{Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN).create_decimal(value):f}"


def _int(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        from decimal import Decimal

        return int(Decimal(text))


def _number(text: str) -> Fraction:
    above, _, below = text.partition("/")
    return Fraction(_int(above), _int(below) if below else 1)


def _value(value: Any) -> Any:
    # In answers a text of digits is an exact number, and nothing else is.
    if isinstance(value, str):
        return _number(value) if _EXACT.fullmatch(value) else value
    if isinstance(value, list):
        return [_value(item) for item in value]
    if isinstance(value, dict):
        return {name: _value(item) for name, item in value.items()}
    return value


def answer(text: str) -> dict[str, Any]:
    """The answer to a question, its exact numbers as fractions."""
    found = _value(json.loads(text))
    assert isinstance(found, dict)
    return found
