"""Tests models in files: their solutions against libroadrunner's, saved texts, and refusals."""

import builtins
import json
import re
from pathlib import Path

import numpy as np
import pytest

import kahan

MODELS = Path(__file__).parent / "models"
SOLUTIONS = json.loads((MODELS / "solutions.json").read_text())
"""The solutions of libroadrunner, which `benchmarks/models.py --record` writes."""
NEEDED = {".ant": ("libsbml", "antimony"), ".xml": ("libsbml",)}


def needs(ending: str) -> None:
    for package in NEEDED.get(ending, ()):
        pytest.importorskip(package)


@pytest.fixture
def antimony(tmp_path):
    """Returns a function that reads a model in the language Antimony."""
    needs(".ant")

    def read(text, **parameters):
        (tmp_path / "model.ant").write_text(text)
        return kahan.read(tmp_path / "model.ant", **parameters)

    return read


def solved(s, horizon, steps):
    return s.orbit(eps=horizon / steps / 2, steps=steps, every=steps // 10, order=8).x


@pytest.mark.parametrize("name", SOLUTIONS)
def test_a_model_has_the_solution_of_libroadrunner(name, tmp_path):
    needs(Path(name).suffix)
    s = kahan.read(MODELS / name)
    wanted = SOLUTIONS[name]
    points, scale = np.array(wanted["points"]), np.abs(wanted["points"]).max(axis=0)
    assert s.variables == tuple(wanted["names"])
    np.testing.assert_allclose([float(value) for value in s.start], points[0], rtol=1e-15)
    assert np.abs((solved(s, wanted["time"], 1280) - points) / scale).max() < 1e-8
    # The saved text of a field reads as the same model.
    (tmp_path / "saved.kahan").write_text(s.source)
    saved = kahan.read(tmp_path / "saved.kahan")
    assert (saved.text, saved.start, saved.parameters) == (s.text, s.start, s.parameters)


def test_every_model_has_a_solution_and_its_reading_is_in_the_gate():
    assert {path.name for path in MODELS.iterdir() if path.suffix != ".json"} == set(SOLUTIONS)
    assert len(SOLUTIONS) >= 40


def test_what_was_read_is_in_the_text(antimony):
    s = antimony("""model cycle()
        compartment cell = 2.5; species A in cell = 3, B in cell; species $F in cell = 0.7; substanceOnly species N in cell = 4
        J1: A -> B; cell*k*A*F; J2: B -> A + N; cell*h*B
        k = 0.2; h = 3*k; B = A/4; unused = 7
        unit substance = mole; unit volume = litre; unit time_unit = second
    end""")
    assert s.variables == ("A", "B", "N")
    assert [float(value) for value in s.start] == [3, 0.75, 4]
    assert {name: float(value) for name, value in s.parameters.items()} == {"cell": 2.5, "F": 0.7, "k": 0.2, "h": 0.6}
    assert list(map(str, s.integrals.values())) == ["A + B"]
    for line in ('# The model "cycle" of model.ant', "init A=3  # concentration in cell", "init N=4  # amount in cell",
                 "par F=0.7  # concentration in cell, held", "par cell=2.5  # volume", "# no equation needs unused",
                 "# h = 3 * k is computed once, from the values of this text", "J1 = cell*k*A*F"):
        assert line in s.source.splitlines(), s.source
    assert "amounts in mole; volumes in litre" in s.source
    faster = antimony("A -> ; k*A; A = 1; k = 1", k=2)
    assert faster.orbit(eps=0.01, steps=50, order=8).x[-1] == pytest.approx([np.exp(-2)], rel=1e-9)


def test_totals_of_several_volumes_are_amounts(antimony):
    s = antimony("compartment a = 2, b = 3; species A in a = 1, B in b = 0; A -> 2 B; k*A; k = 0.1")
    assert list(map(str, s.integrals.values())) == ["2*a*A + b*B"]
    drift = s.integral_values(s.orbit(eps=0.05, steps=100).x, 0.05)["total1"]
    assert np.ptp(drift) < 1e-14


REFUSED = {
    "A -> ; k*A; A = 1; k = 1\nE1: at A < 0.5: A = 1": r":2: the event `E1` stops the flow",
    "A -> ; k*A; A = 1; k = 1\n  at A < 0.5: A = 1": r":2: the event `_E0`",
    "A' = -k*A; A = 1\nk := piecewise(1, A > 2, 3)": r":2: the assignment rule `k`: `piecewise` has a jump",
    "J: A -> ; k*delay(A, 2)\nA = 1; k = 1": r":1: the reaction `J`: `delay` is a value of the past",
    "J: A -> ; k*abs(A)\nA = 1; k = 1": r"`abs` has a jump or a corner",
    "J: A -> ; floor(A)\nA = 1; k = 1": r"`floor` has a jump or a corner",
    "J: A -> B;\nA = 1": r"the reaction `J` has no kinetic law",
    "A = 1; k = 1\nB = A/k": "the model has no species that a reaction changes",
    "A -> ; k*A*; A = 1": "line 1",
    "A -> ; k*A; A = 1\nk = inf": ":2: the parameter `k` is inf, and a field has numbers",
    "compartment c := 2 + time\nspecies S in c = 1; S -> ; k*S; k = 1":
        ":1: the assignment rule `c`: its volume follows a formula",
}


@pytest.mark.parametrize("text", REFUSED)
def test_other_parts_are_refused_by_name_and_place(text, antimony):
    with pytest.raises(ValueError, match=REFUSED[text]):
        antimony(text)


@pytest.mark.parametrize(("old", "new", "why"), [
    ('<reaction id="J1"', '<reaction fast="true" id="J1"', r"level.xml:\d+: the fast reaction `J1` is at its equilibrium"),
    ("<listOfReactions>", '<listOfRules><algebraicRule><math xmlns="http://www.w3.org/1998/Math/MathML"><ci> A </ci></math>'
     "</algebraicRule></listOfRules><listOfReactions>", r"level.xml:\d+: the algebraic rule is no equation of a derivative"),
    ("</model>", "", r"level.xml:\d+: the file"),
])
def test_parts_of_sbml_are_refused_by_name_and_line(old, new, why, tmp_path):
    needs(".xml")
    text = (MODELS / "local_parameters.xml").read_text()
    text = re.sub(r' fast="\w+"', "", text)
    assert old in text
    (tmp_path / "level.xml").write_text(text.replace(old, new, 1))
    with pytest.raises(ValueError, match=why):
        kahan.read(tmp_path / "level.xml")


def test_missing_values_are_said(antimony):
    s = antimony("A -> B; k*A; A = 1")
    assert "# B has no first value, and is read with 0" in s.source
    assert s.parameters == {"k": None}
    with pytest.raises(ValueError, match="k"):
        s.orbit(eps=0.1, steps=1)


def test_constants_are_computed_and_exponents_are_numbers(antimony):
    s = antimony("S -> ; V*S^n; S = 2; V = log(3)*exp(W/8)\nW = 4; n = 2; P = 0\nP' = sqrt(W + 1)*exp(-W/8)")
    assert "n = 2 is an exponent, and stands in the text as a number" in s.source
    assert s.lifted is None and "n" not in s.parameters
    assert float(s.parameters["V"]) == pytest.approx(np.log(3) * np.exp(0.5), rel=1e-15)
    assert s.arrays()[0][1] == pytest.approx(np.sqrt(5) * np.exp(-0.5), rel=1e-15)


def test_a_lift_may_be_asked_for(antimony):
    text = "A -> B; V*A/(K + A); A = 1; V = 2; K = 0.5"
    assert antimony(text).lifted.order == 2
    assert antimony(text, lift="smallest").lifted.order <= 2
    with pytest.raises(ValueError, match="lift"):
        antimony(text, lift="fastest")


def test_first_values_may_have_jumps(antimony):
    s = antimony("A -> ; k*A*A; A = piecewise(1, k > 3, 2, k > 1, 3) + abs(-k) - floor(2.5); k = max(2, c); c = 1.5")
    assert (s.start, float(s.parameters["k"])) == ((2,), 2)
    assert antimony("A -> ; factorial(n)*A; A = 1; n = 3").arrays()[1].tolist() == [[-6]]


def test_a_package_that_is_missing_is_named(tmp_path, monkeypatch):
    real = builtins.__import__
    (tmp_path / "m.xml").write_text("<sbml/>")
    monkeypatch.setattr("kahan._errors.import_module", lambda name: real("no_such_package_" + name))
    with pytest.raises(ImportError, match="pip install python-libsbml"):
        kahan.read(tmp_path / "m.xml")


def test_texts_are_read_by_their_ending(tmp_path):
    def read(name, text, **parameters):
        (tmp_path / name).write_text(text)
        return kahan.read(tmp_path / name, **parameters)

    for text in ("pub struct Own { a }\nxdot = a*y;\nydot = -x;", "x' = a*y\ny' = -x\npar a=1"):
        assert read("own.kahan", text, a=3).parameters["a"] == 3
    assert read("root.txt", "x' = -x/(1 + x)\ninit x=1").lifted.order > 0
    with pytest.raises(ValueError, match="ending says what is in a file; it must be one of"):
        read("own.toml", "x' = y")
    with pytest.raises(kahan.FieldError, match="`abs"):
        read("own.ode", "x'=-abs(x)\ninit x=1\ndone")
    with pytest.raises(kahan.FieldError, match="`wiener` makes the equations random"):
        read("own.ode", "x'=-x+w\nwiener w\ndone")


def test_arrays_are_read(tmp_path):
    np.savez(tmp_path / "own.npz", c=[0, 1], B=[[0, 1], [-2, 0]], names=["x", "v"])
    assert kahan.read(tmp_path / "own.npz").text == "xdot = v;\nvdot = 1 - 2*x;"


def test_xpp_knows_no_case_and_begins_at_0(tmp_path):
    (tmp_path / "own.ode").write_text("PAR Eps=.5, Type=2\nX'=eps*Y\ndy/DT=-x*TYPE\nINIT x=1\n@ TOTAL=10\ndone\n$$$")
    s = kahan.read(tmp_path / "own.ode")
    assert s.variables == ("X", "Y") and s.start == (1, 0)
    assert s.orbit(eps=0.05, steps=20, order=8).x[-1] == pytest.approx([np.cos(2), -2 * np.sin(2)], rel=1e-9)


@pytest.mark.parametrize(("name", "text", "place"), [
    ("own.ode", "par a=1\nx'=y\ny'=-heav(x)", [3, 5]),
    ("own.ode", "par eps=1\nx'=y\ny'=-foo(x)\ndone\n", [3, 5]),
    ("own.kahan", "xdot = y;\nydot = -foo(x);", [2, 9]),
    ("own.kahan", "x' = y\ny' = -x\nintegral H = x^2", [3, 10]),
])
def test_a_mistake_has_its_file_and_its_line_there(tmp_path, name, text, place):
    (tmp_path / name).write_text(text)
    with pytest.raises(kahan.FieldError) as caught:
        kahan.read(tmp_path / name)
    assert [caught.value.line, caught.value.column] == place
    assert f"\n --> {tmp_path / name}:{place[0]}:{place[1]}\n" in str(caught.value)


def test_a_mistake_of_a_made_text_has_its_line_in_that(antimony):
    with pytest.raises(kahan.FieldError, match=r"--> text made from .*model\.ant:\d+:\d+\n") as caught:
        antimony("model own()\nx' = 1/(x - 2); x = 1\nend", lift="energy")
    assert "field:" not in str(caught.value)


def test_an_orbit_begins_at_the_start_of_the_text():
    s = kahan.System("x' = y, y' = -x, init x=1, y=0")
    np.testing.assert_array_equal(s.orbit(eps=0.1, steps=3).x, s.orbit([1, 0], 0.1, 3).x)
    with pytest.raises(TypeError, match="x is missing: the text gives no start"):
        kahan.System("x' = y, y' = -x").orbit(eps=0.1, steps=3)
    with pytest.raises(TypeError, match="steps is missing: give a whole number"):
        s.orbit(eps=0.1)


def test_endings_have_no_case_and_hints(tmp_path: Path) -> None:
    for name, text in (("M.KAHAN", "xdot = x;"), ("M.Ode", "x'=x\ndone\n")):
        (tmp_path / name).write_text(text)
        assert kahan.read(tmp_path / name).variables == ("x",)
    with pytest.raises(ValueError, match="Antimony's is .ant$"):
        kahan.read("model.antimony")
    with pytest.raises(ValueError, match=r"kahan.System\(text\)$"):
        kahan.read("xdot = x;")
