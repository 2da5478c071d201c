"""What orbits are differentiated by."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._orbit import Array
    from ._system import System

__all__ = ["in_order", "differentiable"]


def differentiable(system: System, derivatives: Sequence[str]) -> list[str]:
    """The names that were asked for, each once.

    Raises ``ValueError`` for one that is no parameter, no variable and not ``eps``, and for a lifted field.
    """
    asked = [derivatives] if isinstance(derivatives, str) else list(dict.fromkeys(derivatives))
    if asked and system._lifting is not None:
        raise ValueError("derivatives: this field is lifted, and its new variables depend on parameters and first values, too; "
                         "differentiate a field that is quadratic as it is written")
    kinds = {"parameters": [name for name, _ in system._given], "variables": list(system.variables)}
    known = [name for names in kinds.values() for name in names] + ["eps"]
    for name in asked:
        if name not in known:
            there = [f"the {kind} {', '.join(names)}" for kind, names in kinds.items() if names]
            raise ValueError(f"derivatives: there is no `{name}`; there are {', '.join(there)}, and eps")
    return asked


def in_order(asked: Sequence[str], names: Sequence[str], arrays: Array) -> dict[str, Array]:
    """The derivatives in the order in which they were asked for."""
    return {name: arrays[names.index(name)] for name in asked}
