"""Tests orbits in other number types and by other methods, charts, and observed ensembles."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import kahan

E6 = kahan.catalog.e6
LORENZ = kahan.catalog.lorenz


def test_exact_orbits_are_fractions():
    orbit = E6.orbit([Fraction(1, 3), "2/5", 3], "1/7", 4, scalar="exact")
    x = [Fraction(1, 3), Fraction(2, 5), Fraction(3)]
    for row in orbit.x:
        assert row.tolist() == list(x)
        x = E6.evaluate(x, "1/7", exact=True).x_next.tolist()
    assert len(set(orbit.integrals["H"])) == 1
    assert orbit.eps == Fraction(1, 7) and orbit.t.tolist() == [Fraction(2 * n, 7) for n in range(5)]
    assert (E6.integrals["H"](orbit.x, orbit.eps) == orbit.integrals["H"]).all()


def test_double_doubles_have_what_doubles_lack():
    orbit = E6.orbit([1, 2, 3], "1/20", 50, scalar="dd")
    plain = E6.orbit([1, 2, 3], 0.05, 50)
    # Compares the first rows alone, because doubles lose digits along this unstable orbit.
    assert np.allclose(orbit.x[:10], plain.x[:10], rtol=1e-13) and 0 < np.abs(orbit.x_low).max() < 1e-15
    assert orbit.x.shape == orbit.x_low.shape == (51, 3) and (orbit["y_low"] == orbit.x_low[:, 1]).all()


def test_other_methods_are_there_to_compare_with():
    ends = {method: E6.orbit([1, 2, 3], "1/200", 100, method=method, scalar="f64").x[-1]
            for method in ("kahan", "euler", "rk4", "flow")}
    far = {method: np.abs(end - ends["flow"]).max() for method, end in ends.items()}
    assert far["rk4"] < far["kahan"] < far["euler"]
    with pytest.raises(ValueError, match="no method `eular`; did you mean `euler`"):
        E6.orbit([1, 2, 3], 0.1, 5, method="eular")


def test_projective_orbits_go_through_poles():
    orbit = kahan.catalog.e1.orbit([-1, "2/3", "5/7"], "1/2", 5, scalar="exact", projective=True)
    assert len(orbit) == 6 and float("inf") in orbit.x.ravel().tolist()


def test_charts_are_their_cells():
    start = [1.0, 1.0, 1.0]
    chart = LORENZ(s=10, b="8/3").chart({"r": (20, 30, 4), "eps": np.array([0.001, 0.002])}, start, steps=300, color="lyapunov")
    assert chart.values.shape == (4, 2)
    assert chart.axes["r"].tolist() == [20, 20 + 10 / 3, 20 + 20 / 3, 30] and chart.axes["eps"].tolist() == [0.001, 0.002]
    for i, r in enumerate(["20", "70/3", "80/3", "30"]):
        for j, eps in enumerate([0.001, 0.002]):
            alone = LORENZ(s=10, b="8/3", r=r).ensemble([start], eps, 300, observe=["lyapunov"])
            assert alone.lyapunov[0] == chart.values[i, j]
    again = LORENZ(s=10, b="8/3").chart({"r": "20:30:4", "eps": [0.001, 0.002]}, start, steps=300, color="lyapunov", threads=1)
    assert np.array_equal(again.values, chart.values)
    one = E6.chart({"x": (-1, 1, 5)}, [0, 1, 1], 0.1, color="drift_H")
    assert one.values.shape == (5,)
    with pytest.raises(ValueError, match="no column `drift_Q`; did you mean `drift_H`"):
        E6.chart({"x": (-1, 1, 5)}, [0, 1, 1], 0.1, color="drift_Q")
    with pytest.raises(TypeError):
        E6.chart({"x": (-1, 1, 5)}, [0, 1, 1])


def test_observed_ensembles_are_their_orbits():
    random = np.random.default_rng(3)
    points, eps = random.uniform(0.2, 1, (300, 3)), random.uniform(0.01, 0.05, 300)
    many = E6.ensemble(points, eps, 200, observe=("drift", "fli", "escape"))
    assert many.x.shape == (300, 3) and (many.steps == 200).all()
    for k in (0, 17, 299):
        alone = E6.ensemble(points[k : k + 1], eps[k], 200, observe=("drift", "fli"))
        assert alone.drift_H[0] == many.drift_H[k] and alone.fli[0] == many.fli[k]
        assert np.array_equal(E6.orbit(points[k], eps[k], 200).x[-1], many.x[k])
    with pytest.raises(ValueError, match="no observable `lyapunow`; did you mean `lyapunov`"):
        E6.ensemble(points, eps, 2, observe=["lyapunow"])
    with pytest.raises(AttributeError, match="fli"):
        many.megno


def test_tables_have_columns():
    orbit, section = E6.orbit([1, 2, 3], 0.05, 50), E6.section([1, 2, 3], 0.05, 1000, "x - y", direction="both")
    assert np.array_equal(orbit["y"], orbit.x[:, 1]) and orbit.y is not None and list(orbit) == ["n", "t", "x", "y", "z", "H", "K"]
    assert np.array_equal(np.asarray(section), section.x) and len(np.asarray(section, dtype=np.float32)) == len(section)
    with pytest.raises(KeyError, match="no column `w`"):
        orbit["w"]
    with pytest.raises(AttributeError, match="no column `HH`; did you mean `H`"):
        orbit.HH
    points, eps = np.ones((4, 3)), np.linspace(0.01, 0.02, 4)
    top = kahan.catalog.euler(a2=-3)
    many = top.ensemble(points, eps, 20, params={"a1": 1, "a3": [1, 2, 3, 4]}, observe=["fli"], out=None)
    assert list(many) == ["start_x", "start_y", "start_z", "eps", "a1", "a3", "x", "y", "z", "ended", "ended_step", "fli"]
    assert many["a1"].tolist() == [1] * 4 and many["eps"] is not None and np.array_equal(many["eps"], eps)
    plain = E6.ensemble(points.tolist(), 0.01, 20)
    assert (plain.start == 1).all() and (plain["x"] != 1).all() and (plain.ended_step == 20).all()
    for table in (orbit, section, many, plain, E6.chart({"x": (-1, 1, 3)}, [0, 1, 1], 0.1)):
        again = pickle.loads(pickle.dumps(table))
        assert list(again) == list(table) and all(np.array_equal(again[name], table[name]) for name in table)


def test_tables_are_handed_on_by_arrow():
    orbit = E6.orbit([1, 2, 3], 0.05, 50, every=5)
    tables = {
        "orbit": orbit,
        "single": E6.orbit(np.float32([1, 2, 3]), 0.05, 5),
        "exact": E6.orbit([1, "2/3", 3], "1/7", 3, scalar="exact"),
        "ensemble": E6.ensemble(np.ones((4, 3)), 0.05, 20, observe=["fli"]),
        "plain": E6.ensemble(np.ones((4, 3)), 0.05, 20),
        "section": E6.section([1, 2, 3], 0.05, 1000, "x - y", direction="both"),
        "chart": E6.chart({"x": (-1, 1, 3), "y": (0, 1, 2)}, [0, 1, 1], 0.1),
    }
    assert list(tables["ensemble"]) == ["start_x", "start_y", "start_z", "eps", "x", "y", "z", "ended", "ended_step", "fli"]
    pyarrow = pytest.importorskip("pyarrow")
    for name, table in tables.items():
        columns, taken = table.columns(), pyarrow.table(table)
        assert taken.column_names == list(columns), name
        for column, values in columns.items():
            wanted = [str(value) for value in values] if values.dtype == object else values.tolist()
            assert taken[column].to_pylist() == wanted, (name, column)
    assert pyarrow.table(tables["single"]).schema.field("x").type == pyarrow.float32()
    # A capsule outlives its table, and frees its memory even if nobody reads the capsule.
    capsule = E6.orbit([1, 2, 3], 0.05, 50).__arrow_c_stream__()
    del capsule
    polars = pytest.importorskip("polars")
    assert polars.DataFrame(orbit)["z"].to_list() == orbit.x[:, 2].tolist()
    assert polars.DataFrame(tables["exact"])["x"].to_list()[1:2] == [str(tables["exact"].x[1, 0])]
    pandas = pytest.importorskip("pandas")
    assert orbit.to_pandas().equals(pandas.DataFrame(orbit.columns()))
    for name in ("orbit", "single", "ensemble", "plain", "section"):
        assert pandas.DataFrame(tables[name]).equals(tables[name].to_pandas()), name


def test_tables_are_mappings_of_their_columns():
    orbit = E6.orbit([1, 2, 3], 0.05, 50, every=5)
    chart = E6.chart({"x": (-1, 1, 3), "y": (0, 1, 2)}, [0, 1, 1], 0.1)
    for table in (orbit, chart, E6.ensemble(np.ones((4, 3)), 0.05, 20), E6.section([1, 2, 3], 0.05, 1000, "x - y"),
                  E6.orbit([1, "2/3", 3], "1/7", 3, scalar="exact")):
        columns = table.columns()
        assert list(table.keys()) == list(table) == list(dict(table)) == list({**table}) == list(columns)
        assert all(np.array_equal(one, columns[name]) for name, one in table.items()), table
        assert "x" in table and "w" not in table and table.get("w") is None and table == table and table != dict(table)
    assert list(orbit | {"w": 1}) == [*orbit, "w"] and list({"w": 1} | orbit) == ["w", *orbit] and list(reversed(orbit)) == list(orbit)[::-1]
    assert orbit.states is orbit.x and list(pickle.loads(pickle.dumps(orbit))) == list(orbit)
    for change in (lambda: orbit.update(w=1), lambda: orbit.__setitem__("w", 1), lambda: orbit.pop("x"), orbit.clear):
        with pytest.raises(TypeError, match=r"change those of dict\(table\)"):
            change()


def test_xarray_has_dimensions_and_coordinates():
    pytest.importorskip("xarray")
    orbit = E6.orbit([1, 2, 3], 0.05, 50, every=5).to_xarray()
    assert orbit.y.dims == ("t",) and float(orbit.y.sel(t=5.0)) == float(orbit.y[10]) and orbit.n.values[-1] == 50
    chart = E6.chart({"x": (-1, 1, 3), "y": (0, 1, 2)}, [0, 1, 1], 0.1)
    found = chart.to_xarray()
    assert found.sali.dims == ("x", "y") and found.sali.sel(x=1.0, y=0.0) == chart.values[2, 0] and "index" in found.sali.attrs["long_name"]


RING = "for i in periodic { q[i]dot = p[i]; p[i]dot = q[i+1] - 2*q[i] + q[i-1]; } integral P = sum(p[i]);"


def test_orbits_of_lattices_are_tables():
    ring, random = kahan.Lattice(RING, 6, eps=0.1), np.random.default_rng(5)
    states = random.uniform(-1, 1, (3, 6, 2))
    orbit = ring.orbit(states[0], 20, every=4)
    assert orbit.x.shape == (6, 6, 2) and orbit.t[-1] == pytest.approx(4.0) and orbit.n[-1] == orbit.steps == 20
    assert np.array_equal(orbit.x[-1], ring.advance(states[0], 20)) and orbit["P"][2] == ring.invariants(orbit.x[2])["P"]
    many = ring.orbit(states, 20, every=4)
    assert np.array_equal(many.x[:, 0], orbit.x) and np.array_equal(ring.advance(states, 8), many.x[2])
    assert list(many) == ["n", "t", "P_1", "P_2", "P_3"] and np.array_equal(many["P_1"], orbit["P"])
    burst = kahan.Lattice("for i in periodic { x[i]dot = x[i]^2; }", 3, eps=0.25)
    one = burst.orbit([1, 1.5, 1], 100, every=7)
    assert (one.ended, one.ended_step, len(one)) == ("range", 1, 1) and np.isfinite(burst.step([1, 1.5, 1])).all()
    assert np.isnan(burst.orbit([[1, 1.5, 1]], 3).x[2]).all()
    with pytest.raises(ValueError, match="every"):
        ring.orbit(states, 3, every=0)
    if pytest.importorskip("xarray"):
        assert many.to_xarray().q.dims == ("t", "state_1", "site") and orbit.to_xarray().P.dims == ("t",)


def test_exponents_of_a_chain_are_those_of_its_field():
    family = "struct Chain { k, c } for i in periodic { x[i]dot = k*c[i]*x[i]*(x[i+1] - x[i-1]); }"
    rates, state = [1, 1.5, 1, 2], [1, 2, 0.5, 1]
    chain = kahan.Lattice(family, 4, eps=0.05, k=0.5, c=rates)
    field = kahan.System(family, sites=4)(k=0.5, **{f"c{k}": rate for k, rate in enumerate(rates)})
    asked = {"observe": ["spectrum"], "spectrum": 2}
    assert np.array_equal(chain.observe(state, 200, **asked).spectrum, field.observe(state, 0.05, 200, **asked).spectrum)
    with pytest.raises(ValueError, match="one state"):
        chain.observe([state, state], 10)


def test_plots():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    orbit = E6.orbit([1, 2, 3], 0.05, 100)
    (line,) = orbit.plot().lines
    assert line.get_linestyle() == "-" and line.axes.get_zlabel() == "z" and line.axes.get_title() == "e6, eps = 0.05, 100 steps"
    assert orbit.plot(ax=plt.figure().add_subplot()).get_ylabel() == "y" and orbit.plot("t", "H").get_ylabel() == "H"
    with pytest.raises(ValueError, match='2 axes are needed, and 3 given; .*projection="3d"'):
        orbit.plot("x", "y", "z", ax=plt.figure().add_subplot())
    with pytest.raises(ValueError, match="no axis `w`"):
        orbit.plot("x", "w")
    assert "eps = 0.05" in E6.section([1, 2, 3], 0.05, 1000, "x - y").plot().get_title()
    assert E6.orbit([1, "2/3", 3], "1/7", 3, scalar="exact").plot("t", "x").get_xlabel() == "t"
    many = E6.ensemble(np.random.default_rng(1).uniform(0.1, 0.3, (20, 3)), 0.05, 20, observe=["sali"])
    assert many.plot().collections and many.plot("start_x", "sali", color="sali").figure.axes[1].get_ylabel() == "log of sali, to base 10"
    # The colours show the logarithm of SALI, as in `kahan chart`.
    chart = E6.chart({"x": (-1, 1, 5), "y": (-1, 1, 5)}, [0, 1, 1], 0.1)
    axes = chart.plot()
    shown = axes.collections[0].get_array()
    assert np.allclose(shown, np.log10(np.maximum(chart.values.T, np.finfo(float).eps)).reshape(shown.shape), equal_nan=True)
    assert axes.figure.axes[1].get_ylabel() == "log of smaller alignment index, to base 10"
    assert axes.get_title() == "e6, eps = 0.1, 1000 steps"
    curve = E6.chart({"x": (-1, 1, 5)}, [0, 1, 1], 0.1, color="lyapunov").plot()
    assert curve.get_ylabel() == "largest Lyapunov exponent, per unit of time"
    # Options with matplotlib's short names replace the default style.
    (line,) = orbit.plot("x", "y", ms=5, c="red", lw=3, ls=":").lines
    assert (line.get_markersize(), line.get_color(), line.get_linewidth(), line.get_linestyle()) == (5, "red", 3, ":")
    lattice = kahan.Lattice(RING, 6, eps=0.1).orbit(np.ones((6, 2)), 8)
    assert lattice.plot(cmap="gray").get_xlabel() == "site" and lattice.plot("t", "P", lw=2).get_ylabel() == "P"
    plt.close("all")


def test_settings_of_a_trade_are_a_table():
    settings = kahan.System("xdot = y; ydot = -x;").trade([1, 0], 1, seconds=0.2).settings
    assert settings["eps"].tolist() == [row["eps"] for row in settings] and len(settings.keys()) == len(settings[0])
    assert settings.to_pandas().shape == (len(settings), len(settings[0])) if pytest.importorskip("pandas") else True
    with pytest.raises(KeyError, match="did you mean `eps`"):
        settings["epss"]


def test_cells_that_escape_show_no_chaos():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    hh, over = kahan.catalog.henon_heiles(a=1, b=1, c=1), {"y": (-0.5, 1.2, 4)}
    exponents, steps = (hh.chart(over, [0, 0, 0.3, 0.1], 0.1, color=color, escape=10) for color in ("lyapunov", "escape"))
    escapes = np.isfinite(exponents.escaped)
    assert escapes.any() and not escapes.all() and np.array_equal(steps.values, exponents.escaped, equal_nan=True)
    assert np.array_equal(np.isfinite(exponents.values), ~escapes) and (exponents.ended[escapes] == "escaped").all()
    (shown,), (counted,) = exponents.plot().lines, steps.plot().lines
    assert np.array_equal(np.isnan(shown.get_ydata()), escapes) and np.array_equal(np.isfinite(counted.get_ydata()), escapes)
    # The exponent is NaN if the orbit leaves the range of floats.
    gone = kahan.System("xdot = x^2;").chart({"eps": [0.25, 0.26]}, [1], steps=100, color="lyapunov")
    assert np.isnan(gone.values[0]) and gone.escaped[0] == 2 and np.isfinite(gone.values[1])


def test_claims_are_verified():
    assert kahan.System("xdot = y; ydot = -x; integral H = x^2 + y^2;").verify().failed == 0


def test_others_take_the_field_and_its_integrals():
    rate, x = E6.rhs(), np.array([1.0, 2.0, 3.0])
    assert rate(0.0, x).tolist() == E6.evaluate(x, 1, exact=True).field.tolist()
    assert np.array_equal(rate(0.0, np.stack([x, 2 * x], axis=1))[:, 0], rate(0.0, x))
    assert rate.jacobian(0.0, x).tolist() == E6.evaluate(x, 1, exact=True).field_jacobian.tolist()
    energy = E6.integral_functions()["H"]
    # The integral H of E6 at eps = 0 is x z + y^2.
    assert energy(x) == 7
    scipy = pytest.importorskip("scipy.integrate")
    end = scipy.solve_ivp(rate, (0, 1), x, rtol=1e-10, atol=1e-10, vectorized=True).y[:, -1]
    assert abs(energy(end) - 7) < 1e-7
    stiff = scipy.solve_ivp(rate, (0, 1), x, method="Radau", jac=rate.jacobian, rtol=1e-10, atol=1e-10)
    assert np.abs(stiff.y[:, -1] - end).max() < 1e-7 and stiff.njev > 0


def test_names_of_columns_decide_which_variable_they_are() -> None:
    pandas = pytest.importorskip("pandas")
    s = kahan.System("xdot = k1*y; ydot = -x;", k1=2)
    rows = np.array([[0.1, 0.2], [0.3, 0.4]])
    expected = s.ensemble(rows, 0.1, 5).x
    frame = pandas.DataFrame({"y": rows[:, 1], "x": rows[:, 0]}, index=["a", "b"])
    structured = np.array([(b, a) for a, b in rows], dtype=[("y", float), ("x", float)])
    for given in (frame, structured, {"y": rows[:, 1], "x": rows[:, 0]}, pandas.DataFrame(rows)):
        np.testing.assert_array_equal(s.ensemble(given, 0.1, 5).x, expected)
    assert s.ensemble(rows, 0.1, 5, params={"k1": pandas.Series([1.0, 2.0], index=["a", "b"])}).x.shape == (2, 2)
    start = s.orbit(rows[0], 0.1, 5).x
    for given in (frame.iloc[0], {"y": 0.2, "x": 0.1}):
        np.testing.assert_array_equal(s.orbit(given, 0.1, 5).x, start)
        assert s.observe(given, 0.1, 5).steps == 5
    for wrong, said in ((frame.assign(note=1), "cannot be used, `note`"), (frame.assign(eps=1.0), "eps is given twice"),
                        (frame[["x"]], "no column `y`"), (frame[["x", "x", "y"]], "two columns `x`")):
        with pytest.raises(ValueError, match=said):
            s.ensemble(wrong, 0.1, 5)
    np.testing.assert_array_equal(s.step(frame, 0.1), s.step(rows, 0.1))
    with pytest.raises(TypeError, match="eps: .* have the names y, x"):
        s.ensemble(rows, frame, 5)


def test_every_color_that_is_listed_is_shown() -> None:
    s = kahan.System("xdot = y; ydot = -x; integral H = x^2 + y^2;")
    with pytest.raises(ValueError, match="there is no column `final`; did you mean `final_x`?"):
        s.chart({"x": (0.1, 0.2, 2)}, [0.1, 0.1], 0.1, steps=20, color="final")
    with pytest.raises(ValueError, match="there is no column `nothing_such`") as refused:
        s.chart({"x": (0.1, 0.2, 2)}, [0.1, 0.1], 0.1, steps=20, color="nothing_such")
    listed = str(refused.value).partition("there is ")[2].partition("there is ")[2].split(", ")
    assert "final_x" in listed and "sali" in listed
    for color in listed:
        assert s.chart({"x": (0.1, 0.2, 2)}, [0.1, 0.1], 0.1, steps=20, color=color).values.shape == (2,)


def test_what_was_found_is_claimed_at_the_values_of_the_search() -> None:
    s = kahan.System("xdot = y; ydot = a - b*x^2;", a="1/2")
    claimed = s(b=3).discover(seconds=5).claimed
    assert claimed.parameters == {"a": kahan.System("xdot = a;", a="1/2").parameters["a"], "b": 3}
    assert claimed.integrals and claimed(a=0.5).parameters == claimed.parameters
    assert claimed.ensemble([[0.1, 0.2]], 0.1, 5, observe=["drift"]).x.shape == (1, 2)
    assert s.discover(seconds=5).claimed.parameters["b"] is None


def test_charts_have_the_colors_of_the_command() -> None:
    both = E6.chart({"x": (-1, 1, 5)}, [0, 1, 1], 0.1, color="drift")
    assert both.color == "drift" and np.array_equal(both.values, np.fmax.reduce(
        [E6.chart({"x": (-1, 1, 5)}, [0, 1, 1], 0.1, color=f"drift_{name}").values for name in E6.integrals]))
    # The default bound for an escape is a million.
    far = kahan.System("xdot = x;").chart({"eps": [0.25, 0.5]}, [1], steps=30, color="escape")
    assert far.ended.tolist() == ["complete"] * 2 and far.values.tolist() == [28, 13]
