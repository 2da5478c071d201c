#!/usr/bin/env python3
"""`kahan lift` beside QBee, and orbits of lifted fields of order 8 beside a DOP853 in Numba.

    QBEE_PYTHON=qbee/bin/python python benchmarks/lifts.py

QBee 0.8.2 needs a NumPy before 2, so it runs by an interpreter of its own, which QBEE_PYTHON names.
"""

import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SYSTEMS = ROOT / "benches/lifts/systems.tsv"
ROUNDS, PATIENCE = 5, 35


def systems() -> list[list[str]]:
    """Name, equations, parameters, start, time and kind of each system."""
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
    begun = time.perf_counter()
    found = polynomialize_and_quadratize(equations)
    seconds = time.perf_counter() - begun
    order = len(found.equations) - len(sides) if found else None
    print(json.dumps({"seconds": seconds, "order": order}))


def by_qbee(python: str, name: str) -> dict[str, float] | str:
    try:
        done = subprocess.run([python, __file__, "qbee", name], capture_output=True, text=True, timeout=PATIENCE + 10)
    except subprocess.TimeoutExpired:
        return f"none in {PATIENCE} s"
    return json.loads(done.stdout.splitlines()[-1]) if done.returncode == 0 else "error"


def by_kahan(command: str, row: list[str], *options: str) -> tuple[float, int]:
    """The time of the whole command, and how many variables it introduces."""
    _, text, known, start, _, _ = row
    given = [word for value in known.split() for word in ("--param", value)]
    begun = time.perf_counter()
    done = subprocess.run([command, "lift", "--field", text, "--at", ",".join(start.split()), *given, "--json", *options],
                          check=True, capture_output=True, text=True)
    return time.perf_counter() - begun, json.loads(done.stdout)["order"]


if __name__ == "__main__":
    if sys.argv[1:2] == ["qbee"]:
        qbee(sys.argv[2])
