"""The systems of the catalog, by name: ``kahan.catalog.e6``, ``kahan.catalog.euler(a1=1, a2=-3, a3=1)``.

In names, ``_`` stands for ``-``. ``dir(kahan.catalog)`` lists all names. Chains are a ``Family``; a
call with a number of sites makes a system: ``kahan.catalog.kdv(sites=8)``.
"""

from __future__ import annotations

from typing import Any

from ._errors import CHOICES, unknown
from ._system import Family, System

_KNOWN = {name.replace("-", "_"): name for kind in ("system", "family") for name in CHOICES[kind]}


def __getattr__(name: str) -> Any:
    if name not in _KNOWN:
        raise AttributeError(unknown("system", name, _KNOWN))
    known = _KNOWN[name]
    return Family(known, True) if known in CHOICES["family"] else System._of(known, True, None, {})


def __dir__() -> list[str]:
    return sorted(_KNOWN)
