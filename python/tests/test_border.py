"""Checks that calls with any arguments answer, or raise an exception that Python's users expect."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import kahan

E6 = kahan.catalog.e6
EXPECTED = (TypeError, ValueError, ArithmeticError)

dtypes = st.one_of(hnp.floating_dtypes(), hnp.integer_dtypes(), hnp.boolean_dtypes(), hnp.complex_number_dtypes(),
                   hnp.byte_string_dtypes(), hnp.unicode_string_dtypes())
arrays = dtypes.flatmap(lambda dtype: hnp.arrays(dtype, hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4)))
anything = st.one_of(
    arrays, st.none(), st.booleans(), st.text(), st.binary(), st.floats(), st.integers(), st.just(10**500),
    st.lists(st.one_of(st.floats(), st.integers(), st.just(10**400), st.text()), max_size=4),
    st.lists(st.lists(st.floats(), max_size=4), max_size=4), st.fractions(), st.decimals(), st.dictionaries(st.text(), st.floats()),
)


def quietly(call):
    """Returns the result of the call, or None if the call raises an exception in EXPECTED."""
    try:
        with np.errstate(all="ignore"):
            return call()
    except EXPECTED:
        return None


@settings(max_examples=300, deadline=None)
@given(anything, anything)
def test_steps(x, eps):
    found = quietly(lambda: E6.step(x, eps))
    if found is not None:
        assert found.shape == np.shape(x) and found.dtype in (np.float32, np.float64)
    quietly(lambda: E6.try_step(x, eps))
    quietly(lambda: E6.integral_values(x, eps))


@settings(max_examples=150, deadline=None)
@given(anything, anything, st.one_of(st.integers(-3, 50), anything), st.one_of(st.integers(-2, 9), anything))
def test_orbits(x, eps, steps, every):
    quietly(lambda: E6.orbit(x, eps, steps if not isinstance(steps, int) or steps < 10**6 else 3, every=every))
    quietly(lambda: E6.orbit(x, 0.1, 5, order=every, compensated=True))


@settings(max_examples=150, deadline=None)
@given(anything, anything, anything)
def test_ensembles(points, eps, out):
    quietly(lambda: E6.ensemble(points, eps, 3))
    quietly(lambda: E6.ensemble(np.ones((2, 3)), eps, 3, out=out))
    quietly(lambda: kahan.catalog.euler.ensemble(np.ones((2, 3)), 0.1, 3, params={"a1": points, "a2": eps, "a3": 1}))


@settings(max_examples=300, deadline=None)
@given(st.one_of(st.text(), st.text("xyzdot=;*+-/^ 0123456789.(){}[],\n'", max_size=60), anything))
def test_fields(text):
    quietly(lambda: kahan.System(text))


@settings(max_examples=100, deadline=None)
@given(anything, anything)
def test_questions(x, eps):
    quietly(lambda: E6.evaluate(x, eps, exact=True))
    quietly(lambda: E6.observe(x, eps, 10))
    quietly(lambda: E6.section(x, eps, 10, "x"))


@settings(max_examples=100, deadline=None)
@given(st.text())
def test_planes(text):
    quietly(lambda: E6.section([1, 2, 3], 0.1, 10, text))


def test_layouts():
    x = np.arange(6.0).reshape(3, 2)[:, 0]
    assert not x.flags.c_contiguous
    assert np.array_equal(E6.step(x, 0.1), E6.step(x.copy(), 0.1))
    fortran = np.asfortranarray(np.ones((4, 3)))
    assert np.array_equal(E6.step(fortran, 0.1), E6.step(np.ones((4, 3)), 0.1))

    class Own(np.ndarray):
        pass

    assert np.array_equal(E6.step(np.ones(3).view(Own), 0.1), E6.step(np.ones(3), 0.1))
    readonly = np.ones(3)
    readonly.flags.writeable = False
    assert np.isfinite(E6.step(readonly, 0.1)).all()
    with pytest.raises(ValueError, match="out"):
        E6.step(np.ones(3), 0.1, out=readonly)
    with pytest.raises(ValueError, match="out"):
        E6.step(np.ones(3), 0.1, out=np.ones(4))
    with pytest.raises(TypeError, match="out"):
        E6.step(np.ones(3), 0.1, out=np.ones(3, dtype=np.float32))
    same, wanted = np.ones(3), E6.step(np.ones(3), 0.1)
    assert E6.step(same, 0.1, out=same) is same and np.array_equal(same, wanted)
    twice = np.ones(4)
    with pytest.raises(ValueError, match="out"):
        E6.step(twice[:3], 0.1, out=twice[1:])
    assert E6.step(np.ones(3, dtype=np.float32), 0.1).dtype == np.float32
    assert E6.step(np.ones((0, 3)), 0.1).shape == (0, 3)
