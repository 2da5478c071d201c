"""Tests what a user does with a field: reading the field, its formulas, and questions about it."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

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
    assert s.parameters == {"a": Fraction(1, 10), "b": None} == s(a=np.float32(0.1)).parameters
    assert s(b="1/3").parameters["b"] == Fraction(1, 3)
    with pytest.raises(TypeError, match="no parameter"):
        kahan.System("xdot = a*y; ydot = x;", c=1)
    with pytest.raises(ValueError, match=r"b is missing; .* s\(b=1\)"):
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
    field = kahan.System("Idot = ϕ; ϕdot = I^2 - φ;").field.sympy()
    assert {symbol.name for symbol in field.free_symbols} == {"I", "ϕ", "φ"}


def test_formulas_are_functions_of_points():
    s = kahan.System("xdot = y; ydot = 6*x^2 - a;", a=1).discover().claimed
    orbit = s.orbit([0, 0.1], 0.05, 100)
    H, (rho,), P = s.integrals["H1"], s.densities.values(), s.brackets["P1"]
    assert np.abs(H(orbit.x, 0.05) - orbit.integrals["H1"]).max() < 1e-14
    assert np.allclose(s.map(orbit.x[:-1], 0.05), orbit.x[1:], rtol=1e-13)
    found = s.evaluate([1, "1/2"], "1/3", exact=True)
    at = ([1, "1/2"], "1/3")
    assert (H(*at), rho(*at), s.det_A(*at)) == (found.integrals["H1"], found.density, found.det_A)
    assert (P(*at) == found.brackets["P1"]).all() and (s.jacobian(*at) == found.jacobian).all()
    assert str(P["x", "x"]) == "0" and P["y", "x"](*at) == -P["x", "y"](*at)
    # Each point may have its own eps and its own values of parameters.
    free = kahan.System("xdot = y; ydot = 6*x^2 - a;")
    assert (free.map(orbit.x, np.full(101, 0.05), a=np.ones(101)) == s.map(orbit.x, 0.05)).all()
    with pytest.raises(TypeError, match="depends on a: add a=…"):
        free.map(orbit.x, 0.05)
    with pytest.raises(TypeError, match="a is 1 in this formula"):
        kahan.System("xdot = y; ydot = 6*x^2 - a;", a=1).map(orbit.x, 0.05, a=2)
    assert s.A(np.float32(orbit.x), 0.05).dtype == np.float32 and s.A(orbit.x, 0.05).shape == (101, 2, 2)
    assert s.field(orbit.x[0]).tolist() == s.evaluate(orbit.x[0], 1).field.tolist()
    assert not np.isfinite(s.map([1 / 12, 0], 1)).all()
    with pytest.raises(TypeError, match="depends on eps: add eps=…"):
        H(orbit.x)
    with pytest.raises(TypeError, match="no parameter `b`"):
        H(orbit.x, 0.05, b=1)
    with pytest.raises(ValueError, match="2 coordinates"):
        H([1, 2, 3], 0.05)
    with pytest.raises(KeyError, match="no variable `z`"):
        P["x", "z"]
    # Claims may use constants and earlier claims. Names may be keywords of Python.
    t = kahan.System("const k = 1/2; xdot = lambda; lambdadot = -k*x; integral H = 0.25*x^2 + lambda^2/2; integral K = H^2 + k*H^-1;")
    assert t.integrals["K"](["1", 2]) == Fraction(9, 4) ** 2 + Fraction(1, 2) / Fraction(9, 4)


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
    assert found["integrals"] == found.integrals and "  integral H1 = (" in repr(found) and len(found) == len(list(found))
    assert found.claimed.integrals == found.integrals and str(found.brackets["P1"]["x", "y"]) == "1 - 12*eps^2*x"
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
    assert isinstance(observed.lyapunov, float) and observed.spectrum.shape == (2,) and observed.escaped is None
    assert observed.spectrum_errors.shape == (2,) and observed.lyapunov_error > 0
    for steps in (1, 3, 2000):
        one = s.observe([0.5, 1.25], 0.05, steps)
        many = s.ensemble([[1, 2], [0.5, 1.25]], 0.05, steps, observe=["spectrum", "lyapunov"])
        assert many.lyapunov.shape == (2,) and many.lyapunov[1] == one.lyapunov
        assert many.spectrum.shape == (2, 2) and (many.spectrum[1] == one.spectrum).all()
        assert (np.diff(many.spectrum) <= 0).all() and (many["spectrum_2"] == many["spectrum"][:, 1]).all()
        assert list(many.observed) == ["spectrum", "lyapunov", "lyapunov_error"]
    with pytest.raises(AttributeError, match="`lyapunow`; did you mean `lyapunov`"):
        observed.lyapunow
    section = s.section([0.5, 1.25], 0.05, 5000, "y - 1")
    assert section.x.shape == (len(section.t), 2) and len(section) > 10
    assert np.abs(section.x[:, 1] - 1).max() < 1e-12
    assert s.heights([Fraction(1, 2), Fraction(5, 3)], "1/7", 20).growth in ("quadratic", "exponential", "linear", "undecided")
    assert kahan.catalog.e9.scan({"xi": (-1, 1, 3)}, seconds=5).points


SLIPS = [
    (lambda s: s.orbit([1, 2], 0.1, step=10), "System.orbit: there is no argument `step`; did you mean `steps`"),
    (lambda s: s.chart({"x": (0, 1, 3)}, [1, 1], 0.1, colour="fli"), "did you mean `color`"),
    (lambda s: s.section([1, 2], 0.1, 10, "x", qqqqqqqqq="rising"), "there is x, eps, steps, plane"),
    (lambda s: s.ensemble([[1, 2]], 0.1, 5, params={"rat": 1}), "no parameter `rat`; did you mean `rate`"),
    (lambda s: s(rat=1), "did you mean `rate`"),
    (lambda s: kahan.System("xdot = rate*x; ydot = y;", rat=1), "did you mean `rate`"),
]


@pytest.mark.parametrize("slip, hint", SLIPS)
def test_slips_are_told_what_is_nearest(slip, hint):
    with pytest.raises(TypeError, match=hint):
        slip(kahan.System("xdot = rate*y; ydot = x;", rate=1))


def test_errors_of_a_call_that_is_spelled_right_stay():
    with pytest.raises(TypeError, match="steps"):
        kahan.catalog.e6.orbit([1, 2, 3], 0.1)
    with pytest.raises(TypeError, match="complex"):
        kahan.catalog.e6.step(np.array([1j, 2, 3]), eps=0.1)
    with pytest.raises(TypeError, match="plane: text"):
        kahan.catalog.e6.section([1, 2, 3], 0.1, 10, 2)
    with pytest.raises(ValueError, match="claims no integral"):
        kahan.System("xdot = y; ydot = -x;").ensemble([[1, 2]], 0.1, 10, observe="drift")
    with pytest.raises(ValueError, match="no direction `risng`; did you mean `rising`"):
        kahan.catalog.e6.section([1, 2, 3], 0.1, 10, "x", direction="risng")


KIRCHHOFF = """
    m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3; m3dot = 0;
    p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);
"""


def test_bases_are_functions_of_orbits():
    s = kahan.System(KIRCHHOFF, a1=1, a3=2, b1=3, b3=5)
    found = s.discover()
    assert found.bases and all(basis.outcome == "proved-mod-p" for basis in found.bases)
    again = pickle.loads(pickle.dumps(found)).bases
    for basis, other in zip(found.bases, again):
        assert isinstance(basis, kahan.Basis) and all(isinstance(name, str) for name in basis.monomials)
        exact = s.orbit([1, "1/2", "1/3", "2/3", "3/4", 1], "1/5", basis.points + 2, scalar="exact")
        constants, _ = basis.coefficients(exact.x)
        assert len(constants) == 4 and all((row == constants[0]).all() for row in constants)
        # The monomials satisfy the relation on every row.
        assert not (basis.monomial_values(exact.x) @ constants[0]).any()
        x = exact.x.astype(float)
        near, condition = basis.coefficients(x)
        scale = np.abs(constants[0].astype(float)).max()
        assert np.abs(near - constants[0].astype(float)).max() <= 1e-15 * condition.max() * scale * 100
        assert np.array_equal(other.coefficients(x)[0], near)
        values, one = basis.integral_values(s, x[:2], 0.2), basis.integral_values(s, x[0], 0.2)
        assert list(values) == list(one) == basis.integrals
        for name, value in values.items():
            assert value.shape == (2,) and one[name].shape == () and value[0] == one[name]
        turned = dict(reversed(list(zip(s.variables, x[0]))))
        assert basis.integral_values(s, turned, 0.2) == one
        for call in (basis.monomial_values, basis.coefficients):
            with pytest.raises(TypeError, match=f"x: numbers are taken in order here, .* names {', '.join(turned)}"):
                call(turned)
        with pytest.raises(ValueError, match=f"{basis.points} consecutive points"):
            basis.coefficients(x[: basis.points - 1])


def test_objects_travel():
    s = kahan.catalog.euler(a1=1, a2=-3, a3=2)
    again = pickle.loads(pickle.dumps(s))
    x = np.array([1.0, 2.0, 3.0])
    assert np.array_equal(again.step(x, 0.1), s.step(x, 0.1)) and again.parameters == s.parameters
    assert again == s and hash(again) == hash(s) and s(a1="2/2") == s != s(a1=2)
    for call, given in ((s.rhs(), (0, x)), (s.rhs().jacobian, (0, x)), (s.integral_values, (x, 0.1)), (s.integral_functions(0.1)["H"], (x,)), (s.integrals["H"], (x, 0.1))):
        assert np.array_equal(pickle.loads(pickle.dumps(call))(*given), call(*given))
    with ThreadPoolExecutor(4) as pool:
        ends = list(pool.map(lambda k: s.orbit(x, 0.01, 2000 + k % 2).x[2000], range(20)))
    assert all(np.array_equal(end, ends[0]) for end in ends)


def test_singular_steps_are_said():
    s = kahan.catalog.e6
    with pytest.raises(kahan.SingularStep):
        s.try_step([0.5, 0.0, 0.5], 1.0)
    assert not np.isfinite(s.step([0.5, 0.0, 0.5], 1.0)).all()
    with pytest.raises(kahan.SingularStep, match="point 1"):
        s.try_step([[0.5, 0.25, 0.5], [0.5, 0.0, 0.5]], 1.0)


def test_try_step_keeps_its_promise_where_step_loses_digits():
    s, x, eps = kahan.catalog.e6, [0.45, -0.025, 0.61], 1e9
    exact = np.array(s.evaluate(x, eps, exact=True).x_next, dtype=object)
    errors = [max(abs(Fraction(a) - b) for a, b in zip(way(x, eps), exact)) / max(map(abs, exact)) for way in (s.step, s.try_step)]
    assert errors[1] <= 64 * Fraction(1, 2**53) and errors[0] > 100 * errors[1]
    chain = kahan.System("".join(f"x{i}dot = x{i}*x{(i + 1) % 17};" for i in range(17)))
    with pytest.raises(ValueError, match="up to 16 variables"):
        chain.try_step(np.ones(17), 0.1)


def test_help_shows_what_is_for_users():
    public = {name for name in dir(kahan.System) if not name.startswith("_")}
    undocumented = [name for name in public if not getattr(kahan.System, name).__doc__]
    assert not undocumented and not public & {"table", "points", "advance", "observed", "discovered"}
    tomllib = pytest.importorskip("tomllib")
    cargo = tomllib.loads((Path(__file__).resolve().parents[2] / "Cargo.toml").read_text())
    assert kahan.__version__ == cargo["workspace"]["package"]["version"]


def test_the_catalog_knows_its_names():
    assert kahan.System(kahan.catalog.lorenz.text).field == kahan.catalog.lorenz.field
    assert "e6" in dir(kahan.catalog) and kahan.catalog.e6.name == "e6"
    with pytest.raises(AttributeError, match="did you mean `euler`"):
        kahan.catalog.eulr


def test_a_time_step_is_twice_eps():
    s, x = kahan.catalog.e6, [0.4, -0.3, 0.2]
    assert np.array_equal(s.step(x, dt=0.1), s.step(x, 0.05))
    assert np.array_equal(s.try_step(x, dt="1/10"), s.try_step(x, "1/20"))
    # `orbit` halves a decimal exactly: half of 0.3 is 3/20.
    assert s.orbit([1, 2, 3], dt=0.3, steps=2, scalar="exact").eps == Fraction(3, 20)
    assert np.array_equal(s.orbit(x, dt=0.1, steps=9).x, s.orbit(x, 0.05, 9).x)
    points, steps = np.array([x, x]), np.array([0.1, 0.2])
    assert np.array_equal(s.ensemble(points, dt=steps, steps=9).x, s.ensemble(points, steps / 2, 9).x)
    for ask in ("evaluate", "integral_values", "periodic"):
        assert repr(getattr(s, ask)(x, dt="1/5")) == repr(getattr(s, ask)(x, "1/10"))
    assert repr(s.observe(x, dt=0.1, steps=50)) == repr(s.observe(x, 0.05, 50))
    assert np.array_equal(s.section(x, dt=0.1, steps=500, plane="x").x, s.section(x, 0.05, 500, "x").x)
    over = {"x": (0.1, 0.4, 3)}
    assert np.array_equal(s.chart(over, x, dt=0.1, steps=20).values, s.chart(over, x, 0.05, steps=20).values)
    assert s.heights([1, 2, 3], dt=1, steps=5).log_heights == s.heights([1, 2, 3], "1/2", 5).log_heights
    assert s.poles(dt=2, steps=3).patterns == s.poles(1, steps=3).patterns
    ring = kahan.System("for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }")
    state = 1 + 0.5 * np.cos(np.arange(9))
    assert np.array_equal(ring.lattice(9, dt=0.02).step(state), ring.lattice(9, 0.01).step(state))


def test_fused_steps_are_chosen_by_name():
    plain = kahan.System(E6)
    try:
        fused = kahan.System(E6, fused=True)
    except ValueError as error:
        pytest.skip(str(error))
    assert (plain.fused, fused.fused, kahan.catalog.e6(fused=True).fused) == (False, True, True)
    orbit = fused.orbit([1, 2, 3], 0.05, 300)
    assert not np.array_equal(orbit.x, plain.orbit([1, 2, 3], 0.05, 300).x)
    assert np.allclose(orbit.x[:20], plain.orbit([1, 2, 3], 0.05, 19).x, rtol=1e-13)
    assert np.array_equal(fused.step([1, 2, 3], 0.05), orbit.x[1])
    assert np.array_equal(fused.ensemble(np.array([[1.0, 2, 3]] * 5), 0.05, 300).x[4], orbit.x[-1])
    assert np.array_equal(pickle.loads(pickle.dumps(fused)).orbit([1, 2, 3], 0.05, 300).x, orbit.x)
    assert fused != plain and fused(fused=False) == plain and fused() == fused
    with_parameter = kahan.System("xdot = a*y; ydot = -x;", fused=True)
    assert with_parameter(a=2).fused and with_parameter(a=2, fused=False) == kahan.System("xdot = a*y; ydot = -x;", a=2)
    # A number for `fused` is the value of a parameter with this name.
    assert kahan.System("xdot = fused*x;", fused=2)(fused=3).parameters == {"fused": 3}
    names = [f"x{i}" for i in range(10)]
    with pytest.raises(ValueError, match="no fused steps"):
        kahan.System("".join(f"{name}dot = {name}^2 - ({' + '.join(names)})^2;" for name in names), fused=True)
