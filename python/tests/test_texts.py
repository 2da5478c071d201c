"""Tests fields in the syntax of other tools, and the values that their texts give."""

import pickle
from fractions import Fraction

import kahan
import numpy as np
import pytest

LORENZ = "par s=10,r=28,b=8/3\ninit x=1,y=1,z=1\nx'=s*(y-x)\ny'=r*x-y-x*z\nz'=x*y-b*z\ndone"
STRICT = "xdot = s*(y-x); ydot = r*x-y-x*z; zdot = x*y-b*z;"


@pytest.mark.parametrize("text", [
    "x' = y\ny' = a - x**2",
    "dx/dt = y, dy/dt = a − x²",
    "Eq(Derivative(x(t), t), y(t)), Eq(Derivative(y(t), t), a - x(t)**2)",
    "\\dot{x} = y, \\dot{y} = a - x^2",
    "f = a - x^2; x'[t] == y[t]; y'[t] == f",
])
def test_a_field_in_another_manner_has_the_same_formulas(text):
    strict = kahan.System("xdot = y; ydot = a - x^2;")
    assert str(kahan.System(text).map) == str(strict.map)


def test_values_and_the_first_point_of_a_text_serve():
    s = kahan.System(LORENZ)
    given = kahan.System(STRICT, s=10, r=28, b="8/3")
    assert s.parameters == given.parameters and s.start == (1, 1, 1)
    assert np.array_equal(s.orbit(s.start, 0.001, 10).x, given.orbit([1, 1, 1], 0.001, 10).x)
    assert s(r=1).parameters["r"] == 1 and s(r=1).parameters["b"] == Fraction(8, 3)
    many = np.ones((3, 3))
    assert np.array_equal(s.ensemble(many, 0.001, 5), given.ensemble(many, 0.001, 5))
    assert pickle.loads(pickle.dumps(s)) == s and given.start is None


def test_the_language_is_what_is_printed():
    s = kahan.System("x'' = -x - x**2")
    assert s.text == "xdot = v;\nvdot = -x - x^2;" and s.notes == ["`x''` is read with `xdot = v`: `v` is a new state"]
    assert kahan.System(s.text) == s


def test_what_was_found_keeps_the_values_of_the_text():
    s = kahan.System("a = 1/2; x' = y; y' = a - x^2")
    found = s.discover(seconds=5)
    assert found.claimed.parameters["a"] == Fraction(1, 2)
    assert found.claimed.orbit([0, 0.1], 0.01, 3).x.shape == (4, 2)
