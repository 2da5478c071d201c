"""Checks that the message of each refusal tells what to write instead."""

import inspect
import pickle
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import kahan
from kahan._system import Family

E6 = kahan.catalog.e6
CHAIN = "for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }"
RATE = kahan.System("xdot = rate*y; ydot = x;", rate=1)

REFUSED = [
    (lambda: kahan.System(CHAIN, a=1), kahan.FieldError, r"(?s)`sites=8` in Python.*`kahan.Lattice`"),
    (lambda: E6.ensemble([0, 1, 0], 0.1, 5), ValueError, r"points: the shape \(trajectories, 3\).* this is \(3,\)"),
    (lambda: E6.orbit([[0, 1, 0]], 0.1, 5), ValueError, r"x: the shape \(3,\) is needed.* this is \(1, 3\)"),
    (lambda: E6.step([0, 1], 0.1), ValueError, r"x: the shape \(…, 3\).* this is \(2,\)"),
    (lambda: E6.rhs()(0, np.ones((5, 3))), ValueError, r"y: the shape \(3, points\).* this is \(5, 3\)"),
    (lambda: E6.diagram({"eps": (0.1, 0.2, 3)}, np.zeros((3, 3)), plane="x"), TypeError, "x: one point is needed"),
    (lambda: E6.section([1, 2, 3], 0.1, 5, "x=0"), ValueError, "write `x`"),
    (lambda: E6.step([1, 2, 3], [0.1]), TypeError, "eps: a number is needed, and not list"),
    (lambda: E6.step([1, 2, 3], "a"), ValueError, "eps: `a` is not an exact number"),
    (lambda: E6.orbit([1, 2, 3], (0, 10), 0.1), TypeError, "steps: a whole number is needed, and not 0.1"),
    (lambda: E6.orbit([1, 2, 3], (0, 10), 5), TypeError, "eps: a number is needed"),
    (lambda: E6.orbit([1, float("nan"), 3], 0.1, 5), ValueError, "x: NaN is no number"),
    (lambda: E6.orbit([1, 2, 3], float("nan"), 5), ValueError, "eps: NaN is no number"),
    (lambda: E6.orbit([1, 2, 3], steps=5), TypeError, "give eps, half the time step, or dt"),
    (lambda: E6.orbit([1, 2, 3], h=0.1, steps=5), TypeError, "`h`; write dt, the time step, or eps, half of it"),
    (lambda: E6.orbit([1, 2, 3], 0.1, 5, dt=0.2), TypeError, "eps and dt are both given; dt = 2 eps"),
    (lambda: E6.step([1, 2, 3], 0.1, dt=0.2), TypeError, "eps and dt are both given; dt = 2 eps"),
    (lambda: E6.step([1, 2, 3]), TypeError, "give eps, half the time step, or dt"),
    (lambda: E6.step([1, 2, 3], dt="a"), ValueError, "dt: `a` is not an exact number"),
    (lambda: E6.orbit([1, 2, 3], dt="a", steps=5), ValueError, "dt: `a` is not a number"),
    (lambda: E6.orbit([1, 2, 3], 0.1), TypeError, "steps is missing: give a whole number"),
    (lambda: E6.section([1, 2, 3], 0.1, 5), TypeError, "plane is missing: give a formula"),
    (lambda: E6.ensemble([[1, 2, 3]], 0.1, 5, threads=-1), ValueError, "threads: -1 is below 0"),
    (lambda: RATE.discover(degree=2.5), TypeError, "degree: a whole number"),
    (lambda: RATE.scan({"rate": np.linspace(0, 1, 3)}), TypeError, r"over: rate is \(low, high, count\), or text"),
    (lambda: RATE.chart({"rate": (0, 1, 2.5)}, [1, 1], 0.1), TypeError, "rate: a whole number"),
    (lambda: RATE.chart({"rate": (0, 1, 5)}, [1, 1], 0.1, color="drift"), ValueError, "color: this field claims no integral"),
    (lambda: RATE(rate=Decimal("1e999999")), ValueError, "decimal exponents"),
]


@pytest.mark.parametrize("call, kind, words", REFUSED)
def test_mistakes_are_told(call, kind, words):
    with pytest.raises(kind, match=words):
        call()


def test_what_sympy_says_of_numbers_is_exact_or_refused():
    sympy = pytest.importorskip("sympy")
    x, y, t = sympy.symbols("x y t")
    for irrational in (sympy.pi, sympy.E, sympy.I, sympy.sqrt(2), sympy.sin(1), sympy.oo):
        with pytest.raises(ValueError, match="coefficients are exact; put a symbol in its place"):
            kahan.System({x: y, y: -irrational * x})
    with pytest.raises(ValueError, match="nor a float; give a nearby one, as 1.41421356"):
        RATE(rate=sympy.sqrt(2))
    assert RATE(rate=sympy.Float("0.1")).parameters == RATE(rate=Decimal("0.1")).parameters == {"rate": Fraction(1, 10)}
    moving = sympy.Function("x")(t)
    for equations in ({moving: y, y: x}, {x: y, y: moving}):
        with pytest.raises(ValueError, match=r"x\(t\) is a function; write symbols"):
            kahan.System(equations)


def test_numbers_come_as_floats_fractions_and_text():
    wanted = E6.orbit([0.5, 0.25, 1], 0.1, 10).x[-1]
    for x in ([Fraction(1, 2), "1/4", 1], np.array([0.5, 0.25, 1])):
        for eps in (0.1, Fraction(1, 10), "1/10", np.float64(0.1), np.array(0.1)):
            assert np.array_equal(E6.orbit(x, eps, 1e1).x[-1], wanted)
            assert np.array_equal(E6.ensemble([x], eps, 10.0).x[0], wanted)
            assert np.array_equal(E6.step(x, eps), E6.step([0.5, 0.25, 1], 0.1))
    a = kahan.System("xdot = a*y; ydot = x;")
    assert np.isnan(a.ensemble([[1, 2]], 0.1, 5, params={"a": [np.nan]}).x).all()
    assert kahan.System("xdot = sites*y; ydot = x;")(sites=2).parameters == {"sites": 2}


def test_everything_in_the_catalog_can_be_looked_at():
    families = [value for _, value in inspect.getmembers(kahan.catalog) if isinstance(value, Family)]
    assert kahan.System(CHAIN).lattice(10, 0.1).sites == kahan.System(CHAIN, sites=5).lattice(10, 0.1).sites == 10
    assert "kdv" in [family.name for family in families]
    for family in families:
        chain = family(sites=8)
        of_family = {name.rstrip("01234567") for name in chain.parameters}
        lattice = family.lattice(10, "1/10", **dict.fromkeys(of_family, 1))
        assert len(chain.variables) == 8 * len(lattice.arrays)


def test_an_end_is_said():
    crossings = E6.section([1, 2, 3], 0.01, 10**5, "x - y", direction="both", crossings=5)
    assert len(crossings) == 5 and crossings.ended == "stopped" and "stopped after step" in repr(crossings)
    assert E6.section([1, 2, 3], 0.01, 10, "x - y").ended == "complete"
    beyond = kahan.System("xdot = x^2 + 1; ydot = 1;").section([0.1, 0], 0.05, 60, "x", direction="both")
    assert (len(beyond), beyond.jumps, crossings.jumps) == (1, 2, 0) and "1 crossings, 2 jumps>" in repr(beyond)
    assert "no finite point after step" in repr(kahan.System("xdot = x^2;").orbit([1.0], 0.25, 100))


def test_integrals_are_those_that_a_method_keeps():
    flow = E6.orbit([1, 2, 3], 0.05, 20, method="flow").integrals["H"]
    assert np.ptp(flow) < 1e-12 * abs(flow[0])
    for asked in ({"order": 4}, {"order": 8}, {"order": 8, "scalar": "dd"}, {"method": "rk4"}):
        orbit = E6.orbit([1, 2, 3], 0.01, 20, **asked)
        assert orbit.integrals["H"][0] == flow[0] == 7 and 0 < np.ptp(orbit.integrals["H"]) < 1e-5
    (four,) = E6.ensemble([[1, 2, 3]], 0.01, 20, order=4, observe="drift").drift_H
    assert four == np.abs(E6.orbit([1, 2, 3], 0.01, 20, order=4).integrals["H"] - 7).max() / 7


def test_integrals_of_one_eps_are_those_of_its_orbits():
    found = kahan.System("xdot = y; ydot = 6*x^2 - a;").discover(eps="1/10").claimed(a=1)
    for scalar in ("f64", "dd", "exact"):
        (H,) = found.orbit([0, "1/10"], 0.1, 5, scalar=scalar).integrals.values()
        assert np.ptp(H.astype(float)) < 1e-12
        assert not found.orbit([0, "1/10"], 0.2, 5, scalar=scalar).integrals


def test_values_stand_in_formulas():
    sympy = pytest.importorskip("sympy")
    s = kahan.System("xdot = y; ydot = 6*x^2 - a;").discover().claimed(a="-3/10")
    for formula in (s.integrals["H1"], *s.densities.values(), s.brackets["P1"]["x", "y"]):
        assert "a" not in str(formula) and not formula.sympy().has(sympy.Symbol("a"))
    generic = kahan.System("xdot = y; ydot = 6*x^2 - a;").discover().integrals["H1"].sympy()
    assert sympy.simplify(s.integrals["H1"].sympy() - generic.subs("a", sympy.Rational(-3, 10))) == 0


def test_a_discovery_says_how_far_it_looked():
    found = kahan.System("xdot = 10*(y - x); ydot = x*(28 - z) - y; zdot = x*y - 8/3*z;").discover(seconds=1)
    assert "degree ≤" in repr(found) and found.sentences[-1] in repr(found)


PROGRESS = [
    lambda: E6.orbit([0.1, 0.2, 0.3], 0.001, 10**8, every=10**8, progress=True),
    lambda: E6.ensemble(np.full((2000, 3), 0.1), 0.001, 10**5, threads=1, progress=True),
    lambda: E6.ensemble(np.full((500, 3), 0.1), 0.001, 10**5, observe="sali", threads=1, progress=True),
    lambda: E6.observe([0.1, 0.2, 0.3], 0.001, 10**7, progress=True),
]


@pytest.mark.parametrize("work", PROGRESS)
def test_progress_is_shown_or_what_it_needs(work, capsys, monkeypatch):
    pytest.importorskip("tqdm")
    work()
    assert "steps: " in capsys.readouterr().err
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.warns(UserWarning, match="pip install tqdm"):
        E6.orbit([1, 2, 3], 0.1, 3, progress=True)


def test_a_missing_name_says_which_there_are() -> None:
    o = kahan.System("xdot = a*y; ydot = -a*x; integral H = x^2 + y^2;", a=1).orbit([1, 0], 0.1, 3, derivatives=["a"])
    for orbit in (o, pickle.loads(pickle.dumps(o))):
        with pytest.raises(KeyError, match=r"no claimed integral `E`; there is H; `s.discover\(\).claimed`"):
            orbit.integrals["E"]
        with pytest.raises(KeyError, match=r'no derivative `x`; there is a; ask for it by derivatives=\["x"\]'):
            orbit.derivatives["x"]
        assert orbit.integrals.get("E") is None and list(orbit.derivatives) == ["a"]
    many = o.system.ensemble([[1, 0]], 0.1, 3)
    with pytest.raises(KeyError, match="no derivative `a`; there is none"):
        many.derivatives["a"]


def test_a_new_variable_without_a_value_is_named() -> None:
    m = kahan.System("xdot = -v*x/(k + x);", lift=True, v=1, k=1)
    with pytest.raises(ValueError, match=r"the new variable \w+ = 1/\(x \+ k\) has no value there"):
        m.orbit([-1], 0.05, 5)
    with pytest.raises(ValueError, match="x: NaN is no number"):
        m.orbit([float("nan")], 0.05, 5)


def test_ensembles_without_starts() -> None:
    s = kahan.System("xdot = a*x;")
    for eps, a in ((0.1, np.zeros(0)), (np.zeros(0), 1), (np.zeros(0), np.zeros(0))):
        assert s.ensemble(np.zeros((0, 1)), eps, 3, params={"a": a}).x.shape == (0, 1)
    with pytest.raises(TypeError, match=r"points is missing: .* s.ensemble\(\[\[1\]\], "):
        s.ensemble(dt=0.1, steps=3, params={"a": 1})
    with pytest.raises(TypeError, match=r"points is missing: .* s.ensemble\(\[s.start\], "):
        kahan.System("x' = x; init x=1").ensemble(dt=0.1, steps=3)


def test_packages_that_are_not_there_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    o = kahan.System("xdot = y; ydot = -x;").orbit([1, 0], 0.1, 3)
    for package, how, call in (("pandas", "pip install pandas", o.to_pandas), ("sympy", r"kahan\[sympy\]", o.system.map.sympy),
                               ("sympy", r"kahan\[sympy\]", o.system.map[0].sympy), ("matplotlib", r"kahan\[plot\]", o.plot)):
        with monkeypatch.context() as patch, pytest.raises(ImportError, match=f"the package {package} is needed .*{how}"):
            patch.setitem(sys.modules, package, None)
            call()
