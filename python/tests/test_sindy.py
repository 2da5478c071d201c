"""Tests fields from models of pysindy, and from objects with the same methods."""

from fractions import Fraction

import numpy as np
import pytest

import kahan

CUBIC = ["1", "x0", "x1", "x0^2", "x0 x1", "x1^2", "x0^3", "x0^2 x1", "x0 x1^2", "x1^3"]


class Model:
    """An object with the methods of a fitted model of pysindy."""

    def __init__(self, coefficients, terms=CUBIC, feature_names=("x0", "x1")):
        self._coefficients, self._terms, self.feature_names = np.array(coefficients), list(terms), list(feature_names)

    def coefficients(self):
        return self._coefficients

    def get_feature_names(self):
        return self._terms


def coefficients(terms=CUBIC, **values):
    """Returns two rows of coefficients; `values` has a dict from terms to numbers for each row."""
    rows = np.zeros((2, len(terms)))
    for row, one in zip(rows, (values["first"], values["second"])):
        for term, value in one.items():
            row[terms.index(term)] = value
    return rows


def test_coefficients_are_exact_and_zeros_are_left_out():
    rows = coefficients(first={"x1": 1.0}, second={"1": 0.1, "x0^2": -1.0, "x0 x1": 0.5, "x1^2": 1e-9})
    s = kahan.from_sindy(Model(rows))
    assert s.text == f"x0dot = x1;\nx1dot = {Fraction(0.1)} - x0^2 + 1/2*x0*x1 + {Fraction(1e-9)}*x1^2;"
    assert kahan.from_sindy(Model(rows, feature_names=["x0", "x1"])).variables == ("x0", "x1")
    x = np.array([0.3, -0.2])
    np.testing.assert_allclose(s.rhs()(0.0, x), [x[1], 0.1 - x[0] ** 2 + 0.5 * x[0] * x[1] + 1e-9 * x[1] ** 2], rtol=1e-15)


def test_other_terms_are_named_or_lifted():
    rows = coefficients(first={"x1": 1.0}, second={"x0": -1.0, "x0^2 x1": -0.25})
    with pytest.raises(ValueError, match=r"x1' has the term -0.25 \* x0\^2 x1, which is not quadratic; lift=True"):
        kahan.from_sindy(Model(rows))
    lifted = kahan.from_sindy(Model(rows), lift=True)
    text = kahan.System("x0dot = x1; x1dot = -x0 - x0^2*x1/4;", lift=True)
    np.testing.assert_allclose(lifted.orbit([1, 0], 0.01, 100).x, text.orbit([1, 0], 0.01, 100).x, rtol=1e-13)
    terms = ["x0", "x1", "sin(1 x0)", "x0 cos(2 x1)"]
    rows = coefficients(terms, first={"x1": 1.0}, second={"sin(1 x0)": -1.0, "x0 cos(2 x1)": 0.5})
    with pytest.raises(ValueError, match=r"-1 \* sin\(1 x0\), which is not quadratic"):
        kahan.from_sindy(Model(rows, terms))
    lifted = kahan.from_sindy(Model(rows, terms), lift=True, at=[1, 0])
    text = kahan.System("x0dot = x1; x1dot = -sin(x0) + x0*cos(2*x1)/2;", lift=True, at=[1, 0])
    np.testing.assert_allclose(lifted.orbit([1, 0], 0.01, 100).x, text.orbit([1, 0], 0.01, 100).x, rtol=1e-12)


def test_what_is_no_field_is_an_error():
    model = Model([[1.0, 0.0], [0.0, 1.0]], ["x0", "x1"])
    model.discrete_time = True
    with pytest.raises(ValueError, match="discrete time"):
        kahan.from_sindy(model)
    controlled = Model([[0.0, 1.0], [1.0, 0.0]], ["x0", "x1 u0"], ["x0", "x1", "u0"])
    with pytest.raises(ValueError, match="control input u0"):
        kahan.from_sindy(controlled)
    # `from_sindy` ignores an unused control input.
    controlled = Model([[0.0, 0.0], [1.0, 0.0]], ["x0", "x1 u0"], ["x0", "x1", "u0"])
    assert kahan.from_sindy(controlled).text == "x0dot = 0;\nx1dot = x0;"
    with pytest.raises(ValueError, match=r"shape \(2, 2\); with 10 terms"):
        kahan.from_sindy(Model([[1.0, 0.0], [0.0, 1.0]]))


def test_a_model_of_pysindy_is_read():
    pysindy = pytest.importorskip("pysindy")
    truth = kahan.System("xdot = -0.5*x + 2*y; ydot = -2*x - 0.5*y - 0.5*x*y;")
    t = np.linspace(0, 4, 2001)
    x = truth.orbit([2, 0], t[1] / 2, len(t) - 1, order=4).x
    model = pysindy.SINDy(optimizer=pysindy.STLSQ(threshold=0.1), feature_library=pysindy.PolynomialLibrary(degree=3))
    model.fit(x, t=t, feature_names=["x", "y"])
    s = kahan.from_sindy(model)
    assert s.variables == ("x", "y") and model.predict(x[:1]).shape == (1, 2)
    np.testing.assert_allclose([s.rhs()(0.0, one) for one in x[::100]], model.predict(x[::100]), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(s.arrays()[1], truth.arrays()[1], atol=0.01)
    library = pysindy.PolynomialLibrary(degree=2) + pysindy.FourierLibrary(n_frequencies=1)
    wide = pysindy.SINDy(optimizer=pysindy.STLSQ(threshold=1e-9), feature_library=library)
    wide.fit(x, t=t, feature_names=["x", "y"])
    with pytest.raises(ValueError, match=r"\((1 )?[xy]\), which is not quadratic"):
        kahan.from_sindy(wide)
    lifted = kahan.from_sindy(wide, lift=True)
    np.testing.assert_allclose(lifted.orbit(x[0], t[1] / 2, 100, order=4).x[-1], x[100], atol=1e-3)
