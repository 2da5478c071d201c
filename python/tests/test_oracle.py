"""Compares the catalog with exact values that were computed without this project's code."""

import json
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import kahan

if hasattr(sys, "set_int_max_str_digits"):
    # Allows conversion of the iterates of E9, which have thousands of digits.
    sys.set_int_max_str_digits(0)
DATA = Path(__file__).resolve().parents[2] / "tests" / "data"
NAMES = ["euler", "lv", *(f"e{i}" for i in range(1, 10))]
ALIKE = {"A": "A", "b": "b", "det_A": "det_A", "x_next": "x_next", "jacobian": "jacobian",
         "det_jacobian": "det_jacobian", "field": "f", "field_jacobian": "field_jacobian"}


def fractions(value):
    if isinstance(value, list):
        return [fractions(item) for item in value]
    return None if value is None else Fraction(value)


@pytest.mark.parametrize("name", NAMES)
def test_every_object_at_every_point(name):
    cases = json.loads((DATA / f"{name}.json").read_text())["cases"]
    assert cases
    for case in cases:
        system = getattr(kahan.catalog, name)(**case["params"])
        found = system.evaluate(case["x"], case["eps"], exact=True)
        for own, theirs in ALIKE.items():
            value = found[own]
            value = value.tolist() if isinstance(value, np.ndarray) else value
            assert value == fractions(case.get(theirs)), (name, own, case["x"])


@pytest.mark.parametrize("name", NAMES)
def test_orbits(name):
    orbits = json.loads((DATA / f"{name}.json").read_text())["orbits"]
    assert orbits
    for case in orbits:
        system = getattr(kahan.catalog, name)(**case["params"])
        x = fractions(case["x0"])
        for wanted in fractions(case["iterates"])[:6]:
            x = system.evaluate(x, case["eps"], exact=True).x_next.tolist()
            assert x == wanted
