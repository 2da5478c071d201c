"""Tests tables of starts and parameters: every call goes by the names of columns, or is refused."""

from __future__ import annotations

from collections import namedtuple
from itertools import permutations
from typing import Any

import numpy as np
import pytest

import kahan

S = kahan.System("xdot = k*y; ydot = m - x - y*z; zdot = x*y - z;")
FIXED = S(k=2, m="1/3")
X, Y, Z = np.array([0.1, 0.3, 0.5, 0.7]), np.array([0.2, 0.4, 0.6, 0.8]), np.array([1.0, 1.5, 2.0, 2.5])
K, M, EPS = np.array([1.0, 1.5, 2.0, 2.5]), np.array([0.2, 0.3, 0.4, 0.5]), np.array([0.01, 0.02, 0.03, 0.04])
ALL = {"x": X, "y": Y, "z": Z, "k": K, "m": M, "eps": EPS}
ROWS = np.stack([X, Y, Z], axis=1)


def structured(columns: dict[str, Any]) -> Any:
    made = np.empty(len(next(iter(columns.values()))), dtype=[(name, float) for name in columns])
    for name, values in columns.items():
        made[name] = values
    return made


def records(columns: dict[str, Any]) -> Any:
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


def tuples(columns: dict[str, Any]) -> Any:
    return [namedtuple("Start", list(columns))(*row) for row in zip(*columns.values())]


def frame(columns: dict[str, Any]) -> Any:
    return pytest.importorskip("pandas").DataFrame(columns)


def series(columns: dict[str, Any]) -> Any:
    return [row for _, row in frame(columns).iterrows()]


def polars(columns: dict[str, Any]) -> Any:
    return pytest.importorskip("polars").DataFrame(columns)


def arrow(columns: dict[str, Any]) -> Any:
    return pytest.importorskip("pyarrow").table(columns)


def batch(columns: dict[str, Any]) -> Any:
    return pytest.importorskip("pyarrow").RecordBatch.from_pydict(columns)


class Stream:
    """A table whose only method is Arrow's `__arrow_c_stream__`."""

    def __init__(self, of: Any) -> None:
        self.of = of

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self.of.__arrow_c_stream__(requested_schema)


def stream(columns: dict[str, Any]) -> Any:
    return Stream(arrow(columns))


TABLES = [dict, structured, records, tuples, frame, series, polars, arrow, batch, stream]


def chosen(names: Any) -> dict[str, Any]:
    return {name: ALL[name] for name in names}


@pytest.mark.parametrize("table", TABLES)
def test_columns_stand_in_every_order(table: Any) -> None:
    wanted = FIXED.ensemble(ROWS, 0.01, 5).x
    each = S.ensemble(ROWS, EPS, 5, params={"k": K, "m": M})
    for names in permutations("xyz"):
        given = table(chosen(names))
        np.testing.assert_array_equal(FIXED.ensemble(given, 0.01, 5).x, wanted)
        np.testing.assert_array_equal(FIXED.step(given, 0.01), FIXED.step(ROWS, 0.01))
        np.testing.assert_array_equal(FIXED.try_step(given, 0.01), FIXED.step(ROWS, 0.01))
        np.testing.assert_array_equal(FIXED.rhs()(0.0, given), FIXED.rhs()(0.0, ROWS.T))
        np.testing.assert_array_equal(FIXED.field(given), FIXED.field(ROWS))
    for names in list(permutations(ALL))[::37]:
        found = S.ensemble(table(chosen(names)), steps=5)
        np.testing.assert_array_equal(found.x, each.x)
        assert np.array_equal(found["k"], K) and np.array_equal(found["eps"], EPS) and np.array_equal(found["start_y"], Y)
        np.testing.assert_array_equal(S.A(table(chosen(names))), S.A(ROWS, EPS, k=K, m=M))
    for names in (["m", "k"], ["k", "m"]):
        np.testing.assert_array_equal(S.ensemble(ROWS, EPS, 5, params=table(chosen(names))).x, each.x)
    np.testing.assert_array_equal(S.ensemble(table(chosen("zxy")), steps=5, params=table(chosen(["m", "eps", "k"]))).x, each.x)


@pytest.mark.parametrize("table", TABLES)
def test_a_column_that_cannot_be_used_is_refused(table: Any) -> None:
    for wrong, said in (
        ({"x": X, "y": Y}, "no column `z`; it has x, y"),
        ({"x": X, "y": Y, "Z": Z}, "no column `z`; it has x, y, Z"),
        ({"z": Z, "y": Y, "x": X, "note": X}, "a column that cannot be used, `note`: leave out all but x, y, z, k, m, eps"),
        ({"t": X, "z": Z, "y": Y, "n": X, "x": X}, "columns that cannot be used, `t`, `n`"),
    ):
        with pytest.raises(ValueError, match=said):
            FIXED.ensemble(table(wrong), 0.01, 5)
    single = {"z": Z, "y": Y, "x": X, "k": K}
    calls = [lambda x: FIXED.step(x, 0.1), lambda x: FIXED.rhs()(0.0, x), lambda x: FIXED.integral_values(x, 0.1)]
    for call in calls:
        with pytest.raises(ValueError, match=r"a column `k`, and a parameter has one value here: .* or in Python s\(k=V\)"):
            call(table(single))
        with pytest.raises(ValueError, match="a column `eps`, and the step has one value here"):
            call(table(chosen(["x", "eps", "y", "z"])))
        with pytest.raises(ValueError, match="no column `y`"):
            call(table(chosen("xz")))
    for params, said in (
        ({"m": M, "kk": K}, "params: there is no parameter `kk`; did you mean `k`|there is k, m"),
        ({"k": K, "x": X}, "params: there is no parameter `x`; there is k, m"),
    ):
        with pytest.raises(TypeError, match=said):
            S.ensemble(ROWS, 0.1, 5, params=table(params))
    with pytest.raises(ValueError, match="k is given twice"):
        S.ensemble(table(chosen("zxyk")), 0.1, 5, params={"k": 1, "m": 2})
    for step in ({"eps": 0.1}, {"dt": 0.1}):
        with pytest.raises(ValueError, match="eps is given twice"):
            S.ensemble(table(ALL), steps=5, **step)
    with pytest.raises(TypeError, match="give eps, half the time step, as an argument or a column, or dt"):
        FIXED.ensemble(table(chosen("zxy")), steps=5)


LIFTED = kahan.System("xdot = v; vdot = -sin(x) - k*v;", lift=True, k="1/10")
POND = kahan.System("xdot = x*(1 - y); ydot = y*(x - 1);")

POINT_CALLS = {
    "orbit": lambda x: FIXED.orbit(x, 0.01, 5).x,
    "exact": lambda x: FIXED.orbit(x, "1/100", 3, scalar="exact").x,
    "dd": lambda x: FIXED.orbit(x, 0.01, 3, scalar="dd").x,
    "rk4": lambda x: FIXED.orbit(x, 0.01, 3, method="rk4").x,
    "evaluate": lambda x: FIXED.evaluate(x, 0.01).x_next,
    "observe": lambda x: FIXED.observe(x, 0.01, 9, observe=["extrema", "fli"]).fli,
    "section": lambda x: FIXED.section(x, 0.05, 900, "x - y", direction="both").x,
    "chart": lambda x: FIXED.chart({"eps": [0.01, 0.02]}, x, steps=9, color="final_x").values,
    "heights": lambda x: FIXED.heights(x, "1/10", 3).log_heights["x"],
    "step": lambda x: FIXED.step(x, 0.01),
    "try_step": lambda x: FIXED.try_step(x, 0.01),
    "rhs": lambda x: FIXED.rhs()(0.0, x),
    "jacobian": lambda x: FIXED.rhs().jacobian(0.0, x),
    "field": lambda x: FIXED.field(x),
    "A": lambda x: FIXED.A(x, 0.1),
    "integral_values": lambda x: kahan.catalog.e6.integral_values(x, 0.1)["H"],
    "periodic": lambda x: POND.periodic(x, "1/10").points,
    "lifted": lambda x: LIFTED.orbit(x, 0.01, 5).x,
    "embed": lambda x: LIFTED.lifted.embed(x),
}


def points_with_names(variables: tuple[str, ...], values: list[float]) -> dict[str, Any]:
    one = dict(reversed(list(zip(variables, values))))
    points = {"dict": one, "tuple": namedtuple("Point", list(one))(**one), "record": structured({k: [v] for k, v in one.items()})[0]}
    try:
        import pandas
    except ImportError:
        return points
    return points | {"series": pandas.Series(one), "row": pandas.DataFrame([one]), "first": pandas.DataFrame([one]).iloc[0]}


@pytest.mark.parametrize("call", list(POINT_CALLS))
def test_the_coordinates_of_a_point_have_names(call: str) -> None:
    asked = POINT_CALLS[call]
    variables = {"periodic": POND, "lifted": LIFTED, "embed": LIFTED}.get(call, FIXED).variables
    values = [1.1, 0.9, 1.3][: len(variables)]
    wanted = np.squeeze(asked(values))
    for shape, given in points_with_names(variables, values).items():
        assert np.array_equal(np.squeeze(asked(given)), wanted), shape
    known = dict.fromkeys(variables, 1.0)
    for wrong in ({"x": 1.0}, {"x": 1.0, "w": 1.0} | dict.fromkeys(variables[2:], 1.0), known | {"t": 0.0}):
        with pytest.raises(ValueError, match="[xy]: the table has"):
            asked(wrong)
    if call not in ("field", "A"):
        for wrong in (known | {"eps": 0.1}, known | {"k": 3.0}):
            with pytest.raises(ValueError, match="has one value here|cannot be used, `k`"):
                asked(wrong)


def test_other_calls_refuse_what_is_no_point() -> None:
    for wrong, said in (({"x": 1, "y": 1, "w": 1}, "no column `z`; it has x, y, w"), ({"z": X, "y": Y, "x": Z}, "one point is needed")):
        with pytest.raises((TypeError, ValueError), match=said):
            FIXED.trade(wrong, 1)
        with pytest.raises((TypeError, ValueError), match=said):
            FIXED.evaluate(wrong, 0.1)


def test_numbers_of_a_point_stay_exact() -> None:
    big = 2**60 + 1
    orbit = FIXED.orbit({"z": "1/3", "y": big, "x": 0.5}, "1/7", 1, scalar="exact")
    assert orbit.x[0].tolist() == FIXED.orbit(["1/2", big, "1/3"], "1/7", 0, scalar="exact").x[0].tolist()
    single = FIXED.step({"z": np.float32(1), "y": np.float32(2), "x": np.float32(3)}, 0.1)
    assert single.dtype == np.float32


def test_labels_of_pandas() -> None:
    pandas = pytest.importorskip("pandas")
    wanted = FIXED.ensemble(ROWS, 0.01, 5).x
    table = pandas.DataFrame(chosen("zyx"))
    plain = pandas.DataFrame(ROWS)
    for given in (table, table.set_index("y"), table.set_index(["x", "z"]), table.set_index(pandas.Index(list("abcd"), name="id")),
                  table.rename_axis("row"), plain, table.astype("Float64"), table.astype({"x": object})):
        np.testing.assert_array_equal(FIXED.ensemble(given, 0.01, 5).x, wanted)
    np.testing.assert_array_equal(S.ensemble(table.assign(k=K, m=M).set_index(["m", "k"]), 0.01, 5).x,
                                  S.ensemble(ROWS, 0.01, 5, params={"k": K, "m": M}).x)
    np.testing.assert_array_equal(FIXED.step(pandas.Series([0.1, 0.2, 1.0]), 0.1), FIXED.step([0.1, 0.2, 1.0], 0.1))
    for wrong, said in (
        (table.assign(y2=Y).rename(columns={"y2": "y"})[["x", "y", "z"]], "two columns `y`"),
        (plain[[2, 1, 0]], "no column `x`; it has 2, 1, 0"),
        (plain.rename(columns={0: "x", 1: "y"}), "no column `z`; it has x, y, 2"),
        (pandas.concat({"first": table}, axis=1), "no column `x`"),
        (table.reset_index(), "cannot be used, `index`"),
    ):
        with pytest.raises(ValueError, match=said):
            FIXED.ensemble(wrong, 0.01, 5)
    with pytest.raises(TypeError, match="the column `y` has datetime64"):
        FIXED.ensemble(table.assign(y=pandas.Timestamp("2026-01-01")), 0.01, 5)
    for wrong in (pandas.Series([0.1, 0.2, 1.0], index=[2, 1, 0]), pandas.Series([0.1, 0.2, 1.0], index=["x", "x", "z"])):
        with pytest.raises(ValueError, match="the table has"):
            FIXED.step(wrong, 0.1)
    # A call takes rows in their order, and refuses labels in another order.
    lettered, turned = table.set_axis(list("abcd")), pandas.DataFrame({"k": K, "m": M}, index=list("badc"))
    for params in (turned, {"k": turned["k"], "m": 1}):
        with pytest.raises(ValueError, match="their labels in these columns are not the same"):
            S.ensemble(lettered, 0.01, 5, params=params)
    with pytest.raises(ValueError, match="their labels"):
        FIXED.ensemble(lettered, turned["k"], 5)
    # The numbers of an index are labels, too.
    numbered = turned.reset_index(drop=True)
    for points, params in ((lettered, numbered), (table.sample(frac=1, random_state=1), numbered), (table, turned), (table, numbered[1:])):
        with pytest.raises(ValueError, match="their labels in these columns are not the same"):
            S.ensemble(points, 0.01, 5, params=params)
        with pytest.raises(ValueError, match="their labels in these columns are not the same"):
            S.map(points, 0.01, k=params["k"], m=1)
    for points, params in ((lettered, {name: turned[name].to_numpy() for name in "km"}), (table, numbered),
                           (table.set_axis([0, 1, 2, 3]), numbered)):
        np.testing.assert_array_equal(S.ensemble(points, 0.01, 5, params=params).x, S.ensemble(ROWS, 0.01, 5, params={"k": K, "m": M}).x)


def test_starts_keep_their_shape() -> None:
    grid = np.random.default_rng(1).uniform(0.1, 1, (40, 30, 3))
    flat = grid.reshape(-1, 3)
    rates, steps = np.linspace(1, 2, 1200), np.linspace(0.01, 0.02, 1200)
    of = ["spectrum", "fli", "escape", "drift"]
    e6 = kahan.catalog.e6
    many, one = e6.ensemble(grid, steps.reshape(40, 30), 50, observe=of), e6.ensemble(flat, steps, 50, observe=of)
    assert many.x.shape == many.start.shape == many.spectrum.shape == (40, 30, 3) and len(many) == 1200
    for name in [*one, "ended_step"]:
        found, wanted = many[name], one[name]
        assert found.shape == (40, 30) and np.array_equal(found.ravel(), wanted, equal_nan=found.dtype != object), name
    assert many.ended.shape == many.ended_step.shape == many.escaped.shape == many.drift_H.shape == (40, 30)
    assert all(np.array_equal(a, b, equal_nan=a.dtype != object) for a, b in zip(many.columns().values(), one.columns().values()))
    params = {"k": rates.reshape(40, 30), "m": 1}
    plain = S.ensemble(grid, 0.01, 5, params=params)
    assert np.array_equal(plain.x.reshape(-1, 3), S.ensemble(flat, 0.01, 5, params={"k": rates, "m": 1}).x)
    by_name = S.ensemble({"y": grid[..., 1], "k": params["k"], "x": grid[..., 0], "m": 1, "z": grid[..., 2]}, 0.01, 5)
    assert np.array_equal(by_name.x, plain.x) and by_name["k"].shape == (40, 30) and repr(plain).startswith("<Ensemble of 1200 ")
    out = np.empty_like(grid)
    into = FIXED.ensemble(grid, 0.01, 5, out=out)
    assert np.shares_memory(into.x, out) and np.array_equal(out, FIXED.ensemble(grid, 0.01, 5).x)
    lifted = kahan.System("xdot = v; vdot = -sin(x);", lift=True)
    assert np.array_equal(lifted.ensemble(grid[..., :2], 0.01, 5).x.reshape(-1, 2), lifted.ensemble(flat[:, :2], 0.01, 5).x)
    out = np.empty((40, 30, 2))
    assert np.array_equal(lifted.ensemble(grid[..., :2], 0.01, 5, reembed=True, out=out).x, out)
    for wrong in (rates, rates.reshape(30, 40), rates[:40]):
        with pytest.raises(ValueError, match="k has the shape .*one for each start"):
            S.ensemble(grid, 0.01, 5, params={"k": wrong, "m": 1})
    with pytest.raises(ValueError, match=r"columns have one shape, or one number for all rows, and these have `x` \(4,\), `y` \(3,\)"):
        FIXED.ensemble({"x": X, "y": Y[:3], "z": 1}, 0.01, 5)


def test_one_number_stands_for_all_rows() -> None:
    found = S.ensemble({"z": 1, "k": K, "x": X, "m": "1/3", "y": 0.5, "eps": "1/100"}, None, 5)
    wanted = S.ensemble(np.stack([X, np.full(4, 0.5), np.ones(4)], axis=1), 0.01, 5, params={"k": K, "m": 1 / 3})
    assert np.array_equal(found.x, wanted.x)
    # The call combines one start with several values of a parameter.
    assert np.array_equal(S.ensemble({"z": 1, "k": K, "x": 0.1, "m": 1, "y": 0.5}, 0.01, 5).x,
                          S.ensemble([[0.1, 0.5, 1]] * 4, 0.01, 5, params={"k": K, "m": 1}).x)


def test_results_are_starts() -> None:
    turned = kahan.System("zdot = x*y - z; xdot = 2*y; ydot = 1/3 - x - y*z;")
    assert turned.variables == ("z", "x", "y")
    orbit = turned.orbit([1.0, 0.1, 0.2], 0.01, 9)
    rows = orbit.x[:, [1, 2, 0]]
    assert np.array_equal(FIXED.ensemble(orbit, 0.01, 5).x, FIXED.ensemble(rows, 0.01, 5).x)
    assert np.array_equal(FIXED.step(turned.ensemble(orbit, 0.01, 5), 0.01), FIXED.step(turned.ensemble(orbit, 0.01, 5).x[:, [1, 2, 0]], 0.01))
    with pytest.raises(ValueError, match="no column `k`|cannot be used"):
        kahan.System("xdot = y; ydot = -x;").ensemble(orbit, 0.01, 5)


def test_lifted_fields_and_lattices() -> None:
    text = "xdot = v; vdot = -sin(x) - k*v;"
    start = {"v": 0.2, "x": 1.1}
    lifted = kahan.System(text, lift=True, at=[1.1, 0.2], k="1/10")
    by_name = kahan.System(text, lift=True, at=start, k="1/10")
    assert by_name.lifted == lifted.lifted and np.array_equal(by_name.orbit(start, 0.01, 5).x, lifted.orbit([1.1, 0.2], 0.01, 5).x)
    with pytest.raises(ValueError, match="at: the table has no column `v`"):
        kahan.System(text, lift=True, at={"x": 1, "w": 2}, k="1/10")
    shown = kahan.System(text, lift=True, all=True, k="1/10")
    all_of_it = dict(zip(shown.variables, shown.lifted.embed([1.1, 0.2])))
    turned = dict(reversed(all_of_it.items()))
    wanted = shown.orbit([1.1, 0.2], 0.01, 5).x
    assert np.array_equal(shown.orbit(start, 0.01, 5).x, wanted) and np.array_equal(shown.orbit(turned, 0.01, 5).x, wanted)
    rates = np.array([0.1, 0.2])
    free = kahan.System(text, lift=True)
    assert np.array_equal(free.ensemble({"v": [0.2, 0.3], "k": rates, "x": [1.1, 1.2]}, 0.01, 5).x,
                          free.ensemble([[1.1, 0.2], [1.2, 0.3]], 0.01, 5, params={"k": rates}).x)
    ring = kahan.Lattice("for i in periodic { q[i]dot = p[i]; p[i]dot = q[i+1] - 2*q[i] + q[i-1]; }", 4, eps=0.01)
    assert ring.arrays == ["q", "p"]
    assert np.array_equal(ring.advance({"p": X, "q": Y}, 3), ring.advance(np.stack([Y, X], axis=1), 3))
    with pytest.raises(ValueError, match="state: the table has no column `p`"):
        ring.step({"q": X, "r": Y})


def test_the_right_side_takes_arguments() -> None:
    x = np.array([0.1, 0.2, 0.3])
    for k, m in ((2.0, 0.5), (3.0, 0.25), (2.0, 0.5)):
        alone = S(k=k, m=m).rhs()
        assert np.array_equal(S.rhs()(0.0, x, k, m), alone(0.0, x)) and np.array_equal(S.rhs("m", "k")(0.0, x, m, k), alone(0.0, x))
        assert np.array_equal(S.rhs().jacobian(0.0, x, k, m), alone.jacobian(0.0, x))
        assert np.array_equal(S(k=1).rhs("k", "m")(0.0, ROWS.T, k, m), alone(0.0, ROWS.T))
        assert np.array_equal(S(k=k).rhs()(0.0, x, m), alone(0.0, x)) and np.array_equal(FIXED.rhs()(0.0, x, k, m), alone(0.0, x))
    lifted = kahan.System("xdot = v; vdot = -k*sin(x) - m*v;", lift=True)
    assert np.array_equal(lifted.rhs("k", "m")(0.0, [1.0, 2.0], 3.0, "1/2"), lifted(k=3, m="1/2").rhs()(0.0, [1.0, 2.0]))
    with pytest.raises(TypeError, match="args: 1 values are given, and those of the parameters k, m are needed, in this order"):
        S.rhs()(0.0, x, 1.0)
    with pytest.raises(TypeError, match="rhs: there is no parameter `q`"):
        S.rhs("q")
    with pytest.raises(ValueError, match="needs a value for each of its parameters"):
        S.rhs()(0.0, x)
    solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp
    found = solve_ivp(S.rhs(), (0, 2), x, args=(2.0, 0.5), method="Radau", jac=S.rhs().jacobian, rtol=1e-9, atol=1e-9)
    wanted = solve_ivp(S(k=2, m="1/2").rhs(), (0, 2), x, method="Radau", jac=S(k=2, m="1/2").rhs().jacobian, rtol=1e-9, atol=1e-9)
    assert np.array_equal(found.y, wanted.y)


def test_formulas_take_the_time_step() -> None:
    np.testing.assert_array_equal(FIXED.map([1, 2, 3], dt=0.25), FIXED.map([1, 2, 3], eps=0.125))
    np.testing.assert_array_equal(FIXED.map(ROWS, dt=2 * EPS), FIXED.map(ROWS, EPS))
    assert FIXED.map(["1/2", 2, 3], dt="1/4").tolist() == FIXED.map(["1/2", 2, 3], "1/8").tolist()
    with pytest.raises(TypeError, match="eps and dt are both given"):
        FIXED.map([1, 2, 3], 0.1, dt=0.2)
    with pytest.raises(TypeError, match="eps: given twice"):
        FIXED.map({"x": X, "y": Y, "z": Z, "eps": EPS}, dt=0.2)
