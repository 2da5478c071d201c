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

    The coefficients c differ from orbit to orbit and are constant along an orbit. Scaled so that
    the first of them is 1, they are integrals. The attributes are those of ``kahan discover
    --json``: ``monomials``, ``terms`` (sums of monomials with equal coefficients), ``integrals``
    (the independent ones among the c), ``points`` (the number of consecutive points that determine
    the c) and ``outcome``.
    """

    monomials: list[str]
    """The monomials as text."""
    integrals: list[str]
    """The quotients of coefficients that are independent integrals, as ``c[y^2]/c[1]``."""
    points: int
    """The number of consecutive points of an orbit that determine the coefficients."""

    def __init__(self, found: Mapping[str, Any], relation: Relation) -> None:
        super().__init__(found)
        self.__dict__["_relation"] = relation

    def monomial_values(self, x: Any) -> Array:
        """Returns the monomials at points. The last axis of ``x`` holds the variables; that of the
        result, the monomials.
        """
        x = unnamed(x, "x")
        values: Array = np.prod(x[..., None, :] ** np.array(self._relation.exponents), axis=-1)
        return values

    def coefficients(self, x: Any) -> tuple[Array, Array | None]:
        """Returns the coefficients c at the points of an orbit, and the condition number of their
        equations.

        The rows of ``x`` are consecutive points (``every=1``). Row k of the result is determined by
        ``points`` points from the k-th on, so all rows are equal up to rounding. The relative error
        is about 1e-16 times the condition number; a row without a correct digit is NaN. For an
        exact orbit (``scalar="exact"``) the coefficients are fractions, and the condition number is
        ``None``.
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
        """Returns the independent integrals at points, by name. ``x`` has shape (variables,) or
        (points, variables).

        ``system`` is the field with values for its parameters. For each point, this makes
        ``points`` - 1 steps and solves a system of linear equations.
        """
        orbit = [np.asarray(system._at(x), dtype=float)]
        while len(orbit) < self.points:
            orbit.append(system.step(orbit[-1], eps))
        orbits = np.stack(orbit, axis=-2)
        solved, _ = self._relation.solve(orbits.reshape(-1, *orbits.shape[-2:]))
        return {name: solved[:, place].reshape(orbits.shape[:-2]) for name, place in zip(self.integrals, self._relation.places)}
