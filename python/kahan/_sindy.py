"""Fields from pysindy regressions; pysindy need not be installed."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import numpy as np

from ._arrays import floats
from ._system import System

__all__ = ["from_sindy"]


def from_sindy(model: Any, *, lift: bool | str | None = None, **values: Any) -> System:
    """Returns the field of a fitted ``pysindy`` model.

    It reads ``model.coefficients()``, ``model.get_feature_names()``, and the names of the variables
    in ``model.feature_names``.

    Coefficients are taken exactly; terms that the regression has set to 0 are left out. Raises
    ``ValueError`` for a term that is not quadratic, unless ``lift`` is given. ``lift``, and the
    ``values`` with the point ``at``, are those of ``System``.

    >>> import kahan
    >>> import numpy as np
    >>> class Model:
    ...     feature_names = ["u", "v"]
    ...     coefficients = lambda self: np.array([[0.0, 0.0, 1.0, 0.0], [0.5, -1.0, 0.0, -0.25]])
    ...     get_feature_names = lambda self: ["1", "u", "v", "u v"]
    >>> print(kahan.from_sindy(Model()).text)
    udot = v;
    vdot = 1/2 - u - 1/4*u*v;
    """
    if getattr(model, "discrete_time", False) or type(model).__name__ == "DiscreteSINDy":
        raise ValueError("the model is a map x -> f(x) in discrete time, and a field has rates")
    coefficients, terms = floats(model.coefficients(), "coefficients"), list(model.get_feature_names())
    n = len(coefficients)
    names = list(model.feature_names)[:n]
    if coefficients.shape != (n, len(terms)):
        raise ValueError(f"coefficients has the shape {coefficients.shape}; with {len(terms)} terms it must be ({n}, {len(terms)})")
    rows, columns = np.nonzero(coefficients)
    controls = [name for name in list(model.feature_names)[n:] if any(_has(terms[k], name) for k in set(columns))]
    if controls:
        raise ValueError(f"the model has the control input {controls[0]}, and a field depends on its variables alone")
    powers = {k: _powers(terms[k], names) for k in set(columns)}
    if lift:
        lines = [" ".join(f"+ ({Fraction(float(coefficients[i, k]))})*({_text(terms[k])})" for k in columns[rows == i])
                 for i in range(n)]
        return System(" ".join(f"{name}dot = {line or 0};" for name, line in zip(names, lines)), lift=lift, **values)
    for i, k in zip(rows, columns):
        factors = powers[k]
        if factors is None or len(factors) > 2:
            raise ValueError(f"{names[i]}' has the term {coefficients[i, k]:.6g} * {terms[k]}, which is not quadratic; lift=True lifts "
                             "the field to a quadratic one, or fit with a library of polynomials of degree 2")
    c, B, Q = np.zeros(n), np.zeros((n, n)), np.zeros((n, n * n))
    for k, factors in powers.items():
        match factors:
            case []:
                c += coefficients[:, k]
            case [j]:
                B[:, j] += coefficients[:, k]
            case [j, l]:
                Q[:, n * j + l] += coefficients[:, k]
    return System.from_arrays(c, B, Q, names, **values)


def _has(term: str, name: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(name)}(?!\w)", term) is not None


def _powers(term: str, names: list[str]) -> list[int] | None:
    """Returns the variables of a product such as ``x0^2 x1``, each as often as it occurs; ``None`` for other terms."""
    factors: list[int] = []
    for factor in [] if term == "1" else term.split(" "):
        name, _, power = factor.partition("^")
        if name not in names or not (power or "1").isdigit():
            return None
        factors += [names.index(name)] * int(power or 1)
    return factors


def _text(term: str) -> str:
    """Returns a term in the language of fields; a space between factors means a product."""
    return re.sub(r"(?<=[\w)]) +(?=[\w(])", "*", term)
