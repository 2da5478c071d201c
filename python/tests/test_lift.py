"""Fields that are lifted to quadratic ones: arrays are in the original variables."""

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
    field = "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08"
    s = kahan.System(field, lift=True, at=(1, 0))
    assert s.lifted.order == 1 and s.lifted.relations[0].along == "decays"
    with pytest.raises(kahan.FieldError, match="mechanical"):
        kahan.System(field, lift="energy")
    with pytest.raises(ValueError, match="smallest"):
        kahan.System(field, lift="least")
    with pytest.raises(TypeError, match="lift"):
        kahan.System(field, lift=3)


def test_what_cannot_be_lifted_is_refused():
    with pytest.raises(kahan.FieldError, match="corner"):
        kahan.System("xdot = abs(x);", lift=True)
    with pytest.raises(kahan.FieldError, match="kahan lift"):
        kahan.System("xdot = sin(x);")


def test_names_stay_names_of_parameters_without_a_lift():
    assert kahan.System("xdot = at*x + t0;", at=1, t0=2).parameters == {"at": 1, "t0": 2}


def test_copies_are_lifted(pendulum):
    copy = pickle.loads(pickle.dumps(pendulum))
    assert copy == pendulum and copy.variables == ("x", "v")


def test_expressions_of_sympy_are_lifted():
    sympy = pytest.importorskip("sympy")
    x, v, k = sympy.symbols("x v k")
    s = kahan.System({x: v, v: -k * sympy.sin(x)}, lift=True, k=1)
    text = kahan.System("xdot = v; vdot = -k*sin(x);", lift=True, k=1)
    assert np.array_equal(s.orbit([1, 0], 0.05, 10).x, text.orbit([1, 0], 0.05, 10).x)
    softened = kahan.System({x: v, v: -x / (x**2 + 1) ** sympy.Rational(3, 2)}, lift=True)
    assert np.ptp(softened.orbit([1, 0], 0.01, 500).integrals["energy"]) < 1e-12
    morse = kahan.System({x: v, v: -2 * (1 - sympy.exp(-x)) * sympy.exp(-x)}, lift=True)
    assert morse.lifted.energy is not None


def test_steps_are_projected_wherever_orbits_are_made(pendulum):
    x = np.array([[1.0, 0.0], [0.5, 0.25]])
    for order in (2, 4):
        orbits = [pendulum.orbit(point, 0.1, 100, order=order, reembed=True) for point in x]
        for o in orbits:
            assert o.ended == "complete" and o.x.shape == (101, 2) and np.isfinite(o.x).all()
        last = np.array([o.x[-1] for o in orbits])
        assert not np.array_equal(last, [pendulum.orbit(point, 0.1, 100, order=order).x[-1] for point in x])
        e = pendulum.ensemble(x, 0.1, 100, order=order, reembed=True)
        assert np.array_equal(e.x, last) and set(e.ended) == {"complete"}
        seen = pendulum.ensemble(x, 0.1, 100, order=order, observe=("extrema",), reembed=True)
        assert np.array_equal(seen.x, last) and np.array_equal(seen["greatest_x"], [o.x[:, 0].max() for o in orbits])
        assert pendulum.observe(x[0], 0.1, 100, observe="final", order=order, reembed=True).final["x"] == last[0, 0]
    out = np.empty((2, 2))
    assert pendulum.ensemble(x, 0.1, 100, order=4, reembed=True, out=out).x is out and np.array_equal(out, last)
    energy = [v * v / 2 - np.cos(q) for q, v in pendulum.orbit([1, 0], 0.05, 20_000, every=100, reembed=True).x]
    assert np.ptp(energy[-50:]) <= 1.05 * np.ptp(energy[:50])
    crossings = pendulum.section([1, 0], 0.05, 1000, "v", reembed=True)
    assert len(crossings.x) > 10 and np.allclose(crossings.x[:, 0], -1, atol=5e-3)
    chart = pendulum.chart({"x": (0.5, 1, 2)}, [1, 0], 0.1, steps=100, color="final_x", reembed=True)
    assert chart.values[1] == pendulum.orbit([1, 0], 0.1, 100, reembed=True).x[-1, 0]


def test_what_cannot_be_projected_says_why(pendulum):
    with pytest.raises(ValueError, match="sali is of the map"):
        pendulum.ensemble([[1, 0]], 0.1, 10, observe="sali", reembed=True)
    with pytest.raises(ValueError, match="lyapunov is of the map"):
        pendulum.chart({"x": (0.5, 1, 2)}, [1, 0], 0.1, color="lyapunov", reembed=True)
    with pytest.raises(ValueError, match="float64"):
        pendulum.orbit([1, 0], 0.1, 10, scalar="f32", reembed=True)
    with pytest.raises(ValueError, match="compensated"):
        pendulum.orbit([1, 0], 0.1, 10, compensated=True, reembed=True)
    with pytest.raises(ValueError, match="scalar f64"):
        pendulum.orbit([1, 0], 0.1, 10, scalar="dd", reembed=True)
    quadratic = kahan.System("xdot = v; vdot = -x;")
    for asked in (
        lambda: quadratic.orbit([1, 0], 0.1, 10, reembed=True),
        lambda: quadratic.ensemble([[1, 0]], 0.1, 10, reembed=True),
        lambda: quadratic.section([1, 0], 0.1, 10, "v", reembed=True),
    ):
        with pytest.raises(ValueError, match="lift the field"):
            asked()


def test_a_projection_without_a_solution_ends_an_orbit():
    s = kahan.System("x' = 1 + x^2*y - 4*x, y' = 3*x - x^2*y", lift=True)
    o = s.orbit([1, 1], 0.1, 1000, reembed=True)
    assert o.ended == "reembed" and o.ended_step == len(o.x) - 1 < 1000 and "smaller eps" in o.why and o.why in repr(o)
    e = s.ensemble([[1, 1]], 0.1, 1000, reembed=True)
    assert e.ended[0] == "reembed" and e.steps[0] == o.ended_step and np.isnan(e.x).all()
    assert s.section([1, 1], 0.1, 1000, "x - 1", reembed=True).ended == "reembed"


def test_an_orbit_ends_where_a_root_would_be_negative():
    s = kahan.System("hdot = -sqrt(h);", lift=True)
    for more in ({}, {"compensated": True}, {"scalar": "f32"}, {"scalar": "dd"}, {"order": 4}):
        o = s.orbit([1], "1/60", 500, **more)
        assert o.ended == "range" and 58 <= o.ended_step <= 61 and len(o.x) == o.ended_step + 1
        assert 0 <= o.x[-1, 0] < 2e-3
    assert "sqrt(h)" in s.orbit([1], 1 / 60, 500).why
    e = s.ensemble([[1.0], [4.0]], 1 / 60, 80)
    assert list(e.ended) == ["range", "complete"] and np.isnan(e.x[0, 0]) and e.steps[0] == s.orbit([1], 1 / 60, 80).ended_step
    assert e.x[1, 0] == s.orbit([4], 1 / 60, 80).x[-1, 0]


def test_a_lift_without_a_start_is_judged_by_the_first_orbit():
    field = "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08"
    lift = "smallest"
    s = kahan.System(field, lift=lift)
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        s.orbit([1, 0], 0.01, 10)
        s.orbit([1, 0], 0.01, 10)
        kahan.System(PENDULUM, lift=True).orbit([1, 0], 0.01, 10)
        kahan.System(field, lift=lift).orbit([1, 0], 0.01, 10, reembed=True)
    assert len(found) == 1 and "relation" in str(found[0].message) and "reembed=True" in str(found[0].message)


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
