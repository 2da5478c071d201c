"""Orbits of one initial point and of many."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from os import PathLike
from typing import Any, overload

import numpy as np

from ._arrays import by_name, constants, flat, one_order, read
from ._derivatives import differentiable, in_order
from ._errors import choice
from ._exact import Number, exact, half_step, nearest, whole, whole_or_none
from ._orbit import Array, Ensemble, FloatOrbit, Orbit
from ._points import Points
from ._progress import listener
from ._rhs import RightSide
from ._series import Series

__all__ = ["Trajectories"]


class Trajectories(Points):
    """A field with its orbits."""

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
        """Computes the orbit of a point: the initial point, and every ``every``-th point after it.

        ``x`` has shape (variables,); without it, the orbit begins at the ``start`` of the text.
        Give ``eps`` or ``dt`` = 2 eps; a step takes the time ``dt``. The first ``transient`` steps
        have no rows; the first row has their number and time, and ``steps`` counts the steps after
        them. ``out``, of shape (1 + steps // every, variables), receives the rows instead of a new
        array.

        ``order`` 4, 6 and 8 are compositions of steps of Kahan's map. They follow the flow more
        closely, but do not preserve the map's integrals (see ``Orbit.integrals``). ``scalar`` is
        f64, f32, dd (32 digits: ``x`` has the high doubles, ``x_low`` the low ones) or exact
        (fractions in an array of objects). Points in float32 are stepped in float32.
        ``compensated`` adds the rounding error of each point to the next step. ``method`` is kahan,
        or for comparison euler, rk4 or flow (the exact solution, by certified Taylor series).

        ``projective`` continues through poles, by points at infinity. ``reembed`` projects each
        step of a lifted field, in f64, symmetrically onto the relations between its variables: they
        hold exactly, and energies do not drift. A step then takes as long as 2 to 16 steps of the
        map.

        ``derivatives`` lists names of parameters, variables (for their initial values) and
        ``"eps"``: ``o.derivatives["a"][k]`` is the derivative of ``o.x[k]`` with respect to ``a``,
        exact up to rounding. The points are unaffected. Derivatives exist for f64 and f32, also
        with compositions and compensation, for fields that are not lifted. A derivative beyond the
        range of floats is infinite or NaN, while the orbit continues; the derivative with respect
        to ``eps`` is NaN at eps = 0. Each name costs about one more step of the map per step. The
        first call also compiles code, for some tens of milliseconds; ``s(a=2)`` shares this code
        with ``s``.

        >>> import kahan
        >>> s = kahan.System("xdot = a*x^2;", a=3)
        >>> o = s.orbit([0.5], 0.125, 1, derivatives=["a", "x"])     # the map is x/(1 - 2*eps*a*x)
        >>> o.x[1], o.derivatives["a"][1], o.derivatives["x"][1]
        (array([0.8]), array([0.16]), array([2.56]))

        An orbit ends before a point that is not finite or has no value, and for a lifted field also
        where a root would be negative or, as ``"reembed"``, where the projection does not converge.
        ``ended`` says so, and ``x`` has the rows up to there. For three variables in f64, a step
        takes about ten nanoseconds.
        """
        eps = half_step(eps, dt)
        steps, every, order = whole(steps, "steps"), whole(every, "every"), whole(order, "order")
        transient = whole(transient, "transient")
        x = self._one(x)
        scalar, method = choice(scalar, "scalar"), choice(method, "method")
        by = differentiable(self._system, derivatives, "derivatives")
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
            orbit: Orbit = FloatOrbit(self._system, half, states, every, made, ended, half if order == 2 else 0.0, in_all)
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
        orbit = kind(self._system, given, states if low is None else states[:, :, 0], every, last, ended, integrals)
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
        """Computes many trajectories: their last points and observables, or with ``every`` the
        points on the way.

        ``points`` has shape (trajectories, variables), or more axes, such as (40, 40, variables),
        which all arrays of the result keep. Or it is a table with a column for each variable: a
        ``DataFrame`` of pandas or polars, an Arrow table, a structured array or a dict of arrays.
        The table may also have columns for parameters and ``eps``, which replace these arguments; a
        column with another name is an error. ``params`` is a dict or a table of parameters. ``eps``
        and each parameter are one number, or one for each initial point.

        ``observe`` lists the observables: drift (of ``Orbit.integrals``), extrema, lyapunov (the
        largest exponent, per unit of time), spectrum (all exponents in descending order, of shape
        (trajectories, variables)), log_det (their sum), fli, megno, sali, rotation, escape,
        passed_poles (steps over a pole; a lower bound if ``passed_poles_lower_bound`` is 1). The
        method ``observe`` describes them. Tangent vectors are made orthogonal every ``renormalize``
        steps; ``spectrum=3`` computes only the three largest exponents. With observables and
        ``escape``, an orbit ends as ``"escaped"`` at the step after which a variable exceeds
        ``escape`` in absolute value. The column ``escaped`` is that step, or without ``escape`` the
        first step beyond 1e6, and NaN if there is none. ``reembed`` projects the steps of a lifted
        field, as in ``orbit``; it supports drift, extrema, rotation and escape.

        The first ``transient`` steps are not counted, shown or observed. With ``every`` the result
        is a ``Series`` of shape (trajectories, 1 + steps // every, variables); its rows agree bit
        for bit with those of single orbits. With ``columns``, such as ``["t", "x", "H"]``, it has
        only these columns and takes less memory. ``to`` names a file, F.parquet or F.arrow. The
        table is written to it during the computation, with bounded memory, and the result is the
        ensemble of its last points. Needs pyarrow.

        ``derivatives`` lists names of parameters, variables and ``"eps"``, as in ``orbit``.
        ``r.derivatives["a"]`` has shape (trajectories, variables): row k is the derivative of
        ``r.x[k]`` with respect to the ``a`` of that trajectory, and NaN if the trajectory ended
        early or a derivative is beyond the range of floats. Derivatives cannot be combined with
        observables or ``reembed``.

        The work is spread over ``threads`` threads, by default one for each processor; results do
        not depend on their number. ``ended`` says how each trajectory ended, as ``Orbit.ended``
        does, and ``steps`` after how many steps. If a trajectory ended early, its numbers are NaN.
        """
        if points is None:
            how = "[s.start]" if self.start else f"[[{', '.join('1' for _ in self.variables)}]]"
            raise TypeError(f"points is missing: give the first points, a row each, as s.ensemble({how}, eps=…, steps=…)")
        tables = [value for table in (points, params) for _, value in by_name(table, lambda: self._names) or ()]
        one_order([*tables, eps, dt])
        eps = half_step(eps, dt, is_needed=False)
        points, own = read(points, self, "points", varies=True)
        inputs, start = constants(eps, own, params, self.parameters), np.asarray(points)
        if inputs["eps"].dtype == object:
            inputs["eps"] = inputs["eps"].astype(float)
        each = {name: flat(value, name, start.shape[:-1]) for name, value in inputs.items()}
        eps, given = each["eps"], [each.get(name) for name in self.parameters]
        points = start if start.ndim < 3 else start.reshape(-1, start.shape[-1])
        steps, order = whole(steps, "steps"), whole(order, "order")
        threads = whole_or_none(threads, "threads")
        begun = self._in_all(points, given)
        by = differentiable(self._system, derivatives, "derivatives")
        transient = whole(transient, "transient")
        if by and (observe or reembed or transient or every is not None):
            raise ValueError("derivatives are for ensembles without observers, every, transient and reembed")
        if every is not None:
            if observe or out is not None:
                raise ValueError("every shows points on the way; ask for observers, and for the last points in out, without it")
            frame = Series(self._system, start, inputs, steps, whole(every, "every"), transient)
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
            ensemble = Ensemble(self._system, start, inputs, self._out_of_all(x, into), ends, {})
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
        # An integral with a condition may hold for some of the trajectories only.
        if "drift" in observe and not self.integrals:
            raise ValueError("observe: this field claims no integral that could drift; `s.discover().claimed` has those found")
        of = ["final", *(choice(name, "observable") for name in observe if name != "final")]
        seen, values, ends = self._observed(begun, eps, steps, of, parameters=given, order=order, transient=transient, spectrum=whole_or_none(spectrum, "spectrum"),
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
        return Ensemble(self._system, start, inputs, x, ends, observed)

    def rhs(self, *parameters: str) -> RightSide:
        """Returns f for ODE solvers, as in ``solve_ivp(s.rhs(), (0, 10), x, vectorized=True)``.

        ``args=(a, b)`` gives values to its parameters: those named here, in this order; by default
        those without a value, or else all. Its ``jacobian`` serves as the argument ``jac`` of
        implicit solvers.

        >>> import kahan
        >>> kahan.System("xdot = y; ydot = -x;").rhs()(0.0, [1.0, 2.0])
        array([ 2., -1.])
        >>> kahan.System("xdot = k*y; ydot = -m*x;").rhs("m", "k")(0.0, [1.0, 2.0], 5, 10)
        array([20., -5.])
        """
        return RightSide.of(self._system, parameters)
