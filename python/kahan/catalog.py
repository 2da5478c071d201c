"""The systems of the catalog, by name: ``kahan.catalog.e6``, ``kahan.catalog.euler(a1=1, a2=-3, a3=1)``.

A name that is no identifier has ``_`` for ``-``. ``dir(kahan.catalog)`` lists them. The chains among
them are a ``Family``, which becomes a system with a number of sites: ``kahan.catalog.kdv(sites=8)``.
"""

from __future__ import annotations

from typing import Any

from ._errors import CHOICES, unknown
from ._exact import Number, exact
from ._system import System

_KNOWN = {name.replace("-", "_"): name for kind in ("system", "family") for name in CHOICES[kind]}


class Family:
    """A chain of the catalog whose sites are not counted yet: a call says how many there are.

    For thousands of sites see ``kahan.Lattice``, which takes the name.

    >>> import kahan
    >>> kahan.catalog.volterra_chain(sites=3).variables
    ('x0', 'x1', 'x2')
    """

    name: str
    """Its name in the catalog."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, *, sites: int, **parameters: Number) -> System:
        return System._of(self.name, True, sites, {name: exact(value, name) for name, value in parameters.items()})

    def __repr__(self) -> str:
        return f"<Family {self.name}>"


def __getattr__(name: str) -> Any:
    if name not in _KNOWN:
        raise AttributeError(unknown("system", name, _KNOWN))
    known = _KNOWN[name]
    return Family(known) if known in CHOICES["family"] else System._of(known, True, None, {})


def __dir__() -> list[str]:
    return sorted(_KNOWN)
