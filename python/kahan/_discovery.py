"""Integrals, densities, brackets and drifts of a map."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ._answer import Answer, _short
from ._basis import Basis
from ._formula import Formula

if TYPE_CHECKING:
    from ._system import System

__all__ = ["Discovery"]


class Discovery(Answer):
    """Integrals, densities, brackets and drifts of a map, with the names of ``kahan discover
    --json``.

    ``integrals``, ``densities``, ``brackets`` and ``drifts`` map names to formulas. ``claims``
    lists them as lines in the language of ``kahan!``. ``claimed`` is the field with these claims.
    Integrals whose formulas are too long to write are in ``bases``.
    """

    bases: list[Basis]
    """Sets of monomials with one linear relation along every orbit, whose coefficients are integrals."""

    claims: list[str]
    """The claims that were found and proved, as lines for the text of a field."""

    sentences: list[str]
    """The extent of the search, and its conclusion if something may be missing."""

    def __init__(self, found: Mapping[str, Any], of: System) -> None:
        kinds = ("integrals", "densities", "brackets", "drifts")
        super().__init__({name: value for name, value in found.items() if name not in kinds})
        self.__dict__["_names"] = (*found, "claims")
        self.__dict__["claims"] = [line for kind in kinds for line in found[kind]]
        self.__dict__["_searched"] = of

    def __repr__(self) -> str:
        found = [*self.claims, *(f"basis {', '.join(basis.monomials)}" for basis in self.bases)]
        return "\n".join([f"Discovery of {self.system}:", *self.sentences, *(f"  {_short(line)}" for line in found)])

    @cached_property
    def claimed(self) -> System:
        """Returns the field with the findings as its claims. They are proved once more.

        Its parameters have the values of the search, which are the condition ``when`` of the
        claims.
        """
        searched: System = self.__dict__["_searched"]
        text, is_name, sites, given = searched._call
        sheet = searched._of(text, is_name, sites, {}, searched._lifting)._sheet("text")
        field = sheet.get("field_at_eps", sheet["field"])
        equations = "\n".join(f"{name}dot = {right};" for name, right in zip(self.variables, field))
        names = set(re.findall(r"\w+", equations))
        of_text = searched.parameters.items()
        own = [f"{name} = {value};" for name, value in of_text if value is not None and name in names - set(given)]
        given = {name: value for name, value in given.items() if name in names}
        return searched._of("\n".join([*own, equations, *self.claims]), False, None, given, fused=searched.fused)

    @property
    def integrals(self) -> dict[str, Formula]:
        """The integrals, by name; each is proved."""
        return self.claimed.integrals

    @property
    def densities(self) -> dict[str, Formula]:
        """The invariant densities, by name."""
        return self.claimed.densities

    @property
    def brackets(self) -> dict[str, Formula]:
        """The invariant Poisson brackets, by name, each an antisymmetric matrix."""
        return self.claimed.brackets

    @property
    def drifts(self) -> dict[str, Formula]:
        """The drifts by name: a function whose next value is a function of its value. Each is a vector of the two."""
        return self.claimed.drifts
