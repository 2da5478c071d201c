"""Questions that have one answer."""

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
                          transient=whole(transient, "transient"), order=whole(order, "order"), renormalize=whole(renormalize, "renormalize"), spectrum=whole_or_none(spectrum, "spectrum"), escape=escape, reembed=reembed, observe=of)
        names = [name for name in ("spectrum", "spectrum_errors") if name in found]
        return Answer(found | {name: np.array(found[name], dtype=float) for name in names})

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
        itself after ``transient`` steps: ``flow`` has its period with an error and its multipliers,
        extrapolated from three numbers of steps, and ``steps``, ``eps`` and ``period_of_map`` of the map.

        With ``over``, ``branch["points"]`` has a row at each value, and one at each ``change``;
        ``branch["turns"]`` lists the changes, and ``branch["cut"]`` says whether it ends before the range.

        ``branch`` has ``points`` and ``turns``, the places where something changes: tables whose columns are entries,
        as ``branch["points"]["parameter"]``, and which ``to_pandas()`` converts. ``branch["cut"]`` says whether the branch
        ended within the range.

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
        """How the heights of an exact orbit grow: exponentially where the map is not integrable."""
        return Answer(self._ask("heights", progress, at=self._point(x), eps=exact(half_step(eps, dt), "eps"), steps=whole(steps, "steps"),
                                digits=whole_or_none(digits, "digits"), seconds=seconds))

    def poles(self, eps: Number | None = None, *, dt: Number | None = None, steps: int | None = None, seconds: float | None = None,
              progress: bool = False) -> Answer:
        """What becomes of curves that the map sends to infinity or blows down: whether they come back."""
        return Answer(self._ask("poles", progress, eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"), steps=whole_or_none(steps, "steps"), seconds=seconds))

    def discover(self, *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None, seconds: float | None = None,
                 progress: bool = False) -> Discovery:
        """What the map preserves, found from the equations alone and proved: integrals, densities, brackets, drifts.

        Parameters without a value and ``eps`` are generic. Where integrals may be missing, the
        search goes on to higher degrees until ``seconds`` are over, 60 by default.
        """
        asked = question_text("discover", eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"), degree=whole_or_none(degree, "degree"), seconds=seconds)
        text, relations = self._discovered(asked, listener=listener(progress))
        bases = [Basis(one, relation) for one, relation in zip(json.loads(text)["bases"], relations)]
        discovery = Discovery(answer(text) | {"bases": bases}, self._system)
        self.__dict__["_found"] = discovery
        return discovery

    def scan(self, over: Mapping[str, Range], *, eps: Number | None = None, dt: Number | None = None, degree: int | None = None,
             seconds: float | None = None, progress: bool = False) -> Answer:
        """Which values of parameters and of eps are special: where the map keeps more than it does elsewhere,
        or the degrees of its iterates grow more slowly, as they do where it is less chaotic.

        ``special`` has these values, and ``points`` for each value that was tried what was seen there, its
        ``sight``: how many integrals are independent, and the degrees. ``generic`` is the sight elsewhere.
        """
        return Answer(self._ask("scan", progress, over=axes_of(over, has_lists=False), eps=exact_or_none(half_step(eps, dt, is_needed=False), "eps"),
                                degree=whole_or_none(degree, "degree"), seconds=seconds))

    def trade(self, x: Any, horizon: Number, *, need: str = "trajectory", tolerance: Number = 1e-8, seconds: float = 10.0,
              progress: bool = False) -> Answer:
        """The cheapest setting (scalar, order, eps) that follows the flow, or keeps the integrals, to a tolerance.

        ``settings`` is a table of all that were measured: ``settings["eps"]`` is a column, ``settings[0]`` a row.
        """
        found = self._ask("trade", progress, at=self._point(x), horizon=exact_or_none(horizon, "horizon"), need=need,
                          tolerance=exact_or_none(tolerance, "tolerance"), seconds=float(seconds))
        return Answer(found | {"settings": Settings(found["settings"])})

    def extremes(self, *, trials: int = 4000, seed: int = 1, progress: bool = False) -> Answer:
        """How far floats can be trusted near poles, of mixed magnitudes, with subnormal and infinite numbers.

        Steps are judged by exact arithmetic; ``trials`` of each scalar.
        """
        judged = self._judged(whole(trials, "trials"), whole(seed, "seed"), listener=listener(progress))
        return Answer(answer(judged))


def question_text(ask: str, **fields: Any) -> str:
    """A question as JSON, without what is ``None``."""
    return json.dumps({"ask": ask} | {name: value for name, value in fields.items() if value is not None})
