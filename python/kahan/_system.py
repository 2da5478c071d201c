"""A field, and everything that is asked of it."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ._answer import Answer
from ._exact import Number, answer, exact, point
from ._kahan import Field
from ._orbit import Array, Orbit, Section

__all__ = ["System"]

Range = str | tuple[Number, Number, int]
"""Values with both ends: (low, high, count), or text in the grammar of the command, as "0:1:/20"."""


class System(Field):
    """A quadratic vector field x' = f(x) with its Kahan map.

    ``field`` is the text of the equations in the language of ``kahan!``, or a mapping of SymPy's
    symbols to expressions. Free names are parameters; their values are given by name, exactly
    where they are integers, fractions or text. A float means the decimal that Python prints.
    ``sites`` writes out a chain of a family ``for i in … { … }``.

    >>> import kahan
    >>> s = kahan.System("xdot = y; ydot = a - x^2;", a="1/2")
    >>> s.variables, s.parameters
    (('x', 'y'), {'a': Fraction(1, 2)})

    Raises ``FieldError`` with the place of each mistake, and ``TypeError`` for a value of what is
    no parameter. Costs some milliseconds; the first orbit costs some more.
    """

    _call: tuple[str, bool, int | None, dict[str, str]]

    def __new__(
        cls, field: str | Mapping[Any, Any], /, *, sites: int | None = None, **parameters: Number
    ) -> System:
        if isinstance(field, Mapping):
            from ._sympy import field_text

            field = field_text(field)
        if not isinstance(field, str):
            raise TypeError(f"a field is text or a mapping of SymPy's symbols, not {type(field).__name__}")
        return cls._of(field, False, sites, {name: exact(value, name) for name, value in parameters.items()})

    @classmethod
    def _of(cls, text: str, is_name: bool, sites: int | None, parameters: dict[str, str]) -> System:
        system = Field.__new__(cls, text, is_name=is_name, sites=sites, parameters=list(parameters.items()))
        system._call = (text, is_name, sites, parameters)
        return system

    @classmethod
    def _named(cls, name: str) -> System:
        return cls._of(name, True, None, {})

    def __reduce__(self) -> tuple[Callable[..., System], tuple[Any, ...]]:
        return (type(self)._of, self._call)

    def __call__(self, *, sites: int | None = None, **parameters: Number) -> System:
        """The same field with these values of its parameters, beside those that it has.

        >>> import kahan
        >>> kahan.catalog.euler(a1=1, a2=-3, a3=1).parameters["a2"]
        Fraction(-3, 1)
        """
        text, is_name, own_sites, own = self._call
        given = {name: exact(value, name) for name, value in parameters.items()}
        return self._of(text, is_name, own_sites if sites is None else sites, own | given)

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={value}" for name, value in self.parameters.items() if value is not None)
        return f"<System {self.name}: {', '.join(self.variables)}{'; ' + values if values else ''}>"

    @property
    def variables(self) -> tuple[str, ...]:
        """The state variables, in order."""
        return tuple(super().variables)

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters with their values as fractions; ``None`` for one that has none."""
        from ._exact import _number

        return {name: None if value is None else _number(value) for name, value in self.given}

    # What is called in loops: arrays in, arrays out.

    def orbit(
        self,
        x: Any,
        eps: float,
        steps: int,
        *,
        every: int = 1,
        order: int = 2,
        compensated: bool = False,
        out: Array | None = None,
        progress: bool = False,
    ) -> Orbit:
        """The orbit of a point: its start, and every ``every``-th point after it.

        ``x`` has shape (variables,); float32 is stepped in float32, all else in float64. A step
        takes the time 2 eps. ``order`` 4, 6 and 8 compose steps of Kahan's map. ``compensated``
        carries what rounding takes from a point into the next step. ``out`` of shape
        (1 + steps // every, variables) takes the rows in place of a new array.

        An orbit ends before a point that is not finite; ``ended`` says so, and ``x`` has the rows
        up to there. Costs the steps, some ten nanoseconds each for three variables.
        """
        rows, made, ended = self.points(
            x, eps, steps, every=every, order=order, compensated=compensated, out=out, listener=_listener(progress)
        )
        return Orbit(self, float(eps), rows[:, : len(self.variables)], every, made, ended)

    def ensemble(
        self,
        points: Any,
        eps: float | Array,
        steps: int,
        *,
        params: Mapping[str, float | Array] | None = None,
        order: int = 2,
        threads: int | None = None,
        out: Array | None = None,
        progress: bool = False,
    ) -> Array:
        """The points of many trajectories after so many steps, a row a trajectory.

        ``points`` has shape (trajectories, variables); ``eps`` and each of ``params`` are one number
        or have shape (trajectories,). Work is spread over ``threads``, by default all processors;
        the numbers do not depend on how many. A trajectory that meets a pole ends as NaN.
        """
        names = list(self.parameters)
        given: list[Any] = []
        if params:
            for name in params:
                if name not in names:
                    raise TypeError(f"{self.name} has no parameter `{name}`{_near(name, names)}")
            given = [params.get(name) for name in names]
        return self.advance(
            points, eps, steps, parameters=given, order=order, threads=threads, out=out, listener=_listener(progress)
        )

    # Questions.

    def _ask(self, ask: str, progress: bool = False, **fields: Any) -> dict[str, Any]:
        asked = {name: value for name, value in fields.items() if value is not None}
        text = super().ask(json.dumps({"ask": ask, **asked}), listener=_listener(progress))
        return answer(text)

    def evaluate(self, x: Any, eps: Number, *, exact: bool = False) -> Answer:
        """Every object of the field and of its map at a point, by the names of ``kahan eval --json``.

        ``field``, ``field_jacobian``, ``A``, ``b``, ``det_A``, ``x_next``, ``jacobian``,
        ``det_jacobian``, ``integrals``, ``density``, ``brackets``: arrays of float64, or with
        ``exact`` of fractions. What is undefined at the point is ``None``.
        """
        found = self._ask("evaluate", at=point(x), eps=_exact(eps, "eps"), scalar="exact" if exact else "f64")
        kind = object if exact else float
        arrays = {name: np.array(value, dtype=kind) if isinstance(value, list) and name != "variables" else value
                  for name, value in found.items()}
        return Answer(arrays)

    def observe(
        self, x: Any, eps: Number, steps: int, *, order: int = 2, every: int = 10, escape: float = 1e6,
        progress: bool = False,
    ) -> Answer:
        """What the orbit of a point does: Lyapunov exponents, chaos indicators, rotation, drift, escape.

        Exponents are per unit of time, the largest first; tangent vectors are made orthogonal every
        ``every`` steps. See ``kahan help dynamics`` for what each indicator means.
        """
        return Answer(self._ask("observe", progress, at=point(x), eps=_exact(eps, "eps"), steps=_count(steps, "steps"),
                                order=order, every=every, escape=escape))

    def section(
        self, x: Any, eps: Number, steps: int, plane: str, *, direction: str = "rising", points: int = 100_000,
        progress: bool = False,
    ) -> Section:
        """Where the orbit of a point crosses ``plane`` = 0, a formula of the variables and integrals.

        ``direction`` is rising, falling or both. Each crossing is refined on the curve that the map
        draws as eps grows from 0.
        """
        found = self._ask("section", progress, at=point(x), eps=_exact(eps, "eps"), steps=_count(steps, "steps"),
                          plane=plane, side=direction, points=points)
        x = np.array(found["points"], dtype=float).reshape(-1, len(self.variables))
        return Section(self, plane, x, np.array(found["times"], dtype=float), int(found["steps"]))

    def periodic(self, x: Any, eps: Number | None = None, *, period: int = 1, over: Mapping[str, Range] | None = None) -> Answer:
        """The cycle near a point, its multipliers and stability; ``over`` follows it along a parameter or eps."""
        axes = _axes(over)
        if len(axes) > 1:
            raise ValueError("over: a cycle is followed along one parameter")
        return Answer(self._ask("periodic", at=point(x), eps=_exact(eps, "eps"), period=period, over=axes[0] if axes else None))

    def heights(self, x: Any, eps: Number, steps: int, *, max_digits: int | None = None, seconds: float | None = None,
                progress: bool = False) -> Answer:
        """How the heights of an exact orbit grow: exponentially where the map is not integrable."""
        return Answer(self._ask("heights", progress, at=point(x), eps=_exact(eps, "eps"), steps=_count(steps, "steps"),
                                max_digits=max_digits, seconds=seconds))

    def poles(self, eps: Number | None = None, *, steps: int | None = None, seconds: float | None = None,
              progress: bool = False) -> Answer:
        """What becomes of curves that the map sends to infinity or blows down: whether they come back."""
        return Answer(self._ask("poles", progress, eps=_exact(eps, "eps"), steps=steps, seconds=seconds))

    def discover(self, *, eps: Number | None = None, degree: int | None = None, seconds: float | None = None,
                 progress: bool = False) -> Answer:
        """What the map preserves, found from the equations alone and proved: integrals, densities, brackets.

        Parameters without a value and ``eps`` are generic. Where integrals may be missing, the
        search goes on to higher degrees until ``seconds`` are over, 60 by default.
        """
        return Answer(self._ask("discover", progress, eps=_exact(eps, "eps"), degree=degree, seconds=seconds))

    def scan(self, over: Mapping[str, Range], *, eps: Number | None = None, degree: int | None = None,
             seconds: float | None = None, progress: bool = False) -> Answer:
        """Which values of parameters and of eps are special: where the map keeps more than it does elsewhere."""
        return Answer(self._ask("scan", progress, axes=_axes(over), eps=_exact(eps, "eps"), degree=degree, seconds=seconds))

    def trade(self, x: Any, horizon: Number, *, need: str = "trajectory", tolerance: Number = 1e-8, seconds: float = 10.0,
              progress: bool = False) -> Answer:
        """The cheapest setting (scalar, order, eps) that follows the flow, or keeps the integrals, to a tolerance."""
        return Answer(self._ask("trade", progress, at=point(x), horizon=_exact(horizon, "horizon"), need=need,
                                tolerance=_exact(tolerance, "tolerance"), seconds=float(seconds)))


def _exact(value: Number | None, name: str) -> str | None:
    return None if value is None else exact(value, name)


def _count(value: int, name: str) -> int:
    from operator import index

    count = index(value)
    if count < 0:
        raise ValueError(f"{name}: {count} is below 0")
    return count


def _axes(over: Mapping[str, Range] | None) -> list[dict[str, str]]:
    def text(name: str, values: Range) -> str:
        if isinstance(values, str):
            return values
        if not isinstance(values, Sequence) or len(values) != 3:
            raise TypeError(f"over: {name} is (low, high, count), or text as \"0:1:+1/10\"")
        low, high, count = values
        return f"{exact(low, name)}:{exact(high, name)}:{_count(count, name)}"

    return [{"name": name, "range": text(name, values)} for name, values in (over or {}).items()]


def _near(name: str, names: list[str]) -> str:
    from difflib import get_close_matches

    near = get_close_matches(name, names, 1)
    return f"; did you mean `{near[0]}`?" if near else f"; it has {', '.join(names) or 'none'}"


def _listener(progress: bool) -> Any:
    if not progress:
        return None
    from ._progress import listener

    return listener()
