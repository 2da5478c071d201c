"""The systems of the catalog, by name: ``kahan.catalog.e6``, ``kahan.catalog.euler(a1=1, a2=-3, a3=1)``.

A name that is no identifier has ``_`` for ``-``. ``dir(kahan.catalog)`` lists them.
"""

from __future__ import annotations

from ._errors import CHOICES, unknown
from ._system import System

_KNOWN = {name.replace("-", "_"): name for name in CHOICES["system"]}


def __getattr__(name: str) -> System:
    if name not in _KNOWN:
        raise AttributeError(unknown("system", name, _KNOWN))
    return System._named(_KNOWN[name])


def __dir__() -> list[str]:
    return sorted(_KNOWN)
