"""Totals that reactions preserve."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

__all__ = ["conserved"]


def conserved(columns: Mapping[str, Mapping[str, Fraction]], most: int = 400) -> list[dict[str, Fraction]]:
    """Returns a basis of the weighted sums of species that every reaction preserves, in the order
    of species.

    >>> from fractions import Fraction
    >>> conserved({"A": {"r": Fraction(-1)}, "B": {"r": Fraction(1)}})
    [{'A': Fraction(1, 1), 'B': Fraction(1, 1)}]
    """
    if len(columns) > most:
        return []
    pivots: list[tuple[str, dict[str, Fraction], dict[str, Fraction]]] = []
    found: list[dict[str, Fraction]] = []
    for name, column in columns.items():
        rest, of = {row: value for row, value in column.items() if value}, {name: Fraction(1)}
        for row, pivot, known in pivots:
            if row in rest:
                factor = rest[row] / pivot[row]
                rest, of = _less(rest, factor, pivot), _less(of, factor, known)
        if rest:
            pivots.append((next(iter(rest)), rest, of))
        else:
            found.append(of)
    totals = []
    for of in found:
        first = next(name for name in columns if name in of)
        whole = math.lcm(*(value.denominator for value in of.values()))
        common = math.gcd(*(int(value * whole) for value in of.values()))
        scale = Fraction(whole, common) * (-1 if of[first] < 0 else 1)
        totals.append({name: of[name] * scale for name in columns if name in of})
    return totals


def _less(left: Mapping[str, Fraction], factor: Fraction, right: Mapping[str, Fraction]) -> dict[str, Fraction]:
    """Returns left − factor·right, without zeros."""
    difference = {name: left.get(name, Fraction(0)) - factor * right.get(name, Fraction(0)) for name in {**left, **right}}
    return {name: value for name, value in difference.items() if value}
