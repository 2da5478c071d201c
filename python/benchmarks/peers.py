"""Other packages at the same work: Lorenz' exponents over a grid, and one trajectory at equal error."""

import importlib.util
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import kahan

Solve = Callable[[], np.ndarray]
SIDE, GRIDS, SOLVES = 100, 5, 9


def is_here(package: str) -> bool:
    return importlib.util.find_spec(package) is not None


def beside(theirs: float, ours: float) -> str:
    """Their time over ours, in bold where they are faster."""
    ratio = theirs / ours
    return f"{ratio:.2g}" if ratio >= 1 else f"**{ratio:.2g}**"


def lorenz_grid(limit: Callable[..., None]) -> None:
    """Each package from the start of its process to its end, and its second run, where all is compiled."""

    def run(package: str, side: int) -> tuple[float, float, float]:
        begun = time.perf_counter()
        done = subprocess.run([sys.executable, Path(__file__).with_name("grids.py"), package, str(side)],
                              check=True, capture_output=True, text=True)
        whole = time.perf_counter() - begun
        mean, again = map(float, done.stdout.split())
        # A smaller grid may stand for the whole grid. The start and the compilation are added.
        cells = (SIDE / side) ** 2
        return mean, whole - 2 * again + cells * again, cells * again

    asked = {"kahan": SIDE, "numba": SIDE, "pynamicalsys": 5}
    here = [package for package in asked if is_here(package)]
    rounds = [{package: run(package, asked[package]) for package in here if package != "pynamicalsys" or first}
              for first in [True] + (GRIDS - 1) * [False]]
    limit("100 × 100 largest exponents of Lorenz' system, import included", 2.0, [one["kahan"][1] for one in rounds], " s")
    print("\n## Largest exponents\n\nOver 100 × 100 values of r and s, 10 000 steps of 0.01 each, on two threads. Ratios below 1, in bold: "
          "kahan is slower.\n")
    print("| package | import, compile and run, s | / kahan | run again, s | / kahan | mean exponent |\n|---|---:|---:|---:|---:|---:|")
    method = {"kahan": "", "numba": ", Kahan's map by hand", "pynamicalsys": ", RK4, one thread; from 5 × 5 cells"}
    medians = {package: [statistics.median(column) for column in zip(*(one[package] for one in rounds if package in one))]
               for package in here}
    for package in asked:
        if package not in here:
            print(f"| {package} | skipped: not installed | | | | |")
            continue
        (mean, whole, again), (_, own_whole, own_again) = medians[package], medians["kahan"]
        print(f"| {package}{method[package]} | {whole:.2f} | {beside(whole, own_whole)} | {again:.2f} | {beside(again, own_again)} "
              f"| {mean:.3f} |", flush=True)


# The rates of x, y and z in a common notation, a first point, and the time.
SCENES = {
    "Lotka and Volterra to t = 1000": (["x*(1.0 - y)", "y*(x - 1.0)"], [0.5, 1.25], 1000),
    "Lorenz to t = 10": (["10.0*(y - x)", "x*(28.0 - z) - y", "x*y - 8.0/3.0*z"], [1.0, 1.0, 20.0], 10),
    "E6 to t = 100": (["y*(2.0*z - x)", "x*x - z*z", "y*(z - 2.0*x)"], [0.3, 0.8, 0.5], 100),
}
TOLERANCES = [10.0**-k for k in range(3, 16)]


def system(rates: list[str]) -> kahan.System:
    return kahan.System(" ".join(f"{name}dot = {rate};" for name, rate in zip("xyz", rates)))


def function(rates: list[str]) -> Any:
    return eval(f"lambda {', '.join('xyz'[: len(rates)])}: ({', '.join(rates)})")


def settings_of_kahan(rates: list[str], start: list[float], horizon: int, order: int) -> Iterator[Solve]:
    """Orbits of an order with more and more steps, of which the last point is asked for."""
    s, steps = system(rates), 4.0 * horizon
    while steps < 3e7:
        count = int(steps)
        yield lambda count=count: s.orbit(start, horizon / (2 * count), count, every=count, order=order).x[-1]
        steps *= 1.15


def settings_of_scipy(rates: list[str], start: list[float], horizon: int) -> Iterator[Solve]:
    from scipy.integrate import solve_ivp

    f = function(rates)
    for tolerance in TOLERANCES:
        yield lambda tolerance=tolerance: solve_ivp(
            lambda t, x: f(*x), (0, horizon), start, method="DOP853", rtol=max(tolerance, 3e-14), atol=tolerance).y[:, -1]


def settings_of_heyoka(rates: list[str], start: list[float], horizon: int) -> Iterator[Solve]:
    import heyoka

    variables = heyoka.make_vars(*"xyz"[: len(rates)])
    equations = list(zip(variables, function(rates)(*variables)))

    def solve(integrator: Any) -> np.ndarray:
        integrator.time = 0.0
        integrator.state[:] = start
        integrator.propagate_until(float(horizon))
        return integrator.state.copy()

    for tolerance in TOLERANCES:
        integrator = heyoka.taylor_adaptive(equations, start, tol=tolerance)
        yield lambda integrator=integrator: solve(integrator)


def settings_of_pydiffsol(rates: list[str], start: list[float], horizon: int) -> Iterator[Solve]:
    import pydiffsol

    state = ", ".join(f"{name} = {value}" for name, value in zip("xyz", start))
    for tolerance in TOLERANCES:
        ode = pydiffsol.Ode(f"u_i {{ {state} }} F_i {{ {', '.join(rates)} }}", ode_solver=pydiffsol.tsit45)
        ode.rtol = ode.atol = tolerance
        yield lambda ode=ode: ode.solve_dense(np.array([]), np.array([float(horizon)])).ys[:, -1]


def cheapest(settings: Iterator[Solve], wanted: np.ndarray, error: float) -> Solve | None:
    """The first setting whose end is near enough."""
    for solve in settings:
        try:
            if np.abs(solve() - wanted).max() <= error * np.abs(wanted).max():
                return solve
        except Exception as refused:  # The package refuses this tolerance.
            print(f"refused: {refused}", file=sys.stderr)
    return None


def timed(solve: Solve) -> float:
    """The least time of the runs that fit into some hundredths of a second: what disturbs one of many is none of its cost."""
    times: list[float] = []
    while sum(times) < 0.02:
        begun = time.perf_counter()
        solve()
        times.append(time.perf_counter() - begun)
    return min(times)


def scenes() -> None:
    """One trajectory at equal error at its end, each package with the largest step or tolerance that reaches it."""
    print("\n## One trajectory at equal error\n\nWall time of the cheapest setting whose end is so near the flow's, relative to the "
          "point's size; the flow is certified, in 32\ndigits. What is made and compiled before is in no time. Behind each time its "
          "ratio to kahan's; below 1, in bold: kahan is slower.\n")
    print("| scene | error | kahan | DOP853 of scipy | heyoka | pydiffsol, tsit45 |\n|---|---:|---:|---:|---:|---:|")
    peers = {"scipy": settings_of_scipy, "heyoka": settings_of_heyoka, "pydiffsol": settings_of_pydiffsol}
    for scene, (rates, start, horizon) in SCENES.items():
        count = 16 * horizon
        flow = system(rates).orbit(start, f"{horizon}/{2 * count}", count, every=count, scalar="dd", method="flow")
        for error in (1e-6, 1e-9):
            found = {order: cheapest(settings_of_kahan(rates, start, horizon, order), flow.x[-1], error) for order in (2, 4, 6, 8)}
            order, own = min(((order, one) for order, one in found.items() if one),
                             key=lambda pair: timed(pair[1]))
            cells, ours = [], []
            for package, settings in peers.items():
                one = cheapest(settings(rates, start, horizon), flow.x[-1], error) if is_here(package) else None
                if one is None:
                    cells.append("not reached" if is_here(package) else "skipped: not installed")
                    continue
                pairs = [(timed(own), timed(one)) for _ in range(SOLVES)]
                our, their = (statistics.median(times) for times in zip(*pairs))
                ours.append(our)
                cells.append(f"{1e3 * their:.3g} ms, {beside(their, our)}")
            our = 1e3 * statistics.median(ours or [timed(own)])
            print(f"| {scene} | {error:.0e} | {our:.3g} ms, order {order} | {' | '.join(cells)} |", flush=True)
