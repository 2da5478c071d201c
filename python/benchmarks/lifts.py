#!/usr/bin/env python3
"""`kahan lift` beside QBee, and orbits of lifted fields of order 8 beside a DOP853 in Numba.

    QBEE_PYTHON=qbee/bin/python python benchmarks/lifts.py

QBee 0.8.2 needs a NumPy before 2, so it runs by an interpreter of its own, which QBEE_PYTHON names.
"""

import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
SYSTEMS = ROOT / "benches/lifts/systems.tsv"
ROUNDS, PATIENCE, TURNS = 5, 35, 200


def systems() -> list[list[str]]:
    """Name, equations, parameters, start, time, energy and kind of each system."""
    return [line.split("\t") for line in SYSTEMS.read_text().splitlines()[1:]]


def qbee(name: str) -> None:
    """The time of QBee on one system, without its imports, and how many variables it introduces."""
    import sympy
    from qbee import functions, parameters, polynomialize_and_quadratize

    text, known = next((row[1], row[2]) for row in systems() if row[0] == name)
    sides = [side.split("'", 1) for side in text.split(";")]
    sides = [(state.strip(), right.split("=", 1)[1].replace("^", "**")) for state, right in sides]
    named = [word.split("=")[0] for word in known.split()]
    if re.search(r"\bt\b", text):
        sides.append(("t", "1"))
    states = functions(", ".join(state for state, _ in sides))
    states = states if isinstance(states, (list, tuple)) else [states]
    values = parameters(", ".join(named)) if named else []
    values = values if isinstance(values, (list, tuple)) else [values]
    names = dict(zip([state for state, _ in sides] + named, [*states, *values]))
    equations = [(names[state], sympy.sympify(right, locals=names)) for state, right in sides]
    begun = time.process_time()
    found = polynomialize_and_quadratize(equations)
    seconds = time.process_time() - begun
    order = len(found.equations) - len(sides) if found else None
    print(json.dumps({"seconds": seconds, "order": order}))


def by_qbee(python: str, name: str) -> dict[str, float] | str:
    """QBee's time and order, or why there are none."""
    try:
        done = subprocess.run([python, __file__, "qbee", name], capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return f"none in {PATIENCE} s"
    # QBee prints its progress before the answer.
    return json.loads("{" + done.stdout.rpartition("{")[2]) if done.returncode == 0 else "error"


def spent() -> float:
    """The processor time of all processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def by_kahan(command: str, row: list[str], *options: str) -> tuple[float, int]:
    """The time of the whole command, and how many variables it introduces."""
    begun = spent()
    done = subprocess.run([command, "lift", "--field", row[1], "--json", *options], check=True, capture_output=True, text=True)
    return spent() - begun, json.loads(done.stdout)["order"]


def lifting(limit: Callable[..., None], skipped: Callable[[str, str], None]) -> str:
    """`kahan lift` on the systems of `benches/lifts/systems.tsv`: its time, and beside QBee's. Returns a table."""
    command = shutil.which("kahan") or str(ROOT / "target/release/kahan")
    python = os.environ.get("QBEE_PYTHON")
    if not Path(command).exists():
        skipped("`kahan lift`", "no command `kahan`")
        return ""
    rows, lines, times, ratios, above = systems(), [], [], [], []
    for row in rows:
        smallest = [by_kahan(command, row, "--lift=smallest") for _ in range(ROUNDS)]
        known = [word for value in row[2].split() for word in ("--param", value)]
        default = [by_kahan(command, row, "--at", ",".join(row[3].split()), *known) for _ in range(ROUNDS)]
        theirs = by_qbee(python, row[0]) if python else "skipped"
        # Repeats the runs after QBee, so that both are timed under equal conditions.
        smallest += [by_kahan(command, row, "--lift=smallest") for _ in range(ROUNDS)]
        order, (own, slow) = smallest[0][1], (min(one[0] for one in runs) for runs in (smallest, default))
        if "extra" not in row[-1]:
            times.append((own, slow))
        cells = [theirs, "–", "–"]
        if isinstance(theirs, dict):
            ratios.append(own / theirs["seconds"])
            above += [row[0]] if order > theirs["order"] else []
            cells = [f"{1e3 * theirs['seconds']:.0f} ms", str(theirs["order"]), f"{ratios[-1]:.2g}"]
        lines.append(f"| {row[0]} | {order} | {1e3 * own:.0f} ms | {default[0][1]} | {1e3 * slow:.0f} ms | {' | '.join(cells)} |")
    for name, column in (("--lift=smallest", 0), ("default", 1)):
        ranked = sorted(one[column] for one in times)
        limit(f"`kahan lift`, {name}: the 25th of 30 systems by time", 0.1, [ranked[24]], " s")
        limit(f"`kahan lift`, {name}: the slowest of 30 systems", 1.0, [ranked[29]], " s")
    if ratios:
        limit("`kahan lift --lift=smallest` / QBee, the largest of all ratios", 1.0, [max(ratios)])
        limit("systems in which its order is above QBee's", 0, [len(above)])
    else:
        skipped("`kahan lift --lift=smallest` / QBee", "QBEE_PYTHON names no interpreter with QBee")
    return "\n".join([
        "\n## Lifts\n",
        "Processor time of the whole command `kahan lift`, the least of some runs: with `--lift=smallest`, and as it is with a",
        f"start, from which an orbit is followed. Beside QBee without its imports, which has no more than {PATIENCE} s.\n",
        "| system | smallest | time | default | time | QBee | new variables | smallest / QBee |",
        "|---|---:|---:|---:|---:|---:|---:|---:|", *lines])


# The names of states, the rates by hand, their common subexpressions, the text, and a start.
RACES: dict[str, tuple[str, list[str], list[str], str, list[float]]] = {
    "quartic oscillator": ("x p", ["p", "-x*x*x"], [], "x' = p; p' = -x^3", [1, 0]),
    "pendulum": ("x p", ["p", "-math.sin(x)"], [], "x' = p; p' = -sin(x)", [1, 0]),
    "Toda chain of 3": (
        "x y z p q s", ["p", "q", "s", "c - a", "a - b", "b - c"],
        ["a = math.exp(x - y)", "b = math.exp(y - z)", "c = math.exp(z - x)"],
        "x' = p; y' = q; z' = s; p' = exp(z - x) - exp(x - y); q' = exp(x - y) - exp(y - z); s' = exp(y - z) - exp(z - x)",
        [0.5, 0, -0.3, 0.2, -0.4, 0.2]),
    "Kepler": (
        "x y p q", ["p", "q", "-x*c", "-y*c"], ["r = x*x + y*y", "c = 1/(r*math.sqrt(r))"],
        "x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2 + y^2)^(3/2)", [1, 0, 0, 1.1]),
}
TIME, ERROR = 100.0, 1e-9


def least(works: list[Callable[[], object]]) -> list[float]:
    """The least time of each work; all take turns."""
    times = [float("inf")] * len(works)
    for _ in range(TURNS):
        for place, work in enumerate(works):
            begun = time.perf_counter()
            work()
            times[place] = min(times[place], time.perf_counter() - begun)
    return times


def racing(limit: Callable[..., None], skipped: Callable[[str, str], None]) -> str:
    """Order 8 beside DOP853 in Numba, each with the largest step or tolerance that reaches the error. Returns a table."""
    # These modules are missing in QBee's interpreter, so they are not imported at the top.
    import numpy as np

    import kahan
    from dop853 import by_loops, written_out
    from peers import is_here

    if not is_here("numba") or not is_here("scipy"):
        skipped("lifted, order 8 / DOP853 in Numba", "Numba and SciPy are not both installed")
        return ""
    lines = []
    for name, (states, rates, helpers, text, start) in RACES.items():
        first = np.array(start, float)
        solvers = [make(states.split(), rates, helpers) for make in (by_loops, written_out)]
        reference = solvers[0](first, TIME, 1e-14)

        def far(end: Any) -> float:
            return float(np.abs(end - reference).max() / np.abs(reference).max())

        assert far(solvers[1](first, TIME, 3e-14)) < ERROR / 20, "the reference is right"
        tolerance = 1e-6
        while far(solvers[0](first, TIME, tolerance)) > ERROR:
            tolerance *= 0.9
        ratios = {}
        for which in ("smallest", "automatic"):
            s = kahan.System(text, lift=True if which == "automatic" else which, at=start)
            steps = 60

            def orbit(count: int) -> Any:
                return s.orbit(start, TIME / (2 * steps), count, every=count, order=8).x[-1]

            while far(orbit(steps)) > ERROR:
                steps = int(1.03 * steps) + 1
            peers = [lambda solve=solve: solve(first, TIME, tolerance) for solve in solvers]
            whole, call, *theirs = least([lambda: orbit(steps), lambda: orbit(1), *peers])
            ratios[which] = [(whole - call) / one for one in theirs]
        limit(f"lifted {name}, order 8 / DOP853 in Numba by loops, at {ERROR:.0e}", 0.9, [min(one[0] for one in ratios.values())])
        cells = " | ".join(f"{ratio:.2f}" for which in ("smallest", "automatic") for ratio in ratios[which])
        lines.append(f"| {name} | {cells} |")
    return "\n".join([
        "\n## Lifted orbits of order 8\n",
        f"To the time {TIME:g} with an error of {ERROR:.0e} at the end, as a ratio to DOP853 in Numba; above 1, kahan is slower. A call with",
        "one step is taken off ours.\n",
        "| system | smallest / by loops | smallest / written out | default / by loops | default / written out |",
        "|---|---:|---:|---:|---:|", *lines])


if __name__ == "__main__":
    if sys.argv[1:2] == ["qbee"]:
        qbee(sys.argv[2])
    else:
        from run import limit, skipped

        print(lifting(limit, skipped), racing(limit, skipped), sep="\n")
