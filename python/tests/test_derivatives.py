"""Tests derivatives of orbits with respect to parameters, first values and eps."""

from fractions import Fraction

import numpy as np
import pytest

import kahan

PREY = "xdot = a*x - b*x*y; ydot = c*x*y - d*y;"
LORENZ = "xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;"
DIVIDED = "xdot = (y - x)*(x + a)/b; ydot = x/(a + b) - x*y;"
RING = "".join(f"x{i}dot = k*x{(i + 4) % 5}*x{(i + 1) % 5} - m*x{i} - x{i}*x{(i + 2) % 5};" for i in range(5))

FIELDS = {
    "prey": (PREY, {"a": "3/2", "b": "3/4", "c": "1/2", "d": "5/4"}, [1.25, 0.5]),
    "lorenz": (LORENZ, {"s": 3, "r": 2, "b": "5/8"}, [0.5, -0.25, 0.375]),
    "divided": (DIVIDED, {"a": "1/4", "b": 3}, [0.5, 0.75]),
    "ring": (RING, {"k": "3/4", "m": "1/8"}, [0.25, 0.5, 0.375, 0.625, 0.125]),
}


def shifted(text, values, x, eps, name, by):
    """Returns the field, the point and eps, after adding `by` to the quantity called `name`."""
    values = {known: Fraction(value) + (by if known == name else 0) for known, value in values.items()}
    s = kahan.System(text, **values)
    x = [Fraction(value) + (by if known == name else 0) for known, value in zip(s.variables, x)]
    return s, x, Fraction(eps) + (by if name == "eps" else 0)


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("name", FIELDS)
def test_derivatives_are_those_of_differences_in_32_digits(name, order):
    """Compares with differences over h = 2^-40, which err by h²/6 f''', or 1e-25, and by 1e-18. The
    rounding of 200 steps of up to 17 stages adds up to 1e-14; the largest error was 1.3e-14."""
    text, values, x = FIELDS[name]
    s, eps, steps = kahan.System(text, **values), Fraction(1, 128), 200
    names = [*s.parameters, *s.variables, "eps"]
    o = s.orbit(x, eps, steps, order=order, derivatives=names)
    h = Fraction(1, 2**40)
    for by in names:
        ends = []
        for sign in (1, -1):
            moved, start, at = shifted(text, values, x, eps, by, sign * h)
            ends.append(moved.orbit(start, at, steps, order=order, scalar="dd"))
        above, below = ends
        expected = ((above.x - below.x) + (above.x_low - below.x_low)) / float(2 * h)
        assert o.derivatives[by].shape == o.x.shape == (steps + 1, len(x))
        assert abs(o.derivatives[by] - expected).max() <= 1e-13 * abs(expected).max(), by


def test_derivatives_are_those_of_differences_in_50_digits():
    """Compares with mpmath: differences over 1e-20 in 60 digits have an error of 1e-40. The bound
    allows for the rounding of 100 steps."""
    mpmath = pytest.importorskip("mpmath")
    text, values, x = FIELDS["lorenz"]
    eps, steps = 0.01, 100
    with mpmath.workdps(60):

        def orbit(s, r, b, x, y, z, eps):
            def f(point):
                x, y, z = point
                return mpmath.matrix([s * (y - x), x * (r - z) - y, x * y - b * z])

            point, rows = mpmath.matrix([x, y, z]), []
            for _ in range(steps):
                # Central differences of a quadratic f are exact.
                units = [mpmath.matrix([int(i == j) for i in range(3)]) for j in range(3)]
                slopes = [(f(point + unit) - f(point - unit)) / 2 for unit in units]
                A = mpmath.matrix(3, 3)
                for i in range(3):
                    for j in range(3):
                        A[i, j] = int(i == j) - eps * slopes[j][i]
                point = point + 2 * eps * mpmath.lu_solve(A, f(point))
                rows.append(point)
            return rows

        exact = [mpmath.mpf(Fraction(value).numerator) / Fraction(value).denominator for value in values.values()]
        at = [*exact, *map(mpmath.mpf, x), mpmath.mpf(eps)]
        names, h = [*values, "x", "y", "z", "eps"], mpmath.mpf("1e-20")
        found = kahan.System(text, **values).orbit(x, eps, steps, derivatives=names).derivatives
        for k, name in enumerate(names):
            above, below = (orbit(*[value + sign * h * (j == k) for j, value in enumerate(at)]) for sign in (1, -1))
            expected = np.array([[float(d / (2 * h)) for d in p - q] for p, q in zip(above, below)])
            assert abs(found[name][1:] - expected).max() <= 1e-13 * max(1, abs(expected).max()), name


@pytest.mark.parametrize("settings", [{}, {"order": 4}, {"order": 8}, {"compensated": True}, {"order": 6, "compensated": True},
                                      {"scalar": "f32"}, {"every": 7}, {"every": 1000}])
@pytest.mark.parametrize("name", FIELDS)
def test_points_keep_their_bits(name, settings):
    text, values, x = FIELDS[name]
    s = kahan.System(text, **values)
    alone = s.orbit(x, 0.01, 500, **settings)
    with_them = s.orbit(x, 0.01, 500, derivatives=["eps", s.variables[0]], **settings)
    assert (alone.x == with_them.x).all() and alone.x.dtype == with_them.x.dtype
    assert list(with_them.derivatives) == ["eps", s.variables[0]] and not alone.derivatives
    for values in with_them.derivatives.values():
        assert values.shape == alone.x.shape and values.dtype == alone.x.dtype and np.isfinite(values).all()


def test_modes_have_the_same_derivatives():
    """The modes differ by the rounding of 500 steps: a few times 1.1e-16 each, or 6e-8 in f32."""
    text, values, x = FIELDS["lorenz"]
    s = kahan.System(text, **values)
    names = ["r", "y", "eps"]
    all_rows = s.orbit(x, 0.01, 500, derivatives=names).derivatives
    for bound, settings in ((1e-12, {"every": 7}), (1e-12, {"compensated": True}), (1e-4, {"scalar": "f32"})):
        found = s.orbit(x, 0.01, 500, derivatives=names, **settings).derivatives
        for name in names:
            rows = all_rows[name][:: settings.get("every", 1)]
            assert 0 < abs(found[name] - rows).max() <= bound * abs(rows).max(), (name, settings)


def test_a_pole_ends_an_orbit_and_its_derivatives():
    """Compares with the exact orbit of Kahan's map of x' = a x², x_k = x/(1 - 2 k eps a x)."""
    s = kahan.System("xdot = a*x^2;", a=3)
    x, eps = 0.5, 1 / 64
    o = s.orbit([x], eps, 100, derivatives=["x", "a", "eps"])
    alone = s.orbit([x], eps, 100)
    assert (o.ended, o.steps, len(o.x)) == (alone.ended, alone.steps, len(alone.x))
    k = np.arange(22)[:, None]
    root = 1 - 2 * k * eps * 3 * x
    # The factor 1 - 2 k eps a x falls to 1/16, and so enlarges rounding errors by 256, to 6e-13.
    for name, expected in (("x", root**-2), ("a", 2 * k * eps * x**2 * root**-2), ("eps", 6 * k * x**2 * root**-2)):
        assert o.derivatives[name].shape == o.x.shape
        np.testing.assert_allclose(o.derivatives[name][:21], expected[:21], rtol=1e-12)
    ends = kahan.System("xdot = x^2;").orbit([1.0], 0.05, 50, derivatives="x")
    assert ends.ended == "range" and len(ends.derivatives["x"]) == len(ends.x) == ends.steps + 1 < 51
    assert s.orbit([x], eps, 0, derivatives="x").derivatives["x"].tolist() == [[1.0]]


def test_an_orbit_goes_on_where_its_derivatives_overflow():
    o = kahan.System("xdot = x;").orbit([0.0], 0.5, 700, derivatives=["x"])
    assert o.ended == "complete" and (o.x == 0).all()
    # The rounding errors of 640 steps are about 7e-14.
    np.testing.assert_allclose(o.derivatives["x"][:640, 0], 3.0 ** np.arange(640), rtol=1e-13)
    assert not np.isfinite(o.derivatives["x"][-1, 0])


def test_other_names_and_orbits_are_refused():
    s = kahan.System(PREY, a=1, b=1, c=1, d=1)
    for call in (s.orbit, s.ensemble):
        x = [1.0, 2.0] if call == s.orbit else [[1.0, 2.0]]
        with pytest.raises(ValueError, match="derivatives: there is no parameter or variable `q`; there is x, y, a, b, c, d, eps"):
            call(x, 0.01, 10, derivatives=["a", "q"])
    for settings in ({"scalar": "dd"}, {"scalar": "exact"}, {"method": "rk4"}, {"projective": True}):
        with pytest.raises(ValueError, match="derivatives are for orbits of Kahan's map in f64 and f32"):
            s.orbit([1, 2], "1/100", 3, derivatives=["a"], **settings)
    with pytest.raises(ValueError, match="observers"):
        s.ensemble([[1.0, 2.0]], 0.01, 10, derivatives=["a"], observe=["lyapunov"])
    lifted = kahan.System("xdot = v; vdot = -sin(x);", lift=True)
    with pytest.raises(ValueError, match="lifted"):
        lifted.orbit([0, 1], 0.01, 10, derivatives=["x"])


@pytest.mark.parametrize("order", [2, 4])
def test_an_ensemble_has_the_derivatives_of_its_orbits(order):
    """An ensemble may differ from its orbits by rounding, which derivatives enlarge. Rounding of
    200 steps of up to 5 stages is 1e-13, or 1e-4 in single precision."""
    random = np.random.default_rng(1)
    count = 37
    points, rates = random.uniform(0.5, 2, (count, 2)), random.uniform(0.5, 1.5, count)
    halves = random.uniform(0.005, 0.02, count)
    s = kahan.System(PREY, b=1, c="1/2", d=1)
    names = ["y", "a", "eps", "d"]
    r = s.ensemble(points, halves, 200, params={"a": rates}, order=order, derivatives=names)
    alone = s.ensemble(points, halves, 200, params={"a": rates}, order=order)
    assert (r.x == alone.x).all() and list(r.derivatives) == names
    for k in range(count):
        o = s(a=rates[k]).orbit(points[k], halves[k], 200, order=order, derivatives=names, every=200)
        for name in names:
            assert r.derivatives[name].shape == (count, 2)
            np.testing.assert_allclose(r.derivatives[name][k], o.derivatives[name][-1], rtol=1e-11, atol=1e-11)
    one = s(a=1).ensemble(points, 0.01, 200, derivatives=names, threads=1)
    many = s(a=1).ensemble(points, np.full(count, 0.01), 200, params={"d": np.ones(count)}, derivatives=names, threads=3)
    for name in names:
        np.testing.assert_allclose(one.derivatives[name], many.derivatives[name], rtol=1e-11, atol=1e-11)
    single = s(a=1).ensemble(points.astype(np.float32), 0.01, 200, derivatives=names)
    assert single.derivatives["y"].dtype == np.float32
    np.testing.assert_allclose(single.derivatives["y"], one.derivatives["y"], rtol=1e-3, atol=1e-3)


def test_ended_trajectories_have_no_derivatives():
    s = kahan.System("xdot = a*x^2;", a=1)
    r = s.ensemble([[1.0], [-1.0]], 0.05, 11, derivatives=["x", "a"])
    assert r.ended.tolist() == ["range", "complete"]
    for values in r.derivatives.values():
        assert np.isnan(values[0]).all() and np.isfinite(values[1]).all()


def test_a_field_at_other_values_is_the_one_read_anew():
    """Checks that fields with shared machine code have the same bits as fields read again."""
    text, values, x = FIELDS["divided"]
    s = kahan.System(text, **values)
    s.orbit(x, 0.01, 200, derivatives=["a", "b"])
    for a in ("1/3", 0.7, 5):
        shared, anew = s(a=a), kahan.System(text, **(values | {"a": a}))
        assert shared == anew and shared.parameters == anew.parameters
        found, expected = (one.orbit(x, 0.01, 200, derivatives=["b", "a"]) for one in (shared, anew))
        assert (found.x == expected.x).all()
        for name in ("a", "b"):
            assert (found.derivatives[name] == expected.derivatives[name]).all()
    with pytest.raises(TypeError, match="`q`"):
        s(q=1)


@pytest.mark.parametrize("n", [3, 12])
def test_fields_of_arrays_have_derivatives(n):
    """Compares with differences over 1e-6, which err by 5e-9 because of rounding in 50 steps."""
    random = np.random.default_rng(n)
    s = kahan.System.from_arrays(B=random.normal(size=(n, n)) - 2 * np.eye(n), Q=random.normal(size=(n, n, n)) / n,
                                 parameters={"q": {"B": -np.eye(n)}}, q=1)
    x = random.uniform(-0.5, 0.5, n)
    o = s.orbit(x, 0.01, 50, derivatives=[*s.variables, "q"])
    for k, name in enumerate(s.variables):
        h = 1e-6 * np.eye(n)[k]
        expected = (s.orbit(x + h, 0.01, 50).x - s.orbit(x - h, 0.01, 50).x) / 2e-6
        np.testing.assert_allclose(o.derivatives[name], expected, atol=1e-8)
    expected = (s(q=1 + 1e-6).orbit(x, 0.01, 50).x - s(q=1 - 1e-6).orbit(x, 0.01, 50).x) / 2e-6
    np.testing.assert_allclose(o.derivatives["q"], expected, atol=1e-8)
