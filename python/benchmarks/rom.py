"""A reduced-order model of Burgers' equation that `opinf` has inferred, beside the model's own `predict`.

At equal error: each method takes its loosest tolerance, kahan its largest step, that reaches the error. It prints the times
of a call, their ratio, and the distance of the energy from that of the exact solution. `python rom.py` needs opinf.
"""

import sys
import time
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import opinf
from scipy.integrate import solve_ivp

import kahan

POINTS, VISCOSITY, END, SHOWN = 256, 0.01, 5.0, 20
ERRORS = (1e-3, 1e-6, 1e-9)
METHODS = ("RK45", "DOP853", "LSODA", "Radau", "BDF")
STEPS = [SHOWN * many for many in (*range(1, 20), *range(20, 40, 2), *range(40, 80, 5), *range(80, 320, 20))]


def burgers(u: np.ndarray) -> np.ndarray:
    """u' = -u u_x + nu u_xx, whose advection keeps the energy; a row a state."""
    h = 2 * np.pi / POINTS
    slope = lambda of: (np.roll(of, -1, -1) - np.roll(of, 1, -1)) / (2 * h)
    return -(u * slope(u) + slope(u * u)) / 3 + VISCOSITY * (np.roll(u, -1, -1) - 2 * u + np.roll(u, 1, -1)) / h**2


def inferred(n: int) -> tuple[Any, np.ndarray]:
    """A model of n variables, and a first point."""
    draw = np.random.default_rng(n)
    x = np.arange(POINTS) * 2 * np.pi / POINTS
    times = np.linspace(0, END, 200)
    waves = [sum(a * np.sin(k * x + b) / k for k, (a, b) in enumerate(draw.uniform(-1, 1, (3, 2)) * [1, np.pi], 1)) for _ in range(6)]
    snapshots = [solve_ivp(lambda _, u: burgers(u), (0, END), wave, t_eval=times, rtol=1e-8, atol=1e-10).y for wave in waves]
    basis = np.linalg.svd(np.hstack(snapshots), full_matrices=False)[0][:, :n]
    # Rates at states of the basis determine the operators of the projected equation.
    reduced = draw.normal(size=(3 * (n + n * (n + 1) // 2), n)) / np.sqrt(n)
    model = opinf.models.ContinuousModel("AH")
    model.fit(reduced.T, (burgers(reduced @ basis.T) @ basis).T)
    return model, basis.T @ waves[0]


def timed(call: Callable[[], Any], rounds: int = 7) -> float:
    """The shortest time of a call: that of the processor, since both run in one thread."""
    times = []
    for _ in range(rounds):
        begun = time.process_time()
        call()
        times.append(time.process_time() - begun)
    return min(times)


def first(candidates: list[tuple[Any, Callable[[], np.ndarray]]], wanted: float, error: Callable[[np.ndarray], float]) -> Any:
    """The first candidate whose error is small enough."""
    for named, call in candidates:
        try:
            if error(call()) <= wanted:
                return named, call
        except (ValueError, ArithmeticError):
            continue
    return None


def rows(n: int) -> None:
    model, x0 = inferred(n)
    A, H = (operator.entries for operator in model.operators)
    s = kahan.System.from_arrays(None, A, H)
    t = np.linspace(0, END, SHOWN + 1)
    exact = solve_ivp(model.rhs, (0, END), x0, args=(None,), method="DOP853", t_eval=t, rtol=3e-14, atol=1e-16).y.T
    size = np.abs(exact).max()
    error = lambda x: float(np.abs(x - exact).max() / size) if x.shape == exact.shape else np.inf
    energy = lambda x: float(np.abs((x**2).sum(1) - (exact**2).sum(1)).max() / (exact[0] ** 2).sum())
    ours = {order: [((order, steps), lambda order=order, steps=steps: s.orbit(x0, END / 2 / steps, steps, order=order).x[:: steps // SHOWN])
                    for steps in STEPS] for order in (2, 4, 6, 8)}
    theirs = {method: [((method, tolerance), lambda method=method, tolerance=tolerance: model.predict(
        x0, t, method=method, rtol=tolerance, atol=tolerance * size / 100).T) for tolerance in 10.0 ** -np.arange(2, 13.5, 0.5)]
              for method in METHODS}
    for wanted in ERRORS:
        best = []
        for side in (ours, theirs):
            found = [one for one in (first(candidates, wanted, error) for candidates in side.values()) if one is not None]
            times = [(timed(call), named, call) for named, call in found]
            best.append(min(times, key=lambda one: one[0]))
            default = next((one[0] for one in times if one[1][0] == "RK45"), np.nan)
        (mine, (order, steps), orbit), (other, (method, tolerance), predict) = best
        print(f"n = {n}, error {wanted:.0e}: order {order}, {steps} steps {1e3 * mine:.2f} ms; {method} at {tolerance:.0e} "
              f"{1e3 * other:.2f} ms ({other / mine:.1f} x), RK45 {1e3 * default:.2f} ms ({default / mine:.1f} x); "
              f"energy off by {energy(orbit()):.0e} and {energy(predict()):.0e}", flush=True)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    for n in map(int, sys.argv[1:] or (10, 20, 40)):
        rows(n)
