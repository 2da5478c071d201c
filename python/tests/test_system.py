"""What a user does with a field: read it, see its formulas, ask."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest

import kahan

E6 = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);"


def test_a_mistake_has_a_place_and_a_way_out():
    with pytest.raises(kahan.FieldError) as caught:
        kahan.System("xdot = x;\nydot = x^3;")
    error = caught.value
    assert (error.line, error.column) == (2, 8) and "degree 3" in error.message and error.help
    assert "ydot = x^3;" in str(error) and "^^^" in str(error)
    assert isinstance(error, ValueError)
    with pytest.raises(kahan.FieldError, match="does not hold|not conserved|is no"):
        kahan.System("xdot = y; ydot = x^2; integral H = x;")


def test_parameters_are_exact_and_named():
    s = kahan.System("xdot = a*y; ydot = b*x^2;", a=0.1)
    assert s.parameters == {"a": Fraction(1, 10), "b": None}
    assert s(b="1/3").parameters["b"] == Fraction(1, 3)
    with pytest.raises(TypeError, match="no parameter"):
        kahan.System("xdot = a*y; ydot = x;", c=1)
    with pytest.raises(ValueError, match="b=VALUE|needs a value|no value"):
        s.step([1, 2], 0.1)
    with pytest.raises(TypeError):
        kahan.System(3)


def test_formulas_are_those_of_the_map():
    sympy = pytest.importorskip("sympy")
    s = kahan.System(E6 + " integral H = (y^2 + x*z)/(1 - 3*eps^2*x*z);")
    x, y, z, eps = sympy.symbols("x y z eps")
    A, b = s.A.sympy(), s.b.sympy()
    moved = sympy.Matrix(s.map.sympy())
    assert sympy.simplify(A * moved - b) == sympy.zeros(3, 1)
    assert sympy.simplify(moved.jacobian([x, y, z]) - s.jacobian.sympy()) == sympy.zeros(3, 3)
    H = s.integrals["H"].sympy()
    there = H.subs(dict(zip((x, y, z), moved)), simultaneous=True)
    assert sympy.simplify(there - H) == 0
    assert s.A.shape == (3, 3) and s.b.shape == (3,) and s.det_A.shape == ()
    assert r"\begin{pmatrix}" in s.A.latex and r"\dot{x}" in s._repr_latex_()
    assert pickle.loads(pickle.dumps(s.A)).latex == s.A.latex


def test_fields_come_from_sympy():
    sympy = pytest.importorskip("sympy")
    x, y, a = sympy.symbols("x y a")
    s = kahan.System({x: y, y: a - x**2 / 3 + sympy.Float("0.25") * x}, a=1)
    t = kahan.System("xdot = y; ydot = a - x^2/3 + x/4;", a=1)
    assert np.array_equal(s.orbit([0.1, 0.2], 0.1, 50).x, t.orbit([0.1, 0.2], 0.1, 50).x)


def test_what_is_found_is_proved_and_in_formulas():
    s = kahan.System("xdot = y; ydot = 6*x^2 - a;")
    found = s.discover()
    assert list(found.integrals) == [part["name"] for part in found.found if part["kind"] == "integral"]
    assert found["integrals"] == found.integrals and " _of = " not in repr(found) and len(found) == len(list(found))
    assert found.claimed.integrals == found.integrals and str(found.brackets["P1"]["x", "y"]) == "-(1 - 12*eps^2*x)"
    claimed = found.claimed(a="1/2")
    assert np.ptp(claimed.orbit([0, 0.1], 0.05, 1000).integrals["H1"]) < 1e-13
    (integral,) = found.integrals.values()
    assert "eps^2" in str(integral) and r"\varepsilon" in integral.latex
    assert integral.name in s._repr_latex_()
    assert found.densities
    for given in ({"a": 1}, {"a": "1/2"}):
        fixed = kahan.System("xdot = y; ydot = 6*x^2 - a;", **given).discover()
        assert "H1" in fixed.integrals and "H1" in fixed.claimed.orbit([0, 0.1], 0.05, 10).integrals
    assert kahan.catalog.lv.discover(eps=1).claimed.integrals


def test_questions_answer_by_the_names_of_the_command():
    s = kahan.catalog.lv
    observed = s.observe([0.5, 1.25], 0.05, 2000)
    assert len(observed.lyapunov) == 2 and observed.escaped is None
    with pytest.raises(AttributeError, match="it has .*lyapunov"):
        observed.lyapunow
    section = s.section([0.5, 1.25], 0.05, 5000, "y - 1")
    assert section.x.shape == (len(section.t), 2) and len(section) > 10
    assert np.abs(section.x[:, 1] - 1).max() < 1e-12
    assert s.heights([Fraction(1, 2), Fraction(5, 3)], "1/7", 20).growth in ("quadratic", "exponential", "linear", "undecided")
    assert kahan.catalog.e9.scan({"xi": (-1, 1, 3)}, seconds=5).points


def test_objects_travel():
    s = kahan.catalog.euler(a1=1, a2=-3, a3=2)
    again = pickle.loads(pickle.dumps(s))
    x = np.array([1.0, 2.0, 3.0])
    assert np.array_equal(again.step(x, 0.1), s.step(x, 0.1)) and again.parameters == s.parameters
    with ThreadPoolExecutor(4) as pool:
        ends = list(pool.map(lambda k: s.orbit(x, 0.01, 2000 + k % 2).x[2000], range(20)))
    assert all(np.array_equal(end, ends[0]) for end in ends)


def test_singular_steps_are_said():
    s = kahan.catalog.e6
    with pytest.raises(kahan.SingularStep):
        s.try_step([0.5, 0.0, 0.5], 1.0)
    assert not np.isfinite(s.step([0.5, 0.0, 0.5], 1.0)).all()


def test_the_catalog_knows_its_names():
    assert "e6" in dir(kahan.catalog) and kahan.catalog.e6.name == "e6"
    with pytest.raises(AttributeError, match="did you mean `euler`"):
        kahan.catalog.eulr
