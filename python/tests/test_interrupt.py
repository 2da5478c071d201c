"""Ctrl-C ends long work."""

import signal
import subprocess
import sys
import time

import pytest

LONG = [
    "s.orbit([1, 2, 3], 0.01, 10**12, every=10**12)",
    "s.ensemble(np.ones((20000, 3)) * 0.1, 0.001, 10**9)",
    *(
        f"s.ensemble(np.ones((100_000, 3)) * 0.1, 0.001, 10**6, observe=['{of}'])"
        for of in ["rotation", "spectrum", "extrema", "sali", "escape"]
    ),
    "s.observe([1, 2, 3], 0.01, 10**11)",
    # Steps of these numbers take seconds each.
    "kahan.catalog.lorenz(s=10, r=28, b='8/3').orbit([1, 2, 3], '1/70', 30, scalar='exact')",
    "kahan.catalog.lorenz(s=10, r=28, b='8/3').heights([1, 2, 3], '1/70', 30, max_digits=10**9, seconds=1000)",
    "kahan.System('xdot = y*z + x*w; ydot = x*z - w^2; zdot = x*y + w*y; wdot = x^2 - y*z + z^2;').discover(seconds=1000)",
    "kahan.System('for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }', sites=3); "
    "kahan.Lattice('for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }', 1000, 0.01).advance(np.ones(1000), 10**9)",
]


@pytest.mark.parametrize("work", LONG)
def test_long_work_ends(work):
    code = f"import kahan, numpy as np\ns = kahan.catalog.e6\ns.orbit([1, 2, 3], 0.1, 10)\nprint('begun', flush=True)\n{work}\nprint('ended')"
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=30)
    assert "KeyboardInterrupt" in errors and "ended" not in out
