"""The Dormand–Prince method of order 8 in Numba: by loops over its tableau, and written out for one field."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

Solve = Callable[[np.ndarray, float, float], np.ndarray]

# The step control of both programs, as in SciPy.
CONTROL = """
        below = five + 0.01*three
        error = h*five/math.sqrt(below*n) if below > 0 else 0.0
        factor = 0.9*error**-0.125 if error > 0 else 10.0
        if error < 1:
            t += h
            {accept}
            h *= min(1.0 if refused else 10.0, factor)
            refused = False
        else:
            h *= max(0.2, factor)
            refused = True
"""

LOOPS = """
def solve(start, end, tolerance):
    n = start.size
    y, z, K = start.copy(), np.empty(n), np.empty((13, n))
    t, h, refused = 0.0, 0.01, False
    field(y, K[0])
    while t < end:
        h = min(h, end - t)
        for s in range(1, 13):
            for i in range(n):
                slope = 0.0
                for j in range(s):
                    slope += A[s, j]*K[j, i]
                z[i] = y[i] + h*slope
            field(z, K[s])
        five = three = 0.0
        for i in range(n):
            a = b = 0.0
            for j in range(13):
                a += E5[j]*K[j, i]
                b += E3[j]*K[j, i]
            scale = tolerance*(1 + max(abs(y[i]), abs(z[i])))
            five += (a/scale)**2
            three += (b/scale)**2
""" + CONTROL.format(accept="y[:], K[0] = z, K[12]") + "    return y\n"


def tableau() -> dict[str, np.ndarray]:
    from scipy.integrate._ivp import dop853_coefficients as known

    # The weights are the last row, because the slope at the end begins the next step.
    return {"A": np.vstack([known.A[:12, :12], known.B]), "E3": known.E3, "E5": known.E5}


def by_loops(names: list[str], rates: list[str], helpers: list[str]) -> Solve:
    import numba

    point = [f"{name} = state[{i}]" for i, name in enumerate(names)]
    lines = point + helpers + [f"slope[{i}] = {rate}" for i, rate in enumerate(rates)]
    known: dict[str, Any] = {"math": math, "np": np, **tableau()}
    exec("def field(state, slope):\n    " + "\n    ".join(lines) + LOOPS, known)
    known["field"] = numba.njit(fastmath=True)(known["field"])
    return numba.njit(fastmath=True)(known["solve"])


def written_out(names: list[str], rates: list[str], helpers: list[str]) -> Solve:
    import numba

    table, count = tableau(), len(names)

    def combined(weights: np.ndarray, i: int) -> str:
        return " + ".join(f"{float(weight)!r}*k{j}_{i}" for j, weight in enumerate(weights) if weight)

    def slopes(stage: int, at: list[str]) -> list[str]:
        point = [f"{name} = {value}" for name, value in zip(names, at)]
        return point + helpers + [f"k{stage}_{i} = {rate}" for i, rate in enumerate(rates)]

    ys = [f"y{i}" for i in range(count)]
    before = [f"n, {', '.join(ys)} = {count}, " + ", ".join(f"start[{i}]" for i in range(count)), *slopes(0, ys)]
    step = []
    for s in range(1, 13):
        step += slopes(s, [f"y{i} + h*({combined(table['A'][s], i)})" for i in range(count)])
    # The names of states now hold the end of the step.
    step.append("five = three = 0.0")
    for i, name in enumerate(names):
        step += [f"scale = tolerance*(1 + max(abs(y{i}), abs({name})))", f"five += (({combined(table['E5'], i)})/scale)**2",
                 f"three += (({combined(table['E3'], i)})/scale)**2"]
    accept = "; ".join([f"y{i} = {name}" for i, name in enumerate(names)] + [f"k0_{i} = k12_{i}" for i in range(count)])
    text = ("def solve(start, end, tolerance):\n    " + "\n    ".join(before) + "\n    t, h, refused = 0.0, 0.01, False\n    while t < end:\n"
            "        h = min(h, end - t)\n        " + "\n        ".join(step) + CONTROL.format(accept=accept)
            + f"    return np.array([{', '.join(ys)}])\n")
    known: dict[str, Any] = {"math": math, "np": np}
    exec(text, known)
    return numba.njit(fastmath=True)(known["solve"])
