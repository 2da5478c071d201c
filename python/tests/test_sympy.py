"""Tests fields from equations of SymPy, in the forms that users write."""

import numpy as np
import pytest

import kahan

sympy = pytest.importorskip("sympy")

t, a = sympy.symbols("t a")
x, y = sympy.symbols("x y")
X, Y = sympy.Function("x")(t), sympy.Function("y")(t)
TEXT = "xdot = y; ydot = a - x^2/3 + x/4;"


def right(x, y):
    return y, a - x**2 / 3 + sympy.Float("0.25") * x


@pytest.mark.parametrize("equations", [
    {x: right(x, y)[0], y: right(x, y)[1]},
    [sympy.Eq(X.diff(t), right(X, Y)[0]), sympy.Eq(Y.diff(t), right(X, Y)[1])],
    (sympy.Eq(X.diff(t), right(X, Y)[0]), sympy.Eq(Y.diff(t), right(X, Y)[1])),
    [sympy.Eq(sympy.Matrix([X, Y]).diff(t), sympy.Matrix(right(X, Y)))],
    # `System` must solve these equations for the derivatives.
    [sympy.Eq(2 * X.diff(t) + Y.diff(t), 2 * right(X, Y)[0] + right(X, Y)[1]), sympy.Eq(Y.diff(t), right(X, Y)[1])],
    ([x, y], list(right(x, y))),
    ((x, y), sympy.Matrix(right(x, y))),
    (sympy.Matrix([x, y]), sympy.Matrix(right(x, y))),
    [[x, y], right(x, y)],
])
def test_all_forms_of_equations_are_one_field(equations):
    s, text = kahan.System(equations, a=1), kahan.System(TEXT, a=1)
    assert s.variables == ("x", "y") and s.map == text.map
    assert (s.orbit([0.1, 0.2], 0.1, 50).x == text.orbit([0.1, 0.2], 0.1, 50).x).all()


def test_a_single_equation_and_one_of_order_two():
    assert kahan.System([sympy.Eq(X.diff(t), -a * X)]).text == "xdot = -a*x;"
    assert kahan.System((x, x**2 - a)).text == "xdot = -a + x^2;"
    spring = kahan.System([sympy.Eq(X.diff(t, 2), -X - a * X.diff(t) + Y), sympy.Eq(Y.diff(t), X * X.diff(t))], a="1/2")
    text = kahan.System("x'' = -x - a*x' + y, y' = x*x'", a="1/2")
    assert spring.variables == text.variables == ("x", "v", "y")
    assert (spring.orbit([1, 0, 2], 0.05, 20).x == text.orbit([1, 0, 2], 0.05, 20).x).all()


def test_equations_are_lifted():
    pendulum = kahan.System([sympy.Eq(X.diff(t), Y), sympy.Eq(Y.diff(t), -sympy.sin(X))], lift=True)
    text = kahan.System("xdot = y; ydot = -sin(x);", lift=True)
    np.testing.assert_array_equal(pendulum.orbit([1, 0], 0.05, 30).x, text.orbit([1, 0], 0.05, 30).x)


@pytest.mark.parametrize(("equations", "message"), [
    ([], "equations of SymPy are"),
    ([x, y, a], "equations of SymPy are"),
    (([x, y], [x]), "of one length"),
    ([sympy.Eq(X.diff(t), X), x], "x is no equation"),
    ([sympy.Eq(X, 1)], "derivatives by one symbol"),
    ([sympy.Eq(X.diff(t), X), sympy.Eq(sympy.Function("z")(a).diff(a), a)], "derivatives by one symbol"),
    ([sympy.Eq(X.diff(t) + Y.diff(t), X)], "do not say in one way"),
    ([sympy.Eq(X.diff(t) ** 2, X)], "do not say in one way"),
    ([sympy.Eq(X.diff(t), X + x)], "x is both a function of the time and a symbol"),
    ([sympy.Eq(X.diff(t), Y)], r"y\(t\) is a function"),
    ([sympy.Eq(X.diff(t), sympy.sqrt(2) * X)], "no fraction"),
    ({"None": 0.0}, "no derivative of a symbol"),
    ({x: X}, r"x\(t\) is a function"),
])
def test_what_is_no_field_is_an_error(equations, message):
    with pytest.raises(ValueError, match=message):
        kahan.System(equations)


@pytest.mark.parametrize("field", [1, None, b"xdot = x;"])
def test_other_things_are_no_fields(field):
    with pytest.raises(TypeError, match="text or equations of SymPy"):
        kahan.System(field)
