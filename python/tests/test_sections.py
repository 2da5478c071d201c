"""Tests sections of many orbits, and diagrams."""

import numpy as np
import pytest

import kahan

HENON_HEILES = kahan.System("xdot = p; ydot = q; pdot = -x - 2*x*y; qdot = y^2 - x^2 - y;")
ROSSLER = kahan.System("xdot = -y - z; ydot = x + a*y; zdot = 1/5 + z*(x - c);", a="1/5")
STARTS = np.array([[0, 0.02 * k, 0.45, 0.1] for k in range(20)])


def test_each_orbit_has_the_crossings_that_it_has_alone():
    many = HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=15, transient=100, order=4)
    assert list(many) == ["start", "n", "t", "x", "y", "p", "q"] and len(many) == 300
    assert many.steps.shape == many.jumps.shape == (20,) and set(many.ended) == {"stopped"}
    for k, start in enumerate(STARTS):
        one = HENON_HEILES.section(start, 0.05, plane="x", crossings=15, transient=100, order=4)
        own = many["start"] == k
        assert (many.x[own] == one.x).all() and (many.t[own] == one.t).all() and (many.n[own] == one.n).all()
        assert (one.steps, one.ended, one.jumps) == (many.steps[k], many.ended[k], many.jumps[k])
    assert (HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=15, transient=100, order=4, threads=1).x == many.x).all()


def test_parameters_stand_beside_starts_or_are_gone_through():
    rates = [3.5, 4.0, 4.5]
    beside = ROSSLER.section(np.ones((3, 3)), 0.02, plane="y", crossings=4, params={"c": rates})
    over = ROSSLER.section([1, 1, 1], 0.02, plane="y", crossings=4, over={"c": rates})
    assert list(beside) == list(over) == ["start", "c", "n", "t", "x", "y", "z"]
    assert (beside.x == over.x).all() and (beside["c"] == np.repeat(rates, 4)).all()
    assert (beside["start"] == np.repeat([0, 1, 2], 4)).all() and (over["start"] == 0).all()
    one = ROSSLER(c=4.0).section([1, 1, 1], 0.02, plane="y", crossings=4)
    assert (one.x == over.x[4:8]).all()
    steps = ROSSLER(c=4).section([1, 1, 1], plane="y", crossings=4, over={"eps": (0.01, 0.02, 2)})
    assert steps.eps is None and (steps["eps"] == [0.01] * 4 + [0.02] * 4).all()
    with pytest.raises(ValueError, match="one value for each of the 2"):
        ROSSLER.section(np.ones((2, 3)), 0.02, plane="y", crossings=4, params={"c": rates})


def test_a_diagram_is_a_table_over_a_parameter():
    found = ROSSLER.diagram({"c": (2, 4, 5)}, [1, 1, 0], 0.02, maxima="x", transient=10_000, crossings=12)
    assert list(found) == ["start", "c", "n", "t", "x", "y", "z"] and len(found) == 60
    assert [len(np.unique(found["x"][found["c"] == c].round(2))) for c in (2, 3.5)] == [1, 2]
    assert (np.abs(found["y"] + found["z"]) < 1e-12).all()
    assert repr(found) == "<Diagram of 5 orbits of field at maxima of x: 60 crossings>"
    carried = ROSSLER.diagram({"c": (2, 4, 5)}, [1, 1, 0], 0.02, maxima="x", transient=10_000, crossings=12, carry=True)
    assert (carried.x[:12] == found.x[:12]).all() and (carried.x[12:] != found.x[12:]).any()
    with pytest.raises(ValueError, match="one of both"):
        ROSSLER.diagram({"c": (2, 4, 5)}, [1, 1, 0], 0.02, maxima="x", plane="y")
    with pytest.raises(TypeError, match="plane is missing"):
        ROSSLER.diagram({"c": (2, 4, 5)}, [1, 1, 0], 0.02)
    with pytest.raises(TypeError, match="steps is missing"):
        ROSSLER.ensemble([[1, 1, 0]], 0.02, params={"c": 3})
    with pytest.raises(ValueError, match="one name"):
        ROSSLER.diagram({}, [1, 1, 0], 0.02, maxima="x")


def test_tables_go_into_other_libraries():
    found = ROSSLER.diagram({"c": (2, 4, 3)}, [1, 1, 0], 0.02, plane="y", transient=100, crossings=3)
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    assert list(pandas.DataFrame(found).columns) == list(found)
    assert isinstance(found.to_xarray(), xarray.Dataset) and found.to_xarray().sizes["crossing"] == 9


def test_plots():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    found = ROSSLER.diagram({"c": (2, 4, 3)}, [1, 1, 0], 0.02, plane="y", transient=100, crossings=3)
    axes = found.plot(ms=1)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("c", "x")
    assert found.plot(s=4).lines[0].get_markersize() == 2
    assert len(HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=3).plot().lines) == 20


@pytest.mark.parametrize("name", ["crossings.parquet", "crossings.arrow"])
def test_crossings_are_written_while_they_are_found(tmp_path, name):
    pyarrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    def read():
        path = tmp_path / name
        return parquet.read_table(path) if path.suffix == ".parquet" else pyarrow.ipc.open_file(path).read_all()

    whole = HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=8000)
    found = HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=8000, to=tmp_path / name)
    table = read()
    assert table.column_names == list(whole) and table.num_rows == 160_000
    assert all((table[column].to_numpy() == whole[column]).all() for column in whole)
    assert len(found) == 0 and (found.crossings == whole.crossings).all() and (found.steps == whole.steps).all()
    assert "160000 crossings" in repr(found)
    none = HENON_HEILES.section(STARTS, 0.05, plane="x - 50", steps=10, to=tmp_path / name)
    assert none.crossings.sum() == 0 and read().num_rows == 0 and [path.name for path in tmp_path.iterdir()] == [name]
    with pytest.raises(ValueError, match="F.parquet or F.arrow"):
        HENON_HEILES.section(STARTS, 0.05, plane="x", crossings=2, to=tmp_path / "crossings.csv")


def test_a_branch_is_a_table():
    found = kahan.System("xdot = a - x^2;").periodic([0.9], 0.1, over={"a": (1, -1, 5)})
    points, turns = found.branch["points"], found.branch["turns"]
    assert np.abs(points["parameter"][:2] - [1, 0.5]).max() < 1e-14 and found.branch["over"] == "a"
    assert len(turns) == 1 and abs(turns["parameter"][0]) < 1e-9 and "fold" in turns[0]["change"]
    assert list(pytest.importorskip("pandas").DataFrame(list(points))) == points.keys() == list(points.to_pandas())
