"""Chains of any number of sites."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ._arrays import named
from ._errors import spelled
from ._exact import Number, half_step
from ._kahan import Chain
from ._orbit import Array

__all__ = ["Lattice"]


@spelled
class Lattice(Chain):
    """A chain of a family ``for i in periodic { … }`` at one eps, half the time step, or ``dt`` = 2 eps.

    ``family`` is its text, or its name in the catalog, as ``"kdv"``. ``values`` are the family's
    parameters: a number each, or one a site. A state has a row a site, with a column for each of
    ``arrays``; of one array it may be a list of the sites.

    >>> import kahan, numpy as np
    >>> ring = kahan.Lattice("for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }", 100, eps=0.01)
    >>> state = 1 + 0.5 * np.cos(2 * np.pi * np.arange(100) / 100)
    >>> ring.advance(state, 1000).shape
    (100,)
    """

    _call: tuple[Any, ...]

    def __new__(cls, family: str, sites: int, eps: Number | None = None, *, dt: Number | None = None, **values: float | Array) -> Lattice:
        return cls._of(family, sites, half_step(eps, dt), values)

    @classmethod
    def _of(cls, family: str, sites: int, eps: Number, values: Mapping[str, Any]) -> Lattice:
        lattice: Lattice = Chain.__new__(cls, family, sites, eps, list(values.items()))
        lattice._call = (family, sites, eps, dict(values))
        return lattice

    def __reduce__(self) -> tuple[Callable[..., Lattice], tuple[Any, ...]]:
        return (type(self)._of, self._call)

    @property
    def _names(self) -> list[str]:
        """The names that columns of a state may have."""
        return self.arrays

    def __repr__(self) -> str:
        return f"<Lattice of {self.sites} sites: {', '.join(self.arrays)}>"

    def step(self, state: Any) -> Array:
        """The state one time step of 2 eps later."""
        return self.advance(state, 1)

    def invariants(self, state: Any) -> dict[str, float]:
        """What the family claims, at a state: integrals, the Hamiltonian, and the energy that the map keeps."""
        return dict(self._sums(state))

    def orbit(self, state: Any, steps: int, *, every: int = 1) -> Array:
        """The states after 0, every, 2 every, ... steps: an axis more than a state has."""
        states = [np.array(named(state, self, "state"), dtype=float)]
        for _ in range(steps // every):
            states.append(self.advance(states[-1], every))
        return np.array(states)
