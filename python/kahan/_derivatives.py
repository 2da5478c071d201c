"""Names of the variables of differentiation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ._errors import Named, unknown

if TYPE_CHECKING:
    from ._orbit import Array
    from ._system import System

__all__ = ["in_order", "differentiable"]


def differentiable(system: System, names: str | Sequence[str] | None, argument: str) -> list[str]:
    """Returns the names of parameters, variables and ``eps``, without repetition; all of them for
    ``None``.

    Raises ``ValueError`` for another name, and for a lifted field. ``argument`` is the name of the
    caller's argument.
    """
    known = system._names
    asked = known if names is None else [names] if isinstance(names, str) else list(dict.fromkeys(names))
    if asked and system._lifting is not None:
        raise ValueError(f"{argument}: this field is lifted, and its new variables depend on parameters and first values, too; "
                         "differentiate kahan.System(s.text), which has all variables")
    if "dt" in asked and "dt" not in known:
        raise ValueError(f"{argument}: give eps for a derivative by the time step; dt = 2 eps, and the derivative by dt is half as large")
    for name in asked:
        if name not in known:
            raise ValueError(f"{argument}: {unknown('parameter or variable', str(name), known)}")
    return asked


def in_order(asked: Sequence[str], names: Sequence[str], arrays: Array) -> dict[str, Array]:
    """Returns the derivatives in the order ``asked``; ``names`` are those of their first axis."""
    return Named({name: arrays[names.index(name)] for name in asked}, "derivative", 'ask for it by derivatives=["{name}"]')
