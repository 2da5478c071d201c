"""Questions about a field, each with one answer."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._answer import Answer, Settings
from ._basis import Basis
from ._charts import Range, axes_of
from ._discovery import Discovery
from ._errors import choice
from ._exact import Number, answer, exact, exact_or_none, half_step, whole, whole_or_none
from ._points import Points
from ._progress import listener

__all__ = ["Questions", "question_text"]


class Questions(Points):
    """A field that answers questions."""

    def _ask(self, ask: str, progress: bool = False, **fields: Any) -> dict[str, Any]:
        return answer(self._answer(question_text(ask, **fields), listener=listener(progress)))

    def ask(self, question: str, *, progress: bool = False, **parts: Any) -> Answer:
        """Returns the answer to any question by its name, with parts as in JSON: numbers, text,
        lists and dicts.

        >>> import kahan
        >>> kahan.System("xdot = x^2;").ask("heights", eps="1/2", at=["1/3"], steps=2).steps
        2
        """
        return Answer(self._ask(question, progress, **parts))

    def evaluate(self, x: Any, eps: Number | None = None, *, dt: Number | None = None, exact: bool = False) -> Answer:
        """Evaluates all formulas of the field and of its map at a point, with the names of ``kahan
        eval --json``.

        The names are ``field``, ``field_jacobian``, ``A``, ``b``, ``det_A``, ``x_next``,
        ``jacobian``, ``det_jacobian``, ``integrals``, ``density`` (the claim without ``when``),
        ``brackets`` and ``drifts``. Values are numbers and arrays of float64, or of fractions with
        ``exact``. A value that is undefined at the point is ``None``. Formulas can be evaluated at
        many points: ``s.densities["rho"](x, eps)``.
        """
        found = self._ask("evaluate", at=self._point(x), eps=exact_or_none(half_step(eps, dt), "eps"), scalar="exact" if exact else "f64")

        def arrays(value: Any) -> Any:
            if isinstance(value, dict):
                return {name: arrays(one) for name, one in value.items()}
            return np.array(value, dtype=object if exact else float) if isinstance(value, list) else value

        return Answer({name: value if name == "variables" else arrays(value) for name, value in found.items()})

    def observe(
        self, x: Any, eps: Number | None = None, steps: int | None = None, *, dt: Number | None = None,
        transient: int = 0, observe: Sequence[str] | None = None, order: int = 2, renormalize: int = 10, spectrum: int | None = None, escape: float | None = None, reembed: bool = False, progress: bool = False,
    ) -> Answer:
        """Measures observables along the orbit of a point. ``observe`` names them, as in
        ``ensemble``.

        The first ``transient`` steps are not observed; ``steps`` of the answer includes them.

        Exponents are per unit of time: ``lyapunov`` is the largest, ``spectrum`` has all in
        descending order, with shape (variables,), and ``mean_log_det`` is their sum.
        ``lyapunov_error`` and ``spectrum_errors`` are the changes in the later part of the orbit;
        within them, ``lyapunov`` agrees with the first entry of ``spectrum``. Tangent vectors are
        made orthogonal every ``renormalize`` steps. ``spectrum=3`` computes only the three largest
        exponents.

        Three indicators distinguish chaotic orbits from regular ones. ``fli`` grows like the number
        of steps on chaotic orbits, like its logarithm on regular ones. ``megno`` grows on chaotic
        orbits, and tends to 2 on regular ones. ``sali`` falls to 0 exponentially on chaotic orbits;
        on regular ones it stays or falls like a power of time.

        ``rotation`` is the number of turns per step of each variable around the midpoint of its
        range, modulo 1. ``drift`` is the change of each claimed integral relative to its initial
        value, and ``extrema`` the smallest and largest value of each variable. ``ended`` says how
        the orbit ended and ``ended_step`` after how many steps: ``"complete"``, ``"range"`` if the
        next point is not finite, or ``"escaped"`` if ``escape`` is given and a variable exceeds it;
        the observables then cover the steps before. ``escaped`` is the first step after which a
        variable exceeds ``escape`` (by default 1e6) in absolute value, or ``None``. ``reembed``
        projects the steps of a lifted field, as in ``orbit``; it supports final, drift, extrema,
        rotation and escape.

        The default is all observables except ``final``, the last point, and ``passed_poles``, the
        number of steps over a pole of the map. A step passes a pole if the reduced denominator, at
        the point where the step begins, has a root between 0 and ``eps``, ``eps`` included; for a
        composition, at one of its stages. If the map has too many terms to be written out, steps
        with negative ``det_A`` are counted, and ``passed_poles_lower_bound`` is true.
        """
        if isinstance(observe, str):
            observe = (observe,)
        of = None if observe is None else [choice(name, "observable") for name in observe]
        found = self._ask("observe", progress, at=self._point(x), eps=exact(half_step(eps, dt), "eps"), steps=whole(steps, "steps"),
                          transient=whole(transient, "transient"), order=whole(order, "order"), renormalize=whole(renormalize, "renormalize"), spectrum=whole_or_none(spectrum, "spectrum"), escape=escape, reembed=reembed, observe=of)
        names = [name for name in ("spectrum", "spectrum_errors") if name in found]
        return Answer(found | {name: np.array(found[name], dtype=float) for name in names})

    def verify(self, *, progress: bool = False) -> Answer:
        """Proves the claims of the field again. For an unchanged system of the catalog, proves the
        paper's claims about it.
        """
        return Answer(self._ask("verify", progress, mutate=False))

    def periodic(self, x: Any = None, eps: Number | None = None, *, dt: Number | None = None, period: int = 1, free: str | None = None,
                 transient: int = 0, over: Mapping[str, Range] | None = None, hold: str | None = None, progress: bool = False) -> Answer:
        """Finds a cycle near a point, its multipliers and stability. ``over`` follows it along a
        parameter or eps.

        Without ``eps`` and ``period`` it is a steady state, with the ``eigenvalues`` of f'. Linear
        integrals keep their values at the point, unless ``hold="none"``.

        With ``free="eps"`` it is a limit cycle of the flow, made of ``period`` steps (by default as
        many as the orbit takes). It is searched near ``x``, and near points of the orbit of ``x``
        that nearly return after ``transient`` steps. ``flow`` has its period with an error and its
        multipliers, extrapolated from three numbers of steps, and ``steps``, ``eps`` and
        ``period_of_map`` of the map.

        With ``over``, ``branch["points"]`` has a row for each value and for each ``change``,
        ``branch["turns"]`` lists the changes, and ``branch["cut"]`` is true if the branch ends
        before the range does. Both tables have columns as entries,
        ``branch["points"]["parameter"]``, and ``to_pandas()`` converts them.

        >>> import kahan
        >>> lorenz = kahan.catalog.lorenz(s=10, r=28, b="8/3")
        >>> round(lorenz.periodic([1, 2, 20], 0.0026, period=300, free="eps").flow["period"], 6)
        1.558652
        """
        axes = axes_of(over, has_lists=False)
        if len(axes) > 1:
            raise ValueError("over: a cycle is followed along one parameter")
        found = self._ask("periodic", progress, at=[] if x is None else self._point(x), eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"),
                                period=whole(period, "period"), free=free, transient=whole(transient, "transient"), over=axes, hold=hold)
        if "branch" in found:
            found["branch"] |= {name: Settings(found["branch"][name]) for name in ("points", "turns")}
        return Answer(found)

    def heights(self, x: Any, eps: Number | None = None, steps: int | None = None, *, dt: Number | None = None,
                digits: int | None = None, seconds: float | None = None, progress: bool = False) -> Answer:
        """Measures how the heights of an exact orbit grow: exponentially if the map is not integrable."""
        return Answer(self._ask("heights", progress, at=self._point(x), eps=exact(half_step(eps, dt), "eps"), steps=whole(steps, "steps"),
                                digits=whole_or_none(digits, "digits"), seconds=seconds))

    def poles(self, eps: Number | None = None, *, dt: Number | None = None, steps: int | None = None, seconds: float | None = None,
              progress: bool = False) -> Answer:
        """Tests whether the singularities of the map are confined: follows curves that it sends to
        infinity or blows down.
        """
        return Answer(self._ask("poles", progress, eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"), steps=whole_or_none(steps, "steps"), seconds=seconds))

    def discover(self, *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None, seconds: float | None = None,
                 progress: bool = False) -> Discovery:
        """Finds what the map preserves, from the equations alone, with proofs: integrals,
        densities, brackets, drifts.

        Parameters without a value and ``eps`` are generic. If integrals may be missing, the search
        continues to higher degrees until ``seconds`` have passed, 60 by default.
        """
        asked = question_text("discover", eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"), degree=whole_or_none(degree, "degree"), seconds=seconds)
        text, relations = self._discovered(asked, listener=listener(progress))
        bases = [Basis(one, relation) for one, relation in zip(json.loads(text)["bases"], relations)]
        discovery = Discovery(answer(text) | {"bases": bases}, self._system)
        self.__dict__["_found"] = discovery
        return discovery

    def scan(self, over: Mapping[str, Range], *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None,
             seconds: float | None = None, progress: bool = False) -> Answer:
        """Searches a grid for special values of parameters and eps.

        At a special value, the map preserves more than at generic values, or the degrees of its
        iterates grow more slowly.

        ``special`` lists these values. ``points`` has the result ``sight`` for each value that was
        tried: the number of independent integrals, and the degrees. ``generic`` is the result at
        generic values.
        """
        return Answer(self._ask("scan", progress, over=axes_of(over, has_lists=False), eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"),
                                degree=whole_or_none(degree, "degree"), seconds=seconds))

    def trade(self, x: Any, horizon: Number, *, need: str = "trajectory", tolerance: Number = 1e-8, seconds: float = 10.0,
              progress: bool = False) -> Answer:
        """Finds the cheapest setting (scalar, order, eps) that follows the flow, or keeps the
        integrals, within a tolerance.

        ``settings`` is a table of all measured settings: ``settings["eps"]`` is a column,
        ``settings[0]`` a row.
        """
        found = self._ask("trade", progress, at=self._point(x), horizon=exact_or_none(horizon, "horizon"), need=need,
                          tolerance=exact_or_none(tolerance, "tolerance"), seconds=float(seconds))
        return Answer(found | {"settings": Settings(found["settings"])})

    def extremes(self, *, trials: int = 4000, seed: int = 1, progress: bool = False) -> Answer:
        """Tests steps in floats near poles, of mixed magnitudes, and with subnormal and infinite
        numbers.

        Each step is compared with exact arithmetic; ``trials`` is the number of steps for each
        scalar type.
        """
        judged = self._judged(whole(trials, "trials"), whole(seed, "seed"), listener=listener(progress))
        return Answer(answer(judged))


def question_text(ask: str, **fields: Any) -> str:
    """Returns a question as JSON, without parts that are ``None``."""
    return json.dumps({"ask": ask} | {name: value for name, value in fields.items() if value is not None})
