"""Tests coefficients that depend on eps: steps use their own eps, and the field uses eps = 0."""

from fractions import Fraction

import numpy as np
import pytest

import kahan

TEXT = "struct P { a, b } xdot = y*(1 - a*eps^2) + b*eps^4*x^2; ydot = (a - eps^2)*(x - b*y)*x/(1 + b^2*eps^2) - eps^2/2;"
# The field of TEXT with a parameter k in place of eps^2.
STRAIGHT = "struct P { a, b, k } xdot = y*(1 - a*k) + b*k^2*x^2; ydot = (a - k)*(x - b*y)*x/(1 + b^2*k) - k/2;"
VALUES = {"a": "3/2", "b": "-2/3"}
EPS = Fraction(1, 8)


def systems() -> tuple[kahan.System, kahan.System, kahan.System]:
    """Returns the field of TEXT, and the field of STRAIGHT with k = eps^2 and with k = 0."""
    straight = kahan.System(STRAIGHT)
    return kahan.System(TEXT)(**VALUES), straight(**VALUES, k=EPS**2), straight(**VALUES, k=0)


def test_exact_objects_are_those_of_the_coefficients_at_eps() -> None:
    own, at_eps, at_zero = systems()
    x = [Fraction(2, 3), Fraction(-1, 5)]
    for name in ("map", "A", "b", "det_A"):
        assert np.all(getattr(own, name)(x, eps=EPS) == getattr(at_eps, name)(x, eps=EPS)), name
    assert np.all(own.jacobian(x, eps=EPS) == at_eps.jacobian(x, eps=EPS))
    for name in ("field", "field_jacobian"):
        assert np.all(getattr(own, name)(x) == getattr(at_zero, name)(x)), name
    orbit = own.orbit(x, eps=EPS, steps=4, scalar="exact")
    assert np.all(orbit.x == at_eps.orbit(x, eps=EPS, steps=4, scalar="exact").x)


def test_steps_and_ensembles_are_those_of_the_coefficients_at_eps() -> None:
    own, at_eps, at_zero = systems()
    x, eps = [0.5, -0.25], float(EPS)
    near = {"rtol": 1e-13, "atol": 1e-13}
    assert np.allclose(own.orbit(x, eps=eps, steps=50).x, at_eps.orbit(x, eps=eps, steps=50).x, **near)
    assert np.allclose(own.step(x, eps), at_eps.step(x, eps), **near)
    assert np.allclose(own.try_step(x, eps), at_eps.try_step(x, eps), **near)
    rhs = own.rhs()
    assert np.allclose(rhs(0.0, x), at_zero.rhs()(0.0, x), **near)
    assert np.allclose(rhs.jacobian(0.0, x), at_zero.rhs().jacobian(0.0, x), **near)
    ends = own.ensemble([x, x], eps=[eps, eps / 2], steps=20)
    assert np.allclose(ends.x[0], own.orbit(x, eps=eps, steps=20).x[-1], **near)
    assert np.allclose(ends.x[1], own.orbit(x, eps=eps / 2, steps=20).x[-1], **near)


def test_higher_orders_follow_the_field_at_eps_0() -> None:
    own, _, at_zero = systems()
    x = [0.5, -0.25]
    flow = at_zero.orbit(x, eps=1 / 2048, steps=1024, order=4).x[-1]
    for order in (2, 4):
        errors = [np.abs(own.orbit(x, eps=0.5 / n, steps=n, order=order).x[-1] - flow).max() for n in (16, 32)]
        assert abs(np.log2(errors[0] / errors[1]) - order) < 0.3


def test_derivatives_by_eps_count_the_coefficients() -> None:
    own, _, _ = systems()
    x, eps, step = [0.5, -0.25], float(EPS), 1e-6
    for order in (2, 4):
        orbit = own.orbit(x, eps=eps, steps=10, order=order, derivatives=["eps", "a"])
        ends = [own.orbit(x, eps=eps + shift, steps=10, order=order).x[-1] for shift in (step, -step)]
        assert np.allclose(orbit.derivatives["eps"][-1], (ends[0] - ends[1]) / (2 * step), rtol=1e-6, atol=1e-8)
        gradient = orbit.gradient(np.vstack([np.zeros((10, 2)), [[1.0, 2.0]]]))
        assert np.isclose(gradient["eps"], orbit.derivatives["eps"][-1] @ [1.0, 2.0])
        assert np.isclose(gradient["a"], orbit.derivatives["a"][-1] @ [1.0, 2.0])


def test_claims_of_eps_are_found_and_proved() -> None:
    lines = kahan.System("xdot = x*(1 + x + (3 + eps^2)/(1 + eps^2)*y); ydot = -y*(1 + (3 + eps^2)/(1 + eps^2)*x + y)")
    found = lines.discover(seconds=60)
    assert len(found.integrals) == 1
    integral = found.claimed.integrals["H1"]
    x, eps = [Fraction(1, 2), Fraction(1, 3)], Fraction(1, 7)
    assert integral(x, eps=eps) == integral(found.claimed.map(x, eps=eps), eps=eps)


def test_notebooks_show_the_coefficients_of_the_map() -> None:
    s = kahan.System("xdot = y + eps^2*x^2; ydot = -x")
    assert r"\dot{x} &= y + \varepsilon^{2} x^{2}" in s._repr_latex_()
    assert str(s.field[0]) == "y"


def test_what_is_not_possible_is_refused() -> None:
    with pytest.raises(kahan.FieldError, match="odd powers"):
        kahan.System("xdot = y + eps*x; ydot = x")
    with pytest.raises(kahan.FieldError, match="free of `eps`"):
        kahan.System("xdot = eps^2*sin(x)", lift=True)
    with pytest.raises(ValueError, match="depend on eps"):
        kahan.System("xdot = y + eps^2*x; ydot = x").arrays()
    with pytest.raises(ValueError, match="divides by zero at eps = 1;"):
        kahan.System("xdot = x/(1 - eps^2)").orbit([1], eps=1, steps=2, scalar="exact")
