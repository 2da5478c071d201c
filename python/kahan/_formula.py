"""Formulas of a field and of its map: as text, LaTeX, and SymPy's expressions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

__all__ = ["Formula"]


class Formula:
    """A formula, or a vector or a matrix of formulas.

    ``str`` gives the language of ``kahan!``, in which ``eps`` is half the time step; ``latex`` and
    ``sympy()`` the same for others. Vectors and matrices have entries by index.

    >>> import kahan
    >>> A = kahan.System("xdot = y; ydot = x^2;").A
    >>> A.shape, str(A[1, 0]), A[1, 0].sympy()
    ((2, 2), '-2*eps*x', -2*eps*x)
    """

    name: str
    """The name of what is claimed; empty for what is derived."""
    when: str
    """The condition under which it is claimed; empty where it always holds."""

    def __init__(self, read: Callable[[str], Any], name: str = "", when: str = "") -> None:
        self._read, self.name, self.when = read, name, when

    @property
    def _text(self) -> Any:
        return self._read("text")

    @property
    def shape(self) -> tuple[int, ...]:
        """The sizes of a vector or matrix; ``()`` for one formula."""
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

    def __getitem__(self, place: int | tuple[int, ...]) -> Formula:
        places = place if isinstance(place, tuple) else (place,)

        def read(form: str) -> Any:
            found = self._read(form)
            for k in places:
                if not isinstance(found, list):
                    raise IndexError(f"a formula of shape {self.shape} has no entry {place}")
                found = found[k]
            return found

        read("text")
        return Formula(read)

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
        return (_of_texts, ({form: self._read(form) for form in ("text", "latex", "sympy")}, self.name, self.when))

    @property
    def latex(self) -> str:
        """The formula in LaTeX, a vector as a column."""
        found = self._read("latex")
        if not isinstance(found, list):
            return str(found)
        rows = [row if isinstance(row, list) else [row] for row in found]
        return r"\begin{pmatrix}" + r" \\ ".join(" & ".join(row) for row in rows) + r"\end{pmatrix}"

    def sympy(self) -> Any:
        """The formula as an expression of SymPy, which is needed for it; a vector as a column.

        Names become plain symbols, exact numbers rationals.
        """
        from ._sympy import expression

        found = self._read("sympy")
        if not isinstance(found, list):
            return expression(found)
        import sympy

        return sympy.Matrix([
            [expression(entry) for entry in row] if isinstance(row, list) else [expression(row)] for row in found
        ])

    def _repr_latex_(self) -> str:
        left = rf"{self.name} = " if self.name else ""
        return rf"$\displaystyle {left}{self.latex}$"


def _of_texts(texts: dict[str, Any], name: str, when: str) -> Formula:
    return Formula(texts.__getitem__, name, when)
