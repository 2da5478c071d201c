"""Checks that an orbit ends in the same way and at the same step in every call."""

import warnings

import numpy as np
import pytest

import kahan

# Each case: a field, a start, eps, steps, the kind of end, and the number of steps before the end.
ENDS = [
    ("xdot = x^2;", [1.0], 0.05, 11, "range", 9),
    ("xdot = x^2;", [1.0], 0.05, 9, "complete", 9),
    ("xdot = x^2 + 1;", [0.0], 0.05, 40, "complete", 40),
    ("xdot = x; ydot = x - y;", [1.0, 0.5], 0.5, 800, "range", None),
    ("xdot = y; ydot = -x;", [1.0, 0.0], 0.05, 50, "complete", 50),
]


@pytest.mark.parametrize("text, start, eps, steps, ended, step", ENDS)
def test_an_orbit_ends_in_the_same_way_wherever_it_is_followed(text, start, eps, steps, ended, step):
    s = kahan.System(text)
    orbit = s.orbit(start, eps, steps)
    step = orbit.ended_step if step is None else step
    section = s.section(start, eps, steps, "x - 1/3")
    observed = s.observe(start, eps, steps)
    for one in (orbit, section, observed, s.orbit(start, eps, steps, every=7)):
        assert (one.ended, one.ended_step) == (ended, step)
    points = np.array([start, np.full(len(start), np.nan), start])
    chart = s.chart({"x": [start[0], start[0]]}, start, eps, steps=steps, color="sali", escape=None)
    for many in (s.ensemble(points, eps, steps), s.ensemble(points, eps, steps, observe=["sali", "fli", "extrema"])):
        assert many.ended.tolist() == [ended, "range", ended] and many.ended_step.tolist() == [step, 0, step]
        whole = many.ended == "complete"
        assert (np.isfinite(many.x).all(axis=1) == whole).all() and np.isnan(many.x[~whole]).all()
        assert all((np.isfinite(values) == whole).all() for values in many.observed.values())
        if ended == "complete":
            assert np.array_equal(many.x[0], orbit.x[-1])
    assert chart.ended.tolist() == [ended] * 2 and chart.ended_step.tolist() == [step] * 2
    assert (np.isfinite(chart.values) == (ended == "complete")).all()


def test_an_orbit_escapes_where_a_bound_is_asked_for():
    s = kahan.System("xdot = x;")
    many = s.ensemble([[1.0], [-1.0]], 0.5, 100, observe=["extrema", "escape"], escape=1e6)
    # Each step multiplies x by 3, and 3^13 is the first power of 3 beyond a million.
    assert many.ended.tolist() == ["escaped"] * 2 and (many.ended_step == 13).all() and (many.escaped == 13).all()
    assert np.isnan(many.x).all() and np.isnan(many.greatest_x).all()
    assert s.ensemble([[1.0]], 0.5, 100, observe=["escape"]).ended.tolist() == ["complete"]
    one = s.observe([1], 0.5, 100, escape=1e6)
    assert (one.ended, one.ended_step, one.escaped) == ("escaped", 13, 13)


def test_steps_over_poles_are_counted_where_they_are_asked_for():
    s = kahan.System("xdot = x^2;")
    # Each step lowers 1/x by 0.14; the first and the third orbit pass 1/x = 0, which is a pole.
    many = s.ensemble([[1.0], [-1.0], [1 / 0.21]], 0.07, 8, observe=["passed_poles"])
    assert many.passed_poles.tolist() == [1, 0, 1] and many.passed_poles_lower_bound.tolist() == [0, 0, 0]
    one = s.observe([1], 0.07, 8, observe="passed_poles")
    assert (one.passed_poles, one.passed_poles_lower_bound, one.ended, "sali" in one) == (1, False, "complete", False)
    assert "passed_poles" not in s.observe([1], 0.07, 8)
    assert s.chart({"eps": [0.05, 0.07]}, [1], steps=8, color="passed_poles").values.tolist() == [0, 1]
    assert s.observe([1], 0.07, 8, observe=["spectrum"]).spectrum.shape == (1,)


def test_exact_orbits_end_at_poles():
    orbit = kahan.System("xdot = x^2;").orbit([1], "1/20", 11, scalar="exact")
    assert (orbit.ended, orbit.ended_step, orbit.x[-1, 0]) == ("pole", 9, 10)


def test_an_orbit_warns_once_where_steps_do_not_resolve_fast_components():
    stiff = kahan.System("xdot = -100*(x - y); ydot = -y;")
    with pytest.warns(UserWarning, match="up to 20 for an eigenvalue .* s.trade measures"):
        stiff.orbit([0, 1], 0.1, 3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        stiff.orbit([0, 1], 0.1, 3)
        stiff.orbit([0, 1], 0.001, 3)
