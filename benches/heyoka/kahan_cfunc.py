#!/usr/bin/env python3
"""Kahan's map as heyoka's `cfunc`, which LLVM compiles at run time: how long that takes, and how fast a step then is.

    python3 -m venv venv && venv/bin/pip install -r benches/heyoka/requirements.txt
    cargo build --release
    venv/bin/python benches/heyoka/kahan_cfunc.py [--ours FILE]

Prints a table in Markdown. All is in f64, with the points and parameters of `benches/fields`. FILE is JSON with our side of it,
which stands in the second column: {"E6": {"compile": ns, "latency": ns, "throughput": ns, "throughput_fixed": ns}, ...}.

What is compared: the operations that `kahan show NAME --plan` lists, read from its output, so that both sides compute the same
straight line. What depends on eps and parameters alone is data on both sides (heyoka's `par`), prepared outside.

- compiling: from expressions to code that can be called, the caches of compiled code switched off; median of 10. heyoka makes
  code for one state and for a vector of them. Planning is in neither side; building the expressions is not, either.
- a step in a chain: a `cfunc` of LONG composed steps less one of SHORT, for one state, over the steps between them, so that
  Python's call drops out. The least of all rounds of each. heyoka sees all the steps at once, and may share work among them.
- a step of an ensemble: one call of `cfunc` over MANY states less one over FEW, by one thread, in the vectors that heyoka
  chooses. It reads its parameters anew for each state, which ours need not do; the last row has the constants as numbers in
  the code instead, so that another eps means to compile again.

What is not fair. heyoka contracts products and sums where it can, as our fused builds do and our default ones do not, and
simplifies expressions before: its bits are not ours. Its compiler is a general one, and slow because it can do more. A call of
`cfunc` from Python takes about a microsecond, which is left out, though whoever takes single steps pays it. What is shown is
what this machine gave in one run, on whatever else it had to do; its load stands below the table.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import heyoka as hy
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
EPS = 1e-3
SHORT, LONG = 32, 160
FEW, MANY = 64, 1024
COMPILED, ROUNDS, CALLS = 10, 301, 50


@dataclass
class System:
    """A field with the values it is run with, and the field itself, which steps are checked against."""

    title: str
    name: str
    parameters: dict
    start: dict
    field: callable


def e6(x, y, z):
    return [y * (2 * z - x), x**2 - z**2, y * (z - 2 * x)]


def top(x, y, z):
    return [1.1 * y * z, -2.3 * z * x, 1.7 * x * y]


def clebsch(k, l, m, p, q, r):
    w1, w2, w3 = 1.0, 1.7, 2.9
    return [
        (w3 - w2) * q * r, (w1 - w3) * r * p, (w2 - w1) * p * q,
        m * q - l * r, k * r - m * p, l * p - k * q,
    ]


SPACE = {"x": 1.3, "y": 0.7, "z": 0.4}
BODY = {"m1": 0.3, "m2": 0.7, "m3": 0.4, "p1": 0.8, "p2": 0.5, "p3": 0.6}
SYSTEMS = [
    System("E6", "e6", {}, SPACE, e6),
    System("EulerTop", "euler", {"a1": 1.1, "a2": -2.3, "a3": 1.7}, SPACE, top),
    System("Clebsch", "clebsch", {"w1": 1.0, "w2": 1.7, "w3": 2.9}, BODY, clebsch),
]


class Plan:
    """The straight line of a step, as `kahan show NAME --plan` prints it."""

    def __init__(self, kahan, name):
        text = subprocess.run([kahan, "show", name, "--plan"], check=True, capture_output=True, text=True).stdout
        self.constants = self.section(text, "constants of the step, computed once")
        self.kernel = self.section(text, "kernel of the step, for each state")
        self.next = self.section(text, "next state")

    @staticmethod
    def section(text, title):
        lines = text.split(f"\n{title}\n", 1)[1].split("\n\n", 1)[0].splitlines()
        pairs = (line.split(" = ", 1) for line in lines if " = " in line)
        return [(target.strip(), compile(source.strip(), target, "eval")) for target, source in pairs]

    def prepare(self, known):
        """The constants, by name."""
        values = dict(known)
        for target, source in self.constants:
            values[target] = eval(source, {}, values)
        return values

    def step(self, state, constants):
        """The next state, of numbers or of expressions."""
        values = {**constants, **state}
        for target, source in self.kernel:
            values[target] = eval(source, {}, values)
        return {target.removesuffix("~"): eval(source, {}, values) for target, source in self.next}


class Contender:
    """heyoka's side of one system."""

    def __init__(self, kahan, system):
        self.system = system
        self.plan = Plan(kahan, system.name)
        known = {"eps": EPS, **system.parameters}
        self.values = self.plan.prepare(known)
        self.start = np.array(list(system.start.values()))
        self.names = list(system.start)
        self.check()

    def check(self):
        """The plan is Kahan's: (x~ - x)/(2 eps) = 2 f((x + x~)/2) - (f(x) + f(x~))/2, which holds of quadratic fields."""
        image = self.plan.step(self.system.start, self.values)
        image = np.array([image[name] for name in self.names])
        f = lambda x: np.array(self.system.field(*x))
        right = 2 * f((self.start + image) / 2) - (f(self.start) + f(image)) / 2
        # One rounding of x~, and one of each side, seen through the division by 2 eps.
        bound = 8 * np.finfo(float).eps * np.abs(self.start).max() / (2 * EPS)
        error = np.abs((image - self.start) / (2 * EPS) - right).max()
        if not error <= bound:
            sys.exit(f"{self.system.title}: the plan is off by {error}, more than {bound}")
        self.image = image

    def expressions(self, steps, fixed=False):
        """So many steps as expressions of the state; constants are parameters, or numbers where `fixed`."""
        variables = list(hy.make_vars(*self.names))
        constants = self.values if fixed else {name: hy.par[k] for k, name in enumerate(self.values)}
        state = dict(zip(self.names, variables))
        for _ in range(steps):
            state = self.plan.step(state, constants)
        return [state[name] for name in self.names], variables

    def compiled(self, steps=1, fixed=False, **options):
        function, variables = self.expressions(steps, fixed)
        return hy.cfunc(function, vars=variables, **options)

    def compile_time(self):
        """Nanoseconds to compile one step."""
        function, variables = self.expressions(1)
        times = [timed(lambda: hy.cfunc(function, vars=variables)) for _ in range(1 + COMPILED)]
        # The first loads LLVM.
        return statistics.median(times[1:])

    def latency(self):
        """Nanoseconds of a step that waits for the one before: a chain of LONG steps less one of SHORT."""
        parameters = np.array(list(self.values.values()))

        def call(steps):
            chain = self.compiled(steps, batch_size=1)
            expected = self.system.start
            for _ in range(steps):
                expected = self.plan.step(expected, self.values)
            outputs = np.empty_like(self.start)
            chain(self.start, outputs=outputs, pars=parameters)
            np.testing.assert_allclose(outputs, list(expected.values()), rtol=1e-12)
            return lambda: chain(self.start, outputs=outputs, pars=parameters)

        return per_unit({steps: call(steps) for steps in (SHORT, LONG)})

    def throughput(self, fixed=False):
        """Nanoseconds of a step for each of many states: MANY columns less FEW, so that the call drops out."""
        step = self.compiled(1, fixed)

        def call(columns):
            inputs = repeated(self.start, columns)
            outputs = np.empty_like(inputs)
            given = {} if fixed else {"pars": repeated(np.array(list(self.values.values())), columns)}
            step(inputs, outputs=outputs, **given)
            np.testing.assert_allclose(outputs, repeated(self.image, columns), rtol=1e-14)
            return lambda: step(inputs, outputs=outputs, **given)

        return per_unit({columns: call(columns) for columns in (FEW, MANY)})


def repeated(values, columns):
    """A matrix whose columns are all alike."""
    return np.ascontiguousarray(np.repeat(values[:, None], columns, axis=1))


def per_unit(calls):
    """Nanoseconds by which two calls differ, over the difference of their sizes; each in its least time, in turns."""
    least = {size: float("inf") for size in calls}
    for _ in range(ROUNDS):
        for size, call in calls.items():
            spent = timed(lambda: [call() for _ in range(CALLS)]) / CALLS
            least[size] = min(least[size], spent)
    low, high = sorted(least)
    return (least[high] - least[low]) / (high - low)


def timed(body):
    start = time.perf_counter_ns()
    body()
    return time.perf_counter_ns() - start


def rows(contender):
    """What was measured, how it is called in the file of our side, and nanoseconds."""
    lanes = hy.recommended_simd_size()
    yield f"compiling one step, for one state and for {lanes}", "compile", contender.compile_time()
    yield "a step in a chain", "latency", contender.latency()
    yield f"a step of an ensemble, {lanes} lanes", "throughput", contender.throughput()
    yield f"the same, constants in the code, {lanes} lanes", "throughput_fixed", contender.throughput(fixed=True)


def readable(nanoseconds):
    if nanoseconds is None:
        return "–"
    for unit, size in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def processor():
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    return next(line.split(": ", 1)[1] for line in lines if line.startswith("model name"))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--kahan", type=Path, default=ROOT / "target/release/kahan", help="the command whose plans are taken")
    arguments.add_argument("--ours", type=Path, help="our side's times, as JSON")
    given = arguments.parse_args()
    ours = json.loads(given.ours.read_text()) if given.ours else {}
    # Nothing compiled before may be taken again, here or in an earlier run; and an ensemble is work for one processor.
    hy.llvm_state.set_diskcache_enabled(False)
    hy.llvm_state.set_memcache_limit(0)
    hy.llvm_state.clear_memcache()
    hy.set_nthreads(1)
    print("| system | what | ours | heyoka | ratio |")
    print("|---|---|---:|---:|---:|")
    for system in SYSTEMS:
        for what, key, heyoka in rows(Contender(given.kahan, system)):
            own = ours.get(system.title, {}).get(key)
            ratio = f"{own / heyoka:.3g}" if own else "–"
            print(f"| {system.title} | {what} | {readable(own)} | {readable(heyoka)} | {ratio} |", flush=True)
    load = os.getloadavg()[0]
    print(f"\nheyoka {hy.__version__}; {ROUNDS} rounds; {processor()}; load of the machine at the end: {load:.1f}")


if __name__ == "__main__":
    main()
