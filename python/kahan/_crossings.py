"""Sections, diagrams and charts of orbits over initial points, parameters and eps."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from fractions import Fraction
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from ._arrays import by_name, read
from ._charts import Range, axes_of, size
from ._errors import choice
from ._exact import Number, exact, exact_or_none, half_step, nearest, point, whole, whole_or_none
from ._orbit import Array, Chart, Diagram, Section
from ._points import Points
from ._progress import listener
from ._questions import question_text
from ._series import table_file

__all__ = ["Crossings"]

Crossed = TypeVar("Crossed", bound=Section)


class Crossings(Points):
    """A field with its sections, diagrams and charts."""

    def section(
        self, x: Any, eps: Number | Array | None = None, steps: int | None = None, plane: str | None = None, *,
        dt: Number | Array | None = None, direction: str = "rising", maxima: str | None = None, crossings: int | None = None,
        transient: int = 0, order: int = 2, params: Any = None, over: Mapping[str, Range | Array] | None = None, carry: bool = False,
        reembed: bool = False, to: str | PathLike[str] | None = None, threads: int | None = None, progress: bool = False,
    ) -> Section:
        """Finds where orbits cross ``plane`` = 0, a formula in the variables and integrals.

        ``x`` is a point, an array of shape (orbits, variables), or a table, as in ``ensemble``.
        ``eps`` and each parameter in ``params`` are one number, or one for each initial point.
        ``over`` maps names to values, as in ``chart``: an orbit is computed for each initial point
        and each value. Orbits are computed on several ``threads``; the crossings of an orbit do not
        depend on the other orbits.

        ``direction`` is "rising", "falling" or "both". ``maxima="x"`` replaces ``plane`` and finds
        the maxima of x. Each crossing is refined on the curve that the step of this ``order``
        traces as eps grows from 0, so its time is accurate to that order. A sign change without a
        zero, as at a pole of the formula or of the map, is not a crossing; ``jumps`` counts these.
        The first ``transient`` steps are skipped. After them, an orbit ends after ``crossings``
        crossings or ``steps`` steps; ``ended`` says which. With ``carry``, an orbit begins at the
        last point of the orbit at the previous value. ``reembed`` projects the steps of a lifted
        field, as in ``orbit``.

        ``to`` names a file, F.parquet or F.arrow. The table is written to it during the
        computation, with bounded memory. The result then has no rows, but counts the crossings of
        each orbit. Needs pyarrow.

        >>> import kahan
        >>> s = kahan.System("xdot = y; ydot = -x;")
        >>> s.section([[1, 0], [2, 0]], 0.01, plane="y", crossings=3)
        <Section of 2 orbits of field at y = 0: 6 crossings>
        """
        plane, direction = self._plane(plane, maxima, direction)
        return self._crossed(Section, x, half_step(eps, dt, is_needed="eps" not in (over or {})), params, over, threads, progress, to, maxima,
                             plane=plane, direction=direction, steps=whole_or_none(steps, "steps"), crossings=whole_or_none(crossings, "crossings"),
                             transient=whole(transient, "transient"), order=whole(order, "order"), carry=carry, reembed=reembed)

    def diagram(
        self, over: Mapping[str, Range | Array], x: Any = None, eps: Number | None = None, *, plane: str | None = None,
        maxima: str | None = None, dt: Number | None = None, direction: str = "rising", crossings: int = 100,
        steps: int | None = None, transient: int = 1000, order: int = 2, carry: bool = False, show: str | None = None,
        reembed: bool = False, threads: int | None = None, progress: bool = False,
    ) -> Diagram:
        """Finds where orbits cross a section over a parameter or eps: a bifurcation diagram for
        ``plot``.

        At each value of ``over``, an orbit begins at ``x``, or with ``carry`` at the last point for
        the previous value. It yields up to ``crossings`` points where ``plane`` = 0, or maxima of
        the variable ``maxima``, within ``steps`` steps after the first ``transient`` steps. The
        default transient is 1000 steps, a time of 2000 eps; an orbit that is attracted slowly needs
        more. With ``carry`` the diagram shows hysteresis, and period doublings appear later than
        they occur, because an orbit leaves an unstable cycle slowly. ``show`` is the variable that
        ``plot`` draws; the default is the variable of ``maxima``, or the first one that ``plane``
        does not contain.

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
        found = self._crossed(Diagram, [Fraction(one) for one in self._point(x)], eps, None, over, threads, progress, None, maxima,
                              plane=plane, direction=direction,
                              steps=whole_or_none(steps, "steps"), crossings=whole(crossings, "crossings"), transient=whole(transient, "transient"),
                              order=whole(order, "order"), carry=carry, reembed=reembed)
        others = [variable for variable in self.variables if not re.search(rf"\b{variable}\b", plane)]
        found.over, found.shown = name, show or maxima or (others or self.variables)[0]
        return found

    def _plane(self, plane: str | None, maxima: str | None, direction: str) -> tuple[str, str]:
        """Returns the formula of a section and its direction; for maxima, those of the derivative."""
        if maxima is not None and plane is not None:
            raise ValueError("plane and maxima: one of both says what the section is")
        if maxima is not None:
            return self._rate(maxima), "falling"
        if plane is None:
            raise TypeError('plane is missing: give a formula that is 0 on the section, as plane="x - 1", or a variable, as maxima="x"')
        if not isinstance(plane, str):
            raise TypeError(f"plane: text is needed, as \"x - z\" for x = z, not {type(plane).__name__}")
        return plane, choice(direction, "direction")

    def _crossed(self, kind: type[Crossed], x: Any, eps: Any, params: Any, over: Mapping[str, Range | Array] | None,
                 threads: int | None, progress: bool, to: str | PathLike[str] | None, maxima: str | None, **asked: Any) -> Crossed:
        """Computes the crossings of one orbit or many, and writes them to a file if one is named."""
        points, own = read(self._at(x), self, "x", varies=True)
        given = dict(by_name(params) or ()) | own
        if "eps" in given:
            eps = given.pop("eps")
        each = {name: value for name, value in {**given, "eps": eps}.items() if np.ndim(value)}
        rows = points if np.ndim(points) > 1 else [points] * max([np.size(value) for value in each.values()], default=1)
        is_one = np.ndim(points) == 1 and not each
        system = self._system(**{name: value for name, value in given.items() if not np.ndim(value)}) if len(each) < len(given) else self._system
        starts = {"at": point(points)} if is_one else {"starts": [point(row) for row in rows]}
        lists = {name: [exact(one, name) for one in np.ravel(value)] for name, value in each.items()}
        half = None if eps is None or "eps" in each else eps
        question = question_text("section", eps=exact_or_none(half, "eps"), **starts, params=lists or None, over=axes_of(over) or None, **asked)
        workers, hear = whole_or_none(threads, "threads"), listener(progress)
        if to is None:
            columns, (ended, counts) = system._crossings(question, threads=workers, listener=hear)
        else:
            with table_file(Path(to)) as write:
                columns, (ended, counts) = system._crossings(
                    question, part=lambda part: write({name: values for name, _, values in part}), threads=workers, listener=hear)
                write({name: values for name, _, values in columns})
            columns = [(name, meaning, values[:0]) for name, meaning, values in columns]
        named = [(name, values) for name, _, values in columns]
        return kind(system, asked["plane"], maxima, None if half is None else nearest(half, "eps"), named, is_one and not over, ended, counts)

    def chart(
        self, over: Mapping[str, Range | Array], x: Any, eps: Number | None = None, *,
        dt: Number | None = None, steps: int = 1000, transient: int = 0,
        color: str = "sali", order: int = 2, escape: float | None = None, reembed: bool = False,
        threads: int | None = None, progress: bool = False,
    ) -> Chart:
        """Computes an observable of orbits over parameters, eps or initial values: one number per
        cell.

        ``over`` maps each name to (low, high, count), to text as "0:1:/20", or to an array of
        values. All other values are those of the field, ``x`` and ``eps``. ``color`` is an
        observable with one number: sali, fli, megno, lyapunov, log_det, drift, escape,
        passed_poles; or a column such as drift_H or spectrum_2. Each cell needs one orbit; orbits
        run in SIMD lanes and on all threads. The first ``transient`` steps are not observed.

        The exponents of an escaping orbit are large without being a sign of chaos. If ``escape`` is
        given, an orbit ends where a variable exceeds it in absolute value, and its cell is NaN. A
        good bound is a few times the size of the region of interest. ``ended`` and ``ended_step``
        say for each cell how and after how many steps the orbit ended. ``reembed`` projects the
        steps of a lifted field, as in ``orbit``; it supports the colors drift, escape, and columns
        of final points, extrema and rotation.
        """
        if not over:
            raise ValueError("over: a chart goes through something, as over={\"eps\": (0.01, 0.1, 50)}")
        axes = axes_of(over)
        eps = half_step(eps, dt, is_needed="eps" not in over)
        question = {"ask": "observe", "at": self._point(x), "transient": whole(transient, "transient"),
                    "steps": whole(steps, "steps"), "order": whole(order, "order"), "escape": escape, "reembed": reembed, "over": axes}
        if eps is not None:
            question["eps"] = exact(eps, "eps")
        (*columns, (_, meaning, shown)), _, _ = self._table(json.dumps(question), color=color, threads=whole_or_none(threads, "threads"),
                                                            listener=listener(progress))
        found = {name: values for name, _, values in columns}
        # The last axis varies fastest. An axis with one value has no column.
        sizes = [size(values) or len(np.unique(found[name])) for name, values in over.items()]
        along = {}
        for k, name in enumerate(over):
            places = found[name].reshape(sizes) if name in found else np.full(sizes, np.nan)
            along[name] = np.moveaxis(places, k, 0).reshape(sizes[k], -1)[:, 0]
        of = ", ".join(([] if "eps" in over else [f"eps = {eps}"]) + [f"{steps} steps"])
        ended, ended_step = np.array(found["ended"], dtype=object).reshape(sizes), found["ended_step"].reshape(sizes)
        return Chart(self._system, along, color, shown.reshape(sizes), ended, ended_step, meaning, of)
