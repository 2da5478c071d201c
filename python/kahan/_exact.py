"""Conversion of exact numbers for questions and answers."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, Context, Decimal
from fractions import Fraction
from numbers import Integral, Rational
from operator import index
from typing import Any, Union

import numpy as np

__all__ = ["Number", "answer", "exact", "exact_or_none", "half_step", "nearest", "point", "whole", "whole_or_none"]

Number = Union[int, float, Fraction, str]
"""A number from the caller. A float stands for the decimal that Python prints: 0.1 is 1/10."""

_EXACT = re.compile(r"-?\d+(/\d+)?")


def exact(value: Any, name: str) -> str:
    """Returns the number as text that is read exactly.

    >>> exact(0.1, "eps"), exact(np.float32(0.1), "eps"), exact(Fraction(1, 3), "eps"), exact("-2/7", "eps")
    ('0.1', '0.1', '1/3', '-2/7')
    """
    if isinstance(value, str):
        return value
    if isinstance(value, np.floating) and np.isfinite(value):
        return str(value)
    if isinstance(value, np.generic) or isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, bool):
        raise TypeError(f"{name}: a number is needed, not {value}")
    if isinstance(value, Integral):
        return _digits(int(value))
    if isinstance(value, Rational):
        return f"{_digits(int(value.numerator))}/{_digits(int(value.denominator))}"
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError(f"{name}: {value} is no number to compute with")
        return repr(value)
    # SymPy's numbers have the attributes p and q.
    p, q = getattr(value, "p", None), getattr(value, "q", None)
    if isinstance(p, int) and isinstance(q, int):
        return f"{_digits(p)}/{_digits(q)}"
    if isinstance(value, Decimal) and value.is_finite():
        return str(value)
    if hasattr(value, "__float__") and not isinstance(value, np.ndarray):
        near = float(value)
        if math.isfinite(near) and near != value:
            raise ValueError(f"{name}: {value} is neither a fraction nor a float; give a nearby one, as {near!r}")
        return exact(near, name)
    raise TypeError(f"{name}: a number is needed, not {type(value).__name__}")


def exact_or_none(value: Any, name: str) -> str | None:
    """Returns the number as text that is read exactly, or ``None`` for ``None``."""
    return None if value is None else exact(value, name)


def nearest(value: Any, name: str) -> float:
    """Returns the float nearest to a number."""
    if isinstance(value, float):
        return value
    return float(_fraction(exact(value, name), name))


def _fraction(text: str, name: str) -> Fraction:
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise ValueError(f"{name}: {text} divides by zero") from None
    except ValueError:
        raise ValueError(f"{name}: `{text}` is not a number; write it as 3/7, -2, 0.25 or 1e-3") from None


def half_step(eps: Any, dt: Any, *, is_needed: bool = True) -> Any:
    """Returns eps, half the time step, from eps or from the time step ``dt``: a number, or an array
    with one for each trajectory.

    >>> half_step(0.1, None), half_step(None, 0.1), half_step(None, None, is_needed=False)
    (0.1, Fraction(1, 20), None)
    """
    if dt is None:
        if eps is None and is_needed:
            raise TypeError("give eps, half the time step, or dt, the time step")
        return eps
    if eps is not None:
        raise TypeError("eps and dt are both given; dt = 2 eps, and one of them says it")
    if np.ndim(dt):
        return np.asarray(dt) / 2
    return _fraction(exact(dt, "dt"), "dt") / 2


def point(values: Any, name: str = "x") -> list[str]:
    """Returns the coordinates of a point as exact text."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise TypeError(f"{name}: a point is a list or an array with a coordinate for each variable")
    values = list(values)
    if any(np.ndim(value) for value in values):
        raise TypeError(f"{name}: one point is needed, a number for each variable, and not rows of them")
    return [exact(value, name) for value in values]


def whole(value: Any, name: str) -> int:
    """Returns a whole number of 0 or more; 1e3 is accepted as well."""
    if value is None:
        raise TypeError(f"{name} is missing: give a whole number, as {name}=1000")
    try:
        number = index(int(value) if isinstance(value, float) and value.is_integer() else value)
    except TypeError:
        raise TypeError(f"{name}: a whole number is needed, and not {value!r}") from None
    if number < 0:
        raise ValueError(f"{name}: {number} is below 0")
    return number


def whole_or_none(value: Any, name: str) -> int | None:
    """Returns a whole number of 0 or more, or ``None`` for ``None``."""
    return None if value is None else whole(value, name)


def _digits(value: int) -> str:
    """Returns the digits of an integer of any length; ``str`` refuses more than a few thousand."""
    try:
        return str(value)
    except ValueError:
        return f"{Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN).create_decimal(value):f}"


def _int(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        return int(Decimal(text))


def _number(text: str) -> Fraction:
    above, _, below = text.partition("/")
    return Fraction(_int(above), _int(below) if below else 1)


def _value(value: Any) -> Any:
    # In answers, only texts of digits are exact numbers.
    if isinstance(value, str):
        return _number(value) if _EXACT.fullmatch(value) else value
    if isinstance(value, list):
        return [_value(item) for item in value]
    if isinstance(value, dict):
        return {name: _value(item) for name, item in value.items()}
    return value


def answer(text: str) -> dict[str, Any]:
    """Returns the answer to a question, with exact numbers as fractions."""
    found = _value(json.loads(text))
    assert isinstance(found, dict)
    return found
