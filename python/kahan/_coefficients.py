"""Conversion between fields and arrays of coefficients."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._arrays import floats

__all__ = ["Entries", "coefficients", "dense", "loaded", "named_wrongly"]

Entries = tuple[tuple[str, ...], tuple[str, ...], tuple[np.ndarray[Any, Any], ...]]
"""The states, the parameters, and arrays with the component, the two states, the parameter and the
value of each coefficient. An index of -1 means no state or parameter.
"""

_PARTS = ("c", "B", "Q")


def _triangle(n: int, order: str) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Returns the states j and k of the columns of a Q that has each product once."""
    return np.tril_indices(n) if order == "tril" else np.triu_indices(n)


def _sparse(given: Any, name: str) -> tuple[tuple[int, ...], tuple[np.ndarray[Any, Any], ...], np.ndarray[Any, Any]]:
    """Returns the shape of an array, the indices of its nonzero entries, and their values."""
    if hasattr(given, "tocoo"):
        entries = given.tocoo()
        indices: tuple[np.ndarray[Any, Any], ...] = tuple(getattr(entries, "coords", None) or (entries.row, entries.col))
        return entries.shape, indices, floats(entries.data, name)
    array = floats(given, name)
    indices = np.nonzero(array)
    return array.shape, indices, array[indices]


def _halves(given: Any, name: str, n: int) -> Any:
    """Returns a dense symmetric Q with each product once, j <= k; any other Q unchanged."""
    if hasattr(given, "tocoo") or np.size(given) != n**3:
        return given
    Q = floats(given, name)
    cube = Q.reshape(n, n, n) if Q.shape in ((n, n, n), (n, n * n)) else None
    if cube is None or not np.array_equal(cube, cube.transpose(0, 2, 1)):
        return given
    j, k = _triangle(n, "triu")
    halves = cube[:, j, k] * np.where(j == k, 1, 2)
    return halves if np.isfinite(halves).all() else given


def _part(given: Any, name: str, n: int, order: str) -> tuple[np.ndarray[Any, Any], ...]:
    """Returns the components, first states, second states (-1 for none) and values of the entries."""
    halves = _halves(given, name, n) if name[0] == "Q" else given
    order = order if halves is given else "triu"
    shape, (component, *columns), values = _sparse(halves, name)
    half = n * (n + 1) // 2
    fitting: dict[str, list[tuple[int, ...]]] = {"c": [(n,)], "B": [(n, n)], "Q": [(n, n, n), (n, n * n), (n, half)]}
    shapes = fitting[name[0]]
    if shape not in shapes:
        wanted = ", ".join(map(str, shapes[:-1])) + " or " * (len(shapes) > 1) + str(shapes[-1])
        raise ValueError(f"{name} has the shape {shape}; with {n} variables it must be {wanted}")
    if not np.isfinite(values).all():
        at = int(np.flatnonzero(~np.isfinite(values))[0])
        place = tuple(int(index[at]) for index in (component, *columns))
        raise ValueError(f"{name}: the entry {place} is {values[at]}")
    none = np.full(len(values), -1)
    if name[0] == "c":
        columns = [none, none]
    elif name[0] == "B":
        columns = [columns[0], none]
    elif len(shape) == 2:
        column = columns[0]
        columns = [of[column] for of in _triangle(n, order)] if shape[1] == half and n > 1 else list(np.divmod(column, n))
    return (component, *columns, values.astype(float))


def coefficients(
    parts: Sequence[Any], names: Sequence[str] | None, parameters: Mapping[str, Any] | None, order: str
) -> Entries:
    """Returns the coefficients of ẋ = c + Bx + Q(x, x), each array possibly ``None``, and those
    that parameters multiply.
    """
    if order not in ("tril", "triu"):
        raise ValueError(f'order: columns of Q stand as "tril" (j <= i) or "triu" (j >= i), not "{order}"')
    # Products come first, as in polynomials.
    groups: list[tuple[int, str, Any]] = [(-1, part, given) for part, given in zip("QBc", parts[::-1]) if given is not None]
    for k, (name, own) in enumerate((parameters or {}).items()):
        if not isinstance(own, Mapping):
            own = dict(zip(_PARTS, own, strict=True))
        for part, given in own.items():
            if part not in _PARTS:
                raise ValueError(f"parameters: {name} multiplies arrays c, B and Q, and there is no `{part}`")
            if given is not None:
                groups.append((k, part, given))
    if not groups:
        raise ValueError("give at least one of the arrays c, B and Q")
    shape = np.shape(groups[0][2])
    if not shape or 0 in shape:
        raise ValueError(f"{groups[0][1]} has the shape {shape}; its first direction is the components of the field")
    n = shape[0]
    states = tuple(names) if names is not None else tuple(f"x{i + 1}" for i in range(n))
    if len(states) != n:
        raise ValueError(f"names: there are {len(states)} and {n} variables")
    known = tuple(parameters or ())
    columns = []
    for k, part, given in groups:
        component, j, l, values = _part(given, part if k < 0 else f"{part} of {known[k]}", n, order)
        columns.append((component, j, l, np.full(len(values), k), values))
    *indices, values = (np.concatenate(column) for column in zip(*columns))
    return states, known, (*(np.ascontiguousarray(index, dtype=np.int64) for index in indices), values)


def named_wrongly(entries: Entries) -> str:
    """Returns the first invalid name of a state or parameter; empty if all are valid."""
    names = [*entries[0], *entries[1]]
    for name in names:
        if names.count(name) > 1:
            return f"names: `{name}` is there twice, and each variable and parameter needs a name of its own"
        if not name.isidentifier():
            return f"names: `{name}` cannot be a variable or parameter; a name has letters, digits and _, and begins with no digit"
    return ""


def dense(n: int, entries: Sequence[Any], sparse: bool) -> tuple[Any, Any, Any]:
    """Returns the arrays c, B and Q of coefficients. Q is symmetric; sparse arrays have a row for each component."""
    component, j, k, values = (np.asarray(column) for column in entries)
    c = np.zeros(n)
    is_c, is_b, is_q = (k < 0) & (j < 0), (k < 0) & (j >= 0), k >= 0
    c[component[is_c]] = values[is_c]
    rows, ours, others, halves = component[is_q], j[is_q], k[is_q], values[is_q] / 2
    # A square has both halves in one place.
    rows, ours, others, halves = np.tile(rows, 2), np.concatenate([ours, others]), np.concatenate([others, ours]), np.tile(halves, 2)
    if sparse:
        from scipy.sparse import coo_array

        B = coo_array((values[is_b], (component[is_b], j[is_b])), shape=(n, n)).tocsr()
        return c, B, coo_array((halves, (rows, ours * n + others)), shape=(n, n * n)).tocsr()
    B, Q = np.zeros((n, n)), np.zeros((n, n, n))
    B[component[is_b], j[is_b]] = values[is_b]
    np.add.at(Q, (rows, ours, others), halves)
    return c, B, Q


def loaded(path: Any) -> dict[str, Any]:
    """Returns the arguments of ``System.from_arrays`` from a file of ``np.savez``: c, B, Q, names
    and order.

    B and Q may be sparse SciPy arrays in row format, stored as ``Q_data``, ``Q_indices`` and
    ``Q_indptr``.
    """
    with open(path, "rb") as stream:
        try:
            file = np.load(stream, allow_pickle=False)
            arrays = None if isinstance(file, np.ndarray) else {name: file[name] for name in file.files}
        except Exception as error:
            # NumPy's message recommends pickles, which can run any code.
            why = "it has arrays of Python's objects" if "Object arrays" in str(error) else "it is damaged, or another file"
            raise ValueError(f"{path} cannot be read as arrays of numbers: {why}; write c, B and Q with np.savez") from None
    if arrays is None:
        raise ValueError(f"{path} has one array; write c, B and Q with np.savez")
    given: dict[str, Any] = {name: arrays.pop(name) for name in _PARTS if name in arrays}
    for name in ("B", "Q"):
        parts = [arrays.pop(f"{name}_{part}", None) for part in ("data", "indices", "indptr")]
        if any(part is not None for part in parts):
            if any(part is None for part in parts) or name in given:
                raise ValueError(f"{path}: a sparse {name} is {name}_data, {name}_indices and {name}_indptr, without {name} itself")
            from scipy.sparse import csr_array

            n = len(parts[2]) - 1
            try:
                given[name] = csr_array(tuple(parts), shape=(n, n if name == "B" else n * n))
            except ValueError as error:
                raise ValueError(f"{path}: {name}_data, {name}_indices and {name}_indptr are no sparse array: {error}") from None
    if "names" in arrays:
        given["names"] = [str(name) for name in arrays.pop("names").tolist()]
    if "order" in arrays:
        given["order"] = str(arrays.pop("order"))
    if arrays:
        raise ValueError(f"{path} has an array `{next(iter(arrays))}`, and a field has c, B, Q, names and order")
    return given
