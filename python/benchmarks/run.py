#!/usr/bin/env python3
"""How fast the package is: against Rust, against its limits, and beside its peers.

    python benchmarks/run.py > benchmarks/RESULTS.md

What is compared takes turns in one run; figures are medians of the rounds. The exit status is 1
where a limit is not met. What is not installed here is left out, and said to be.
"""

import os
import platform
import statistics
import subprocess
import sys
import time
import timeit
from pathlib import Path

import numpy as np

import kahan
from dense import dense_fields, from_arrays
from fit import fitting
from lifts import lifting, racing
from models import MODELS, table
from peers import lorenz_grid, scenes
from sparse import sparse_fields

HERE = Path(__file__).resolve().parent
E6 = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);"
START, EPS = [0.3, 0.8, 0.5], 0.005
ROUNDS, TURNS = 9, 25
THREADS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1

# Exceeded limits, which make the exit status 1.
missed: list[str] = []


def limit(name: str, at_most: float, values: list[float], unit: str = "") -> None:
    """A row of the table of limits."""
    low, measured, high = statistics.quantiles(values, n=4) if len(values) > 1 else values * 3
    if measured > at_most:
        missed.append(f"{name}: {measured:.3g}{unit}, at most {at_most:g}{unit}")
    verdict = "holds" if measured <= at_most else "**does not hold**"
    print(f"| {name} | {at_most:g}{unit} | {measured:.3g}{unit} [{low:.3g}, {high:.3g}] | {verdict} |", flush=True)


def skipped(name: str, why: str) -> None:
    print(f"| {name} | | skipped: {why} | |", flush=True)


def against_rust(s: kahan.System) -> None:
    """Ratios of the same work from Python and in Rust, which the program `beside` does when it is asked."""
    names = ["1e7 steps of E6, each stored, / Rust", "1e7 steps of E6, the last stored, / Rust", "1e5 trajectories of 1000 steps / Rust"]
    try:
        manifest = str(HERE / "Cargo.toml")
        subprocess.run(["cargo", "build", "--quiet", "--release", "--locked", "--manifest-path", manifest], check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        for name in names:
            skipped(name, f"the program in Rust could not be built ({error})")
        return
    beside = subprocess.Popen([HERE.parent / "target/release/beside"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    steps, starts = 10**7, np.tile(START, (100_000, 1))
    works = [
        (1.3, f"each {steps}", lambda: s.orbit(START, EPS, steps)),
        (1.1, f"last {steps}", lambda: s.orbit(START, EPS, steps, every=steps)),
        (1.1, f"ensemble {len(starts)} 1000 {THREADS}", lambda: s.ensemble(starts, EPS, 1000, threads=THREADS)),
    ]
    for name, (at_most, task, work) in zip(names, works):
        ratios = []
        for _ in range(TURNS + 1):
            beside.stdin.write(task + "\n")
            beside.stdin.flush()
            theirs, last = map(float, beside.stdout.readline().split())
            begun = time.perf_counter()
            found = work()
            ratios.append((time.perf_counter() - begun) / theirs)
            assert found.x[-1, -1] == last, "Python and Rust compute the same"
            del found
        # The first round compiles machine code, so its time is left out.
        limit(name, at_most, ratios[1:])
    beside.stdin.close()
    beside.wait()


def calls(s: kahan.System) -> None:
    x = np.array(START)
    names = {"step": s.step, "x": x, "eps": EPS, "out": np.empty(3)}
    for name, at_most, call in (("a call of step into out", 1.0, "step(x, eps, out=out)"), ("a call of step", 1.5, "step(x, eps)")):
        times = timeit.repeat(call, globals=names, repeat=ROUNDS, number=100_000)
        limit(name, at_most, [10 * seconds for seconds in times], " µs")


def start_up() -> None:
    """What a program waits for before it can begin, each time in a new process."""
    code = (
        "import time, numpy; begun = time.perf_counter(); import kahan; there = time.perf_counter(); "
        f"kahan.System({E6!r}); print(there - begun, time.perf_counter() - there)"
    )
    runs = [subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True) for _ in range(ROUNDS)]
    imports, systems = zip(*([1e3 * float(word) for word in run.stdout.split()] for run in runs))
    limit("import kahan, beyond NumPy", 50, list(imports), " ms")
    limit("kahan.System of E6", 10, list(systems), " ms")
    wheels = sorted((HERE.parent / "target").glob("**/kahan-*.whl"), key=lambda wheel: wheel.stat().st_mtime)
    if wheels:
        limit("the wheel", 12, [wheels[-1].stat().st_size / 1e6], " MB")
    else:
        skipped("the wheel", "none in target/; `./check` and `maturin build` make it")


def machine() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        processor = next(line.partition(": ")[2] for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        processor = platform.processor() or platform.machine()
    return (
        f"{processor}, {THREADS} processors to use; {platform.system()}, Python {platform.python_version()}, NumPy {np.__version__}; "
        f"load when this began: {os.getloadavg()[0]:.1f}"
    )


def main() -> None:
    print(f"# Results\n\nWritten by `run.py`, which README.md explains, on {machine()}.\n")
    print("## Limits\n\n| figure | at most | median [quartiles] | verdict |\n|---|---:|---:|---|")
    s = kahan.System(E6)
    against_rust(s)
    calls(s)
    start_up()
    dense_fields(limit, skipped)
    from_arrays(limit)
    sparse_fields(limit, skipped)
    fitting(limit, skipped)
    lifts = lifting(limit, skipped) + racing(limit, skipped)
    lorenz_grid(limit)
    scenes()
    print(lifts)
    if python := os.environ.get("ROADRUNNER_PYTHON"):
        print("\n## Models in files, beside libroadrunner\n")
        table(MODELS, python)
    for line in missed:
        print(f"limit not met: {line}", file=sys.stderr)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
