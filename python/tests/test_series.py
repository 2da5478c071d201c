"""Tests the points along many orbits: bits, ends, columns and files."""

import itertools

import numpy as np
import pytest

import kahan

S = kahan.System("xdot = a*y; ydot = x - x^2;")
E6 = kahan.catalog.e6


@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("kind", [np.float64, np.float32])
@pytest.mark.parametrize("every, transient", [(1, 0), (7, 0), (7, 20), (200, 3)])
def test_a_series_is_its_orbits(kind, order, every, transient):
    random = np.random.default_rng(7)
    points = random.uniform(0.1, 0.5, (300, 2)).astype(kind)
    eps, a = random.uniform(0.001, 0.01, 300), random.uniform(0.5, 1.5, 300)
    for halves, values in itertools.product((0.005, eps), (1.25, a)):
        found = [S.ensemble(points, halves, 101, params={"a": values}, every=every, transient=transient, order=order, threads=threads)
                 for threads in (1, 3)]
        assert found[0].x.shape == (300, 101 // every + 1, 2) and found[0].x.dtype == kind
        assert np.array_equal(found[0].x, found[1].x) and (found[0].steps == 101 + transient).all()
        for k in (0, 127, 128, 299):
            half, value = (float(np.broadcast_to(given, 300)[k]) for given in (halves, values))
            orbit = S(a=value).orbit(points[k], half, 101, every=every, transient=transient, order=order)
            assert np.array_equal(found[0].x[k], orbit.x) and np.array_equal(found[0].n, orbit.n)
            assert np.array_equal(found[0].by_start("t")[k], orbit.t)


@pytest.mark.parametrize("dt", [0.05, "1/20", np.float64(0.05)])
def test_times_of_a_step_dt_are_floats(dt):
    found = S.ensemble([[0.1, 0.2], [0.3, 0.4]], dt=dt, steps=20, every=10, params={"a": 1})
    assert found.t.dtype == float and found["t"].dtype == float and np.array_equal(found.by_start("t")[0], found.t)
    assert np.array_equal(found.t, S(a=1).orbit([0.1, 0.2], dt=dt, steps=20, every=10).t)


def test_the_last_points_are_those_of_the_ensemble():
    points = np.random.default_rng(1).uniform(0.5, 2, (4, 5, 3))
    series, ends = E6.ensemble(points, 0.01, 40, every=10), E6.ensemble(points, 0.01, 40)
    assert series.x.shape == (4, 5, 5, 3) and np.array_equal(series.x[..., -1, :], ends.x)
    assert np.array_equal(series.x[..., 0, :], points) and np.array_equal(series.by_start("y"), series.x[..., 1])
    late = E6.ensemble(points, 0.01, 10, transient=30)
    assert np.array_equal(late.x, ends.x) and (late.steps == 40).all()


def test_an_early_end_leaves_nan_behind_it():
    burst = kahan.System("xdot = x^2;")
    found = burst.ensemble([[1.0], [-1.0], [np.nan]], 0.05, 20, every=3)
    assert list(found.ended) == ["range", "complete", "range"] and list(found.steps) == [9, 20, 0]
    orbit = burst.orbit([1.0], 0.05, 20, every=3)
    assert np.array_equal(found.x[0, :4], orbit.x) and np.isnan(found.x[0, 4:]).all() and np.isfinite(found.x[1]).all()
    late = burst.ensemble([[1.0], [-1.0]], 0.05, 20, every=3, transient=15)
    assert list(late.steps) == [9, 35] and np.isnan(late.x[0]).all()
    orbit = burst.orbit([1.0], 0.05, 20, transient=15)
    assert orbit.x.shape == (0, 1) and (orbit.ended, orbit.steps) == ("range", 9)


def test_lifted_fields_end_as_their_orbits():
    root = kahan.System("xdot = -sqrt(x);", lift=True, at=[1])
    points = [[1.0], [2.0], [0.3]]
    for reembed in (False, True):
        found = root.ensemble(points, 0.05, 40, every=3, reembed=reembed)
        for k, point in enumerate(points):
            orbit = root.orbit(point, 0.05, 40, every=3, reembed=reembed)
            assert (found.ended[k], found.steps[k]) == (orbit.ended, orbit.steps)
            assert np.array_equal(found.x[k, : len(orbit.x)], orbit.x) and np.isnan(found.x[k, len(orbit.x):]).all()


def test_a_transient_is_not_shown():
    for settings in ({}, {"scalar": "f32"}, {"scalar": "dd"}, {"scalar": "exact"}, {"method": "rk4"}, {"compensated": True}):
        whole, late = E6.orbit([1, 2, 3], "1/20", 8, **settings), E6.orbit([1, 2, 3], "1/20", 5, transient=3, **settings)
        assert np.array_equal(late.x, whole.x[3:]) and np.array_equal(late.t, whole.t[3:]) and late.steps == 8
        assert list(late.n) == list(whole.n[3:])
    with pytest.raises(ValueError, match="without transient"):
        late.gradient(late.x)
    with pytest.raises(ValueError, match="without transient"):
        E6.orbit([1, 2, 3], 0.05, 8, transient=1, derivatives=["x"])
    settled = E6.orbit([1, 2, 3], 0.05, 30).x[-1]
    seen, late = E6.observe(settled, 0.05, 300), E6.observe([1, 2, 3], 0.05, 300, transient=30)
    assert late["steps"] == 330 and late["sali"] == seen["sali"] and late["lyapunov"] == seen["lyapunov"]
    many = E6.ensemble([[1, 2, 3]] * 3, 0.05, 300, transient=30, observe=["sali"], renormalize=5)
    assert (many["sali"] == seen["sali"]).all() and (many.steps == 330).all()
    over = {"x": [1.0, 1.5]}
    chart = E6.chart(over, [1, 2, 3], 0.05, steps=300, transient=30)
    assert chart.values[0] == seen["sali"] and (chart.ended_step == 330).all()


def test_columns_are_those_of_orbits():
    pandas = pytest.importorskip("pandas")
    a = np.array([0.5, 1.5])
    found = E6.ensemble([[1, 2, 3], [2, 1, 3]], 0.05, 20, every=5)
    orbit = E6.orbit([2, 1, 3], 0.05, 20, every=5)
    assert list(found) == ["start", *orbit.columns()] and len(found) == 10
    for name, column in orbit.columns().items():
        assert np.array_equal(found.by_start(name)[1], column), name
    frame = pandas.DataFrame(found)
    assert list(frame["start"]) == [0] * 5 + [1] * 5 and list(frame) == list(found)
    varied = S.ensemble([[0.1, 0.2], [0.3, 0.1]], 0.05, 20, params={"a": a}, every=5)
    assert list(varied)[:4] == ["start", "a", "n", "t"] and np.array_equal(varied.by_start("a")[1], [1.5] * 5)
    chosen = E6.ensemble([[1, 2, 3], [2, 1, 3]], 0.05, 20, every=5, columns=["t", "y", list(E6.integrals)[0]])
    assert list(chosen) == ["t", "y", list(E6.integrals)[0]] and chosen.x.shape == (2, 5, 1)
    for name in chosen:
        assert np.array_equal(chosen[name], found[name]), name
    with pytest.raises(KeyError, match="there is no column `z`"):
        chosen["z"]
    with pytest.raises((KeyError, ValueError), match="there is no column `w`"):
        E6.ensemble([[1, 2, 3]], 0.05, 20, every=5, columns=["w"])
    for wrong in ({"columns": ["x"]}, {"to": "x.parquet"}, {"every": 2, "observe": ["sali"]}, {"every": 0}):
        with pytest.raises(ValueError):
            E6.ensemble([[1, 2, 3]], 0.05, 20, **wrong)


def test_a_dataset_has_starts_and_times():
    pytest.importorskip("xarray")
    found = S(a=1).ensemble([[0.1, 0.2], [0.3, 0.1]], 0.05, 20, every=5).to_xarray()
    assert found["x"].dims == ("start", "t") and found["t"].shape == (5,) and list(found["start_x"]) == [0.1, 0.3]
    varied = S(a=1).ensemble([[0.1, 0.2], [0.3, 0.1]], [0.05, 0.1], 20, every=5).to_xarray()
    assert varied["x"].dims == ("start", "n") and varied["t"].dims == ("start", "n")


def test_a_dataset_keeps_the_grid_of_the_starts():
    pytest.importorskip("xarray")
    grid = np.random.default_rng(5).uniform(0.1, 0.3, (3, 4, 2))
    rates = np.linspace(0.5, 1.5, 12).reshape(3, 4)
    series = S.ensemble(grid, 0.05, 20, every=5, params={"a": rates})
    found, dims = series.to_xarray(), ("start_axis_0", "start_axis_1")
    assert found["x"].dims == (*dims, "t") and np.array_equal(found["x"], series.x[..., 0])
    assert found["a"].dims == dims and np.array_equal(found["a"], rates) and np.array_equal(found["start_y"], grid[..., 1])
    ends = S.ensemble(grid, 0.05, 20, params={"a": rates}, observe=["spectrum"])
    found = ends.to_xarray()
    assert found["x"].dims == found["spectrum_2"].dims == found["ended"].dims == dims
    assert np.array_equal(found["spectrum_2"], ends.spectrum[..., 1]) and np.array_equal(found["y"], ends.x[..., 1])


@pytest.mark.parametrize("ending", ["parquet", "arrow"])
def test_a_file_is_written_part_by_part(tmp_path, monkeypatch, ending):
    pyarrow = pytest.importorskip("pyarrow")
    import pyarrow.parquet

    from kahan import _series

    points = np.random.default_rng(3).uniform(0.5, 2, (50, 3))
    whole = E6.ensemble(points, 0.01, 40, every=10)
    monkeypatch.setattr(_series, "_AT_ONCE", 15 * 7)
    path, heard = tmp_path / f"series.{ending}", []
    ends = E6.ensemble(points, 0.01, 40, every=10, to=path)
    assert np.array_equal(ends.x, whole.x[:, -1]) and list(ends.ended) == list(whole.ended)
    read = pyarrow.parquet.read_table(path) if ending == "parquet" else pyarrow.ipc.open_file(path).read_all()
    assert read.column_names == list(whole) and [one.name for one in tmp_path.iterdir()] == [path.name]
    if ending == "parquet":
        assert pyarrow.parquet.ParquetFile(path).num_row_groups == 8
    for name, column in whole.columns().items():
        assert np.array_equal(read[name].to_numpy(), column), name
    reduced = E6.ensemble(points, 0.01, 40, every=10, columns=["x"])
    assert np.array_equal(reduced["x"], whole["x"]) and not heard
    with pytest.raises(ValueError, match="F.parquet or F.arrow"):
        E6.ensemble(points, 0.01, 40, every=10, to=tmp_path / "series.csv")


def test_the_first_exponents_of_many_variables():
    """For each rate a of a diagonal field, the exponent is log((1 + eps a)/(1 - eps a))/(2 eps)."""
    n = 300
    rates = np.concatenate([[-0.1, -0.5, -1], np.linspace(-2, -3, n - 3)])
    s = kahan.System.from_arrays(B=np.diag(rates))
    found = s.observe(np.ones(n), 0.05, 2000, observe=["spectrum"], spectrum=3)
    exact = np.log((1 + 0.05 * rates[:3]) / (1 - 0.05 * rates[:3])) / 0.1
    assert found["spectrum"].shape == (3,) and np.abs(found["spectrum"] - exact).max() < 1e-2
    many = s.ensemble(np.ones((2, n)), 0.05, 2000, observe=["spectrum"], spectrum=3)
    assert many.spectrum.shape == (2, 3) and np.array_equal(many.spectrum[1], found["spectrum"])
