"""Orbits and what is seen of them, as arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import spelled, unknown
from ._kahan import arrow

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._system import System

__all__ = ["Chart", "Ensemble", "Orbit", "Section"]

Array = np.ndarray[Any, Any]

_ENDS = {"complete": "", "range": ", no finite point after step {}", "pole": ", a pole after step {}",
         "points": ", no more after step {}, as `points` says"}


def _end(ended: str, steps: int) -> str:
    return _ENDS[ended].format(steps)


class Table(ABC):
    """What is tabular: columns of one length by name, for pandas, and by Arrow's capsule for polars, pyarrow and others."""

    @abstractmethod
    def columns(self) -> dict[str, Array]:
        """The columns by name."""

    def to_pandas(self) -> Any:
        """A data frame of the columns. Needs pandas."""
        import pandas

        return pandas.DataFrame(self.columns())

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        """The columns as Arrow's stream: ``pyarrow.table(this)``, ``polars.DataFrame(this)``. Fractions are text."""
        return arrow(list(self.columns().items()))


@spelled
class Orbit(Table):
    """The points of one orbit, a row each: ``x[k]`` is the point after ``n[k]`` steps.

    ``ended`` is ``"complete"`` where all steps were made. It is ``"range"`` where the next point is
    beyond the range of floats, as it is at poles in floats too, and ``"pole"`` where other numbers
    and methods tell that it has no value (det A = 0).
    """

    system: System
    """The field, with its parameters."""
    eps: float
    """Half the time step."""
    x: Array
    """The points, of shape (rows, variables); the first is the start."""
    x_low: Array | None = None
    """What the points lack, where they are double-doubles: these are ``x + x_low``."""
    every: int
    """Steps from row to row."""
    steps: int
    """The steps that were made; fewer than were asked where the orbit ends."""
    ended: str
    """Why it goes no further."""

    def __init__(
        self, system: System, eps: float, x: Array, every: int, steps: int, ended: str,
        integrals: float | dict[str, Array],
    ) -> None:
        self.system, self.eps, self.x, self.every = system, eps, x, every
        self.steps, self.ended = steps, ended
        self._integrals = integrals

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
        """The claimed integrals on each row, by name; of those claimed ``when`` a condition holds, the ones
        whose condition the parameters and eps meet.

        A claim is about Kahan's map at this eps. Compositions (``order`` above 2) and other methods
        do not keep it: they follow the flow, and their integrals are the claims at eps = 0, not a
        number where these have no value.
        """
        given = self._integrals
        return given if isinstance(given, dict) else self.system.integral_values(self.x, given)

    def __len__(self) -> int:
        return len(self.x)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.x, dtype=dtype) if copy or dtype is not None else self.x

    def __repr__(self) -> str:
        return f"<Orbit of {self.system.name}: {len(self.x)} points, {self.steps} steps{_end(self.ended, self.steps)}>"

    def columns(self) -> dict[str, Array]:
        """n, t, the variables and the integrals, by name."""
        return {"n": self.n, "t": self.t, **self.system._columns(self.x), **self.integrals}

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the orbit over two or three of ``t`` and the variables; by default the first three.

        Needs matplotlib. ``style`` goes to ``Axes.plot``; returns the axes.
        """
        from ._plot import orbit

        return orbit(self, axes, ax, style)


@spelled
class Ensemble(Table):
    """Many trajectories: where they ended, and what was observed of them, an entry a trajectory.

    Each column of what was observed is an attribute and in ``observed``, as ``lyapunov``,
    ``drift_H``; ``numpy.asarray`` of it is ``x``.
    """

    system: System
    """The field, with its parameters."""
    x: Array
    """The last points, of shape (trajectories, variables)."""
    steps: Array | None
    """With observers, the steps that each made: fewer than asked where numbers leave their range."""
    observed: dict[str, Array]
    """What was observed, by name."""

    def __init__(self, system: System, x: Array, steps: Array | None, observed: dict[str, Array]) -> None:
        self.system, self.x, self.steps, self.observed = system, x, steps, observed

    def __getattr__(self, name: str) -> Array:
        observed = self.__dict__.get("observed", {})
        if name in observed:
            found: Array = observed[name]
            return found
        raise AttributeError(unknown("column", name, ["x", "steps", *observed]))

    def __len__(self) -> int:
        return len(self.x)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.x, dtype=dtype) if copy or dtype is not None else self.x

    def __repr__(self) -> str:
        seen = f"; observed: {', '.join(self.observed)}" if self.observed else ""
        return f"<Ensemble of {len(self.x)} trajectories{seen}>"

    def columns(self) -> dict[str, Array]:
        """The variables of the last points, the steps, and what was observed, by name."""
        steps = {} if self.steps is None else {"steps": self.steps}
        return {**self.system._columns(self.x), **steps, **self.observed}


@spelled
class Chart(Table):
    """What orbits do over one or more parameters or first values: ``values[i, j]`` at ``axes``' i-th and j-th."""

    system: System
    """The field, with its parameters."""
    axes: dict[str, Array]
    """What is gone through, in the order of the axes of ``values``, with its values."""
    color: str
    """What is shown."""
    values: Array
    """The numbers; not a number where an orbit leaves the range of floats."""

    def __init__(self, system: System, axes: dict[str, Array], color: str, values: Array) -> None:
        self.system, self.axes, self.color, self.values = system, axes, color, values

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.values, dtype=dtype) if copy or dtype is not None else self.values

    def __repr__(self) -> str:
        sizes = " x ".join(f"{name}: {len(values)}" for name, values in self.axes.items())
        return f"<Chart of {self.color} of {self.system.name} over {sizes}>"

    def columns(self) -> dict[str, Array]:
        """What is gone through, and the numbers, by name; a row a cell."""
        grid = np.meshgrid(*self.axes.values(), indexing="ij")
        places = {name: axis.ravel() for name, axis in zip(self.axes, grid)}
        return {**places, self.color: self.values.ravel()}

    def plot(self, *, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws one axis as a curve, two in colours, the first across. Needs matplotlib; returns the axes."""
        from ._plot import chart

        return chart(self, ax, style)


@spelled
class Section(Table):
    """Where an orbit crosses a section: a row a crossing.

    ``ended`` is ``"complete"`` where all steps were made, ``"points"`` where the orbit had as many
    crossings before as ``points`` asked for, and ``"range"`` where its next point is not finite.
    """

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
    ended: str
    """Why the orbit goes no further."""

    def __init__(self, system: System, plane: str, x: Array, t: Array, steps: int, ended: str) -> None:
        self.system, self.plane, self.x, self.t, self.steps, self.ended = system, plane, x, t, steps, ended

    def __len__(self) -> int:
        return len(self.x)

    def __repr__(self) -> str:
        return f"<Section of {self.system.name} at {self.plane} = 0: {len(self.x)} crossings{_end(self.ended, self.steps)}>"

    def columns(self) -> dict[str, Array]:
        """t and the variables, by name."""
        return {"t": self.t, **self.system._columns(self.x)}

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the crossings over two of the variables. Needs matplotlib; returns the axes."""
        from ._plot import section

        return section(self, axes, ax, style)
