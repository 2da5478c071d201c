"""Orbits and their observables, as arrays and tables."""

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
    """Named columns of equal length, like a data frame: ``keys()``, ``items()``, ``dict(table)``.

    A column is an entry, ``table["y"]``, and also an attribute unless another attribute has that
    name: ``x`` is always the array of points. Iteration runs over the names, and ``len`` counts the
    rows. ``numpy.asarray`` of a table is its points, or the values of a chart.
    ``polars.DataFrame(table)`` and ``pyarrow.table(table)`` read it through Arrow's capsule
    interface.
    """

    @abstractmethod
    def columns(self) -> dict[str, Array]:
        """Returns the columns by name."""

    def _whole(self) -> Array:
        """Returns the table as one array."""
        whole: Array = self.x
        return whole

    def __getitem__(self, name: str) -> Array:
        columns = self.columns()
        if name not in columns:
            raise KeyError(unknown("column", str(name), columns))
        return columns[name]

    def __getattr__(self, name: str) -> Array:
        # Copying and unpickling ask for names before the table has attributes.
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
        """Returns the names of the columns."""
        return self.columns().keys()

    def items(self) -> ItemsView[str, Array]:
        """Returns pairs of the name and the values of each column."""
        return self.columns().items()

    def __contains__(self, name: object) -> bool:
        return name in self.columns()

    def get(self, name: str, default: Any = None) -> Any:
        """Returns the column of this name, or else the default."""
        return self[name] if name in self else default

    # Equality of arrays has no single answer.
    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self._whole(), dtype=dtype) if copy or dtype is not None else self._whole()

    def to_pandas(self) -> Any:
        """Returns a data frame of the columns. Needs pandas."""
        return needed("pandas").DataFrame(self.columns())

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        """Returns the columns as an Arrow stream, for ``pyarrow.table`` and ``polars.DataFrame``.
        Fractions become text.
        """
        return arrow(list(self.columns().items()))


class Frame(Table, dict[str, Array]):  # type: ignore[misc]
    """A table that ``pandas.DataFrame(table)`` accepts with its column names; pandas requires a
    ``dict``.

    The columns are those of :meth:`columns`. The ``dict`` itself stays empty, so all methods that
    would read or change it are redefined here.
    """

    def values(self) -> ValuesView[Array]:  # type: ignore[override]
        """Returns the columns."""
        return self.columns().values()

    def copy(self) -> dict[str, Array]:
        """Returns the columns as a ``dict``."""
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
    """A table of points of one orbit or of many, which end after ``steps`` steps."""

    x: Array
    steps: Any
    ended: Any

    @property
    def states(self) -> Array:
        """The points, like ``x``; useful if a variable is called ``x``."""
        return self.x

    @property
    def ended_step(self) -> Any:
        """The number of steps to the last point of each orbit, like ``steps``."""
        return self.steps


class Many(Frame, Ended):  # type: ignore[misc]
    """A table of many orbits. Their ends are given as a list of words, the index of each orbit's
    word, and its steps.
    """

    system: System
    start: Array
    given: dict[str, Array]
    steps: Array
    """The number of steps of each orbit; fewer than requested if it ended early."""
    _ends: tuple[list[str], Array, Array]

    def _end(self, ends: tuple[list[str], Array, Array]) -> None:
        self._ends, self.steps = ends, ends[2].reshape(self.start.shape[:-1])

    def _over_starts(self) -> tuple[list[str], dict[str, Any]]:
        """Returns the dimensions of the initial points, and their coordinates: numbers, initial
        points and ``given``.
        """
        shape = self.steps.shape
        dims = ["start"] if len(shape) == 1 else [f"start_axis_{k}" for k in range(len(shape))]
        numbers = {name: np.arange(size) for name, size in zip(dims, shape)}
        points = {f"start_{name}": (dims, values.reshape(shape)) for name, values in self.system._columns(self.start).items()}
        given = {name: (dims, values.reshape(shape)) if values.ndim else values for name, values in self.given.items()}
        return dims, {**numbers, **points, **given}

    @cached_property
    def ended(self) -> Array:
        """The reason for the end of each orbit, in one word."""
        ended: Array = np.array(self._ends[0], dtype=object)[self._ends[1]].reshape(self.steps.shape)
        return ended

    def _early(self) -> str:
        early = int(np.sum(self.ended != "complete"))
        return f", {early} ended early" if early else ""


class Stepped(Ended):
    """A table with a row after every ``every`` steps of one orbit."""

    x: Array
    """The points or states, the initial one first."""
    every: int
    """The number of steps between rows."""
    transient: int = 0
    """The number of steps before the first row."""
    steps: int
    """The number of steps made; fewer than requested if the orbit ended early."""
    ended: str
    """The reason for the end, in one word."""

    @property
    def n(self) -> Array:
        """The number of steps from the initial point to each row."""
        return self.transient + self.every * np.arange(len(self.x))


@spelled
class Orbit(Stepped):
    """The points of one orbit: row ``x[k]`` is the point after ``n[k]`` steps.

    ``ended`` is ``"complete"`` if all steps were made. It is ``"range"`` if the next point is
    beyond the range of floats, as at poles in floats, and ``"pole"`` if in exact numbers it has no
    value (det A = 0). For a lifted field it is ``"range"`` if a root would be negative, and
    ``"reembed"`` if the symmetric projection does not converge; ``why`` explains this.
    ``ended_step`` is the number of steps to the last point.
    """

    system: System
    """The field, with its parameters."""
    eps: float | Fraction
    """Half the time step; a fraction for an exact orbit."""
    x: Array
    """The points, of shape (rows, variables); the first is the initial point, or the point after the transient."""
    x_low: Array | None = None
    """The low parts of double-doubles: the points are ``x + x_low``. Otherwise ``None``."""
    why: str | None = None
    """An explanation of the end, for a lifted field."""
    _order: int | None = None
    # The order is known for steps of Kahan's map in floats on a quadratic field.
    derivatives: dict[str, Array]
    """The derivatives of ``x``, by the names in ``derivatives=``, each with the shape of ``x``; see
    ``System.orbit``.
    """

    def __init__(
        self, system: System, eps: float | Fraction, x: Array, every: int, steps: int, ended: str,
        integrals: float | dict[str, Array], in_all: Array | None = None,
    ) -> None:
        self.system, self.eps, self.x, self.every = system, eps, x, every
        self.steps, self.ended, self.derivatives = steps, ended, in_order((), (), x)
        self._integrals, self._in_all = integrals, in_all

    @property
    def t(self) -> Array:
        """The time of each row, 2 eps n. For equations that contain ``t``, it begins at ``t0``."""
        n = self.n.astype(object) if isinstance(self.eps, Fraction) else self.n
        times: Array = 2 * self.eps * n
        start = self.system._time[0]
        if start:
            times = times + (Fraction(start) if isinstance(self.eps, Fraction) else start)
        return times

    @cached_property
    def integrals(self) -> dict[str, Array]:
        """The claimed integrals of each row, by name.

        Claims with a condition ``when`` are included if the parameters and eps meet it.

        Claims are about Kahan's map at this eps. Compositions (``order`` above 2) and other methods
        do not preserve these integrals: they follow the flow, and their integrals are the claims at
        eps = 0, NaN where these have no value.
        """
        given = self._integrals
        in_all = self.x if self._in_all is None else self._in_all
        found = given if isinstance(given, dict) else self.system._integrals_in_all(in_all, given)
        return Named(found, "claimed integral", "`s.discover().claimed` has those found")

    def gradient(self, weights: Any, by: str | Sequence[str] | None = None, *, progress: bool = False) -> dict[str, float]:
        """Returns the gradient of a scalar L of the orbit with respect to the initial point, the
        parameters and eps.

        ``weights`` are the derivatives of L with respect to ``x``, in the shape of ``x``: ``2*(o.x
        - data)`` if L is the sum of squares of ``o.x - data``. ``by`` names parameters, variables
        (for that coordinate of the initial point) and ``"eps"``, by default all. The result has a
        number for each.

        One backward sweep over the orbit computes all of them; the time hardly grows with the
        number of parameters. The steps are recomputed in float64 from checkpoints, so memory grows
        with the square root of the number of steps.

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
        """Returns n, t, the variables and the integrals by name; for double-doubles also ``x_low`` after ``x``."""
        columns = {"n": self.n, "t": self.t}
        for k, name in enumerate(self.system.variables):
            columns[name] = self.x[:, k]
            if self.x_low is not None:
                columns[f"{name}_low"] = self.x_low[:, k]
        return columns | self.integrals

    def to_xarray(self) -> Any:
        """Returns an ``xarray.Dataset`` of the columns over the coordinate ``t``, with ``n`` as a
        second one. Needs xarray.
        """
        columns = self.columns()
        del columns["t"]
        beside = {"n": ("t", columns.pop("n"))} if "n" not in self.system.variables else {}
        return needed("xarray").Dataset({name: ("t", column) for name, column in columns.items()},
                                        {"t": self.t, **beside}, {"field": self.system.text, "eps": float(self.eps)})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the orbit over two or three columns, as ``"t", "H"``; by default the first three
        variables.

        With two axes, points are dots; with three, or if one is the time, they are joined by lines.
        Needs matplotlib. ``style`` is passed to ``Axes.plot``, and short names such as ``lw`` and
        ``ms`` are accepted. Returns the axes.
        """
        from ._plot import orbit

        return orbit(self, axes, ax, style)


class FloatOrbit(Frame, Orbit):  # type: ignore[misc]
    """An orbit in floats or double-doubles. (Arrow takes fractions as text, but not from a ``dict``.)"""


@spelled
class Ensemble(Many):
    """Many trajectories: their first and last points and observables, an entry for each trajectory.

    ``ended`` is the reason for the end of each trajectory, as in ``Orbit.ended``: ``"complete"``,
    ``"range"``, or ``"escaped"`` beyond the bound ``escape``. If a trajectory ended early, its
    point and observables are NaN, except the step of its escape.
    """

    system: System
    """The field, with its parameters."""
    start: Array
    """The initial points, of shape (trajectories, variables) or with the given axes, as (40, 40, variables)."""
    given: dict[str, Array]
    """``eps`` and the values of ``params``, by name: one number, or one for each trajectory."""
    x: Array
    """The last points, in the shape of ``start``; NaN if a trajectory ended early."""
    observed: dict[str, Array]
    """The observables by name: a number for each trajectory; ``spectrum`` has one for each variable."""
    derivatives: dict[str, Array]
    """The derivatives of ``x``, by the names in ``derivatives=``, each with the shape of ``x``; see
    ``System.ensemble``.
    """

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
        """Returns all columns by name.

        They are the initial points (as ``start_x``), ``eps`` and the given parameters, the last
        points, the reason and the step of each end, and the observables. The spectrum has the
        columns ``spectrum_1``, ``spectrum_2``, ….
        """
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
        """Returns an ``xarray.Dataset`` of the last points, ends and observables over the axes of
        the initial points.

        The initial points, ``eps`` and parameters are coordinates. Needs xarray.
        """
        dims, coordinates = self._over_starts()
        columns = {name: (dims, values.reshape(self.steps.shape)) for name, values in self.columns().items() if name not in coordinates}
        return needed("xarray").Dataset(columns, coordinates, {"field": self.system.text})

    def __len__(self) -> int:
        return self.steps.size

    def plot(self, *axes: str, color: str | None = None, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws each trajectory as a dot over two columns, by default the first two variables of
        the last points.

        ``color`` names a column that colours the dots. Needs matplotlib. ``style`` is passed to
        ``Axes.scatter``. Returns the axes.
        """
        from ._plot import ensemble

        return ensemble(self, axes, color, ax, style)


@spelled
class Chart(Table):
    """An observable of orbits over one or more axes: ``values[i, j]`` belongs to the i-th and j-th
    value of ``axes``.
    """

    system: System
    """The field, with its parameters."""
    axes: dict[str, Array]
    """The names and values of the axes, in the order of the axes of ``values``."""
    color: str
    """The name of the observable."""
    values: Array
    """The values of the observable; NaN if an orbit ended early."""
    ended: Array
    """The reason for the end of each orbit: ``"complete"``, ``"escaped"`` beyond ``escape``, or ``"range"``."""
    ended_step: Array
    """The number of steps to the last point of each orbit."""
    meaning: str
    """The meaning of the values, with their unit."""
    of: str
    """A description of the orbits."""

    def __init__(self, system: System, axes: dict[str, Array], color: str, values: Array, ended: Array, ended_step: Array,
                 meaning: str, of: str) -> None:
        self.system, self.axes, self.color, self.values = system, axes, color, values
        self.ended, self.ended_step, self.meaning, self.of = ended, ended_step, meaning, of

    @property
    def escaped(self) -> Array:
        """The step after which a variable exceeds ``escape``; NaN if none does. An overflow counts as an escape."""
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
        """Returns the axes, the values, and the reason and step of each end, by name; a row for each cell."""
        grid = np.meshgrid(*self.axes.values(), indexing="ij")
        places = {name: axis.ravel() for name, axis in zip(self.axes, grid)}
        return {**places, self.color: self.values.ravel(), "ended": self.ended.ravel(), "ended_step": self.ended_step.ravel()}

    def to_xarray(self) -> Any:
        """Returns an ``xarray.Dataset`` of the values and ends, with the axes as coordinates.

        Needs xarray. ``chart.to_xarray()[chart.color].plot(x="a")`` draws two axes, with ``a``
        horizontal, on a linear scale; ``chart.plot`` takes logarithms of SALI and of drifts.
        """
        columns = {self.color: self.values, "ended": self.ended, "ended_step": self.ended_step}
        found = needed("xarray").Dataset({name: (list(self.axes), values) for name, values in columns.items()}, self.axes,
                                         {"field": self.system.text, "orbits": self.of})
        found[self.color].attrs["long_name"] = self.meaning
        return found

    def plot(self, *, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws a curve for one axis, or cells in colours for two, the first one horizontal.

        SALI and drifts are drawn as logarithms. Cells of orbits that ended early stay empty, unless
        the color is escape; the title counts them.

        Needs matplotlib; returns the axes.
        """
        from ._plot import chart

        return chart(self, ax, style)


@spelled
class Section(Frame, Ended):  # type: ignore[misc]
    """Where orbits cross a section: a row for each crossing.

    ``jumps`` counts sign changes of ``plane`` without a zero: at a pole of the formula or of the
    map, or where the formula jumps. They have no rows.

    ``ended`` is ``"complete"`` if all steps were made, ``"stopped"`` if the orbit reached the
    number ``crossings`` before that, and ``"range"`` if its next point is not finite.
    ``ended_step`` is the number of steps to the last point of the orbit.
    """

    system: System
    """The field, with its parameters."""
    plane: str
    """The formula that vanishes on the section."""
    maxima: str | None
    """The variable whose maxima form the section, if requested."""
    x: Array
    """The crossings, of shape (crossings, variables)."""
    t: Array
    """The times of the crossings."""
    n: Array
    """The number of steps before each crossing."""
    given: dict[str, Array]
    """For many orbits: for each crossing, the number of its initial point, ``"start"``, and the
    values that vary; otherwise empty.
    """
    steps: Any
    """The number of steps of the orbit. For many orbits it is an array with one entry each, and so
    are ``ended`` and ``jumps``.
    """
    ended: Any
    """The reason for the end of the orbit."""
    jumps: Any
    """The number of sign changes of ``plane`` without a zero."""
    crossings: Array
    """The number of crossings of each orbit."""
    eps: float | None
    """Half the time step; ``None`` if it varies."""

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
        """A description of the section."""
        return f"{self.plane} = 0" if self.maxima is None else f"maxima of {self.maxima}"

    def columns(self) -> dict[str, Array]:
        """Returns the ``given`` values, n, t and the variables, by name."""
        counted = {name: values for name, values in (("n", self.n), ("t", self.t)) if name not in self.system.variables}
        return {**self.given, **counted, **self.system._columns(self.x)}

    def to_xarray(self) -> Any:
        """Returns an ``xarray.Dataset`` of the columns, an entry for each crossing, with the
        ``given`` values as coordinates. Needs xarray.
        """
        columns = {name: ("crossing", values) for name, values in self.columns().items()}
        coordinates = {name: columns.pop(name) for name in self.given}
        return needed("xarray").Dataset(columns, coordinates, {"field": self.system.text, "plane": self.plane})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the crossings over two of the variables, each initial point in its own colour.
        Needs matplotlib. Returns the axes.
        """
        from ._plot import section

        return section(self, axes, ax, style)


@spelled
class Diagram(Section):
    """Where orbits cross a section, over a parameter or eps: a row for each crossing."""

    over: str
    """The parameter that varies, or eps."""
    shown: str
    """The variable that ``plot`` shows."""

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws a variable at the crossings over the parameter that varies. Needs matplotlib. Returns the axes."""
        from ._plot import diagram

        return diagram(self, axes or (self.over, self.shown), ax, style)
