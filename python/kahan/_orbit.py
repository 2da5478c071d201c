"""Orbits and what is seen of them, as arrays."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._system import System

__all__ = ["Orbit", "Section"]

Array = np.ndarray[Any, Any]


class Orbit:
    """The points of one orbit, a row each: ``x[k]`` is the point after ``n[k]`` steps."""

    system: System
    """The field, with its parameters."""
    eps: float
    """Half the time step."""
    x: Array
    """The points, of shape (rows, variables); the first is the start."""
    every: int
    """Steps from row to row."""
    steps: int
    """The steps that were made; fewer than were asked where the orbit ends."""
    ended: str
    """``"complete"``, or ``"range"`` where the next point is not finite: a pole (det A = 0), or
    numbers too large."""

    def __init__(self, system: System, eps: float, x: Array, every: int, steps: int, ended: str) -> None:
        self.system, self.eps, self.x, self.every = system, eps, x, every
        self.steps, self.ended = steps, ended

    @property
    def n(self) -> Array:
        """The number of steps that leads to each row."""
        return self.every * np.arange(len(self.x))

    @property
    def t(self) -> Array:
        """The time of each row, 2 eps n."""
        return 2 * self.eps * self.n

    @cached_property
    def integrals(self) -> dict[str, Array]:
        """The claimed integrals on each row, by name. What is claimed ``when`` a condition holds is left out."""
        return self.system.integral_values(self.x, self.eps)

    def __len__(self) -> int:
        return len(self.x)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.x, dtype=dtype) if copy or dtype is not None else self.x

    def __repr__(self) -> str:
        end = "" if self.ended == "complete" else f", then out of range: {self.ended}"
        return f"<Orbit of {self.system.name}: {len(self.x)} points, {self.steps} steps{end}>"

    def to_pandas(self) -> Any:
        """A data frame with n, t, the variables and the integrals. Needs pandas."""
        import pandas

        variables = {name: self.x[:, k] for k, name in enumerate(self.system.variables)}
        return pandas.DataFrame({"n": self.n, "t": self.t, **variables, **self.integrals})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the orbit over two or three of ``t`` and the variables; by default the first three.

        Needs matplotlib. ``style`` goes to ``Axes.plot``; returns the axes.
        """
        from ._plot import orbit

        return orbit(self, axes, ax, style)


class Section:
    """Where an orbit crosses a section: a row a crossing."""

    system: System
    """The field, with its parameters."""
    plane: str
    """What vanishes on the section."""
    x: Array
    """The crossings, of shape (crossings, variables)."""
    t: Array
    """Their times."""
    steps: int
    """The steps of the orbit."""

    def __init__(self, system: System, plane: str, x: Array, t: Array, steps: int) -> None:
        self.system, self.plane, self.x, self.t, self.steps = system, plane, x, t, steps

    def __len__(self) -> int:
        return len(self.x)

    def __repr__(self) -> str:
        return f"<Section of {self.system.name} at {self.plane} = 0: {len(self.x)} crossings>"

    def to_pandas(self) -> Any:
        """A data frame with t and the variables. Needs pandas."""
        import pandas

        return pandas.DataFrame({"t": self.t, **{name: self.x[:, k] for k, name in enumerate(self.system.variables)}})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the crossings over two of the variables. Needs matplotlib; returns the axes."""
        from ._plot import section

        return section(self, axes, ax, style)
