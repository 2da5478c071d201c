"""The parameters and formulas of a field."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cached_property
from typing import Any

from ._exact import _number
from ._formula import Formula, Symbols
from ._kahan import Field

__all__ = ["Formulas"]


class Formulas(Field):
    """A field with its parameters, formulas and claims by name."""

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters with their values as fractions, or ``None`` for a parameter without a
        value.

        Values given by name replace those in the text of the field. Values of the text are used
        where numbers are needed; formulas keep the names.

        >>> import kahan
        >>> s = kahan.System("par a=2\\ninit x=1, y=0\\nx' = y\\ny' = -a*x")
        >>> s.parameters, s.start, s.text
        ({'a': Fraction(2, 1)}, (Fraction(1, 1), Fraction(0, 1)), 'xdot = y;\\nydot = -a*x;')
        """
        return {name: None if value is None else _number(value) for name, value in self._given}

    def _sheet(self, form: str) -> dict[str, Any]:
        """Returns all formulas in one notation, computed once."""
        sheets: dict[str, dict[str, Any]] = self.__dict__.setdefault("_sheets", {})
        if form not in sheets:
            sheets[form] = json.loads(self._answer(json.dumps({"ask": "show", "as": form, "jacobian": True})))
        return sheets[form]

    def _formula(self, key: str) -> Formula:
        if self._sheet("text").get(key) is None:
            raise ValueError(f"{self.name} has no {key} as a formula: it is beyond the budget of terms")
        return Formula(lambda form: self._sheet(form)[key], self._symbols)

    @cached_property
    def _symbols(self) -> Symbols:
        claims = self._sheet("text")["claims"]
        functions = {claim["name"]: claim["equations"][0][1] for claim in claims if claim["kind"] != "bracket"}
        return Symbols(tuple(self._all_variables), self.parameters, functions)

    @property
    def field(self) -> Formula:
        """The field f(x), a vector. If coefficients depend on eps, it is taken at eps = 0."""
        return self._formula("field")

    @property
    def field_jacobian(self) -> Formula:
        """The Jacobian f'(x) of the field. If coefficients depend on eps, it is taken at eps = 0."""
        return self._formula("field_jacobian")

    @property
    def A(self) -> Formula:
        """The matrix A(x, eps). The map x -> x~ solves A(x, eps) x~ = b(x, eps)."""
        return self._formula("A")

    @property
    def b(self) -> Formula:
        """The right-hand side b(x, eps) of A x~ = b, a vector."""
        return self._formula("b")

    @property
    def det_A(self) -> Formula:
        """The determinant det A(x, eps). Its zeros are the poles of the map, except for factors that cancel."""
        return self._formula("det_A")

    @property
    def map(self) -> Formula:
        """Kahan's map x -> x~ in lowest terms, a vector."""
        return self._formula("map")

    @property
    def jacobian(self) -> Formula:
        """The Jacobian dx~/dx of the map, a matrix of fractions in lowest terms."""
        return self._formula("jacobian")

    def _claims(self, kind: str, arranged: Callable[[list[str], dict[str, Any], str], Any]) -> dict[str, Formula]:
        """Returns the claims of a kind by name. ``arranged`` formats the right-hand sides of a claim in a notation."""
        def formula(place: int, claim: dict[str, Any]) -> Formula:
            def read(form: str) -> Any:
                return arranged([right for _, right in self._sheet(form)["claims"][place]["equations"]], claim, form)

            return Formula(read, self._symbols, claim["name"], claim["when"])

        claims = enumerate(self._sheet("text")["claims"])
        return {claim["name"]: formula(k, claim) for k, claim in claims if claim["kind"] == kind}

    @property
    def integrals(self) -> dict[str, Formula]:
        """The claimed integrals by name. Each was proved when the field was read."""
        return self._claims("integral", lambda sides, *_: sides[0])

    @property
    def densities(self) -> dict[str, Formula]:
        """The claimed invariant densities by name: the map preserves the volume form density dx."""
        return self._claims("density", lambda sides, *_: sides[0])

    @property
    def brackets(self) -> dict[str, Formula]:
        """The claimed Poisson brackets by name, as antisymmetric matrices: brackets["P"]["x", "y"] is {x, y}."""
        names = self._all_variables

        def matrix(sides: list[str], claim: dict[str, Any], form: str) -> list[list[str]]:
            entries = [["0"] * len(names) for _ in names]
            for pair, text in zip(claim["pairs"], sides):
                i, j = map(names.index, pair)
                entries[i][j], entries[j][i] = text, rf"-\left({text}\right)" if form == "latex" else f"-({text})"
            return entries

        return self._claims("bracket", matrix)

    @property
    def drifts(self) -> dict[str, Formula]:
        """The claimed drifts by name. Each is a vector of a function F and of its next value as a
        formula in F.

        >>> import kahan
        >>> F = kahan.System("xdot = x^2; drift F = 1/x by F - 2*eps;").drifts["F"]
        >>> str(F[0]), str(F[1]), F(["1/3"], eps="1/2").tolist()
        ('1/x', 'F - 2*eps', [Fraction(3, 1), Fraction(2, 1)])
        """
        return self._claims("drift", lambda sides, *_: sides)

    def _repr_latex_(self) -> str:
        """Returns the field, its map if it is short, and the known integrals."""
        def lines(accent: str, formula: Formula) -> list[str]:
            return [rf"\{accent}{{{name}}} &= {right.latex}" for name, right in zip(self._all_variables, formula)]

        sheet = self._sheet("text")
        rows = lines("dot", self._formula("field_at_eps") if "field_at_eps" in sheet else self.field)
        if sheet["map"] is not None and len(str(self.map)) < 400:
            rows += lines("widetilde", self.map)
        known = self.__dict__.get("_found", self)
        rows += [f"{formula.name} &= {formula.latex}" for formula in known.integrals.values()]
        return r"$\displaystyle \begin{aligned}" + r" \\ ".join(rows) + r"\end{aligned}$"
