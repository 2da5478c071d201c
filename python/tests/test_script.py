"""Runs the Python script that `kahan show --sympy` prints.

The command is that of the wheel, or that in the environment variable `KAHAN`."""

import json
import os
import subprocess
import sys

import pytest

sympy = pytest.importorskip("sympy")
KAHAN = os.environ.get("KAHAN")
COMMAND = [KAHAN] if KAHAN else [sys.executable, "-m", "kahan_command"]


def printed(*arguments):
    return subprocess.run([*COMMAND, *arguments], check=True, capture_output=True, encoding="utf-8").stdout


def assigned(*arguments):
    """Returns the variables that the script assigns."""
    names = {}
    exec(printed("show", *arguments, "--sympy"), names)
    return names


def symbols(*names):
    return {sympy.Symbol(name) for name in names}


def is_zero(expression):
    return sympy.expand(sympy.fraction(sympy.together(expression))[0]) == 0


def solves(script):
    return all(is_zero(entry) for entry in script["A"] * script["map"] - script["b"])


def test_names_that_mean_something_elsewhere_are_symbols():
    field = "Idot = beta*S*I - lambda*E; Edot = lambda*I - pi*E; Sdot = -Integer*I; Ndot = lambda_*N/2 + N^2;"
    script = assigned("--field", field)
    assert solves(script)
    assert script["variables"] == [sympy.Symbol(name) for name in "IESN"]
    free = symbols(*"IESN", "beta", "lambda_", "pi", "Integer_", "lambda__")
    assert script["field"].free_symbols == {*script["variables"], *script["parameters"]} == free
    assert script["map"].free_symbols == free | {script["eps"]}


def test_names_that_python_reads_as_one_are_two():
    call = ["--field", "\u03d5dot = \u03c6; \u03c6dot = \u03b1 - \u03d5^2;", "--jacobian"]
    script = assigned(*call)
    assert solves(script)
    assert script["map"].free_symbols == symbols("\u03d5", "\u03c6", "\u03b1", "eps")
    assert is_zero(script["A"].det() - script["det_A"])
    difference = script["map"].jacobian(script["variables"]) - script["jacobian"]
    assert all(is_zero(entry) for entry in difference)
    printed_once = printed("show", *call, "--sympy")
    assert json.loads(printed("show", *call, "--sympy", "--json"))["script"] == printed_once


def test_claims_overwrite_nothing_and_stand_in_later_ones():
    claims = "integral names = x^2 + y^2; integral sympify = names/3; integral lambda = sympify*eps;"
    others = "density claims = 1/names; integral A = lambda/map when map = 2; bracket Symbol { {x,y} = A; } when map = 2;"
    script = assigned("--field", f"xdot = map*y; ydot = -map*x; {claims} {others}")
    assert solves(script)
    found = script["claims"]
    assert list(found) == ["names", "sympify", "lambda_", "claims", "A", "Symbol_"]
    x, y, eps, parameter = (sympy.Symbol(name) for name in ["x", "y", "eps", "map"])
    energy = x**2 + y**2
    assert found["A"] == energy / 3 * eps / parameter
    assert found["Symbol_"] == {"{x,y}": found["A"]}
    moved = dict(zip(script["variables"], script["map"]))
    assert is_zero(energy.subs(moved, simultaneous=True) - energy)


@pytest.mark.parametrize("name", [system["name"] for system in json.loads(printed("list", "--json"))["systems"]])
def test_every_system_of_the_catalog(name):
    shown = json.loads(printed("show", name, "--json"))
    script = assigned(name)
    free = {*script["variables"], *script["parameters"], script["eps"]}
    assert script["A"].free_symbols | script["b"].free_symbols <= free
    if shown["map"] is None:
        assert script["map"] is script["det_A"] is None
    else:
        assert script["map"].free_symbols <= free and solves(script)
    claims = {claim["name"]: claim["kind"] for claim in shown["claims"]}
    assert list(script["claims"]) == list(claims)
    for called, claim in script["claims"].items():
        formulas = claim.values() if claims[called] == "bracket" else [claim]
        assert all(formula.free_symbols <= free for formula in formulas), called
