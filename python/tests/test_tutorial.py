"""Runs the tutorial, one cell after the other.

Websites for source code show the stored outputs. This command renews the stored outputs:
``jupyter nbconvert --to notebook --execute --inplace tutorial.ipynb``.
"""

import json
import sys
from pathlib import Path

import pytest

CELLS = json.loads((Path(__file__).resolve().parents[1] / "tutorial.ipynb").read_text(encoding="utf-8"))["cells"]
CODE = ["".join(cell["source"]) for cell in CELLS if cell["cell_type"] == "code"]


def test_every_cell_runs(monkeypatch):
    pytest.importorskip("sympy")
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    names = {}
    for number, code in enumerate(CODE):
        exec(compile(code, f"code cell {number} of tutorial.ipynb", "exec"), names)
    # The cell leaves out the comparison if SciPy is missing.
    monkeypatch.setitem(sys.modules, "scipy.integrate", None)
    (compared,) = [code for code in CODE if "scipy" in code]
    exec(compared, names)
    matplotlib.pyplot.close("all")
