"""Tests gradients of a scalar function of an orbit, by one backward sweep."""

from fractions import Fraction

import numpy as np
import pytest

import kahan

POND = "xdot = a*x - b*x*y; ydot = c*x*y - d*y/(1 + a^2);"
VALUES = {"a": 1.5, "b": 0.75, "c": 0.5, "d": 1.25}
ROUNDING = 1e-13
"""A relative bound: 30 steps of up to 17 stages round by 6e-14, and the largest error was 3e-15."""


def ring(n):
    """Returns the field of a reaction network with n species and 4n rates."""
    def rate(i):
        left, right = (i - 1) % n, (i + 1) % n
        return f"x{i}dot = k{i}*x{left} - k{i + 1 if i + 1 < n else 0}*x{i} - l{i}*x{i}*x{right} + p{i}*x{left}*x{left} - d{i}*x{i};"

    return kahan.System("".join(map(rate, range(n))), **{f"{k}{i}": 0.5 + 0.01 * i for k in "klpd" for i in range(n)})


def by_differences(s, x, eps, steps, weights, name, every=1, order=2, scalar="dd"):
    """Returns a derivative of the weighted sum of rows by differences; the error is below 1e-16."""
    tiny = Fraction(1, 1 << 40)

    def loss(sign):
        moved = lambda own, other: Fraction(own) + (sign * tiny if other == name else 0)
        start = [moved(one, variable) for one, variable in zip(x, s.variables)]
        at = s(**{other: moved(value, other) for other, value in s.parameters.items()})
        o = at.orbit(start, moved(eps, "eps"), steps, every=every, order=order, scalar=scalar)
        low = 0 * o.x if scalar == "exact" else o.x_low
        return sum(Fraction(w) * (Fraction(a) + Fraction(b)) for w, a, b in zip(weights.ravel(), o.x.ravel(), low.ravel()))

    return float((loss(1) - loss(-1)) / (2 * tiny))


@pytest.mark.parametrize("order, every", [(2, 1), (4, 3), (8, 1)])
def test_a_gradient_is_that_of_differences_in_32_digits(order, every):
    s, x, eps, steps = kahan.System(POND, **VALUES), [1.25, 0.5], 1 / 64, 30
    o = s.orbit(x, eps, steps, every=every, order=order)
    weights = np.random.default_rng(1).uniform(0.5, 1, o.x.shape)
    gradient = o.gradient(weights)
    assert list(gradient) == ["x", "y", "a", "b", "c", "d", "eps"]
    for name, slope in gradient.items():
        assert slope == pytest.approx(by_differences(s, x, eps, steps, weights, name, every, order), rel=ROUNDING)


def test_a_gradient_of_many_parameters_is_that_of_differences_in_32_digits():
    s = ring(10)
    x, eps, steps = [0.5 + 0.03125 * i for i in range(10)], 1 / 64, 30
    o = s.orbit(x, eps, steps)
    weights = np.random.default_rng(1).uniform(0.5, 1, o.x.shape)
    gradient = o.gradient(weights, by=["k3", "x2", "d9", "eps", "p0"])
    assert list(gradient) == ["k3", "x2", "d9", "eps", "p0"] and len(s.parameters) == 40
    for name, slope in gradient.items():
        assert slope == pytest.approx(by_differences(s, x, eps, steps, weights, name), rel=ROUNDING)
    assert o.gradient(weights, by="k3") == {"k3": gradient["k3"]}


@pytest.mark.parametrize("z", [-2.0, -2.0 + 2.0**-40])
def test_a_gradient_at_a_removable_pole_is_that_of_exact_differences(z):
    """For a = b = 1 and eps = 1/2, det A is 0 at z = -2, but the map in lowest terms is regular."""
    s = kahan.System("xdot = -a*x*z; ydot = -a*y*z; zdot = a*x^2 + b*y^2;", a=1, b=1)
    x, eps, steps = [0.75, 0.5, z], 0.5, 2
    assert abs(s.evaluate(x, eps).det_A) < 1e-12
    o = s.orbit(x, eps, steps)
    weights = np.random.default_rng(1).uniform(0.5, 1, o.x.shape)
    for name, slope in o.gradient(weights).items():
        assert slope == pytest.approx(by_differences(s, x, eps, steps, weights, name, scalar="exact"), rel=ROUNDING)


def test_rows_of_an_orbit_that_ends_early_have_a_gradient():
    s = kahan.System("xdot = a*x^2;", a=1)
    o = s.orbit([1], 0.05, 20)
    assert o.ended == "range" and len(o.x) == 10
    weights = np.ones((10, 1))
    # The row after n steps of x' = a x^2 is x/(1 - 2 eps a n x).
    expected = sum(1 / (1 - 0.1 * n) ** 2 for n in range(10))
    assert o.gradient(weights, "x")["x"] == pytest.approx(expected, rel=ROUNDING)
    with pytest.raises(ValueError, match=r"the shape \(10, 1\) .* this is \(21, 1\); the orbit ended early, no finite point after step 9: "
                                         r"give weights for its 10 rows, or choose fewer steps or a smaller eps"):
        o.gradient(np.ones((21, 1)))


def test_unusable_arguments_are_errors():
    s = kahan.System(POND, **VALUES)
    o = s.orbit([1.25, 0.5], 0.01, 10)
    with pytest.raises(ValueError, match=r"weights: the shape \(11, 2\) of the orbit's x is needed, and this is \(2,\)$"):
        o.gradient([1, 2])
    with pytest.raises(ValueError, match="by: there is no parameter or variable `epss`; did you mean `eps`?"):
        o.gradient(o.x, ["a", "epss"])
    for how in [{"scalar": "exact"}, {"scalar": "dd"}, {"method": "rk4"}]:
        other = s.orbit([1.25, 0.5], 0.01, 3, **how)
        with pytest.raises(ValueError, match="gradient is of orbits of Kahan's map in f64 or f32"):
            other.gradient(np.ones((4, 2)))
    lifted = kahan.System("x' = v; v' = -sin(x)", lift=True).orbit([1, 0], 0.01, 10)
    with pytest.raises(ValueError, match="by: this field is lifted"):
        lifted.gradient(lifted.x)


def test_a_fit_of_many_rates_by_gradients():
    """A fit of 40 rates lowers the loss to 5e-6 of its first value in 200 iterations."""
    from scipy.optimize import minimize

    true = ring(10)
    x, eps, steps = np.linspace(0.5, 1, 10), 0.02, 50
    data = true.orbit(x, eps, steps).x
    names = list(true.parameters)

    def loss(rates):
        o = true(**dict(zip(names, map(float, rates)))).orbit(x, eps, steps)
        gradient = o.gradient(2 * (o.x - data), names)
        return np.sum((o.x - data) ** 2), np.array([gradient[name] for name in names])

    begin = np.array([float(true.parameters[name]) for name in names]) * 1.1
    found = minimize(loss, begin, jac=True, method="L-BFGS-B", options={"maxiter": 200, "ftol": 1e-15, "gtol": 1e-12})
    assert found.fun < 1e-4 * loss(begin)[0]


def test_what_has_no_gradient_is_said():
    o = kahan.System("xdot = a*x;", a=1).orbit([1], 0.05, 3)
    for names in (["dt"], ["x", "dt"]):
        with pytest.raises(ValueError, match="by: give eps for a derivative by the time step"):
            o.gradient(0 * o.x, names)
    lifted = kahan.System("xdot = -v*x/(k + x);", lift=True, v=1, k=1).orbit([1], 0.05, 3)
    for names in (None, "k"):
        with pytest.raises(ValueError, match="by: .* new variables depend on parameters and first values, too"):
            lifted.gradient(0 * lifted.x, names)
