"""Formulas of a field and of its map, as text, LaTeX, SymPy expressions and functions of points."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from ._arrays import by_name, floats, one_order, read
from ._errors import needed, unknown
from ._exact import Number, exact, half_step
from ._kahan import Program, columns

__all__ = ["Formula", "Symbols"]


class Symbols(NamedTuple):
    """The names in formulas of a field, besides ``eps``."""

    variables: tuple[str, ...]
    """The state variables, in order."""
    parameters: dict[str, Fraction | None]
    """The parameters with their values; ``None`` for a parameter without a value."""
    functions: dict[str, str]
    """Constants and claims, as text. Later claims may use their names."""

    @property
    def _names(self) -> list[str]:
        """Returns the names that columns of a table may have."""
        return [*self.variables, *self.parameters, "eps"]

    def _matched(self, names: list[str], name: str, varies: bool) -> tuple[list[int], list[tuple[str, int]]]:
        return columns(names, list(self.variables), list(self.parameters), varies, name)


class Formula:
    """A formula, or a vector or a matrix of formulas.

    ``str`` writes it in the language of ``kahan!``, in which ``eps`` is half the time step;
    ``latex`` and ``sympy()`` write it in other notations. Entries of vectors and matrices are
    selected by index or by variable. A call evaluates the formula at points.

    >>> import kahan
    >>> A = kahan.System("xdot = y; ydot = x^2;").A
    >>> A.shape, str(A[1, 0]), A["y", "x"].sympy()
    ((2, 2), '-2*eps*x', -2*eps*x)
    >>> float(A[1, 0]([3, 4], eps=0.25)), A([3, "1/2"], eps="1/4")[1, 0]
    (-1.5, Fraction(-3, 2))
    """

    name: str
    """The name of the claim; empty for a derived formula."""
    when: str
    """The condition of the claim; empty if it always holds."""

    def __init__(self, read: Callable[[str], Any], of: Symbols, name: str = "", when: str = "") -> None:
        self._read, self._of, self.name, self.when = read, of, name, when

    @property
    def _text(self) -> Any:
        return self._read("text")

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of a vector or matrix; ``()`` for a single formula."""
        text, sizes = self._text, []
        while isinstance(text, list):
            sizes.append(len(text))
            text = text[0] if text else ""
        return tuple(sizes)

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("this is one formula, which has no length")
        return self.shape[0]

    def __iter__(self) -> Iterator[Formula]:
        return (self[k] for k in range(len(self)))

    def __getitem__(self, place: int | str | tuple[int | str, ...]) -> Formula:
        places = [self._index(k) for k in (place if isinstance(place, tuple) else (place,))]

        def read(form: str) -> Any:
            found = self._read(form)
            for k in places:
                if not isinstance(found, list):
                    raise IndexError(f"a formula of shape {self.shape} has no entry {place}")
                found = found[k]
            return found

        read("text")
        return Formula(read, self._of)

    def _index(self, place: int | str) -> int:
        if not isinstance(place, str):
            return place
        if place not in self._of.variables:
            raise KeyError(unknown("variable", place, self._of.variables))
        return self._of.variables.index(place)

    def __call__(self, x: Any, eps: Number | np.ndarray[Any, Any] | None = None, *,
                 dt: Number | np.ndarray[Any, Any] | None = None, **parameters: Any) -> Any:
        """Returns the values at points.

        ``x`` has shape (variables,) or (points, variables), or it is a table with a column for each
        variable, and optionally for parameters and ``eps``. The entries of a vector or matrix are
        the last axes of the result.

        ``eps``, or ``dt`` = 2 eps, is required if the formula contains it, and so are parameters
        without a value in the field. Each is one number, or one for each point. Coordinates given
        as fractions or text yield exact values, as fractions; at a pole they raise
        ``ZeroDivisionError``, while floats become infinite or NaN. Floats agree bit for bit with
        those of the command.
        """
        given = [value for _, value in by_name(x, lambda: self._of._names) or ()]
        one_order([*given, eps, dt, *parameters.values()])
        eps = half_step(eps, dt, is_needed=False)
        x, own = read(x, self._of, varies=True)
        eps = own.pop("eps", None) if eps is None else eps
        if own.keys() & parameters.keys() or "eps" in own:
            raise TypeError(f"{', '.join(own.keys() & {*parameters, 'eps'})}: given twice, as a column, too; leave one of them out")
        parameters |= own
        array = np.asarray(x)
        is_exact = array.dtype.kind in "OU"
        array = np.vectorize(_fraction, otypes=[object])(array, "x") if is_exact else floats(x, "x")
        variables, known, functions = self._of
        if array.ndim == 0 or array.shape[-1] != len(variables):
            raise ValueError(f"x: a point has {len(variables)} coordinates, one a variable, and the shape is {array.shape}")
        for name in parameters:
            if name not in known:
                raise TypeError(unknown("parameter", name, known))
            if known[name] is not None:
                raise TypeError(f"{name} is {known[name]} in this formula; the field with another value has another one")
        values: dict[str, Any] = dict(zip(variables, np.moveaxis(array, -1, 0)))
        for name, value in {"eps": eps, **known, **parameters}.items():
            if value is not None:
                exactly = np.vectorize(_fraction, otypes=[object])(value, name)
                values[name] = exactly if is_exact else exactly.astype(array.dtype)
        names = (*variables, *known, "eps")
        program = _program(names, tuple(functions.items()), tuple(np.ravel(self._text).tolist()))
        for name in (names[k] for k in program.needed):
            if name not in values:
                raise TypeError(f"the formula depends on {name}: add {name}=… to the call")
        shape, points = array.shape[:-1], math.prod(array.shape[:-1])
        rows = [np.broadcast_to(values[names[k]], shape).ravel() for k in program.needed]
        found: Any
        if is_exact:
            parts = [(value.numerator, value.denominator) for row in rows for value in row]
            found = np.array([Fraction(*value) for value in program.fractions(parts, points)], dtype=object)
        else:
            found = program.floats(np.array(rows, dtype=array.dtype), points)
        return found.reshape(shape + self.shape)[()]

    def __str__(self) -> str:
        text = self._text
        if not isinstance(text, list):
            return str(text)
        rows = [", ".join(row) if isinstance(row, list) else row for row in text]
        return "\n".join(f"[{row}]" for row in rows)

    def __repr__(self) -> str:
        return f"<{self.name + ' = ' if self.name else ''}{self}>"

    def __eq__(self, other: object) -> bool:
        return self._text == other._text if isinstance(other, Formula) else NotImplemented

    def __hash__(self) -> int:
        return hash(str(self))

    def __reduce__(self) -> tuple[Callable[..., Formula], tuple[Any, ...]]:
        return (_of_texts, ({form: self._read(form) for form in ("text", "latex", "sympy")}, self._of, self.name, self.when))

    @property
    def latex(self) -> str:
        """The formula in LaTeX; a vector is written as a column."""
        found = self._read("latex")
        if not isinstance(found, list):
            return str(found)
        rows = [row if isinstance(row, list) else [row] for row in found]
        return r"\begin{pmatrix}" + r" \\ ".join(" & ".join(row) for row in rows) + r"\end{pmatrix}"

    def sympy(self) -> Any:
        """Returns the formula as a SymPy expression; a vector becomes a column matrix. Needs SymPy.

        Names become plain symbols, and exact numbers become rationals.
        """
        from ._sympy import expression

        found = self._read("sympy")
        if not isinstance(found, list):
            return expression(found)
        return needed("sympy", "sympy").Matrix([
            [expression(entry) for entry in row] if isinstance(row, list) else [expression(row)] for row in found
        ])

    def _repr_latex_(self) -> str:
        left = rf"{self.name} = " if self.name else ""
        return rf"$\displaystyle {left}{self.latex}$"


def _of_texts(texts: dict[str, Any], of: Symbols, name: str, when: str) -> Formula:
    return Formula(texts.__getitem__, of, name, when)


def _fraction(value: Number, name: str) -> Fraction:
    return value if isinstance(value, Fraction) else Fraction(exact(value, name))


@lru_cache(maxsize=256)
def _program(names: tuple[str, ...], definitions: tuple[tuple[str, str], ...], texts: tuple[str, ...]) -> Program:
    program: Program = Program(names, definitions, texts)
    return program
