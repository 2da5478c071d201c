"""Tests fields that are lifted to quadratic fields; arrays are in the original variables."""

import pickle
import warnings
from fractions import Fraction

import numpy as np
import pytest

import kahan

PENDULUM = "xdot = v; vdot = -sin(x);"
DUFFING = "xdot = v; vdot = x - x^3 + cos(2*t);"


@pytest.fixture(scope="module")
def pendulum():
    return kahan.System(PENDULUM, lift=True)


def test_a_lift_says_what_it_is(pendulum):
    lifted = pendulum.lifted
    assert pendulum.variables == ("x", "v")
    assert lifted.order == 2 and lifted.optimal and lifted.new == {"sin_x": "sin(x)", "cos_x": "cos(x)"}
    assert lifted.variables == ["x", "v", "sin_x", "cos_x"]
    assert lifted.energy.startswith("1/2*v^2 - cos_x") or "cos_x" in lifted.energy
    assert lifted.relations[0].along == "kept"
    all_ = lifted.embed([[0.5, 1.0], [1.5, 2.0]])
    assert np.array_equal(all_, [[0.5, 1, np.sin(0.5), np.cos(0.5)], [1.5, 2, np.sin(1.5), np.cos(1.5)]])
    assert np.array_equal(lifted.project(all_), [[0.5, 1.0], [1.5, 2.0]])
    assert kahan.System("xdot = v; vdot = -x;").lifted is None


def test_orbits_are_in_the_original_variables(pendulum):
    o = pendulum.orbit([1, 0], 0.05, 200)
    assert o.x.shape == (201, 2) and list(o)[:4] == ["n", "t", "x", "v"]
    assert np.ptp(o.integrals["energy"]) < 1e-13
    whole = kahan.System(PENDULUM, lift=True, all=True)
    assert whole.variables == ("x", "v", "sin_x", "cos_x")
    every = whole.orbit(pendulum.lifted.embed([1, 0]), 0.05, 200)
    assert np.array_equal(every.x[:, :2], o.x) and np.array_equal(every["energy"], o["energy"])
    quadratic = kahan.System(pendulum.lifted.field)
    assert np.array_equal(quadratic.orbit(pendulum.lifted.embed([1, 0]), 0.05, 200).x, every.x)
    out = np.empty((201, 2))
    assert pendulum.orbit([1, 0], 0.05, 200, out=out).x is not None and np.array_equal(out, o.x)
    wide = pendulum.orbit([1, 0], "1/20", 20, scalar="dd")
    assert wide.x.shape == (21, 2) and np.allclose(wide.x, o.x[:21], atol=1e-14)


def test_steps_and_ensembles_are_too(pendulum):
    x = np.array([[1.0, 0.0], [0.5, 0.25]])
    one = pendulum.step(x, 0.05)
    assert np.array_equal(one, [pendulum.orbit(point, 0.05, 1).x[1] for point in x])
    assert np.array_equal(pendulum.try_step(x[0], 0.05), pendulum.step(x[0], 0.05))
    assert pendulum.step(x.astype(np.float32), 0.05).dtype == np.float32
    e = pendulum.ensemble(x, 0.05, 100)
    assert np.allclose(e.x, [pendulum.orbit(point, 0.05, 100).x[-1] for point in x], rtol=0, atol=1e-13)
    seen = pendulum.ensemble(x, 0.05, 100, observe=("extrema", "lyapunov"))
    assert np.array_equal(seen.x, e.x) and seen["least_x"].shape == (2,) and "least_sin_x" not in seen.observed
    observed = pendulum.observe([1, 0], 0.05, 100, observe=("extrema",))
    assert list(observed.extrema) == ["x", "v"]
    assert pendulum.section([1, 0], 0.05, 500, "v").x.shape[1] == 2
    assert pendulum.chart({"x": (0.1, 1, 3)}, [1, 0], 0.05, steps=100).values.shape == (3,)


def test_values_of_parameters_go_into_the_embedding():
    s = kahan.System("x' = v, v' = -sin(k*x)", lift=True)
    with pytest.raises(ValueError, match="k"):
        s.lifted.embed([1, 0])
    x = np.array([[1.0, 0.0], [1.0, 0.0]])
    e = s.ensemble(x, 0.05, 10, params={"k": [1.0, 2.0]})
    assert np.array_equal(e.x, [s(k=k).orbit([1, 0], 0.05, 10).x[-1] for k in (1, 2)])
    assert s(k="1/2").lifted.embed([1, 0])[2] == np.sin(0.5)


def test_time_begins_at_t0():
    s = kahan.System(DUFFING, lift="smallest", t0="1/2")
    assert s.variables == ("x", "v") and "t" in s.lifted.variables
    o = s.orbit([1, 0], 0.01, 10)
    assert o.x.shape == (11, 2) and o.t[0] == 0.5 and o.t[-1] == pytest.approx(0.7)
    f = s.rhs()
    assert np.allclose(f(3.0, [1.0, 2.0]), [2.0, np.cos(6.0)])
    assert np.allclose(f(3.0, np.array([[1.0, 0.0], [2.0, 1.0]])), [[2.0, 1.0], [np.cos(6.0), np.cos(6.0)]])
    exact = s.orbit([1, 0], Fraction(1, 100), 2, scalar="exact")
    assert exact.t[0] == Fraction(1, 2)


def test_the_lift_can_be_chosen():
    field = "x' = x*(1 - x) - x*y/(1 + x), y' = x*y/(1 + x) - y/4"
    s = kahan.System(field, lift=True)
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        s.orbit([1, 0.5], 0.01, 10)
        s.orbit([1, 0.5], 0.01, 10)
        kahan.System(PENDULUM, lift=True).orbit([1, 0], 0.01, 10)
        kahan.System(field, lift=True).orbit([1, 0.5], 0.01, 10, reembed=True)
    assert len(found) == 1 and "relation" in str(found[0].message) and "reembed=True" in str(found[0].message)


def test_exponents_are_those_of_the_variables_of_arrays():
    eps, driven = 0.02, kahan.System("x' = y, y' = x - x^3 - y/4 + 3/10*cos(t)", lift=True)
    e = driven.ensemble([[1, 0], [0.5, 0]], eps, 5000, observe=("spectrum", "lyapunov", "log_det"))
    assert e["spectrum"].shape == (2, 2) and len(driven.observe([1, 0], eps, 5000).spectrum) == 2
    # The sum of the exponents is the divergence of the original field, with an error of order eps².
    np.testing.assert_allclose(e["spectrum"].sum(axis=1), -0.25, atol=5 * eps**2)
    np.testing.assert_allclose(e["mean_log_det"], -0.25, atol=5 * eps**2)


def test_shapes_count_the_variables_of_arrays(pendulum):
    for asked in (
        lambda: pendulum.orbit([[1, 0], [1, 0]], 0.1, 10),
        lambda: pendulum.ensemble([1, 0], 0.1, 10),
        lambda: pendulum.ensemble([[1, 0, 0]], 0.1, 10),
        lambda: pendulum.step([1, 0, 0], 0.1),
        lambda: pendulum.integral_values([1, 0, 0], 0.1),
    ):
        with pytest.raises(ValueError, match=r"2[,)]") as error:
            asked()
        assert "4" not in str(error.value)
