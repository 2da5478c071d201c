"""Hirota–Kimura bases as functions of orbits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._answer import Answer
from ._arrays import unnamed
from ._errors import spelled
from ._exact import Number, _number, point
from ._kahan import Relation
from ._orbit import Array

if TYPE_CHECKING:
    from ._system import System

__all__ = ["Basis"]


@spelled
class Basis(Answer):
    """Monomials m_k with one linear relation, sum of c_k m_k(x) = 0, along every orbit of a map.

    The coefficients c differ from orbit to orbit and do not change along one, so that, with the
    first of them 1, they are integrals. ``monomials``, ``terms`` (sums of monomials with equal
    coefficients), ``integrals`` (the independent ones among the c), ``points`` (how many consecutive
    points of an orbit determine the c) and ``outcome`` are those of ``kahan discover --json``.
    """

    monomials: list[str]
    """The monomials as text."""
    integrals: list[str]
    """Which quotients of coefficients are independent integrals, as ``c[y^2]/c[1]``."""
    points: int
    """How many consecutive points of an orbit determine the coefficients."""

    def __init__(self, found: Mapping[str, Any], relation: Relation) -> None:
        super().__init__(found)
        self.__dict__["_relation"] = relation

    def monomial_values(self, x: Any) -> Array:
        """The monomials at points: an axis of them in the place of the variables, which are ``x``'s last."""
        x = unnamed(x, "x")
        values: Array = np.prod(x[..., None, :] ** np.array(self._relation.exponents), axis=-1)
        return values

    def coefficients(self, x: Any) -> tuple[Array, Array | None]:
        """The coefficients c at the points of an orbit, and the condition of the equations for them.

        ``x`` has consecutive points as rows, ``every=1``. Row k of the coefficients is that of the
        ``points`` points from the k-th on, so that all rows are equal but for rounding, which is
        about 1e-16 times the condition; NaN where no digit is right. Of an exact orbit
        (``scalar="exact"``) they are fractions, and there is no condition.
        """
        x = unnamed(x, "x")
        if x.ndim != 2 or len(x) < self.points:
            raise ValueError(f"x: {self.points} consecutive points are needed, a row each, and the shape is {x.shape}")
        if x.dtype == object:
            rows = [point(row) for row in x]
            solved = (self._relation.solve_exactly(rows[k : k + self.points]) for k in range(len(x) - self.points + 1))
            return np.array([[_number(value) for value in values] for values in solved], dtype=object), None
        windows = np.lib.stride_tricks.sliding_window_view(x, self.points, axis=0).swapaxes(1, 2)
        relation: Relation = self._relation
        return relation.solve(windows)

    def integral_values(self, system: System, x: Any, eps: Number) -> dict[str, Array]:
        """The independent integrals at points, by name: ``x`` has shape (variables,) or (points, variables).

        ``system`` is the field with values of its parameters. Costs ``points`` - 1 steps a point, and a
        system of linear equations.
        """
        orbit = [np.asarray(system._at(x), dtype=float)]
        while len(orbit) < self.points:
            orbit.append(system.step(orbit[-1], eps))
        orbits = np.stack(orbit, axis=-2)
        solved, _ = self._relation.solve(orbits.reshape(-1, *orbits.shape[-2:]))
        return {name: solved[:, place].reshape(orbits.shape[:-2]) for name, place in zip(self.integrals, self._relation.places)}
