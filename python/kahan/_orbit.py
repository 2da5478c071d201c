"""Orbits and what is seen of them, as arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import ItemsView, Iterator, KeysView, Mapping, Sequence, ValuesView
from copyreg import __newobj__ as newobject  # type: ignore[attr-defined]
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ._derivatives import differentiable, in_order
from ._errors import Named, needed, spelled, unknown
from ._kahan import arrow
from ._progress import listener

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._system import System

__all__ = ["Chart", "Diagram", "Ensemble", "Orbit", "Section"]

Array = np.ndarray[Any, Any]

_ENDS = {"complete": "", "range": ", no finite point after step {}", "pole": ", a pole after step {}",
         "escaped": ", escaped at step {}", "time": ", out of time after step {}", "stopped": ", stopped after step {}",
         "reembed": ", no step back to the relations after step {}"}


def _end(ended: str, steps: int) -> str:
    return _ENDS[ended].format(steps)


class Table(ABC):
    """Columns of one length by name, as a data frame has them: ``keys()``, ``items()``, ``dict(table)``.

    A column is an entry, ``table["y"]``, and an attribute where there is no other one: ``x`` are always the
    points. Iteration goes over the names, and ``len`` counts the rows. ``numpy.asarray`` of a table is its points,
    or a chart's values. ``polars.DataFrame(table)`` and ``pyarrow.table(table)`` read it by Arrow's capsule.
    """

    @abstractmethod
    def columns(self) -> dict[str, Array]:
        """The columns by name."""

    def _whole(self) -> Array:
        """The table as one array."""
        whole: Array = self.x
        return whole

    def __getitem__(self, name: str) -> Array:
        columns = self.columns()
        if name not in columns:
            raise KeyError(unknown("column", str(name), columns))
        return columns[name]

    def __getattr__(self, name: str) -> Array:
        # What copies and pickles a table asks before it has its attributes.
        if name.startswith("_") or "system" not in self.__dict__:
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns())

    def __len__(self) -> int:
        return len(self._whole())

    def keys(self) -> KeysView[str]:
        """The names of the columns."""
        return self.columns().keys()

    def items(self) -> ItemsView[str, Array]:
        """The names of the columns, each with its column."""
        return self.columns().items()

    def __contains__(self, name: object) -> bool:
        return name in self.columns()

    def get(self, name: str, default: Any = None) -> Any:
        """The column of this name, or else the default."""
        return self[name] if name in self else default

    # Arrays have no single answer to whether they are equal.
    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self._whole(), dtype=dtype) if copy or dtype is not None else self._whole()

    def to_pandas(self) -> Any:
        """A data frame of the columns. Needs pandas."""
        return needed("pandas").DataFrame(self.columns())

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        """The columns as Arrow's stream: ``pyarrow.table(this)``, ``polars.DataFrame(this)``. Fractions are text."""
        return arrow(list(self.columns().items()))


class Frame(Table, dict[str, Array]):  # type: ignore[misc]
    """A table that ``pandas.DataFrame(table)`` takes with its names: pandas asks for a ``dict``.

    The columns are those of :meth:`columns`, and the ``dict`` itself stays empty, so all that would read or
    change it is defined here.
    """

    def values(self) -> ValuesView[Array]:  # type: ignore[override]
        """The columns."""
        return self.columns().values()

    def copy(self) -> dict[str, Array]:
        """The columns as a ``dict``."""
        return self.columns()

    def __or__(self, other: Mapping[str, Any]) -> dict[str, Any]:  # type: ignore[override]
        return self.columns() | dict(other)

    def __ror__(self, other: Mapping[str, Any]) -> dict[str, Any]:  # type: ignore[override]
        return dict(other) | self.columns()

    def __reversed__(self) -> Iterator[str]:
        return reversed(self.columns())

    def __reduce__(self) -> tuple[Any, ...]:
        return newobject, (type(self),), self.__dict__

    def _fixed(self, *given: Any, **named: Any) -> Any:
        raise TypeError("the columns of a table are fixed; change those of dict(table)")

    __setitem__ = __delitem__ = __ior__ = update = setdefault = pop = popitem = clear = _fixed


class Ended(Table):
    """A table of the points of one orbit or of many, which end after so many ``steps``."""

    x: Array
    steps: Any
    ended: Any

    @property
    def states(self) -> Array:
        """The points, ``x``, which a variable may be called, too."""
        return self.x

    @property
    def ended_step(self) -> Any:
        """The steps to the last point of each orbit, ``steps``."""
        return self.steps


class Many(Frame, Ended):  # type: ignore[misc]
    """A table of many orbits, whose ends come as words, the place of its word for each, and its steps."""

    system: System
    start: Array
    given: dict[str, Array]
    steps: Array
    """The steps that each made, fewer than asked where it ended early."""
    _ends: tuple[list[str], Array, Array]

    def _end(self, ends: tuple[list[str], Array, Array]) -> None:
        self._ends, self.steps = ends, ends[2].reshape(self.start.shape[:-1])

    def _over_starts(self) -> tuple[list[str], dict[str, Any]]:
        """The dimensions of the starts, and their coordinates: numbers, first points and ``given``."""
        shape = self.steps.shape
        dims = ["start"] if len(shape) == 1 else [f"start_axis_{k}" for k in range(len(shape))]
        numbers = {name: np.arange(size) for name, size in zip(dims, shape)}
        points = {f"start_{name}": (dims, values.reshape(shape)) for name, values in self.system._columns(self.start).items()}
        given = {name: (dims, values.reshape(shape)) if values.ndim else values for name, values in self.given.items()}
        return dims, {**numbers, **points, **given}

    @cached_property
    def ended(self) -> Array:
        """How each ended, in a word."""
        ended: Array = np.array(self._ends[0], dtype=object)[self._ends[1]].reshape(self.steps.shape)
        return ended

    def _early(self) -> str:
        early = int(np.sum(self.ended != "complete"))
        return f", {early} ended early" if early else ""


class Stepped(Ended):
    """A table with a row after every so many steps of one orbit."""

    x: Array
    """The points or states, of which the first is the start."""
    every: int
    """Steps from row to row."""
    transient: int = 0
    """Steps to the first row."""
    steps: int
    """The steps that were made; fewer than were asked where the orbit ends."""
    ended: str
    """Why it goes no further."""

    @property
    def n(self) -> Array:
        """The number of steps that leads to each row."""
        return self.transient + self.every * np.arange(len(self.x))


@spelled
class Orbit(Stepped):
    """The points of one orbit, a row each: ``x[k]`` is the point after ``n[k]`` steps.

    ``ended`` is ``"complete"`` where all steps were made. It is ``"range"`` where the next point is
    beyond the range of floats, as it is at poles in floats too, and ``"pole"`` where exact numbers
    tell that it has no value (det A = 0). Of a lifted field it is ``"range"`` where a root would be negative, and
    ``"reembed"`` where symmetric projection does not converge; ``why`` has the words. ``ended_step`` is the number
    of steps to the last point.
    """

    system: System
    """The field, with its parameters."""
    eps: float | Fraction
    """Half the time step; of an exact orbit the fraction."""
    x: Array
    """The points, of shape (rows, variables); the first is the start, or the point after the transient."""
    x_low: Array | None = None
    """What the points lack, where they are double-doubles: these are ``x + x_low``."""
    why: str | None = None
    """The end in words, where a lifted field ends the orbit."""
    _order: int | None = None
    # The order, if the steps are those of Kahan's map in floats and on a quadratic field.
    derivatives: dict[str, Array]
    """The derivatives of ``x``, each of its shape, by the names of ``derivatives=``; see ``System.orbit``."""

    def __init__(
        self, system: System, eps: float | Fraction, x: Array, every: int, steps: int, ended: str,
        integrals: float | dict[str, Array], in_all: Array | None = None,
    ) -> None:
        self.system, self.eps, self.x, self.every = system, eps, x, every
        self.steps, self.ended, self.derivatives = steps, ended, in_order((), (), x)
        self._integrals, self._in_all = integrals, in_all

    @property
    def t(self) -> Array:
        """The time of each row, 2 eps n; of equations with ``t`` from ``t0`` on."""
        n = self.n.astype(object) if isinstance(self.eps, Fraction) else self.n
        times: Array = 2 * self.eps * n
        start = self.system._time[0]
        if start:
            times = times + (Fraction(start) if isinstance(self.eps, Fraction) else start)
        return times

    @cached_property
    def integrals(self) -> dict[str, Array]:
        """The claimed integrals on each row, by name; of those claimed ``when`` a condition holds, the ones
        whose condition the parameters and eps meet.

        A claim is about Kahan's map at this eps. Compositions (``order`` above 2) and other methods
        do not keep it: they follow the flow, and their integrals are the claims at eps = 0, not a
        number where these have no value.
        """
        given = self._integrals
        in_all = self.x if self._in_all is None else self._in_all
        found = given if isinstance(given, dict) else self.system._integrals_in_all(in_all, given)
        return Named(found, "claimed integral", "`s.discover().claimed` has those found")

    def gradient(self, weights: Any, by: str | Sequence[str] | None = None, *, progress: bool = False) -> dict[str, float]:
        """The gradient of a scalar L of the orbit: its derivatives by the start, the parameters and eps.

        ``weights``, of the shape of ``x``, are the derivatives of L by ``x``: ``2*(o.x - data)`` where L is
        the sum of squares of ``o.x - data``. ``by`` names parameters, variables (the derivative by that coordinate of the
        start) and ``"eps"``; the result has a number for each of these, by default for all.

        One sweep back over the orbit yields all of them, in a time that hardly grows with the number of parameters.
        Steps are computed again, in float64, from checkpoints; memory grows with the square root of the number of steps.

        >>> import kahan
        >>> pond = kahan.System("xdot = a*x - b*x*y; ydot = c*x*y - d*y;", a=1, b=1, c=1, d=1)
        >>> o = pond.orbit([1.5, 1], eps=0.05, steps=100)
        >>> weights = 0*o.x
        >>> weights[-1, 0] = 1                                  # L is the last x
        >>> {name: round(slope, 3) for name, slope in o.gradient(weights, ["a", "b", "x"]).items()}
        {'a': 0.447, 'b': 0.304, 'x': -0.526}
        """
        system = self.system
        if self._order is None:
            raise ValueError("gradient is of orbits of Kahan's map in f64 or f32, without transient, reembed and projective")
        by = differentiable(system, by, "by")
        given = np.asarray(weights, dtype=float)
        if given.shape != self.x.shape:
            early = "" if self.ended == "complete" else (f"; the orbit ended early{_end(self.ended, self.steps)}: give weights "
                                                         f"for its {len(self.x)} rows, or choose fewer steps or a smaller eps")
            raise ValueError(f"weights: the shape {self.x.shape} of the orbit's x is needed, and this is {given.shape}{early}")
        found = dict(system._gradient(self.x[0], float(self.eps), given, every=self.every, order=self._order,
                                      listener=listener(progress)))
        return {name: found[name] for name in by}

    def __repr__(self) -> str:
        end = _end(self.ended, self.steps) if self.why is None else f", {self.why}"
        return f"<Orbit of {self.system.name}: {len(self.x)} points, {self.steps} steps{end}>"

    def columns(self) -> dict[str, Array]:
        """n, t, the variables and the integrals, by name; of double-doubles ``x_low`` behind ``x``, too."""
        columns = {"n": self.n, "t": self.t}
        for k, name in enumerate(self.system.variables):
            columns[name] = self.x[:, k]
            if self.x_low is not None:
                columns[f"{name}_low"] = self.x_low[:, k]
        return columns | self.integrals

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of the columns over the coordinate ``t``, with ``n`` beside it. Needs xarray."""
        columns = self.columns()
        del columns["t"]
        beside = {"n": ("t", columns.pop("n"))} if "n" not in self.system.variables else {}
        return needed("xarray").Dataset({name: ("t", column) for name, column in columns.items()},
                                        {"t": self.t, **beside}, {"field": self.system.text, "eps": float(self.eps)})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the orbit over two or three columns, as ``"t", "H"``; by default the first three variables.

        Points are dots over two axes, and joined where one is the time or there are three. Needs
        matplotlib. ``style`` goes to ``Axes.plot`` and may have its short names, as ``lw`` and ``ms``; returns the axes.
        """
        from ._plot import orbit

        return orbit(self, axes, ax, style)


class FloatOrbit(Frame, Orbit):  # type: ignore[misc]
    """An orbit in floats or double-doubles; Arrow takes fractions as text, but not out of a ``dict``."""


@spelled
class Ensemble(Many):
    """Many trajectories: where they began and ended, and what was observed of them, an entry a trajectory.

    ``ended`` says of each how it ended, as ``Orbit.ended`` says of one: ``"complete"``, ``"range"``, or
    ``"escaped"`` beyond a bound that was asked for. Where one ended early its point and what was
    observed are NaN, but for the step of its escape.
    """

    system: System
    """The field, with its parameters."""
    start: Array
    """The first points, of shape (trajectories, variables) or with the axes that were given, as (40, 40, variables)."""
    given: dict[str, Array]
    """``eps`` and what was given as ``params``, by name: one number, or one a trajectory."""
    x: Array
    """The last points, of the same shape: NaN where a trajectory ended early."""
    observed: dict[str, Array]
    """The observed columns by name: a number for each start, in ``spectrum`` one for each variable."""
    derivatives: dict[str, Array]
    """The derivatives of ``x``, each of its shape, by the names of ``derivatives=``; see ``System.ensemble``."""

    def __init__(self, system: System, start: Array, given: dict[str, Array], x: Array, ends: tuple[list[str], Array, Array],
                 observed: dict[str, Array]) -> None:
        lead = start.shape[:-1]

        def shaped(values: Array) -> Array:
            return values if values.shape[: len(lead)] == lead else values.reshape(lead + values.shape[1:])

        self.system, self.start, self.given, self.x = system, start, given, shaped(x)
        self._end(ends)
        self.observed = {name: shaped(values) for name, values in observed.items()}
        self.derivatives = in_order((), (), x)

    def __repr__(self) -> str:
        seen = f"; observed: {', '.join(self.observed)}" if self.observed else ""
        return f"<Ensemble of {len(self)} trajectories{self._early()}{seen}>"

    def columns(self) -> dict[str, Array]:
        """The first points, as ``start_x``, ``eps`` and parameters that were given, the last points, how and
        after how many steps each ended, and what was observed, by name; of the spectrum ``spectrum_1`` and
        so on."""
        start = {f"start_{name}": values for name, values in self.system._columns(self.start).items()}
        given = {name: np.broadcast_to(values, self.steps.shape).ravel() for name, values in self.given.items()}
        ends = {"ended": self.ended.ravel(), "ended_step": self.steps.ravel()}
        seen: dict[str, Array] = {}
        for name, values in self.observed.items():
            rows = values.reshape(len(self), -1)
            columns = [(name, rows[:, 0])] if values.ndim == self.steps.ndim else ((f"{name}_{k}", row) for k, row in enumerate(rows.T, 1))
            seen.update(columns)
        return {**start, **given, **self.system._columns(self.x), **ends, **seen}

    def __getitem__(self, name: str) -> Array:
        return self.observed[name] if name in self.observed else super().__getitem__(name).reshape(self.steps.shape)

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of last points, ends and observed columns over the axes of the starts.

        First points, ``eps`` and parameters are coordinates. Needs xarray.
        """
        dims, coordinates = self._over_starts()
        columns = {name: (dims, values.reshape(self.steps.shape)) for name, values in self.columns().items() if name not in coordinates}
        return needed("xarray").Dataset(columns, coordinates, {"field": self.system.text})

    def __len__(self) -> int:
        return self.steps.size

    def plot(self, *axes: str, color: str | None = None, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws a dot a trajectory over two columns, by default the last points' first two variables.

        ``color`` is a column that colours the dots. Needs matplotlib. ``style`` goes to
        ``Axes.scatter``; returns the axes.
        """
        from ._plot import ensemble

        return ensemble(self, axes, color, ax, style)


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
    """The numbers; not a number where an orbit ended early."""
    ended: Array
    """How each orbit ended: ``"complete"``, ``"escaped"`` beyond ``escape``, or ``"range"``."""
    ended_step: Array
    """The steps to the last point of each orbit."""
    meaning: str
    """What the numbers are, with their unit."""
    of: str
    """Of which orbits they are."""

    def __init__(self, system: System, axes: dict[str, Array], color: str, values: Array, ended: Array, ended_step: Array,
                 meaning: str, of: str) -> None:
        self.system, self.axes, self.color, self.values = system, axes, color, values
        self.ended, self.ended_step, self.meaning, self.of = ended, ended_step, meaning, of

    @property
    def escaped(self) -> Array:
        """The step after which a variable is beyond ``escape``; not a number where none is. What is beyond
        all numbers is beyond a size."""
        beyond: Array = np.where(self.ended == "range", self.ended_step + 1.0, np.nan)
        return np.where(self.ended == "escaped", self.ended_step, beyond)

    def _whole(self) -> Array:
        return self.values

    def __len__(self) -> int:
        return self.values.size

    def __repr__(self) -> str:
        sizes = " x ".join(f"{name}: {len(values)}" for name, values in self.axes.items())
        return f"<Chart of {self.color} of {self.system.name} over {sizes}>"

    def columns(self) -> dict[str, Array]:
        """What is gone through, the numbers, and how and when the orbits ended, by name; a row a cell."""
        grid = np.meshgrid(*self.axes.values(), indexing="ij")
        places = {name: axis.ravel() for name, axis in zip(self.axes, grid)}
        return {**places, self.color: self.values.ravel(), "ended": self.ended.ravel(), "ended_step": self.ended_step.ravel()}

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of the numbers and of how and when the orbits ended, over the axes as coordinates.

        Needs xarray. ``chart.to_xarray()[chart.color].plot(x="a")`` draws two axes with ``a`` across, on a linear scale;
        ``plot`` of the chart itself takes logarithms of SALI and of drifts.
        """
        columns = {self.color: self.values, "ended": self.ended, "ended_step": self.ended_step}
        found = needed("xarray").Dataset({name: (list(self.axes), values) for name, values in columns.items()}, self.axes,
                                         {"field": self.system.text, "orbits": self.of})
        found[self.color].attrs["long_name"] = self.meaning
        return found

    def plot(self, *, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws one axis as a curve, two in colours, the first across; SALI and drifts as logarithms, and
        nothing where an orbit ended early, unless the color is escape; the title counts these cells.

        Needs matplotlib; returns the axes.
        """
        from ._plot import chart

        return chart(self, ax, style)


@spelled
class Section(Frame, Ended):  # type: ignore[misc]
    """Where orbits cross a section: a row a crossing.

    ``jumps`` counts sign changes of ``plane`` without a zero: at a pole of the formula or of the map,
    or where the formula jumps. They are no rows.

    ``ended`` is ``"complete"`` where all steps were made, ``"stopped"`` where the orbit had as many
    crossings before as ``crossings`` asked for, and ``"range"`` where its next point is not finite.
    ``ended_step`` is the number of steps to the last point of the orbit.
    """

    system: System
    """The field, with its parameters."""
    plane: str
    """What vanishes on the section."""
    maxima: str | None
    """The variable whose maxima the section has, if they were asked for."""
    x: Array
    """The crossings, of shape (crossings, variables)."""
    t: Array
    """Their times."""
    n: Array
    """The steps that they come after."""
    given: dict[str, Array]
    """Of many orbits, for each crossing the number of its first point, ``"start"``, and what varies; else empty."""
    steps: Any
    """The steps of the orbit; of many an array, an entry an orbit, as ``ended`` and ``jumps``."""
    ended: Any
    """Why the orbit goes no further."""
    jumps: Any
    """How often ``plane`` changes its sign without a zero."""
    crossings: Array
    """How many crossings each orbit has."""
    eps: float | None
    """Half the time step; ``None`` where it varies."""

    def __init__(self, system: System, plane: str, maxima: str | None, eps: float | None, columns: list[tuple[str, Array]],
                 is_one: bool, ended: list[str], counts: list[Array]) -> None:
        front = len(columns) - 2 - len(system.variables)
        self.system, self.plane, self.maxima, self.eps, self.given = system, plane, maxima, eps, dict(columns[:front])
        self.n, self.t = columns[front][1], columns[front + 1][1]
        self.x = np.stack([column for _, column in columns[front + 2:]], axis=1)
        steps, self.crossings, jumps = counts
        self.steps, self.ended, self.jumps = steps, np.array(ended, dtype=object), jumps
        if is_one:
            self.steps, self.ended, self.jumps = int(steps[0]), ended[0], int(jumps[0])

    def __repr__(self) -> str:
        count = int(np.sum(self.jumps))
        jumps = f", {count} jumps" if count else ""
        if isinstance(self.ended, str):
            of, end = "", _end(self.ended, self.steps)
        else:
            early = sum(ended not in ("complete", "stopped") for ended in self.ended)
            of, end = f" of {len(self.ended)} orbits", f", {early} ended early" if early else ""
        return f"<{type(self).__name__}{of} of {self.system.name} at {self._place}: {np.sum(self.crossings)} crossings{jumps}{end}>"

    @property
    def _place(self) -> str:
        """The section in words."""
        return f"{self.plane} = 0" if self.maxima is None else f"maxima of {self.maxima}"

    def columns(self) -> dict[str, Array]:
        """What is ``given``, n, t and the variables, by name."""
        counted = {name: values for name, values in (("n", self.n), ("t", self.t)) if name not in self.system.variables}
        return {**self.given, **counted, **self.system._columns(self.x)}

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of the columns, an entry a crossing, with what is ``given`` as coordinates. Needs xarray."""
        columns = {name: ("crossing", values) for name, values in self.columns().items()}
        coordinates = {name: columns.pop(name) for name in self.given}
        return needed("xarray").Dataset(columns, coordinates, {"field": self.system.text, "plane": self.plane})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the crossings over two of the variables, each start in a colour of its own. Needs matplotlib; returns the axes."""
        from ._plot import section

        return section(self, axes, ax, style)


@spelled
class Diagram(Section):
    """Where orbits cross a section, over a parameter or eps: a row a crossing."""

    over: str
    """What goes through values."""
    shown: str
    """The variable that ``plot`` shows."""

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws a variable at the crossings over what goes through values. Needs matplotlib; returns the axes."""
        from ._plot import diagram

        return diagram(self, axes or (self.over, self.shown), ax, style)
