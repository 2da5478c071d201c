"""Tests fields that are made from arrays, and the arrays that fields return."""

import os
import pickle
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

import kahan
from kahan._coefficients import loaded


def quadratic(n, rng, size=0.1):
    """Returns random dense arrays c, B and a symmetric Q."""
    Q = rng.normal(size=(n, n, n)) * size
    return rng.normal(size=n) * size, rng.normal(size=(n, n)) * size, Q + Q.transpose(0, 2, 1)


def triangle(Q, order):
    """Returns the coefficients of Q with each product of two variables once."""
    n = len(Q)
    whole = Q + Q.transpose(0, 2, 1) - Q * np.eye(n)
    j, k = np.tril_indices(n) if order == "tril" else np.triu_indices(n)
    return whole[:, j, k]


@pytest.mark.parametrize("n", [1, 2, 3, 7, 12])
def test_all_forms_of_arrays_are_one_field(n):
    c, B, Q = quadratic(n, np.random.default_rng(n))
    x = np.linspace(-0.5, 0.5, n)
    s = kahan.System.from_arrays(c, B, Q)
    assert s.variables == tuple(f"x{i + 1}" for i in range(n))
    expected = c + B @ x + Q @ x @ x
    np.testing.assert_allclose(s.rhs()(0.0, x), expected, rtol=1e-14 * n**2, atol=1e-15 * n**2)
    # Computes Kahan's map with NumPy, from the arrays alone.
    eps = 0.01
    step = x + 2 * eps * np.linalg.solve(np.eye(n) - eps * (B + 2 * Q @ x), expected)
    np.testing.assert_allclose(s.step(x, eps), step, rtol=1e-13, atol=1e-15)
    # The sum of two halves may differ from the coefficient in the last bit.
    for other, order in ((Q.reshape(n, n * n), "tril"), (triangle(Q, "tril"), "tril"), (triangle(Q, "triu"), "triu")):
        again = kahan.System.from_arrays(c, B, other, order=order)
        np.testing.assert_allclose(again.step(x, eps), step, rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize("n", [2, 5, 11])
def test_arrays_come_back_as_they_were_given(n):
    c, B, Q = quadratic(n, np.random.default_rng(n))
    s = kahan.System.from_arrays(c, B, Q)
    for found, given in zip(s.arrays(), (c, B, Q)):
        assert (found == given).all()
    scipy = pytest.importorskip("scipy.sparse")
    found = s.arrays(sparse=True)
    assert (found[1].toarray() == B).all() and (found[2].toarray() == Q.reshape(n, n * n)).all()
    sparse = kahan.System.from_arrays(c, scipy.csr_matrix(B), scipy.coo_array(Q.reshape(n, n * n)))
    assert sparse.text == s.text and sparse == s


def test_arrays_say_what_the_text_says():
    text = kahan.System("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x) + 3/8;")
    s = kahan.System.from_arrays(*text.arrays(), names=["x", "y", "z"])
    x = [0.3, 0.5, -0.2]
    # The text has factored terms and the arrays have expanded terms, so the last digits differ.
    np.testing.assert_allclose(s.orbit(x, 0.01, 200).x, text.orbit(x, 0.01, 200).x, rtol=1e-13)
    assert kahan.System(s.text).arrays()[2].tolist() == s.arrays()[2].tolist()
    euler = kahan.System.from_arrays(Q=kahan.catalog.euler(a1=1, a2=-3, a3=1).arrays()[2])
    assert len(euler.discover().integrals) >= 2
    assert euler.evaluate([Fraction(1, 2), 1, 2], Fraction(1, 10), exact=True).x_next[0].denominator > 1


def test_floats_are_taken_exactly():
    s = kahan.System.from_arrays(B=[[0.1]], names=["x"])
    assert s.text == f"xdot = {Fraction(0.1)}*x;"
    single = kahan.System.from_arrays(B=np.array([[0.1]], dtype=np.float32), names=["x"])
    assert single.arrays()[1].item() == float(np.float32(0.1))


def test_parameters_multiply_arrays():
    s = kahan.System.from_arrays(
        c=[1, 0], parameters={"mu": {"B": [[0, 0], [0, -1]]}, "nu": (None, None, [[0, 0, 0, 0], [1, 0, 0, 0]])}, names=["u", "v"])
    assert s.text == "udot = 1;\nvdot = -mu*v + nu*u^2;" and list(s.parameters) == ["mu", "nu"]
    at = s(mu=0.5, nu="1/3")
    text = kahan.System("udot = 1; vdot = -mu*v + nu*u^2;", mu=0.5, nu="1/3")
    assert (at.orbit([0.1, 0.2], 0.05, 20).x == text.orbit([0.1, 0.2], 0.05, 20).x).all()
    with pytest.raises(ValueError, match="mu"):
        s.arrays()
    again = pickle.loads(pickle.dumps(at))
    assert again == at and (again.step([0.1, 0.2], 0.1) == at.step([0.1, 0.2], 0.1)).all()


@pytest.mark.parametrize(("arrays", "message"), [
    ({}, "at least one"),
    ({"B": [[1, 2]]}, r"B has the shape \(1, 2\); with 1 variables it must be \(1, 1\)"),
    ({"c": [1, 2], "Q": np.zeros((2, 5))}, r"Q has the shape \(2, 5\).*\(2, 2, 2\), \(2, 4\) or \(2, 3\)"),
    ({"B": [[0, np.nan], [0, 0]]}, r"B: the entry \(0, 1\) is nan"),
    ({"c": [np.inf]}, r"c: the entry \(0,\) is inf"),
    ({"c": [1.0], "names": ["a", "b"]}, "names: there are 2 and 1 variables"),
    ({"c": [1.0], "order": "F"}, "order"),
    ({"c": [1.0], "parameters": {"a": {"D": [1.0]}}}, "there is no `D`"),
    ({"c": 1.0}, "shape"),
])
def test_what_is_no_field_is_an_error(arrays, message):
    with pytest.raises(ValueError, match=message):
        kahan.System.from_arrays(**arrays)


@pytest.mark.parametrize("names", [["eps"], ["2x"], ["a b"], ["x+y"]])
def test_names_follow_the_rules_of_texts(names):
    with pytest.raises(kahan.FieldError):
        kahan.System.from_arrays(c=[1.0], names=names)
    with pytest.raises(kahan.FieldError):
        kahan.System.from_arrays(c=[1.0, 1.0], names=["x", "x"])


def test_many_variables_step_as_the_arrays_say():
    rng = np.random.default_rng(5)
    n = 200
    c, B, Q = quadratic(n, rng, size=0.01)
    s = kahan.System.from_arrays(c, B, Q)
    x, eps = rng.normal(size=n) * 0.1, 0.001
    step = x + 2 * eps * np.linalg.solve(np.eye(n) - eps * (B + 2 * Q @ x), c + B @ x + Q @ x @ x)
    np.testing.assert_allclose(s.step(x, eps), step, rtol=1e-12, atol=1e-14)


def test_ten_thousand_sparse_variables():
    scipy = pytest.importorskip("scipy.sparse")
    n, i = 10_000, np.arange(10_000)
    B = scipy.diags_array([np.ones(n - 1), -2 * np.ones(n), np.ones(n - 1)], offsets=[-1, 0, 1])
    Q = scipy.coo_array((-np.ones(n), (i, i * n + i)), shape=(n, n * n))
    s = kahan.System.from_arrays(B=B, Q=Q)
    x, eps = np.full(n, 0.5), 0.1
    matrix = scipy.eye_array(n) - eps * (B - 2 * scipy.diags_array(x))
    from scipy.sparse.linalg import spsolve

    step = x + 2 * eps * spsolve(matrix.tocsc(), B @ x - x**2)
    np.testing.assert_allclose(s.step(x, eps), step, rtol=1e-12, atol=1e-14)


def shown(path):
    """Returns the equations that the command shows for a file."""
    command = [os.environ["KAHAN"]] if "KAHAN" in os.environ else [sys.executable, "-m", "kahan_command"]
    done = subprocess.run([*command, "show", "--file", path, "--macro"], check=True, capture_output=True, encoding="utf-8")
    return "\n".join(line.strip() for line in done.stdout.splitlines() if "dot = " in line)


def test_arrays_in_a_file_are_a_field(tmp_path):
    c, B, Q = quadratic(3, np.random.default_rng(3))
    s = kahan.System.from_arrays(c, B, Q, names=["u", "v", "w"])
    path = tmp_path / "model.npz"
    np.savez(path, c=c, B=B, Q=Q, names=s.variables)
    assert kahan.System.from_arrays(**loaded(path)) == s and shown(path) == s.text
    np.savez_compressed(path, Q=triangle(Q, "triu"), order="triu")
    assert kahan.System.from_arrays(**loaded(path)).text == kahan.System.from_arrays(Q=triangle(Q, "triu"), order="triu").text
    assert shown(path) == kahan.System.from_arrays(**loaded(path)).text
    scipy = pytest.importorskip("scipy.sparse")
    sparse = scipy.csr_array(Q.reshape(3, 9))
    np.savez(path, c=c, B=B, Q_data=sparse.data, Q_indices=sparse.indices, Q_indptr=sparse.indptr, names=s.variables)
    assert kahan.System.from_arrays(**loaded(path)) == s and shown(path) == s.text


@pytest.mark.parametrize(("arrays", "message"), [
    ({"c": [1.0], "D": [1.0]}, "has an array `D`"),
    ({"B_data": [1.0]}, "a sparse B is B_data, B_indices and B_indptr"),
    ({"B": [[1.0]], "B_data": [1.0], "B_indices": [0], "B_indptr": [0, 1]}, "without B itself"),
])
def test_a_file_of_other_arrays_is_an_error(tmp_path, arrays, message):
    np.savez(tmp_path / "model.npz", **arrays)
    with pytest.raises(ValueError, match=message):
        loaded(tmp_path / "model.npz")
    np.save(tmp_path / "one.npy", [1.0])
    with pytest.raises(ValueError, match="has one array"):
        loaded(tmp_path / "one.npy")


@pytest.mark.parametrize("n", [1, 2, 5])
def test_operators_of_opinf_are_arrays(n):
    operators = pytest.importorskip("opinf").operators
    rng = np.random.default_rng(n)
    c, A, H = rng.normal(size=n), rng.normal(size=(n, n)), rng.normal(size=(n, n * (n + 1) // 2))
    s = kahan.System.from_arrays(c, A, H)
    model = [operators.ConstantOperator(c), operators.LinearOperator(A), operators.QuadraticOperator(H)]
    assert kahan.System.from_arrays(*(operator.entries for operator in model)) == s
    rate = s.rhs()
    for x in rng.normal(size=(20, n)):
        np.testing.assert_allclose(rate(0.0, x), sum(operator.apply(x) for operator in model), rtol=1e-13, atol=1e-13)


def test_an_inferred_model_is_a_field():
    opinf = pytest.importorskip("opinf")
    truth = kahan.System("udot = 1/10 - u + u*v/2; vdot = -v/5 - u^2/2;")
    t = np.linspace(0, 10, 2001)
    states = truth.orbit([1, 1], t[1] / 2, 2000, order=6).x.T
    model = opinf.models.ContinuousModel("cAH")
    model.fit(states, truth.field(states.T).T)
    c, A, H = (operator.entries for operator in model.operators)
    s = kahan.System.from_arrays(c, A, H, names=["u", "v"])
    np.testing.assert_allclose(s.rhs()(0.0, states[:, 7]), model.rhs(0.0, states[:, 7]), rtol=1e-13)
    for found, wanted in zip(s.arrays(), truth.arrays()):
        np.testing.assert_allclose(found, wanted, atol=1e-9)


def test_damaged_files_are_named(tmp_path):
    path = tmp_path / "model.npz"

    def refused(match):
        with pytest.raises(ValueError, match=match) as raised:
            kahan.read(path)
        assert "model.npz" in str(raised.value) and "pickle" not in str(raised.value)

    np.savez(path, B=np.eye(2))
    whole = path.read_bytes()
    flipped = bytearray(whole)
    flipped[170] ^= 255
    for content in (b"", b"no zip", pickle.dumps([1]), b"PK\x03\x04", whole[:200], bytes(flipped)):
        path.write_bytes(content)
        refused("cannot be read as arrays of numbers: it is damaged")
    for arrays, said in (
        ({"B": np.array([[1, None], [2, 3]], dtype=object)}, "Python's objects"),
        ({"B": [[1, np.nan], [2, 3]]}, "entry .* is nan"),
        ({"B": np.ones((2, 3))}, r"has the shape \(2, 3\)"),
        ({"B": np.eye(2), "names": ["a", "c d"]}, "names: `c d` cannot be a variable"),
        ({"B": np.array(["a", "b"])}, "`a` is not a number"),
    ):
        np.savez(path, **arrays)
        refused(said)
    path.rename(tmp_path / "OTHER.NPZ").write_bytes(whole)
    assert kahan.read(tmp_path / "OTHER.NPZ").variables == ("x1", "x2")


@pytest.mark.parametrize("names, said", [
    (["a", "b", "c d"], "`c d` cannot be a variable"), (["a", "b", ""], "`` cannot be"), (["a", "b", "a"], "`a` is there twice"),
])
def test_wrong_names_are_said(names, said):
    with pytest.raises(kahan.FieldError, match=said) as raised:
        kahan.System.from_arrays(B=np.eye(3), names=names)
    assert said in raised.value.message
