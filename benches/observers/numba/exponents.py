#!/usr/bin/env python3
"""Largest Lyapunov exponents and a stability map, beside loops of Numba and NumPy.

    python3 -m venv venv && venv/bin/pip install -r benches/observers/numba/requirements.txt
    cargo build --release --manifest-path benches/Cargo.toml -p kahan-bench-observers
    venv/bin/python benches/observers/numba/exponents.py

Prints two tables in Markdown, after it has checked that both sides compute the same. All take turns; a ratio is the median of
the rounds' ratios, theirs over ours, so that above 1 we are faster. Times are the least of all rounds.

Their loops are those of `steps.py`, compiled by Numba for this processor with `fastmath`, which fuses and reorders as ours
never do, unless the row says otherwise. Tangent vectors are scaled every SCALED steps, as a logarithm or a root at each step
would cost more than the step; ours look at their length at every step. The stability map runs on two threads on both sides,
and its times are processor seconds of both, as a wall clock would tell what else the machine does. "In the inner loop" are
LANES cells whose steps are inlined into it, without which Numba's compiler makes no vectors of them. NumPy steps CHUNK cells
at a time, so that its arrays stay in the cache, the chunks on two threads. What Numba takes to compile a loop when it is
called first is in no time of a loop; ours are compiled with the program.
"""

import os
import statistics
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

os.environ["NUMBA_NUM_THREADS"] = "2"

import numba
import numpy as np

from steps import e6, lorenz, steps_in_space, steps_of_cells

ROOT = Path(__file__).resolve().parents[3]
ORBIT_STEPS, MAP_STEPS = 20_000_000, 1000
ORBIT_ROUNDS, MAP_ROUNDS = 7, 3
SCALED, LANES, CHUNK = 32, 16, 4096
SIDE, MAP_EPS = 512, 0.05
# As ours begin, so that both sides report the same number.
V, W = (12 / 64, 49 / 64, 22 / 64, 59 / 64), (35 / 64, 31 / 64, 27 / 64, 23 / 64)


def fast(function):
    return numba.njit(function, fastmath=True, error_model="numpy", inline="always")


def plain(function):
    return numba.njit(function, error_model="numpy", inline="always")


def exponent(jit, step):
    """The largest exponent per unit of time."""

    @jit
    def square(s):
        return s[3] * s[3] + s[4] * s[4] + s[5] * s[5]

    @jit
    def loop(x, y, z, eps, steps):
        s = (x, y, z, V[0], V[1], V[2])
        growth = -np.log(square(s))
        done = 0
        while done < steps:
            some = min(SCALED, steps - done)
            for _ in range(some):
                s = step(s, eps)
            done += some
            growth += np.log(square(s))
            scale = 1 / np.sqrt(square(s))
            s = (s[0], s[1], s[2], scale * s[3], scale * s[4], scale * s[5])
        return growth / (4 * eps * steps)

    return loop


def cell_by_cell(step, scaled, sali):
    @numba.njit(fastmath=True, error_model="numpy", parallel=True)
    def loop(starts, steps):
        index = np.empty(starts.shape[1])
        for i in numba.prange(starts.shape[1]):
            s = (starts[0, i], starts[1, i], starts[2, i], starts[3, i]) + V + W
            for n in range(1, steps + 1):
                s = step(s, MAP_EPS)
                if n % SCALED == 0 or n == steps:
                    s = scaled(s)
            index[i] = sali(s)
        return index

    return loop


def side_by_side(step, scaled, sali):
    """The number of cells is a multiple of LANES."""

    @fast
    def read(s, k):
        return (s[0, k], s[1, k], s[2, k], s[3, k], s[4, k], s[5, k],
                s[6, k], s[7, k], s[8, k], s[9, k], s[10, k], s[11, k])

    @fast
    def write(s, k, t):
        s[0, k], s[1, k], s[2, k], s[3, k], s[4, k], s[5, k] = t[0], t[1], t[2], t[3], t[4], t[5]
        s[6, k], s[7, k], s[8, k], s[9, k], s[10, k], s[11, k] = t[6], t[7], t[8], t[9], t[10], t[11]

    @numba.njit(fastmath=True, error_model="numpy")
    def block(s, steps):
        for n in range(1, steps + 1):
            for k in range(LANES):
                write(s, k, step(read(s, k), MAP_EPS))
            if n % SCALED == 0 or n == steps:
                for k in range(LANES):
                    write(s, k, scaled(read(s, k)))

    @numba.njit(fastmath=True, error_model="numpy", parallel=True)
    def loop(starts, steps):
        index = np.empty(starts.shape[1])
        for i in numba.prange(starts.shape[1] // LANES):
            s = np.empty((12, LANES))
            for k in range(LANES):
                at = i * LANES + k
                write(s, k, (starts[0, at], starts[1, at], starts[2, at], starts[3, at]) + V + W)
            block(s, steps)
            for k in range(LANES):
                index[i * LANES + k] = sali(read(s, k))
        return index

    return loop


def in_chunks(step, scaled, sali):
    """By NumPy: its operations run without Python's lock, so the chunks may share two threads."""

    def chunk(starts, steps):
        ones = np.ones_like(starts[0])
        s = (*starts, *(entry * ones for entry in V + W))
        for n in range(1, steps + 1):
            s = step(s, MAP_EPS)
            if n % SCALED == 0 or n == steps:
                s = scaled(s)
        return sali(s)

    def loop(starts, steps):
        chunks = np.split(starts, range(CHUNK, starts.shape[1], CHUNK), axis=1)
        with ThreadPoolExecutor(2) as pool, np.errstate(all="ignore"):
            return np.concatenate(list(pool.map(lambda starts: chunk(starts, steps), chunks)))

    return loop


class Ours:
    """The process that computes the same when asked to."""

    def __init__(self):
        program = ROOT / "benches/target/release/exponents"
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, field, steps):
        """Seconds, and the exponent or the index of each cell."""
        self.process.stdin.write(f"{field} {steps}\n")
        self.process.stdin.flush()
        seconds, *values = map(float, self.process.stdout.readline().split())
        return seconds, np.array(values)

    def awake(self, field, steps):
        """Seconds after a run that woke the processor: this process has slept while the loops, all in one process, have not."""
        self.ask(field, steps)
        return self.ask(field, steps)[0]

    def processor_seconds(self, field, steps):
        before = self.processor_time()
        self.ask(field, steps)
        return self.processor_time() - before

    def processor_time(self):
        """What Linux has noted, in hundredths of a second."""
        stat = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(stat[11]) + int(stat[12])) / os.sysconf("SC_CLK_TCK")


def timed(body, clock=time.perf_counter):
    begun = clock()
    body()
    return clock() - begun


def race(ours, contenders, rounds, clock=time.perf_counter):
    """Least times of ours and theirs, and the median of each contender's ratio."""
    ours()
    [body() for body in contenders.values()]
    times = [(ours(), [timed(body, clock) for body in contenders.values()]) for _ in range(rounds)]
    own = min(own for own, _ in times)
    for k, name in enumerate(contenders):
        yield name, own, min(theirs[k] for _, theirs in times), statistics.median(theirs[k] / own for own, theirs in times)


def orbits(ours):
    print("| largest exponent of one orbit | ours, ns a step | theirs | theirs / ours | compiling, s |")
    print("|---|---:|---:|---:|---:|")
    for name, field, start, eps in (("E6", e6, (0.3, 0.8, 0.5), 1 / 64), ("Lorenz", lorenz, (1.0, 2.0, 20.0), 0.005)):
        kahan, runge_kutta = steps_in_space(fast, field)
        loops = {
            "Numba, Kahan's map": exponent(fast, kahan),
            "Numba without `fastmath`, Kahan's map": exponent(plain, steps_in_space(plain, field)[0]),
            "Numba, Runge and Kutta's method": exponent(fast, runge_kutta),
        }
        compiling = {title: timed(lambda: loop(*start, eps, 1)) for title, loop in loops.items()}
        # Ten units of time of Lorenz' system, in which what is rounded grows ten-thousandfold.
        _, (value,) = ours.ask(name.lower(), 1000)
        for title, loop in loops.items():
            if "Kahan" in title:
                assert abs(loop(*start, eps, 1000) - value) < 1e-10, title
        if name == "Lorenz":
            _, (value,) = ours.ask("lorenz", ORBIT_STEPS)
            for value in [value, *(loop(*start, eps, ORBIT_STEPS) for loop in loops.values())]:
                assert abs(value - 0.9056) < 5e-3, value
        bodies = {title: lambda loop=loop: loop(*start, eps, ORBIT_STEPS) for title, loop in loops.items()}
        for title, own, theirs, ratio in race(lambda: ours.awake(name.lower(), ORBIT_STEPS), bodies, ORBIT_ROUNDS):
            own, theirs = 1e9 * own / ORBIT_STEPS, 1e9 * theirs / ORBIT_STEPS
            print(f"| {name}: {title} | {own:.1f} | {theirs:.1f} | {ratio:.2f} | {compiling[title]:.1f} |", flush=True)


def maps(ours):
    kahan, runge_kutta, *rest = steps_of_cells(fast)
    numpy_kahan, _, *numpy_rest = steps_of_cells(lambda function: function)
    loops = {
        "Numba, a loop over cells": cell_by_cell(kahan, *rest),
        f"Numba, {LANES} cells in the inner loop": side_by_side(kahan, *rest),
        "Numba, a loop over cells, Runge and Kutta's method": cell_by_cell(runge_kutta, *rest),
        "NumPy": in_chunks(numpy_kahan, *numpy_rest),
    }
    axis = np.linspace(-0.4, 0.4, SIDE)
    y, q = (part.ravel() for part in np.meshgrid(axis, axis, indexing="ij"))
    starts = np.array([np.full_like(y, 0.1), y, np.full_like(y, 0.1), q])
    compiling = {title: timed(lambda: loop(starts[:, :LANES], 1)) for title, loop in loops.items() if title != "NumPy"}
    # Ten units of time, in which hardly anything has grown; then all of them, where what is chaotic is.
    _, soon = ours.ask("map", 100)
    _, late = ours.ask("map", MAP_STEPS)
    for title, loop in loops.items():
        if "Runge" not in title:
            assert np.max(np.abs(loop(starts, 100) - soon)) < 1e-12, title
        share = [np.mean(index < 1e-4) for index in (loop(starts, MAP_STEPS), late)]
        assert abs(share[0] - share[1]) < 2e-3, (title, share)
    print(f"\n| SALI of {SIDE} × {SIDE} cells, {MAP_STEPS} steps | ours, processor s | theirs | theirs / ours | compiling, s |")
    print("|---|---:|---:|---:|---:|")
    bodies = {title: lambda loop=loop: loop(starts, MAP_STEPS) for title, loop in loops.items()}
    for title, own, theirs, ratio in race(lambda: ours.processor_seconds("map", MAP_STEPS), bodies, MAP_ROUNDS, time.process_time):
        print(f"| {title} | {own:.2f} | {theirs:.2f} | {ratio:.2f} | {compiling.get(title, 0):.1f} |", flush=True)


def main():
    ours = Ours()
    orbits(ours)
    maps(ours)
    print(f"\nNumba {numba.__version__}, NumPy {np.__version__}; load of the machine at the end: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
