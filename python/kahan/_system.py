"""A field, and everything that is asked of it."""

from __future__ import annotations

import json
import re
import warnings
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, partial
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar, cast, overload

import numpy as np

from ._answer import Answer, Settings
from ._arrays import by_name, constants, flat, named, one_order, read
from ._basis import Basis
from ._charts import Range, axes_of, size
from ._coefficients import Entries, coefficients, dense, named_wrongly
from ._derivatives import differentiable, in_order
from ._discovery import Discovery
from ._errors import FieldError, choice, spelled
from ._exact import Number, answer, exact, half_step, nearest, point, whole
from ._formulas import Formulas
from ._kahan import Field, is_family
from ._lattice import Lattice
from ._lifted import Lift, Lifted, lifting
from ._orbit import Array, Chart, Diagram, Ensemble, FloatOrbit, Orbit, Section
from ._progress import listener
from ._series import Series, table_file
from ._rhs import RightSide

__all__ = ["Family", "System"]

Crossed = TypeVar("Crossed", bound=Section)


@spelled
class System(Formulas):
    """A quadratic vector field x' = f(x) with its Kahan map.

    ``field`` is the text of the equations in the language of ``kahan!`` or as one writes them, such as
    ``x' = y, y' = -x``, or equations of SymPy: a mapping of symbols to expressions, a pair (symbols, expressions),
    or a list of ``Eq(x(t).diff(t), …)``. ``notes`` reports unusual readings.
    Free names are parameters, whose values are given by name: as integers, fractions or text, or as a float, which
    means the decimal that Python prints.
    ``sites`` writes out a chain of a family ``for i in … { … }``.

    With ``lift=True`` the equations may have functions, quotients, powers and ``t``: the field is lifted to
    a quadratic one, which ``lifted`` describes, and formulas are those of that. Arrays in and out are in the
    original variables, or with ``all=True`` in all but ``t``, whose value at the start is ``t0``. ``lift`` may say
    which lift is wanted, "energy", "relations", "stable" or "smallest", and ``at`` the point of whose orbit its
    relations are to be right.

    >>> import kahan
    >>> s = kahan.System("xdot = y; ydot = a - x^2;", a="1/2")
    >>> s.variables, s.parameters
    (('x', 'y'), {'a': Fraction(1, 2)})

    Raises ``FieldError`` with the place of each mistake, and ``TypeError`` for a value of what is
    no parameter. Costs some milliseconds; the first orbit costs some more.

    A step is given by ``eps``, half the time step, or by ``dt`` = 2 eps, in each method that takes one.
    ``progress=True`` of the methods that take long shows a bar of tqdm, which must be installed.
    """

    _call: tuple[str | Entries, bool, int | None, dict[str, str]]
    _lifting: Lift | None

    def __new__(
        cls, field: str | Mapping[Any, Any] | Sequence[Any], /, *, sites: int | None = None, lift: bool | str | None = None,
        at: Any = None, t0: Number | None = None, all: Any = None, **parameters: Number
    ) -> System:
        if not lift:
            # Without a lift these are names of parameters like others.
            parameters |= {name: value for name, value in {"at": at, "t0": t0, "all": all}.items() if value is not None}
        if isinstance(field, (Mapping, list, tuple)):
            from ._sympy import field_text

            field = field_text(field, expands=not lift)
        if not isinstance(field, str):
            raise TypeError(f"a field is text or equations of SymPy, not {type(field).__name__}")
        try:
            given = {name: exact(value, name) for name, value in parameters.items()}
            return cls._of(field, False, sites, given, lifting(lift, at, t0, all))
        except FieldError:
            if sites is None and not parameters and not lift and is_family(field):
                return cast(System, Family(field))
            raise

    @classmethod
    def _of(
        cls, text: str | Entries, is_name: bool, sites: int | None, parameters: dict[str, str],
        lift: Lift | None = None, of: System | None = None,
    ) -> System:
        system: System = Field.__new__(
            cls, text, is_name=is_name, sites=sites, parameters=list(parameters.items()), lift=lift, of=of
        )
        system._call, system._lifting = (text, is_name, sites, parameters), lift
        if lift and lift[1] and lift[1][1]:
            system._matched(lift[1][1], "at", False)
        return system

    @classmethod
    def from_arrays(
        cls, c: Any = None, B: Any = None, Q: Any = None, names: Sequence[str] | None = None,
        parameters: Mapping[str, Any] | None = None, *, order: str = "tril", **values: Number
    ) -> System:
        """The field ẋ = c + Bx + Q(x, x) of these arrays, dense or sparse ones of SciPy; ``None`` stands for 0.

        ``c`` has shape (n,), ``B`` (n, n), ``Q`` (n, n, n), or (n, n·n) with the columns xⱼxₖ row by row, or
        (n, n(n + 1)/2) with each product once: j ≥ k as operator inference has them, with ``order="triu"`` j ≤ k.
        ``names`` are those of the variables, x1 to xn where they are not given. ``parameters`` maps names to the
        arrays (c, B, Q) that they multiply, or to a dict of some of them; ``values`` are values of parameters.

        Floats are taken exactly. Raises ``ValueError`` for an array of another shape and numbers that are not finite,
        and ``FieldError`` for names that variables cannot have.

        >>> import kahan
        >>> s = kahan.System.from_arrays(B=[[0, 1], [0, 0]], Q=[[0, 0, 0], [-1, 0, 0]], names=["x", "v"])
        >>> s.text
        'xdot = v;\\nvdot = -x^2;'
        >>> kahan.System.from_arrays(parameters={"r": {"B": [[1]], "Q": [[-1]]}}, names=["x"], r=2).text
        'xdot = r*x - r*x^2;'
        """
        given = {name: exact(value, name) for name, value in values.items()}
        entries = coefficients((c, B, Q), names, parameters, order)
        try:
            return cls._of(entries, False, None, given)
        except FieldError:
            wrong = named_wrongly(entries)
            if wrong:
                raise FieldError(wrong, [(wrong, 1, 1, "")]) from None
            raise

    def arrays(self, *, sparse: bool = False) -> tuple[Any, Any, Any]:
        """The arrays (c, B, Q) of the field at its parameters, as floats: ẋ = c + Bx + Q(x, x).

        ``Q`` is symmetric and has shape (n, n, n); with ``sparse=True`` B and Q are sparse arrays of SciPy, Q with
        the columns xⱼxₖ row by row. Of a lifted field they are those of all variables. Raises ``ValueError`` for a
        parameter without a value.

        >>> import kahan
        >>> kahan.System("xdot = x*y; ydot = 1 - 2*x;").arrays()[1]
        array([[ 0.,  0.],
               [-2.,  0.]])
        """
        indices, values = self._coefficients()
        return dense(len(self._all_variables), (*indices, values), sparse)

    def __reduce__(self) -> tuple[Callable[..., System], tuple[Any, ...]]:
        return (type(self)._of, (*self._call, self._lifting))

    def lattice(self, sites: int, eps: Number | None = None, *, dt: Number | None = None, **values: float | Array) -> Lattice:
        """The chain of so many sites of a family, stepped as an array; see ``Lattice``.

        The text of a family is enough: ``kahan.System("for i in periodic { … }").lattice(1000, 0.01)``.
        """
        text, _, _, own = self._call
        return Lattice(text if isinstance(text, str) else self.text, sites, eps, dt=dt, **({name: float(Fraction(value)) for name, value in own.items()} | values))

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, System) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[Any, ...]:
        return (self.name, self.text, self.variables, *self.parameters.items())

    def __call__(self, *, sites: int | None = None, **parameters: Number) -> System:
        """This field with further or other values of parameters; a chain may have another number of ``sites``.

        >>> import kahan
        >>> kahan.catalog.euler(a1=1, a2=-3, a3=1).parameters["a2"]
        Fraction(-3, 1)
        """
        text, is_name, own_sites, own = self._call
        if sites is not None and "sites" in self.parameters:
            parameters["sites"], sites = sites, None
        given = {name: exact(value, name) for name, value in parameters.items()}
        sites = own_sites if sites is None else sites
        # The new field shares code with this one, except a lift, made for values of parameters, and a chain of other sites.
        known = self if self._lifting is None and sites == own_sites else None
        return self._of(text, is_name, sites, own | given, self._lifting, known)

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={value}" for name, value in self.parameters.items() if value is not None)
        return f"<System {self.name}: {', '.join(self.variables)}{'; ' + values if values else ''}>"

    @property
    def variables(self) -> tuple[str, ...]:
        """The state variables, in order: of a lifted field the original ones, as arrays have them."""
        return tuple(super().variables)

    @cached_property
    def lifted(self) -> Lifted | None:
        """How the field became quadratic, where it was lifted."""
        text = self._lift
        return None if text is None else Lifted(self, text)

    @property
    def start(self) -> tuple[Fraction, ...] | None:
        """The first point that the text gives, ``x(0) = 1`` or ``init x=1``; ``None`` where it gives none."""
        return None if self._start is None else tuple(Fraction(value) for value in self._start)

    @property
    def source(self) -> str:
        """The text of the field as given, or as made from a model file, with values, starts and comments. ``read`` reads it again."""
        return self._call[0] if isinstance(self._call[0], str) else self.text

    # Arrays in, arrays out.

    @property
    def _names(self) -> list[str]:
        """The names that columns of a table may have."""
        return [*self.variables, *self.parameters, "eps"]

    def _at(self, x: Any) -> Any:
        """A point, or points, in the order of the variables, by names if there are some; for ``None`` the start of the text."""
        if x is None:
            start = self.start
            if start is None:
                raise TypeError("x is missing: the text gives no start, as `init x=1` for every variable")
            return list(start)
        return named(x, self)

    def _one(self, x: Any) -> Any:
        """A point in the order of the variables; a table of one row is a point."""
        at = self._at(x)
        is_row = at is not x and isinstance(at, np.ndarray) and at.ndim == 2 and len(at) == 1
        return at[0] if is_row else at

    def _in_all(self, x: Any, parameters: Sequence[Any] = ()) -> Any:
        """Points of all variables: of a lifted field the new ones are functions of the original ones."""
        if self._lifting is None:
            return x
        embedded = self._embedded(x, list(parameters))
        return embedded.astype(np.float32) if getattr(x, "dtype", None) == np.float32 else embedded

    def _out_of_all(self, x: Array, out: Array | None = None) -> Array:
        """The points that arrays have, of points of all variables."""
        shown = x if self._lifting is None else x[..., self._places]
        if out is None or self._lifting is None:
            return shown
        out[...] = shown
        return out

    def _has_values(self, begun: Any) -> None:
        """Raises ``ValueError`` where a new variable of a lifted field has no value at a point, all of whose coordinates are finite."""
        if self._lifting is not None and begun.ndim == 1 and np.isfinite(begun[..., self._places]).all():
            for name, value in zip(self._all_variables, begun):
                if not np.isfinite(value):
                    of = self.lifted.new.get(name) if self.lifted else None
                    raise ValueError(f"x: the new variable {name}{f' = {of}' if of else ''} has no value there; choose another point")

    def _judge(self, x: Any, eps: float) -> None:
        """Warns once where a lift that was chosen without a start is wrong along an orbit of all variables."""
        if self._lifting is None or self._lifting[1] is not None or "_is_judged" in self.__dict__:
            return
        self.__dict__["_is_judged"] = True
        warning = self._relations_warning(x, eps) if eps else None
        if warning:
            warnings.warn(f"{warning} (at=, lift= and reembed=True)", stacklevel=3)

    def _look_at_rates(self, x: Array, eps: float) -> None:
        """Warns where steps do not resolve fast components along the first orbit at an eps."""
        if self.__dict__.get("_is_looked_at") == eps:
            return
        self.__dict__["_is_looked_at"] = eps
        note = self._rates_note(np.asarray(x[:: max(1, len(x) // 16)], dtype=float), eps)
        if note:
            warnings.warn(f"{note}; s.trade measures which eps resolves them", stacklevel=4)

    def _point(self, x: Any) -> list[str]:
        return point(self._one(x))

    def _columns(self, x: Array) -> dict[str, Array]:
        """The columns of points by the names of the variables."""
        return dict(zip(self.variables, x.reshape(-1, x.shape[-1]).T))

    def integral_values(self, x: Any, eps: Number | None = None, *, dt: Number | None = None) -> dict[str, Array]:
        """The claimed integrals at points, by name: ``x`` has shape (variables,) or (points, variables).

        Those of the map depend on eps, and some are claimed ``when`` eps and the parameters have
        certain values.
        """
        return self._integrals_in_all(self._in_all(self._at(x)), half_step(eps, dt))

    def _integrals_in_all(self, x: Any, eps: Number) -> dict[str, Array]:
        names, values = self._integrals_at(x, eps)
        return {name: values[..., k] for k, name in enumerate(names)}

    def orbit(
        self,
        x: Any = None,
        eps: Number | None = None,
        steps: int | None = None,
        *,
        dt: Number | None = None,
        transient: int = 0,
        every: int = 1,
        order: int = 2,
        scalar: str = "f64",
        compensated: bool = False,
        method: str = "kahan",
        projective: bool = False,
        reembed: bool = False,
        derivatives: Sequence[str] = (),
        out: Array | None = None,
        progress: bool = False,
    ) -> Orbit:
        """The orbit of a point: its start, and every ``every``-th point after it.

        ``x`` has shape (variables,); without it the orbit begins at the ``start`` of the text. A step takes the time
        ``dt`` = 2 eps; one of both is given. ``transient`` steps are made before the first row, which then has their
        number and time; ``steps`` counts those behind them. ``order`` 4, 6 and 8 compose steps
        of Kahan's map; a composition follows the flow more closely, but gives up the map's integrals
        (see ``Orbit.integrals``). ``scalar`` is f64, f32, dd (32 digits: ``x`` has the leading
        doubles, and ``x_low`` what they lack) or exact (fractions in an array of objects); float32
        points are stepped in float32. ``compensated`` carries what rounding takes from a point into the next
        step. ``method`` is kahan, or for comparison euler, rk4 or flow (the solution itself, by
        certified Taylor series). ``projective`` goes on at poles, through points at infinity. ``reembed``
        projects each step of a lifted field, in f64, symmetrically onto the relations between its variables: they
        hold exactly, and energies do not drift; a step takes 2 to 16 steps of the map.
        ``out`` of shape (1 + steps // every, variables) takes the rows in place of a new array.

        ``derivatives`` has names of parameters, of variables (the derivative by their first value) and ``"eps"``:
        ``o.derivatives["a"][k]`` is the derivative of ``o.x[k]`` by ``a``, exact up to rounding. Derivatives leave the
        points as they are. They exist for f64 and f32, also composed or compensated, of fields that are not lifted. A
        derivative beyond the range of floats is infinite or NaN, while the orbit goes on; by ``eps`` it is NaN at
        eps = 0. Each name costs about one more step of the map per step. The first call also compiles for some tens of
        milliseconds; ``s(a=2)`` shares this code with ``s``.

        >>> import kahan
        >>> s = kahan.System("xdot = a*x^2;", a=3)
        >>> o = s.orbit([0.5], 0.125, 1, derivatives=["a", "x"])     # the map is x/(1 - 2*eps*a*x)
        >>> o.x[1], o.derivatives["a"][1], o.derivatives["x"][1]
        (array([0.8]), array([0.16]), array([2.56]))

        An orbit ends before a point that is not finite or has no value, of a lifted field where a root would
        be negative, and as ``"reembed"`` where the projection does not converge; ``ended`` says so, and
        ``x`` has the rows up to there. Costs the steps, some ten nanoseconds each for three
        variables in f64.
        """
        eps = half_step(eps, dt)
        steps, every, order = whole(steps, "steps"), whole(every, "every"), whole(order, "order")
        transient = whole(transient, "transient")
        x = self._one(x)
        scalar, method = choice(scalar, "scalar"), choice(method, "method")
        by = differentiable(self, derivatives, "derivatives")
        if by and (scalar not in ("f64", "f32") or method != "kahan" or projective or transient):
            raise ValueError("derivatives are for orbits of Kahan's map in f64 and f32, without transient")
        if scalar in ("f64", "f32") and method == "kahan" and not projective:
            x = np.asarray(x, dtype=np.float32) if scalar == "f32" else x
            half = nearest(eps, "eps")
            begun = self._in_all(x)
            self._has_values(begun)
            rows, made, ended, why = self._points(
                begun, half, steps, transient=transient, every=every, order=order, compensated=compensated, reembed=reembed,
                out=out if self._lifting is None else None, listener=listener(progress)
            )
            if not reembed:
                self._judge(begun, half)
            in_all = rows[:, : len(self._all_variables)]
            self._look_at_rates(in_all, half)
            states = self._out_of_all(in_all, None if out is None else out[: len(rows)])
            orbit: Orbit = FloatOrbit(self, half, states, every, made, ended, half if order == 2 else 0.0, in_all)
            orbit.why = why
            orbit._order, orbit.transient = None if reembed or transient else order, transient
            if by:
                found = self._derivatives(rows, half, by, every=every, order=order, compensated=compensated,
                                          listener=listener(progress))
                orbit.derivatives = in_order(by, *found)
            return orbit
        if compensated or out is not None:
            raise ValueError("compensated and out are for orbits of Kahan's map in f64 and f32")
        question = {"ask": "orbit", "at": self._point(x), "eps": exact(eps, "eps"), "transient": transient, "steps": steps, "every": every,
                    "scalar": scalar, "order": order, "method": method, "projective": projective, "reembed": reembed}
        columns, ended, last = self._table(json.dumps(question), listener=listener(progress))
        count = len(self.variables)
        values = [np.array(value, dtype=object) if isinstance(value, list) else value for _, _, value in columns]
        states = np.stack(values[2 : 2 + count], axis=1)
        low = states[:, :, 1] if scalar == "dd" else None
        integrals = {name: value[:, 0] if scalar == "dd" else value
                     for (name, _, _), value in zip(columns[2 + count :], values[2 + count :])}
        given = Fraction(exact(eps, "eps")) if scalar == "exact" else nearest(eps, "eps")
        kind = Orbit if scalar == "exact" else FloatOrbit
        orbit = kind(self, given, states if low is None else states[:, :, 0], every, last, ended, integrals)
        orbit.x_low, orbit.transient = low, transient
        return orbit

    @overload
    def ensemble(
        self, points: Any = None, eps: Number | Array | None = None, steps: int | None = None, *, every: None = None, **rest: Any
    ) -> Ensemble: ...
    @overload
    def ensemble(
        self, points: Any = None, eps: Number | Array | None = None, steps: int | None = None, *, every: int, to: None = None, **rest: Any
    ) -> Series: ...
    @overload
    def ensemble(
        self, points: Any = None, eps: Number | Array | None = None, steps: int | None = None, *, every: int,
        to: str | PathLike[str], **rest: Any
    ) -> Ensemble: ...
    def ensemble(  # type: ignore[misc]
        self,
        points: Any = None,
        eps: Number | Array | None = None,
        steps: int | None = None,
        *,
        dt: Number | Array | None = None,
        params: Any = None,
        every: int | None = None,
        columns: Sequence[str] | None = None,
        transient: int = 0,
        to: str | PathLike[str] | None = None,
        observe: Sequence[str] = (),
        order: int = 2,
        renormalize: int = 10,
        spectrum: int | None = None,
        escape: float | None = None,
        reembed: bool = False,
        derivatives: Sequence[str] = (),
        threads: int | None = None,
        out: Array | None = None,
        progress: bool = False,
    ) -> Ensemble | Series:
        """Many trajectories: their last points, and observables of their orbits; with ``every`` their points on the way.

        ``points`` has shape (trajectories, variables), or more axes, (40, 40, variables), which all arrays of the
        result keep. Or it is a table with a column for each variable: a ``DataFrame`` of pandas or polars, a table of
        Arrow, a structured array or a dict of arrays. The table may also have columns of parameters and of ``eps``, which
        replace these arguments; a column of another name is an error. ``params`` is a dict or a table of parameters.
        ``eps`` and each parameter are one number, or one for each start. ``observe`` names the observables, and nothing
        else is computed: drift (of ``Orbit.integrals``), extrema, lyapunov (the largest exponent, per unit
        of time), spectrum (all, in descending order, of shape (trajectories, variables)), log_det (their sum),
        fli, megno, sali, rotation, escape, passed_poles (steps over a pole, a lower bound where
        ``passed_poles_lower_bound`` is 1); see ``observe``. Tangent vectors are made orthogonal every ``renormalize``
        steps; ``spectrum=3`` leaves it at the three largest exponents. With observers, an orbit ends as ``"escaped"`` at the step after which a variable is beyond
        ``escape``, if that is given. The column ``escaped`` is that step, or else the first one beyond 1e6, and
        NaN where there is none. ``reembed`` projects the steps of a lifted field, as in ``orbit``; drift, extrema,
        rotation and escape can be observed of them.

        ``transient`` steps are made before those that are counted, shown or observed. With ``every`` the result is a
        ``Series`` of shape (trajectories, 1 + steps // every, variables), whose rows have the bits of single orbits; with
        ``columns`` it has these alone, as ``["t", "x", "H"]``, and takes less memory. ``to`` names a file, F.parquet or
        F.arrow, to which the table is written while it is computed, in memory that does not grow with it; the result is
        then the ensemble of the last points that it has. Needs pyarrow.

        ``derivatives`` has names of parameters, variables and ``"eps"``, as in ``orbit``. ``r.derivatives["a"]`` has
        shape (trajectories, variables): row k is the derivative of ``r.x[k]`` by the ``a`` of that trajectory, and NaN
        if the trajectory ended early or a derivative is beyond the range of floats. Derivatives exclude observers and
        ``reembed``.

        Work is spread over ``threads``, by default all processors; the numbers do not depend on how
        many. ``ended`` says how each trajectory ended, which is how its ``orbit`` ends, and ``steps``
        after how many steps. Where one ended early its numbers are NaN.
        """
        if points is None:
            how = "[s.start]" if self.start else f"[[{', '.join('1' for _ in self.variables)}]]"
            raise TypeError(f"points is missing: give the first points, a row each, as s.ensemble({how}, eps=…, steps=…)")
        tables = [value for table in (points, params) for _, value in by_name(table, lambda: self._names) or ()]
        one_order([*tables, eps, dt])
        eps = half_step(eps, dt, is_needed=False)
        points, own = read(points, self, "points", varies=True)
        inputs, start = constants(eps, own, params, self.parameters), np.asarray(points)
        each = {name: flat(value, name, start.shape[:-1]) for name, value in inputs.items()}
        eps, given = each["eps"], [each.get(name) for name in self.parameters]
        points = start if start.ndim < 3 else start.reshape(-1, start.shape[-1])
        steps, order = whole(steps, "steps"), whole(order, "order")
        threads = _whole(threads, "threads")
        begun = self._in_all(points, given)
        by = differentiable(self, derivatives, "derivatives")
        transient = whole(transient, "transient")
        if by and (observe or reembed or transient or every is not None):
            raise ValueError("derivatives are for ensembles without observers, every, transient and reembed")
        if every is not None:
            if observe or out is not None:
                raise ValueError("every shows points on the way; ask for observers, and for the last points in out, without it")
            frame = Series(self, start, inputs, steps, whole(every, "every"), transient)
            call = partial(self._series, steps=steps, every=frame.every, transient=transient, order=order, reembed=reembed, threads=threads)
            return frame.filled(begun, eps, given, call, None if columns is None else [columns] if isinstance(columns, str) else list(columns),
                                to, listener(progress))
        if columns is not None or to is not None:
            raise ValueError("columns and to are for points on the way; give every, the steps from one to the next")
        if not observe and not reembed:
            into = out
            if out is not None and start.ndim > 2 and out.shape == start.shape and out.flags.c_contiguous:
                into = out.reshape(points.shape)
            x, ends = self._advance(begun, eps, transient + steps, parameters=given, order=order, threads=threads,
                              out=into if self._lifting is None else None, listener=listener(progress))
            ensemble = Ensemble(self, start, inputs, self._out_of_all(x, into), ends, {})
            if by:
                found = self._last_derivatives(begun, eps, steps, by, parameters=given, order=order, threads=threads,
                                               listener=listener(progress))
                found[1][:, np.ravel(ensemble.ended) != "complete"] = np.nan
                names, arrays = found
                ensemble.derivatives = in_order(by, names, arrays.reshape(-1, *ensemble.x.shape))
            return ensemble
        if isinstance(observe, str):
            observe = (observe,)
        if out is not None and observe:
            raise ValueError("out is for ensembles without observers")
        # An integral that is claimed under a condition may hold for some of the trajectories.
        if "drift" in observe and not self.integrals:
            raise ValueError("observe: this field claims no integral that could drift; `s.discover().claimed` has those found")
        of = ["final", *(choice(name, "observable") for name in observe if name != "final")]
        seen, values, ends = self._observed(begun, eps, steps, of, parameters=given, order=order, transient=transient, spectrum=_whole(spectrum, "spectrum"),
                                            renormalize=whole(renormalize, "renormalize"), escape=escape, reembed=reembed,
                                            threads=threads, listener=listener(progress))
        count = len(self.variables)
        x = values[:, :count]
        if out is not None:
            out[...], x = x.reshape(start.shape), out
        observed: dict[str, Array] = {}
        exponents = sum(name.startswith("spectrum_") for name in seen)
        for k, name in enumerate(seen[count:], count):
            if name == "spectrum_1":
                observed["spectrum"] = values[:, k:k + exponents]
            elif not name.startswith("spectrum_"):
                observed[name] = values[:, k]
        return Ensemble(self, start, inputs, x, ends, observed)

    def rhs(self, *parameters: str) -> RightSide:
        """f as solvers for ordinary differential equations take it: ``solve_ivp(s.rhs(), (0, 10), x, vectorized=True)``.

        With ``args=(a, b)`` its parameters have these values: of those named here, in their order, or else of those
        without a value, or else of all. Its ``jacobian`` is the argument ``jac`` of implicit solvers.

        >>> import kahan
        >>> kahan.System("xdot = y; ydot = -x;").rhs()(0.0, [1.0, 2.0])
        array([ 2., -1.])
        >>> kahan.System("xdot = k*y; ydot = -m*x;").rhs("m", "k")(0.0, [1.0, 2.0], 5, 10)
        array([20., -5.])
        """
        return RightSide.of(self, parameters)

    def integral_functions(self, eps: Number = 0.0) -> dict[str, Callable[[Any], Any]]:
        """The claimed integrals as functions of a point, for methods that project on their levels.

        At ``eps`` = 0 they are those of the flow, as far as it has them; else those of the map.
        """
        names = self._integrals_at(np.zeros(len(self.variables)), eps)[0]
        return {name: partial(_integral_value, self, name, eps) for name in names}

    # Questions.

    def _ask(self, ask: str, progress: bool = False, **fields: Any) -> dict[str, Any]:
        return answer(self._answer(_question(ask, **fields), listener=listener(progress)))

    def ask(self, question: str, *, progress: bool = False, **parts: Any) -> Answer:
        """The answer to any question by its name, with its parts as in JSON: numbers, text, lists and dicts.

        >>> import kahan
        >>> kahan.System("xdot = x^2;").ask("heights", eps="1/2", at=["1/3"], steps=2).steps
        2
        """
        return Answer(self._ask(question, progress, **parts))

    def evaluate(self, x: Any, eps: Number | None = None, *, dt: Number | None = None, exact: bool = False) -> Answer:
        """Every object of the field and of its map at a point, by the names of ``kahan eval --json``.

        ``field``, ``field_jacobian``, ``A``, ``b``, ``det_A``, ``x_next``, ``jacobian``,
        ``det_jacobian``, ``integrals``, ``density`` (of which there is one without ``when``),
        ``brackets`` and ``drifts``: numbers and arrays of float64, or with ``exact`` of fractions. What is undefined
        at the point is ``None``. Formulas are functions of many points: ``s.densities["rho"](x, eps)``.
        """
        found = self._ask("evaluate", at=self._point(x), eps=_exact(half_step(eps, dt), "eps"), scalar="exact" if exact else "f64")

        def arrays(value: Any) -> Any:
            if isinstance(value, dict):
                return {name: arrays(one) for name, one in value.items()}
            return np.array(value, dtype=object if exact else float) if isinstance(value, list) else value

        return Answer({name: value if name == "variables" else arrays(value) for name, value in found.items()})

    def observe(
        self, x: Any, eps: Number | None = None, steps: int | None = None, *, dt: Number | None = None,
        transient: int = 0, observe: Sequence[str] | None = None, order: int = 2, renormalize: int = 10, spectrum: int | None = None, escape: float | None = None, reembed: bool = False, progress: bool = False,
    ) -> Answer:
        """What the orbit of a point does; ``observe`` names what is seen, as in ``ensemble``, and nothing else is computed.

        ``transient`` steps are made before the orbit is observed; ``steps`` of the answer counts them, too.

        Exponents are per unit of time: ``lyapunov`` is the largest, ``spectrum`` has all in descending order,
        of shape (variables,), and ``mean_log_det`` is their sum. ``lyapunov_error`` and
        ``spectrum_errors`` say by how much each still changes; as far as that, ``lyapunov`` and the first of
        ``spectrum`` agree. Tangent vectors
        are made orthogonal every ``renormalize`` steps; ``spectrum=3`` leaves it at the three largest exponents. Three indicators tell chaotic orbits from regular ones:
        ``fli`` grows like the number of steps, and else like its logarithm; ``megno`` grows, and else tends
        to 2; ``sali`` falls to 0 exponentially, and else stays or falls like a power of time.
        ``rotation`` has for each variable the turns a step about the middle of its extremes, modulo 1,
        ``drift`` the change of each claimed integral relative to its first value, and ``extrema`` the least
        and the greatest value of each variable. ``ended`` says how the orbit ended and ``ended_step`` after
        how many steps: ``"complete"``, ``"range"`` where the next point is not finite, or ``"escaped"`` where a
        variable is beyond ``escape``, if that is given; what is observed is then of the steps before.
        ``escaped`` is the step after which a variable is beyond ``escape``, or else beyond 1e6, and ``None``
        where there is none. ``reembed`` projects the steps of a lifted field, as in ``orbit``; of them final, drift,
        extrema, rotation and escape can be observed.

        Unless ``observe`` names them, all are computed but ``final``, the last point, and ``passed_poles``, the number
        of steps over a pole of the map: those whose reduced denominator, at the point where the step begins, has a root
        between 0 and ``eps``, ``eps`` included; of a composition that of one of its stages. Where the map has too many
        terms to be written out, a negative ``det_A`` counts, and ``passed_poles_lower_bound`` is true.
        """
        if isinstance(observe, str):
            observe = (observe,)
        of = None if observe is None else [choice(name, "observable") for name in observe]
        found = self._ask("observe", progress, at=self._point(x), eps=exact(half_step(eps, dt), "eps"), steps=whole(steps, "steps"),
                          transient=whole(transient, "transient"), order=whole(order, "order"), renormalize=whole(renormalize, "renormalize"), spectrum=_whole(spectrum, "spectrum"), escape=escape, reembed=reembed, observe=of)
        names = [name for name in ("spectrum", "spectrum_errors") if name in found]
        return Answer(found | {name: np.array(found[name], dtype=float) for name in names})

    def section(
        self, x: Any, eps: Number | Array | None = None, steps: int | None = None, plane: str | None = None, *,
        dt: Number | Array | None = None, direction: str = "rising", maxima: str | None = None, crossings: int | None = None,
        transient: int = 0, order: int = 2, params: Any = None, over: Mapping[str, Range | Array] | None = None, carry: bool = False,
        reembed: bool = False, to: str | PathLike[str] | None = None, threads: int | None = None, progress: bool = False,
    ) -> Section:
        """Where orbits cross ``plane`` = 0, a formula of the variables and integrals.

        ``x`` is a point, or points of shape (orbits, variables), or a table, as in ``ensemble``; ``eps`` and the
        parameters of ``params`` are one number, or one for each start. ``over`` maps names to values, as in ``chart``:
        each start begins an orbit at each of them. Orbits run side by side on ``threads``, and each has the crossings
        that it has alone.

        ``direction`` is rising, falling or both; ``maxima="x"`` takes the place of a plane, and finds where x is
        largest. Each crossing is refined on the curve that the step of this ``order`` draws as eps grows from 0, so its
        time is of that order, too. A sign change without a zero, as at a pole of the formula or of the
        map, is no crossing; ``jumps`` counts them. An orbit ends after ``crossings`` of them, or ``steps`` behind the
        first ``transient``, which are not looked at; ``ended`` says which. With ``carry`` an orbit begins where that at the
        value before came to. ``reembed`` projects the steps of a lifted field, as in ``orbit``.

        ``to`` names a file, F.parquet or F.arrow, to which the table is written while it is computed, in memory that does
        not grow with it; the result then has no rows, and counts the crossings of each orbit. Needs pyarrow.

        >>> import kahan
        >>> s = kahan.System("xdot = y; ydot = -x;")
        >>> s.section([[1, 0], [2, 0]], 0.01, plane="y", crossings=3)
        <Section of 2 orbits of field at y = 0: 6 crossings>
        """
        plane, direction = self._plane(plane, maxima, direction)
        return self._crossed(Section, x, half_step(eps, dt, is_needed="eps" not in (over or {})), params, over, threads, progress, to,
                             plane=plane, direction=direction, steps=_whole(steps, "steps"), crossings=_whole(crossings, "crossings"),
                             transient=whole(transient, "transient"), order=whole(order, "order"), carry=carry, reembed=reembed)

    def diagram(
        self, over: Mapping[str, Range | Array], x: Any = None, eps: Number | None = None, *, plane: str | None = None,
        maxima: str | None = None, dt: Number | None = None, direction: str = "rising", crossings: int = 100,
        steps: int | None = None, transient: int = 1000, order: int = 2, carry: bool = False, show: str | None = None,
        reembed: bool = False, threads: int | None = None, progress: bool = False,
    ) -> Diagram:
        """Where orbits cross a section over a parameter, or eps: a bifurcation diagram, which ``plot`` draws.

        At each value of ``over`` an orbit begins at ``x``, or with ``carry`` where that at the value before came to; it
        has so many ``crossings`` of ``plane`` = 0, or maxima of the variable ``maxima``, behind ``transient`` steps, at most
        in ``steps``. ``show`` is the variable that ``plot`` draws: by default that of ``maxima``, or the first that ``plane`` does not name.

        >>> import kahan
        >>> s = kahan.System("xdot = -y - z; ydot = x + y/5; zdot = 1/5 + z*(x - c);")
        >>> d = s.diagram({"c": (2, 4, 3)}, [1, 1, 0], 0.02, maxima="x", crossings=5, transient=10_000)
        >>> list(d), d["x"].round(2)[:5]
        (['start', 'c', 'n', 't', 'x', 'y', 'z'], array([3.9, 3.9, 3.9, 3.9, 3.9]))
        """
        if len(over) != 1:
            raise ValueError('over: one name goes through values, as over={"c": (2, 6, 400)}')
        plane, direction = self._plane(plane, maxima, direction)
        [name] = over
        eps = half_step(eps, dt, is_needed=name != "eps")
        found = self._crossed(Diagram, [Fraction(one) for one in self._point(x)], eps, None, over, threads, progress, None, plane=plane, direction=direction,
                              steps=_whole(steps, "steps"), crossings=whole(crossings, "crossings"), transient=whole(transient, "transient"),
                              order=whole(order, "order"), carry=carry, reembed=reembed)
        others = [variable for variable in self.variables if not re.search(rf"\b{variable}\b", plane)]
        found.over, found.shown = name, show or maxima or (others or self.variables)[0]
        return found

    def _plane(self, plane: str | None, maxima: str | None, direction: str) -> tuple[str, str]:
        """The formula of a section and its direction; of maxima those of the derivative."""
        if maxima is not None and plane is not None:
            raise ValueError("plane and maxima: one of both says what the section is")
        if maxima is not None:
            return self._rate(maxima), "falling"
        if not isinstance(plane, str):
            raise TypeError(f"plane: text is needed, as \"x - z\" for x = z, not {type(plane).__name__}")
        return plane, choice(direction, "direction")

    def _crossed(self, kind: type[Crossed], x: Any, eps: Any, params: Any, over: Mapping[str, Range | Array] | None,
                 threads: int | None, progress: bool, to: str | PathLike[str] | None, **asked: Any) -> Crossed:
        """Asks for the crossings of one orbit or many, and writes them to a file if one is named."""
        points, own = read(self._at(x), self, "x", varies=True)
        given = dict(by_name(params) or ()) | own
        if "eps" in given:
            eps = given.pop("eps")
        each = {name: value for name, value in {**given, "eps": eps}.items() if np.ndim(value)}
        rows = points if np.ndim(points) > 1 else [points] * max([np.size(value) for value in each.values()], default=1)
        is_one = np.ndim(points) == 1 and not each
        system = self(**{name: value for name, value in given.items() if not np.ndim(value)}) if len(each) < len(given) else self
        starts = {"at": point(points)} if is_one else {"starts": [point(row) for row in rows]}
        lists = {name: [exact(one, name) for one in np.ravel(value)] for name, value in each.items()}
        half = None if eps is None or "eps" in each else eps
        question = _question("section", eps=_exact(half, "eps"), **starts, params=lists or None, over=axes_of(over) or None, **asked)
        workers, hear = _whole(threads, "threads"), listener(progress)
        if to is None:
            columns, (ended, counts) = system._crossings(question, threads=workers, listener=hear)
        else:
            with table_file(Path(to)) as write:
                columns, (ended, counts) = system._crossings(
                    question, part=lambda part: write({name: values for name, _, values in part}), threads=workers, listener=hear)
                write({name: values for name, _, values in columns})
            columns = [(name, meaning, values[:0]) for name, meaning, values in columns]
        named = [(name, values) for name, _, values in columns]
        return kind(system, asked["plane"], None if half is None else nearest(half, "eps"), named, is_one and not over, ended, counts)

    def chart(
        self, over: Mapping[str, Range | Array], x: Any, eps: Number | None = None, *,
        dt: Number | None = None, steps: int = 1000, transient: int = 0,
        color: str = "sali", order: int = 2, escape: float | None = None, reembed: bool = False,
        threads: int | None = None, progress: bool = False,
    ) -> Chart:
        """What orbits do over parameters, eps or first values: an observable at every value of ``over``.

        ``over`` has for each name (low, high, count), text as "0:1:/20", or an array of values; what
        it does not name is that of the field, ``x`` and ``eps``. ``color`` is an observable with one
        number: sali, fli, megno, lyapunov, log_det, drift, escape, passed_poles, or a column, as drift_H or
        spectrum_2. Costs an orbit a cell, in lanes and on all threads. ``transient`` steps are made before those that are observed.

        An exponent of an orbit that escapes is large, and no sign of chaos: an orbit ends where a variable
        is beyond ``escape``, if that is given, and its cell is NaN. Some times the size of the region of
        interest is a good bound. ``ended`` and ``ended_step`` say how and after how many steps the orbit of each cell ended.
        ``reembed`` projects the steps of a lifted field, as in ``orbit``, for the colors drift, escape, and columns of
        final points, extrema and rotation.
        """
        if not over:
            raise ValueError("over: a chart goes through something, as over={\"eps\": (0.01, 0.1, 50)}")
        axes = axes_of(over)
        eps = half_step(eps, dt, is_needed="eps" not in over)
        question = {"ask": "observe", "at": self._point(x), "transient": whole(transient, "transient"),
                    "steps": whole(steps, "steps"), "order": whole(order, "order"), "escape": escape, "reembed": reembed, "over": axes}
        if eps is not None:
            question["eps"] = exact(eps, "eps")
        (*columns, (_, meaning, shown)), _, _ = self._table(json.dumps(question), color=color, threads=_whole(threads, "threads"),
                                                            listener=listener(progress))
        found = {name: values for name, _, values in columns}
        # Cells are numbered with the last axis fastest; what has one value only is no column.
        sizes = [size(values) or len(np.unique(found[name])) for name, values in over.items()]
        along = {}
        for k, name in enumerate(over):
            places = found[name].reshape(sizes) if name in found else np.full(sizes, np.nan)
            along[name] = np.moveaxis(places, k, 0).reshape(sizes[k], -1)[:, 0]
        of = ", ".join(([] if "eps" in over else [f"eps = {eps}"]) + [f"{steps} steps"])
        ended, ended_step = np.array(found["ended"], dtype=object).reshape(sizes), found["ended_step"].reshape(sizes)
        return Chart(self, along, color, shown.reshape(sizes), ended, ended_step, meaning, of)

    def verify(self, *, progress: bool = False) -> Answer:
        """Whether the claims of the field hold: each is proved, as when it was read; of a system of
        the catalog as it stands those of the paper about it."""
        return Answer(self._ask("verify", progress, mutate=False))

    def periodic(self, x: Any = None, eps: Number | None = None, *, dt: Number | None = None, period: int = 1, free: str | None = None,
                 transient: int = 0, over: Mapping[str, Range] | None = None, hold: str | None = None, progress: bool = False) -> Answer:
        """The cycle near a point, its multipliers and stability; ``over`` follows it along a parameter or eps.

        Without ``eps`` and ``period`` it is a steady state, with the ``eigenvalues`` of f'. Linear integrals keep
        their values at the point; with ``hold="none"`` they do not.

        With ``free="eps"`` it is a limit cycle of the flow, of ``period`` steps (by default as many
        as the orbit takes), found near ``x`` and near where the orbit of ``x`` comes back close to
        itself after ``transient`` steps: ``flow`` has its period with an error, its eps and its
        multipliers, extrapolated from three numbers of steps.

        >>> import kahan
        >>> lorenz = kahan.catalog.lorenz(s=10, r=28, b="8/3")
        >>> round(lorenz.periodic([1, 2, 20], 0.0026, period=300, free="eps").flow["period"], 6)
        1.558652
        """
        axes = axes_of(over, has_lists=False)
        if len(axes) > 1:
            raise ValueError("over: a cycle is followed along one parameter")
        return Answer(self._ask("periodic", progress, at=[] if x is None else self._point(x), eps=_exact(half_step(eps, dt, is_needed=False), "eps"),
                                period=whole(period, "period"), free=free, transient=whole(transient, "transient"), over=axes, hold=hold))

    def heights(self, x: Any, eps: Number | None = None, steps: int | None = None, *, dt: Number | None = None,
                digits: int | None = None, seconds: float | None = None, progress: bool = False) -> Answer:
        """How the heights of an exact orbit grow: exponentially where the map is not integrable."""
        return Answer(self._ask("heights", progress, at=self._point(x), eps=exact(half_step(eps, dt), "eps"), steps=whole(steps, "steps"),
                                digits=_whole(digits, "digits"), seconds=seconds))

    def poles(self, eps: Number | None = None, *, dt: Number | None = None, steps: int | None = None, seconds: float | None = None,
              progress: bool = False) -> Answer:
        """What becomes of curves that the map sends to infinity or blows down: whether they come back."""
        return Answer(self._ask("poles", progress, eps=_exact(half_step(eps, dt, is_needed=False), "eps"), steps=_whole(steps, "steps"), seconds=seconds))

    def discover(self, *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None, seconds: float | None = None,
                 progress: bool = False) -> Discovery:
        """What the map preserves, found from the equations alone and proved: integrals, densities, brackets, drifts.

        Parameters without a value and ``eps`` are generic. Where integrals may be missing, the
        search goes on to higher degrees until ``seconds`` are over, 60 by default.
        """
        asked = _question("discover", eps=_exact(half_step(eps, dt, is_needed=False), "eps"), degree=_whole(degree, "degree"), seconds=seconds)
        text, relations = self._discovered(asked, listener=listener(progress))
        bases = [Basis(one, relation) for one, relation in zip(json.loads(text)["bases"], relations)]
        discovery = Discovery(answer(text) | {"bases": bases}, self)
        self.__dict__["_found"] = discovery
        return discovery

    def scan(self, over: Mapping[str, Range], *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None,
             seconds: float | None = None, progress: bool = False) -> Answer:
        """Which values of parameters and of eps are special: where the map keeps more than it does elsewhere,
        or the degrees of its iterates grow more slowly, as they do where it is less chaotic.

        ``special`` has these values, and ``points`` for each value that was tried what was seen there, its
        ``sight``: how many integrals are independent, and the degrees. ``generic`` is the sight elsewhere.
        """
        return Answer(self._ask("scan", progress, over=axes_of(over, has_lists=False), eps=_exact(half_step(eps, dt, is_needed=False), "eps"),
                                degree=_whole(degree, "degree"), seconds=seconds))

    def trade(self, x: Any, horizon: Number, *, need: str = "trajectory", tolerance: Number = 1e-8, seconds: float = 10.0,
              progress: bool = False) -> Answer:
        """The cheapest setting (scalar, order, eps) that follows the flow, or keeps the integrals, to a tolerance.

        ``settings`` is a table of all that were measured: ``settings["eps"]`` is a column, ``settings[0]`` a row.
        """
        found = self._ask("trade", progress, at=self._point(x), horizon=_exact(horizon, "horizon"), need=need,
                          tolerance=_exact(tolerance, "tolerance"), seconds=float(seconds))
        return Answer(found | {"settings": Settings(found["settings"])})

    def extremes(self, *, trials: int = 4000, seed: int = 1, progress: bool = False) -> Answer:
        """How far floats can be trusted near poles, of mixed magnitudes, with subnormal and infinite numbers.

        Steps are judged by exact arithmetic; ``trials`` of each scalar.
        """
        judged = self._judged(whole(trials, "trials"), whole(seed, "seed"), listener=listener(progress))
        return Answer(answer(judged))


class Family:
    """A chain ``for i in periodic { … }`` whose sites are not counted yet: a call says how many there are.

    >>> import kahan
    >>> ring = kahan.System("for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }")
    >>> ring(sites=3).variables
    ('x0', 'x1', 'x2')
    >>> ring.lattice(1000, eps=0.01)
    <Lattice of 1000 sites: x>
    """

    name: str
    """Its name in the catalog, or its text."""

    def __init__(self, name: str, is_name: bool = False) -> None:
        self.name, self._is_name = name, is_name

    def __call__(self, *, sites: int, **parameters: Number) -> System:
        return System._of(self.name, self._is_name, sites, {name: exact(value, name) for name, value in parameters.items()})

    def lattice(self, sites: int, eps: Number | None = None, *, dt: Number | None = None, **values: float | Array) -> Lattice:
        """The chain of so many sites, stepped as an array."""
        return Lattice(self.name, sites, eps, dt=dt, **values)

    def __repr__(self) -> str:
        return f"<Family {self.name}>"


def _integral_value(system: System, name: str, eps: Number, x: Any) -> Array:
    return system.integral_values(x, eps)[name]


def _question(ask: str, **fields: Any) -> str:
    return json.dumps({"ask": ask} | {name: value for name, value in fields.items() if value is not None})


def _exact(value: Number | None, name: str) -> str | None:
    return None if value is None else exact(value, name)


def _whole(value: int | None, name: str) -> int | None:
    return None if value is None else whole(value, name)
