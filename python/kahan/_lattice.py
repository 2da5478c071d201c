"""Chains with any number of sites."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ._answer import Answer
from ._arrays import named
from ._errors import Named, needed, spelled
from ._exact import Number, half_step, nearest, whole
from ._kahan import Chain
from ._orbit import Array, Frame, Stepped, _end
from ._progress import listener

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Lattice", "LatticeOrbit"]


@spelled
class Lattice(Chain):
    """A chain ``for i in periodic { … }`` at a fixed ``eps``, half the time step (or ``dt`` = 2
    eps).

    ``family`` is the text of the chain, or a name in the catalog such as ``"kdv"``. ``values`` are
    the parameters: one number each, or one for each site. A state has a row for each site and a
    column for each array in ``arrays``; with a single array it may be one-dimensional. Arrays of
    states have further axes in front, and are advanced state by state.

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
        """Returns the names that columns of a state may have."""
        return self.arrays

    def __repr__(self) -> str:
        return f"<Lattice of {self.sites} sites: {', '.join(self.arrays)}>"

    def _alone(self, state: Any) -> tuple[Array, int]:
        """Returns the state or states, and the number of axes of a single state."""
        states = np.array(named(state, self, "state"), dtype=float)
        pair = (self.sites, len(self.arrays))
        return states, 1 if len(self.arrays) == 1 and states.shape[-2:] != pair and states.shape[-1:] == pair[:1] else 2

    def step(self, state: Any) -> Array:
        """Returns the state one time step of 2 eps later."""
        return self.advance(state, 1)

    def advance(self, state: Any, steps: int = 1, *, progress: bool = False) -> Array:  # type: ignore[override]
        """Returns the state ``steps`` steps later, in the same shape; NaN if it is not finite."""
        states, axes = self._alone(state)
        if states.ndim <= axes:
            return super().advance(states, whole(steps, "steps"), listener=listener(progress))
        each = states.reshape(-1, *states.shape[-axes:])
        return np.array([self.advance(one, steps, progress=progress) for one in each]).reshape(states.shape)

    def invariants(self, state: Any) -> dict[str, Any]:
        """Returns the claimed quantities at a state: integrals, Hamiltonian, and the energy that
        the map preserves.

        For arrays of states, each of them is an array.
        """
        states, axes = self._alone(state)
        if states.ndim <= axes:
            return dict(self._sums(states))
        each = [dict(self._sums(one)) for one in states.reshape(-1, *states.shape[-axes:])]
        return {name: np.array([one[name] for one in each]).reshape(states.shape[:-axes]) for name in each[0]} if each else {}

    def observe(self, state: Any, steps: int, **asked: Any) -> Answer:
        """Observes the orbit of one state, like ``System.observe``. ``spectrum=3`` gives the three
        largest exponents.

        The chain is written out as a field of all sites, ``System(family, sites=n)``; this takes
        milliseconds per site. ``asked`` are the other arguments of ``System.observe``.

        >>> import kahan
        >>> chain = kahan.Lattice("for i in periodic { q[i]dot = p[i]; p[i]dot = q[i+1] - 2*q[i] + q[i-1]; }", 8, eps=0.05)
        >>> chain.observe([[1, 0]] + [[0, 0]] * 7, 1000, observe=["spectrum"], spectrum=3).spectrum.shape
        (3,)
        """
        from ._system import System

        family, sites, eps, values = self._call
        states, axes = self._alone(state)
        if states.ndim > axes:
            raise ValueError("state: one state is observed at a time")
        field = System(family, sites=sites)
        of_sites: dict[str, Any] = {}
        for name, given in values.items():
            each = [name] if name in field.parameters else next(
                names for infix in ("", "_") if (names := [f"{name}{infix}{k}" for k in range(sites)])[0] in field.parameters)
            of_sites |= dict(zip(each, np.broadcast_to(given, len(each)).tolist()))
        return field(**of_sites).observe(states.ravel(), eps, steps, **asked)

    def orbit(self, state: Any, steps: int, *, every: int = 1, progress: bool = False) -> LatticeOrbit:
        """Returns the states after 0, ``every``, 2 ``every``, … steps.

        An orbit of one state ends before the first state that is not finite. An array of states
        keeps all rows, with NaN for states whose orbit has ended.
        """
        steps, every = whole(steps, "steps"), whole(every, "every")
        if not every:
            raise ValueError("every: 1 or more is needed")
        states, axes = self._alone(state)
        rows, made = [states], 0
        while made + every <= steps:
            states = self.advance(states, every, progress=progress)
            if rows[0].ndim <= axes and np.isnan(states).any():
                break
            rows.append(states)
            made += every
        ended = made + every <= steps
        if ended:
            states = self.step(rows[-1])
            while not np.isnan(states).any():
                states, made = self.step(states), made + 1
        return LatticeOrbit(self, np.array(rows), every, made, "range" if ended else "complete")


@spelled
class LatticeOrbit(Frame, Stepped):  # type: ignore[misc]
    """The states of an orbit of a lattice: ``x[k]`` is the state after ``n[k]`` steps, ``x[k][...,
    i, :]`` its site i.

    ``ended`` is ``"complete"`` if all steps were made, and ``"range"`` if the next state is not
    finite.
    """

    system: Lattice
    """The lattice."""
    x: Array
    """The states, of shape (rows, sites) or (rows, sites, arrays). For arrays of states, their axes
    follow the first.
    """

    def __init__(self, system: Lattice, x: Array, every: int, steps: int, ended: str) -> None:
        self.system, self.x, self.every, self.steps, self.ended = system, x, every, steps, ended

    @property
    def t(self) -> Array:
        """The time of each row, 2 eps n."""
        times: Array = 2 * nearest(self.system._call[2], "eps") * self.n
        return times

    @cached_property
    def invariants(self) -> dict[str, Array]:
        """The claimed quantities of each row, by name."""
        return Named(self.system.invariants(self.x), "claimed invariant", "")

    def __repr__(self) -> str:
        return f"<LatticeOrbit of {self.system.sites} sites: {len(self.x)} states, {self.steps} steps{_end(self.ended, self.steps)}>"

    def columns(self) -> dict[str, Array]:
        """Returns n, t and the invariants by name. For arrays of states they are numbered, as ``S_1``."""
        columns = {"n": self.n, "t": self.t}
        for name, values in self.invariants.items():
            each = values.reshape(len(self.x), -1).T
            columns |= {name: values} if values.ndim == 1 else {f"{name}_{k}": one for k, one in enumerate(each, 1)}
        return columns

    def to_xarray(self) -> Any:
        """Returns an ``xarray.Dataset`` of the arrays over ``t`` and ``site``, with the invariants. Needs xarray."""
        x, arrays = self.x, self.system.arrays
        axes = x.ndim - 1 - self.system._alone(x[0])[1]
        sites = x if x.shape[axes + 2:] else x[..., np.newaxis]
        dims = ["t", *(f"state_{k}" for k in range(1, axes + 1))]
        columns = {name: ([*dims, "site"], sites[..., k]) for k, name in enumerate(arrays)}
        columns |= {name: (dims, values) for name, values in self.invariants.items()}
        return needed("xarray").Dataset(columns, {"t": self.t, "n": ("t", self.n), "site": np.arange(self.system.sites)})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the first array in colours over sites and time, or two columns such as ``"t",
        "H"``.

        Needs matplotlib. ``style`` is passed to ``Axes.pcolormesh`` or ``Axes.plot``. Returns the
        axes.
        """
        from ._plot import lattice

        return lattice(self, axes, ax, style)
