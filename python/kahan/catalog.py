"""The systems of the catalog, by name: ``kahan.catalog.e6``, ``kahan.catalog.euler(a1=1, a2=-3, a3=1)``.

A name that is no identifier has ``_`` for ``-``. ``dir(kahan.catalog)`` lists them.
"""

from __future__ import annotations

from ._kahan import catalog as _names
from ._system import System

_KNOWN = {name.replace("-", "_"): name for name in _names()}


def __getattr__(name: str) -> System:
    if name in _KNOWN:
        return System._named(_KNOWN[name])
    from difflib import get_close_matches

    near = get_close_matches(name, _KNOWN, 1)
    hint = f"; did you mean `{near[0]}`?" if near else ""
    raise AttributeError(f"the catalog has no `{name}`{hint} It has {', '.join(_KNOWN)}")


def __dir__() -> list[str]:
    return sorted(_KNOWN)
