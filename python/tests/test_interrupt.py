"""Checks that Ctrl-C ends every kind of long work."""

import signal
import subprocess
import sys

import pytest

RING = "for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }"
HARD = "xdot = y*z + x*w; ydot = x*z - w^2; zdot = x*y + w*y; wdot = x^2 - y*z + z^2;"

# Each call takes minutes or more; the list has every kind of long work.
LONG = [
    "s.orbit([1, 2, 3], 0.01, 10**12, every=10**12)",
    "s.orbit([1, 2, 3], 0.01, 10**12, every=10**12, compensated=True)",
    *(f"s.orbit([1, 2, 3], 0.01, 10**12, every=10**11, {how})" for how in ["scalar='dd'", "method='flow'", "projective=True"]),
    # The next calls compute gradients of an orbit with distant rows, and of a long orbit.
    "o = s.orbit([1, 2, 3], 0.01, 10, every=10); o.every = 10**11; o.gradient(o.x)",
    "o = s.orbit([1, 2, 3], 0.01, 2*10**8, every=10**8); o.gradient(o.x)",
    # Each step with long exact numbers takes seconds.
    "lorenz.orbit([1, 2, 3], '1/70', 30, scalar='exact')",
    "lorenz.heights([1, 2, 3], '1/70', 30, digits=10**9, seconds=1000)",
    "while True: s.step(many, 0.01)",
    "while True: s.try_step(many, 0.01)",
    "s.ensemble(many, 0.001, 10**9)",
    "s.ensemble(many, 0.001, 10**6, every=10**5)",
    "s.ensemble(many[:1000], 0.001, 10**5, every=10, columns=['x'], transient=10**8)",
    "s.orbit([1, 2, 3], 0.01, 10, transient=10**12)",
    *(
        f"s.ensemble(many, 0.001, 10**6, observe=['{of}'])"
        for of in ["drift", "extrema", "lyapunov", "spectrum", "log_det", "fli", "megno", "sali", "rotation", "escape"]
    ),
    "s.observe([1, 2, 3], 0.01, 10**11)",
    "s.section([1, 2, 3], 0.01, 10**11, 'x + 100')",
    "s.chart({'x': (0, 1, 100), 'y': (0, 1, 100)}, [1, 2, 3], 0.01, steps=10**9)",
    "kahan.System('xdot = a - x^2;').periodic([1], 0.1, over={'a': (1, -1, 100_000)})",
    f"kahan.System('{HARD}').discover(seconds=1000)",
    f"kahan.System('{HARD}').scan({{'eps': (1, 2, 1000)}}, seconds=1000)",
    f"kahan.System('{HARD}').poles(steps=100, seconds=1000)",
    "lorenz.trade([1, 2, 3], 3000, seconds=1000)",
    "s.extremes(trials=10**9)",
    "while True: s.verify()",
    "while True: relation.solve(np.random.default_rng(1).random((300_000, 4, 2)))",
    f"kahan.Lattice('{RING}', 1000, 0.01).advance(np.ones(1000), 10**9)",
    f"kahan.Lattice('{RING}', 1000, 0.01).orbit(np.ones(1000), 10**9, every=10**6)",
    # Each call of `System` proves the claim in its text.
    f"while True: kahan.System('{RING} integral S = sum(x[i]);', sites=3)",
]

BEGIN = """
import kahan, numpy as np
s, lorenz = kahan.catalog.e6, kahan.catalog.lorenz(s=10, r=28, b='8/3')
many = np.ones((300_000, 3)) * 0.1
# x, y and 1 on lines.
relation = kahan._kahan.Relation([[1, 0], [0, 1], [0, 0]], [[(0, 1)], [(1, 1)], [(2, 1)]], 2, [0, 1], None)
s.orbit([1, 2, 3], 0.1, 10)
print('begun', flush=True)
"""


@pytest.mark.parametrize("work", LONG)
def test_long_work_ends(work):
    code = f"{BEGIN}\n{work}\nprint('ended')"
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n", process.stderr.read()
    # The work must still run after one second.
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(timeout=1)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=60)
    assert "KeyboardInterrupt" in errors and "ended" not in out
