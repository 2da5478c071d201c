"""Points along many orbits, as one table or as a file."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import Named, needed, spelled, unknown
from ._orbit import Array, Ensemble, Many

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._system import System

__all__ = ["Series"]

_AT_ONCE = 1 << 22
"""The largest count of numbers in memory while a table is reduced or written."""

Ends = tuple[list[str], Array, Array]


@spelled
class Series(Many):
    """Points along many orbits, as one table: ``x[i, k]`` is the point of start ``i`` after
    ``n[k]`` steps.

    ``ended`` is the reason for the end of each orbit, as in ``Orbit.ended``, and ``steps`` its
    number of steps. Points after an early end are NaN. Columns have the length of the table, orbit
    after orbit: ``r["x"]``. ``r.by_start("x")[i, k]`` has the shape of the points.
    """

    system: System
    """The field, with its parameters."""
    start: Array
    """The initial points, of shape (starts, variables) or with the given axes."""
    given: dict[str, Array]
    """``eps`` and the values of ``params``, by name: one number, or one for each start."""
    x: Array
    """The points, of shape (starts, rows, variables); with chosen columns, only the chosen variables."""
    every: int
    """The number of steps between rows."""
    transient: int
    """The number of steps before the first row."""
    steps: Array
    """The number of steps of each orbit, including the transient."""

    def __init__(self, system: System, start: Array, given: dict[str, Array], asked: int, every: int, transient: int) -> None:
        self.system, self.start, self.given, self.every, self.transient = system, start, given, every, transient
        self._rows, self._names = asked // max(every, 1) + 1, None

    def filled(self, begun: Array, eps: Array, given: list[Any], call: Callable[..., Any], names: list[str] | None, to: Any,
               hear: Any) -> Series | Ensemble:
        """Returns this series with its points, only those of ``names``, or written to a file during the computation."""
        if names is None and to is None or np.ndim(begun) != 2:
            return self._with(*call(begun, eps, parameters=given, listener=hear))
        parts = self._parts(np.asarray(begun), eps, given, call, names, hear)
        if to is not None:
            return _written(self, parts, Path(to))
        # Other columns are computed on demand.
        kept = [name for name in names or () if name in self.system.variables or name not in self._plain()]
        ends: list[Ends] = []
        found: list[list[Array]] = []
        for part in parts:
            ends.append(part._ends)
            found.append([part._flat(name).reshape(-1, self._rows) for name in kept])
        self._end(_joined(ends))
        shape = (*self.start.shape[:-1], self._rows)
        self._taken = {name: np.concatenate(columns).reshape(shape) for name, columns in zip(kept, zip(*found))}
        variables = [self._taken[name] for name in kept if name in self.system.variables]
        self.x, self._names = np.stack(variables, axis=-1) if variables else np.empty((*shape, 0)), names
        return self

    def _parts(self, begun: Array, eps: Array, given: list[Any], call: Callable[..., Any], names: list[str] | None,
               hear: Any) -> Iterator[Series]:
        """Yields series of successive starts, as many as fit in memory at once."""
        count, size = len(begun), max(1, _AT_ONCE // (self._rows * begun.shape[1]))
        start = self.start.reshape(count, -1)
        for first in range(0, max(count, 1), size):
            own = slice(first, first + size)

            def of(value: Any, own: slice = own) -> Any:
                return value if value is None or np.ndim(value) == 0 else np.ravel(value)[own]

            def heard(what: str, done: Any, _: Any, first: int = first, own: int = len(begun[own])) -> None:
                each = self.transient + (self._rows - 1) * self.every
                hear(what, first * each + min(done, own * each), count * each)

            part = Series(self.system, start[own], {name: of(value) for name, value in self.given.items()}, 0, self.every, self.transient)
            part._rows, part._names, part._first = self._rows, names, first
            found = call(begun[own], of(eps), parameters=[of(value) for value in given], listener=hear and heard)
            yield part._with(*found)

    def _with(self, rows: Array, ends: Ends) -> Series:
        lead = self.start.shape[:-1]
        self._in_all = rows
        self.x = self.system._out_of_all(rows).reshape(*lead, *rows.shape[1:-1], -1)
        self._end(ends)
        return self

    _first = 0
    _taken: dict[str, Array] = {}
    _names: list[str] | None

    @property
    def n(self) -> Array:
        """The number of steps from the initial point to each row."""
        return self.transient + self.every * np.arange(self._rows)

    @property
    def t(self) -> Array:
        """The time of each row, 2 eps n; of shape (starts, rows) if starts differ in ``eps``."""
        eps = self.given["eps"]
        times: Array = 2 * (eps[..., None] if eps.ndim else eps) * self.n + (self.system._time[0] or 0)
        return times

    @cached_property
    def integrals(self) -> dict[str, Array]:
        """The claimed integrals of each row, by name, as in ``Orbit.integrals``.

        They are NaN for orbits whose parameters or ``eps`` do not meet the condition of a claim.
        """
        rows = self._in_all
        found: dict[str, Array] = {}
        flat = {name: np.ravel(values) for name, values in self.given.items()}
        # Orbits of one field are evaluated together.
        of_one = all(len(values) == 1 for values in flat.values())
        for own in [slice(None)] if of_one else (slice(k, k + 1) for k in range(len(rows))):
            values: dict[str, Any] = {name: float(values[0 if len(values) == 1 else own.start]) for name, values in flat.items()}
            eps = values.pop("eps")
            system = self.system(**values) if values else self.system
            for name, column in system._integrals_in_all(rows[own], eps).items():
                found.setdefault(name, np.full(rows.shape[:2], np.nan))[own] = column
        shape = (*self.steps.shape, self._rows)
        return Named({name: column.reshape(shape) for name, column in found.items()}, "claimed integral",
                     "`s.discover().claimed` has those found")

    def _plain(self) -> list[str]:
        """Returns the columns other than integrals."""
        given = [name for name, values in self.given.items() if values.ndim]
        return list(dict.fromkeys(["start", *given, "n", "t", *self.system.variables]))

    def _chosen(self) -> list[str]:
        if self._names is None:
            return [*self._plain(), *(name for name in self.integrals if name not in self.system.variables)]
        return self._names

    def _flat(self, name: str) -> Array:
        """Returns a column of the table, one row after the other."""
        count, system = self.steps.size, self.system
        if name in self._taken:
            return self._taken[name].ravel()
        if self._names is not None and name not in self._names:
            raise KeyError(unknown("column", str(name), self._names))
        if name in system.variables:
            return self.x[..., system.variables.index(name)].ravel()
        if name == "t":
            return np.broadcast_to(self.t.reshape(-1, self._rows), (count, self._rows)).ravel()
        if name == "n":
            return np.tile(self.n, count)
        if name == "start":
            return np.repeat(np.arange(self._first, self._first + count), self._rows)
        if name in self.given:
            return np.repeat(np.broadcast_to(self.given[name], self.steps.shape).ravel(), self._rows)
        integrals = self.integrals
        if name not in integrals:
            raise KeyError(unknown("column", str(name), [*self._plain(), *integrals]))
        return integrals[name].ravel()

    def columns(self) -> dict[str, Array]:
        """Returns the columns by name, a row for each point, orbit after orbit.

        They are the number of the start, ``eps`` and parameters that differ, n, t, the variables
        and the integrals, or only the chosen columns.
        """
        return {name: self._flat(name) for name in self._chosen()}

    def __getitem__(self, name: str) -> Array:
        return self._flat(name)

    def by_start(self, name: str) -> Array:
        """Returns a column in the shape (starts, rows)."""
        return self._flat(name).reshape(*self.steps.shape, self._rows)

    def __len__(self) -> int:
        return self.steps.size * self._rows

    def __repr__(self) -> str:
        return f"<Series of {self.system.name}: {self.steps.size} orbits of {self._rows} points{self._early()}>"

    def to_xarray(self) -> Any:
        """Returns an ``xarray.Dataset`` of the columns over the starts and ``t``, or ``n`` if
        starts differ in ``eps``.

        The initial points, ``eps``, parameters and ends are coordinates over the starts. Needs
        xarray.
        """
        dims, beside = self._over_starts()
        differs = self.given["eps"].ndim > 0
        all_dims = [*dims, "n" if differs else "t"]
        times = {"t": (all_dims, self.t), "n": self.n} if differs else {"t": self.t, "n": ("t", self.n)}
        columns = {name: (all_dims, self.by_start(name))
                   for name in self._chosen() if name in self.system.variables or name not in ("start", "n", "t", *self.given)}
        return needed("xarray").Dataset(columns, {**beside, **times, "ended": (dims, self.ended)}, {"field": self.system.text})

    def plot(self, *axes: str, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws each orbit as a line over two or three columns, by default t and the first
        variable. Needs matplotlib.
        """
        from ._plot import series

        return series(self, axes, ax, style)


def _joined(ends: list[Ends]) -> Ends:
    """Returns the ends of trajectories that were computed in parts."""
    words = list(dict.fromkeys(word for part, _, _ in ends for word in part))
    places = [np.array([words.index(word) for word in part], dtype=np.uint8)[own] for part, own, _ in ends]
    return words, np.concatenate(places), np.concatenate([steps for _, _, steps in ends])


def _written(series: Series, parts: Iterator[Series], path: Path) -> Ensemble:
    """Writes the table in parts."""
    ends: list[Ends] = []
    last: list[Array] = []
    with table_file(path) as write:
        for part in parts:
            write(part.columns())
            ends.append(part._ends)
            last.append(part.x[:, -1])
    return Ensemble(series.system, series.start, series.given, np.concatenate(last), _joined(ends), {})


@contextmanager
def table_file(path: Path) -> Iterator[Callable[[dict[str, Array]], None]]:
    """Returns a writer that appends columns to a table file, as row groups or record batches; the
    file appears when it is complete.
    """
    if path.suffix not in (".parquet", ".arrow", ".feather"):
        raise ValueError(f"to: a table is written to F.parquet or F.arrow, not {path}")
    pyarrow = needed("pyarrow")
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    writer: Any = None

    def write(columns: dict[str, Array]) -> None:
        nonlocal writer
        table = pyarrow.table(columns)
        if writer is not None and not len(table):
            # Columns without rows have other types.
            return
        if writer is None:
            if path.suffix == ".parquet":
                from pyarrow import parquet

                writer = parquet.ParquetWriter(unfinished, table.schema)
            else:
                writer = pyarrow.ipc.new_file(unfinished, table.schema)
        writer.write_table(table)

    try:
        yield write
        writer.close()
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
