"""Compares Python's numbers with the command's, bit for bit; the command prints floats exactly."""

import csv
import io
import subprocess
import sys

import numpy as np
import pytest

import kahan

START = [1.0, 2.0, 3.0]


def command(*arguments):
    done = subprocess.run([sys.executable, "-m", "kahan_command", *arguments], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return list(csv.reader(io.StringIO(done.stdout)))


@pytest.mark.parametrize("order", [2, 4, 8])
@pytest.mark.parametrize("scalar", ["f64", "f32"])
def test_orbits_are_those_of_the_command(order, scalar):
    rows = command("orbit", "e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "1000", "--every", "7",
                   "--order", str(order), "--scalar", scalar)
    kind = np.float64 if scalar == "f64" else np.float32
    wanted = np.array([[kind(x) for x in row[2:5]] for row in rows[1:]], dtype=kind)
    orbit = kahan.catalog.e6.orbit(np.array(START, dtype=kind), 0.05, 1000, every=7, order=order)
    assert orbit.x.dtype == kind and np.array_equal(orbit.x, wanted)
    assert orbit.steps == 1000 and orbit.n[-1] == 994


def test_steps_are_those_of_the_orbit():
    s = kahan.catalog.e6
    orbit = s.orbit(START, 0.05, 100)
    x = np.array(START)
    for row in orbit.x[1:]:
        x = s.step(x, 0.05)
        assert np.array_equal(x, row)
    # `step` takes many points at once, and can write into a given array.
    out = np.empty((100, 3))
    assert s.step(orbit.x[:-1], 0.05, out=out) is out and np.array_equal(out, orbit.x[1:])


def test_an_ensemble_is_its_trajectories():
    s = kahan.System("xdot = a*y; ydot = x - x^2;")
    random = np.random.default_rng(7)
    points = random.uniform(0.1, 0.5, (3000, 2))
    eps, a = random.uniform(0.001, 0.01, 3000), random.uniform(0.5, 1.5, 3000)
    for threads in (1, 3, None):
        found = s.ensemble(points, eps, 50, params={"a": a}, threads=threads).x
        if threads == 1:
            first = found
        assert np.array_equal(found, first)
    for k in (0, 1023, 1024, 2999):
        assert np.array_equal(first[k], s(a=float(a[k])).orbit(points[k], float(eps[k]), 50).x[-1])


def test_compensated_orbits_keep_integrals_better():
    s = kahan.catalog.e6
    ends = [s.orbit([1, 2, 3], 1 / 128, 200_000, every=200_000, compensated=flag).integrals for flag in (False, True)]
    name = next(iter(ends[0]))
    drifts = [abs(end[name][-1] / end[name][0] - 1) for end in ends]
    assert drifts[1] < drifts[0]


def test_an_orbit_ends_before_it_leaves_the_range():
    orbit = kahan.System("xdot = x^2;").orbit([1.0], 0.25, 100)
    assert orbit.ended == "range" and orbit.steps == len(orbit.x) - 1 and np.isfinite(orbit.x).all()


def test_formulas_have_the_values_of_the_command():
    s = kahan.System("idot = i^2/3 - i/7 + 1/10;")
    text = str(s.map[0])
    rows = command("orbit", "--field", "for i in open { x[i]dot = x[i+1]; }", "--sites", "30",
                   "--start", f"x = {text.replace('eps', '(1/16)')}", "--eps", "1", "--steps", "0")
    wanted = [float(x) for x in rows[1][-30:]]
    assert "^" in text and "/" in text and len(set(wanted)) == 30
    assert s.map(np.arange(30.0)[:, None], 1 / 16)[:, 0].tolist() == wanted
