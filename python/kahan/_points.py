"""Conversion of points between arrays and a field."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ._arrays import named
from ._coefficients import Entries
from ._exact import Number, half_step, point
from ._formulas import Formulas
from ._lifted import Lift, Lifted
from ._orbit import Array

if TYPE_CHECKING:
    from ._system import System

__all__ = ["Points"]


class Points(Formulas):
    """A field whose points are arrays of its variables; for a lifted field, the original variables."""

    _call: tuple[str | Entries, bool, int | None, dict[str, str]]
    _lifting: Lift | None

    @property
    def _system(self) -> System:
        """The field, typed as the ``System`` that answers refer to."""
        return cast("System", self)

    @property
    def variables(self) -> tuple[str, ...]:
        """The state variables, in the order of arrays; for a lifted field, the original ones."""
        return tuple(super().variables)

    @cached_property
    def lifted(self) -> Lifted | None:
        """The lift, if the field was lifted; otherwise ``None``."""
        text = self._lift
        return None if text is None else Lifted(self._system, text)

    @property
    def start(self) -> tuple[Fraction, ...] | None:
        """The initial point in the text, ``x(0) = 1`` or ``init x=1``; ``None`` without one."""
        return None if self._start is None else tuple(Fraction(value) for value in self._start)

    @property
    def _names(self) -> list[str]:
        """Returns the names that columns of a table may have."""
        return [*self.variables, *self.parameters, "eps"]

    def _at(self, x: Any) -> Any:
        """Returns a point, or points, in the order of the variables, matched by names if there are
        any; for ``None`` the start of the text.
        """
        if x is None:
            start = self.start
            if start is None:
                raise TypeError("x is missing: the text gives no start, as `init x=1` for every variable")
            return list(start)
        return named(x, self)

    def _one(self, x: Any) -> Any:
        """Returns a point in the order of the variables; a table with one row counts as a point."""
        at = self._at(x)
        is_row = at is not x and isinstance(at, np.ndarray) and at.ndim == 2 and len(at) == 1
        return at[0] if is_row else at

    def _in_all(self, x: Any, parameters: Sequence[Any] = ()) -> Any:
        """Returns points of all variables; the new variables of a lifted field are functions of the original ones."""
        if self._lifting is None:
            return x
        embedded = self._embedded(x, list(parameters))
        return embedded.astype(np.float32) if getattr(x, "dtype", None) == np.float32 else embedded

    def _out_of_all(self, x: Array, out: Array | None = None) -> Array:
        """Returns the points in the variables of arrays, from points of all variables."""
        shown = x if self._lifting is None else x[..., self._places]
        if out is None or self._lifting is None:
            return shown
        out[...] = shown
        return out

    def _has_values(self, begun: Any) -> None:
        """Raises ``ValueError`` if a new variable of a lifted field has no value at a finite point."""
        if self._lifting is not None and begun.ndim == 1 and np.isfinite(begun[..., self._places]).all():
            for name, value in zip(self._all_variables, begun):
                if not np.isfinite(value):
                    of = self.lifted.new.get(name) if self.lifted else None
                    raise ValueError(f"x: the new variable {name}{f' = {of}' if of else ''} has no value there; choose another point")

    def _judge(self, x: Any, eps: float) -> None:
        """Warns once if a lift, chosen without an initial point, is inaccurate along an orbit."""
        if self._lifting is None or self._lifting[1] is not None or "_is_judged" in self.__dict__:
            return
        self.__dict__["_is_judged"] = True
        warning = self._relations_warning(x, eps) if eps else None
        if warning:
            warnings.warn(f"{warning} (at=, lift= and reembed=True)", stacklevel=3)

    def _look_at_rates(self, x: Array, eps: float) -> None:
        """Warns if steps do not resolve fast components along the first orbit at an eps."""
        if self.__dict__.get("_is_looked_at") == eps:
            return
        self.__dict__["_is_looked_at"] = eps
        note = self._rates_note(np.asarray(x[:: max(1, len(x) // 16)], dtype=float), eps)
        if note:
            warnings.warn(f"{note}; s.trade measures which eps resolves them", stacklevel=4)

    def _point(self, x: Any) -> list[str]:
        return point(self._one(x))

    def _columns(self, x: Array) -> dict[str, Array]:
        """Returns the columns of points by the names of the variables."""
        return dict(zip(self.variables, x.reshape(-1, x.shape[-1]).T))

    def integral_values(self, x: Any, eps: Number | None = None, *, dt: Number | None = None) -> dict[str, Array]:
        """Returns the claimed integrals at points, by name. ``x`` has shape (variables,) or
        (points, variables).

        Integrals of the map depend on eps. Some are claimed only ``when`` eps and the parameters
        have certain values.
        """
        return self._integrals_in_all(self._in_all(self._at(x)), half_step(eps, dt))

    def _integrals_in_all(self, x: Any, eps: Number) -> dict[str, Array]:
        names, values = self._integrals_at(x, eps)
        return {name: values[..., k] for k, name in enumerate(names)}

    def integral_functions(self, eps: Number = 0.0) -> dict[str, Callable[[Any], Any]]:
        """Returns the claimed integrals as functions of a point, for methods that project onto
        their level sets.

        At ``eps`` = 0 they are the integrals of the flow, as far as it has them; otherwise those of
        the map.
        """
        names = self._integrals_at(np.zeros(len(self.variables)), eps)[0]
        return {name: partial(_integral_value, self, name, eps) for name in names}


def _integral_value(field: Points, name: str, eps: Number, x: Any) -> Array:
    return field.integral_values(x, eps)[name]
