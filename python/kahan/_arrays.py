"""Conversion of arguments to arrays of floats, with named columns in the order of the variables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from ._errors import unknown
from ._exact import nearest
from ._orbit import Array, Ensemble, Orbit, Section

__all__ = ["Columns", "by_name", "constants", "flat", "floats", "named", "one_order", "read", "unnamed"]


class Columns(Protocol):
    """A field or a formula with its names."""

    @property
    def _names(self) -> Sequence[str]:
        """Returns the names that columns may have."""

    def _matched(self, names: list[str], name: str, varies: bool) -> tuple[list[int], list[tuple[str, int]]]:
        """Returns the columns of the variables among ``names``; with ``varies`` also those of
        parameters and ``eps``.
        """


def _labels(labels: Iterable[Any]) -> list[str]:
    """Returns labels as names; empty if they only count from 0, as in a default index."""
    labels = list(labels)
    return [] if labels == list(range(len(labels))) else [str(label) for label in labels]


def by_name(given: Any, known: Callable[[], Sequence[str]] = tuple) -> list[tuple[str, Any]] | None:
    """Returns the names and values of the columns of a table, or of the coordinates of a point;
    ``None`` without names.

    Levels of a pandas index count as columns if their names are ``known``.
    """
    if isinstance(given, (np.ndarray, np.void)):
        return [(name, given[name]) for name in given.dtype.names or ()] or None
    if isinstance(given, (Orbit, Ensemble, Section)):
        return [(name, given.x[..., k]) for k, name in enumerate(given.system.variables)]
    if isinstance(given, Mapping):
        return [(str(name), value) for name, value in given.items()]
    if isinstance(given, (list, tuple)):
        fields = getattr(given, "_fields", None)
        if fields is not None:
            return list(zip(fields, given))
        return _of_records(given) if given and not isinstance(given[0], (int, float, list, str)) else None
    if hasattr(given, "__arrow_c_stream__") and not hasattr(given, "__array__") and not hasattr(given, "column_names"):
        import pyarrow

        given = pyarrow.table(given)
    if hasattr(given, "column_names"):
        return [(str(name), given.column(k)) for k, name in enumerate(given.column_names)]
    index, columns = getattr(given, "index", None), getattr(given, "columns", None)
    if columns is not None and not callable(columns):
        labels, has_places = _labels(columns), hasattr(given, "iloc")
        found = [(name, given.iloc[:, k] if has_places else given[name]) for k, name in enumerate(labels)]
        levels: Any = index if found and hasattr(index, "get_level_values") else None
        shared = [name for name in levels.names if name in known()] if levels is not None else []
        return found + [(name, levels.get_level_values(name)) for name in shared] or None
    if hasattr(given, "iloc"):
        return [(name, given.iloc[k]) for k, name in enumerate(_labels(given.index))] or None
    return None


def _of_records(given: Sequence[Any]) -> list[tuple[str, Any]] | None:
    """Returns the columns of a list of points, which must all have the same names."""
    records = [by_name(one) for one in given]
    if not any(records):
        return None
    names = [name for name, _ in records[0] or ()]
    rows = [dict(record or ()) for record in records]
    if any(sorted(name for name, _ in record or ()) != sorted(names) for record in records):
        raise ValueError("the points of a list have the same names, or all of them none")
    return [(name, [row[name] for row in rows]) for name in names]


def read(given: Any, of: Columns, name: str = "x", varies: bool = False) -> tuple[Any, dict[str, Any]]:
    """Returns points with named columns in the order of the variables, and the columns of
    parameters and ``eps``.

    Raises ``ValueError`` for a variable without a column, a name that occurs twice, and an unknown
    column.
    """
    found = by_name(given, lambda: of._names)
    if found is None:
        return given, {}
    states, others = of._matched([label for label, _ in found], name, varies)
    one_order(found[k][1] for k in (*states, *(k for _, k in others)))
    arrays = [_column(*found[k], name) for k in states]
    more = {label: found[k][1] for label, k in others}
    shapes = {array.shape: found[k][0] for array, k in zip(arrays, states)} | {np.shape(value): label for label, value in more.items()}
    sizes = [shape for shape in shapes if shape]
    if len(sizes) > 1:
        told = ", ".join(f"`{shapes[shape]}` {shape}" for shape in sizes)
        raise ValueError(f"{name}: columns have one shape, or one number for all rows, and these have {told}")
    if not sizes and len({array.dtype for array in arrays}) > 1:
        # Beside floats, integers and fractions stay exact.
        arrays = [array.astype(object) for array in arrays]
    shape = sizes[0] if sizes else ()
    return np.stack([np.broadcast_to(array, shape) for array in arrays], axis=-1), more


def named(given: Any, of: Columns, name: str = "x") -> Any:
    """Returns named columns in the order of the variables, and unnamed numbers unchanged."""
    return read(given, of, name)[0]


def _column(label: str, values: Any, name: str) -> Array:
    array = np.asarray(values)
    if array.dtype.kind not in "fiubOU":
        raise TypeError(f"{name}: the column `{label}` has {array.dtype}, and numbers are needed")
    return array


def constants(eps: Any, own: dict[str, Any], params: Any, parameters: Iterable[str]) -> dict[str, Array]:
    """Returns ``eps`` and the values of parameters by name; ``own`` are columns from the table of initial points."""
    parameters = list(parameters)
    table = [] if params is None else by_name(params, lambda: [*parameters, "eps"])
    if table is None:
        raise TypeError(f"params: values with the names of parameters are needed, as a dict or a table, not {type(params).__name__}")
    for label, _ in table:
        if label != "eps" and label not in parameters:
            raise TypeError(f"params: {unknown('parameter', label, parameters)}")
    found: dict[str, Array] = {}
    for label, value in [("eps", eps), *table, *own.items()]:
        if value is not None:
            if label in found:
                raise ValueError(f"{label} is given twice, by itself or as a column; leave one of them out")
            found[label] = _numbers(value, label)
    if "eps" not in found:
        raise TypeError("give eps, half the time step, as an argument or a column, or dt, the time step")
    return {"eps": found.pop("eps"), **found}


def flat(value: Array, name: str, shape: tuple[int, ...]) -> Array:
    """Returns one number, or one for each start, flattened from the ``shape`` of the starts."""
    if value.shape == shape == (0,):
        return np.zeros(())  # No trajectory uses it.
    if value.ndim == 0 or len(shape) < 2:
        return value
    if value.shape != shape:
        raise ValueError(f"{name} has the shape {value.shape}; one number is needed, or one for each start, {shape}")
    return value.reshape(-1)


def one_order(columns: Iterable[Any]) -> None:
    """Checks that columns with row labels, as in pandas, have equal labels, because rows are matched by position."""
    first = None
    for column in columns:
        index = getattr(column, "index", None)
        if index is None or callable(index) or not hasattr(index, "equals"):
            continue
        if first is not None and not first.equals(index) and list(first) != list(index):
            raise ValueError("rows are taken in order, and their labels in these columns are not the same; give columns of one "
                             "table, or their values, as .to_numpy() has them")
        first = index


def unnamed(given: Any, name: str) -> Array:
    """Returns numbers in their order. Raises ``TypeError`` if they have names."""
    found = by_name(given)
    if found is not None and not isinstance(given, (Orbit, Ensemble, Section)):
        raise TypeError(f"{name}: numbers are taken in order here, and these have the names "
                        f"{', '.join(label for label, _ in found)}; give their values as an array")
    return np.asarray(given)


def _numbers(given: Any, name: str) -> Array:
    """Returns numbers in their order, also from a column with row labels."""
    return np.asarray(given) if hasattr(given, "iloc") and not hasattr(given, "columns") else unnamed(given, name)


def floats(given: Any, name: str) -> Array:
    """Returns an array of float32 if given as such, otherwise of float64, in C order.

    Fractions and text become the nearest floats. Raises ``TypeError`` for numbers that are not
    real, or that float64 cannot hold without loss of digits.
    """
    array = _numbers(given, name)
    if array.dtype.kind in "OU":
        array = np.array([nearest(value, name) for value in array.ravel()], dtype=float).reshape(array.shape)
    if array.dtype.kind not in "fiub" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: real numbers up to float64 are needed, and these are {array.dtype}")
    wanted = np.float32 if array.dtype == np.float32 else np.float64
    return np.ascontiguousarray(array, dtype=wanted).reshape(array.shape)
