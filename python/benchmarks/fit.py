#!/usr/bin/env python3
"""Fits with exact derivatives beside fits with finite differences, and beside `solve_ivp`.

    python benchmarks/fit.py

Two models are fitted to 200 data points by `scipy.optimize.least_squares`, from the same first guess and with the same
tolerances: predator and prey with two unknown rates, and a network of mass action with ten. The methods take turns in one
run, and all fits find the rates. Orbits have order 4 and one step from point to point. Their errors, and those of `solve_ivp`
at its tolerance, are printed; they are below the noise of the data.

With exact derivatives one orbit gives residuals and Jacobian: `least_squares` asks for the Jacobian where it has just asked for
the residuals, so the last orbit is kept.
"""

import statistics
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import kahan
from peers import is_here

POINTS, ROUNDS, NOISE, TOLERANCE = 200, 25, 1e-3, 1e-6

PREY = "xdot = a*x - x*y; ydot = b*x*y - y;"
# A and B bind to C, which turns into D and E and back; all species are fed and washed out.
NETWORK = """
    Adot = k0 - k1*A*B + k2*C - k3*A;
    Bdot = k4 - k1*A*B + k2*C - k3*B;
    Cdot = k1*A*B - k2*C - k5*C + k6*D*E;
    Ddot = k5*C - k6*D*E - k7*D;
    Edot = k5*C - k6*D*E - k8*E + k9*D;
"""


class Model:
    """A field with unknown rates, its data, and the residuals of a guess."""

    def __init__(self, text: str, true: list[float], guess: list[float], x: list[float], time: float) -> None:
        self.system, self.true, self.guess, self.x = kahan.System(text), np.array(true), np.array(guess), np.array(x)
        self.names, self.time, self.eps = list(self.system.parameters), time, time / (2 * POINTS)
        self.exact = self.by_solve_ivp(self.true, 1e-12)
        self.data = self.exact + NOISE * np.random.default_rng(1).normal(size=self.exact.shape)
        self.last: tuple[Any, kahan.Orbit | None] = (None, None)

    def by_kahan(self, rates: Any) -> Any:
        return self.system(**dict(zip(self.names, rates))).orbit(self.x, self.eps, POINTS, order=4).x[1:]

    def sensitivities(self, rates: Any) -> kahan.Orbit:
        """The orbit that was computed last, if it is that of these rates."""
        known, orbit = self.last
        if orbit is None or (known != rates).any():
            system = self.system(**dict(zip(self.names, rates)))
            orbit = system.orbit(self.x, self.eps, POINTS, order=4, derivatives=self.names)
            self.last = rates.copy(), orbit
        return orbit

    def jacobian(self, rates: Any) -> Any:
        found = self.sensitivities(rates).derivatives
        return np.stack([found[name][1:].ravel() for name in self.names], axis=1)

    def by_solve_ivp(self, rates: Any, tolerance: float = TOLERANCE) -> Any:
        from scipy.integrate import solve_ivp

        times = np.linspace(0, self.time, POINTS + 1)
        side = self.side(rates)
        found = solve_ivp(side, (0, self.time), self.x, t_eval=times, rtol=tolerance, atol=tolerance / 1000)
        return found.y.T[1:]

    def side(self, rates: Any) -> Callable[..., Any]:
        """The right side as one would write it by hand."""
        if len(rates) == 2:
            a, b = rates
            return lambda t, z: [a * z[0] - z[0] * z[1], b * z[0] * z[1] - z[1]]
        k = rates

        def network(t: float, z: Any) -> list[float]:
            A, B, C, D, E = z
            binds, breaks = k[1] * A * B - k[2] * C, k[5] * C - k[6] * D * E
            return [k[0] - binds - k[3] * A, k[4] - binds - k[3] * B, binds - breaks, breaks - k[7] * D,
                    breaks - k[8] * E + k[9] * D]

        return network

    def fit(self, predict: Callable[[Any], Any], **how: Any) -> Any:
        from scipy.optimize import least_squares

        return least_squares(lambda rates: (predict(rates) - self.data).ravel(), self.guess, method="lm", xtol=1e-10,
                             ftol=1e-10, gtol=1e-10, **how)

    def exactly(self) -> Any:
        self.last = None, None
        return self.fit(lambda rates: self.sensitivities(rates).x[1:], jac=self.jacobian)

    def by_differences(self) -> Any:
        return self.fit(self.by_kahan)

    def with_solve_ivp(self) -> Any:
        return self.fit(self.by_solve_ivp)


def models() -> dict[int, Model]:
    """By the number of rates."""
    rates = [0.6, 1.5, 0.4, 0.3, 0.5, 0.8, 0.6, 0.25, 0.35, 0.2]
    return {
        2: Model(PREY, [1.5, 0.8], [1.2, 1.0], [1.0, 0.5], 20.0),
        10: Model(NETWORK, rates, [0.5] * 10, [1.0, 0.8, 0.1, 0.2, 0.1], 20.0),
    }


LIMITS = {2: 0.7, 10: 0.35}


def timed(work: Callable[[], Any]) -> tuple[float, Any]:
    """The processor time, as a fit runs on one thread and other programs then matter less. The caches are those of the same
    work before."""
    work()
    begun = time.process_time()
    found = work()
    return time.process_time() - begun, found


def fitting(limit: Callable[..., None], skipped: Callable[[str, str], None]) -> None:
    """The rows of a table of limits."""
    if not is_here("scipy"):
        return skipped("fits by least squares", "scipy is not installed")
    for count, model in models().items():
        ways = [model.exactly, model.by_differences] + ([model.with_solve_ivp] if count == 2 else [])
        errors = [abs(predict(model.true) - model.exact).max() for predict in (model.by_kahan, model.by_solve_ivp)]
        print(f"{count} rates: errors of orbits {errors[0]:.1g}, of solve_ivp {errors[1]:.1g}, noise {NOISE:g}", file=sys.stderr)
        rounds = [[timed(way) for way in ways] for _ in range(ROUNDS + 1)]
        for way, (_, found) in zip(ways, rounds[0]):
            name = way.__name__.replace("_", " ")
            seconds = statistics.median(one[ways.index(way)][0] for one in rounds[1:])
            off = abs(found.x - model.true).max()
            assert found.success and off < 0.2, (name, found)
            print(f"{count} rates, {name}: {1e3 * seconds:.3g} ms, {found.nfev} evaluations, {found.njev} Jacobians, "
                  f"largest error of a rate {off:.2g}", file=sys.stderr)
        ratios = list(zip(*[[row[0][0] / other[0] for other in row[1:]] for row in rounds[1:]]))
        limit(f"fit of {count} rates, {POINTS} points, / the same by differences", LIMITS[count], list(ratios[0]))
        for values in ratios[1:]:
            limit(f"fit of {count} rates, {POINTS} points, / with solve_ivp", 0.1, list(values))


if __name__ == "__main__":
    fitting(lambda name, at_most, values: print(f"{name}: {statistics.median(values):.3g}, at most {at_most:g}"),
            lambda name, why: print(f"{name}: skipped, {why}"))
