"""Lifts: quadratic fields made from equations that are not quadratic."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from ._answer import Answer

if TYPE_CHECKING:
    from ._orbit import Array
    from ._system import System

__all__ = ["Lift", "Lifted", "lifting"]


Lift = tuple[str, "tuple[list[str], list[str]] | None", str, bool]
"""Which lift is wanted, the coordinates of a point and their names, if they have some, the time, and whether arrays have the
new variables."""


def lifting(lift: bool | str | None, at: Any, t0: Any, all: bool) -> Lift | None:
    """Returns how a field is to be lifted, for the compiled module; ``None`` if it is not."""
    from ._arrays import by_name
    from ._exact import exact, point

    if not lift:
        return None
    if not isinstance(lift, (bool, str)):
        raise TypeError(f"lift: True or text is needed, as \"energy\", not {type(lift).__name__}")
    which = "automatic" if lift is True else str(lift)
    found = None if at is None else by_name(at)
    start = None if at is None else (point(at), []) if found is None else (
        point([np.asarray(value).reshape(-1)[0] if np.size(value) == 1 else value for _, value in found], "at"),
        [name for name, _ in found],
    )
    return which, start, exact(0 if t0 is None else t0, "t0"), bool(all)


class Lifted(Answer):
    """A lift, with the names of ``kahan lift --json``, and conversions between original and new
    variables.

    >>> import kahan
    >>> s = kahan.System("xdot = v; vdot = -sin(x);", lift=True)
    >>> s.variables, s.lifted.order, s.lifted.new
    (('x', 'v'), 2, {'sin_x': 'sin(x)', 'cos_x': 'cos(x)'})
    >>> s.lifted.embed([0, 1])
    array([0., 1., 0., 1.])
    """

    order: int
    """The number of new variables, without ``t``."""
    optimal: bool
    """Whether a complete search found no lift with fewer new variables."""
    chosen: str
    """The reason for the choice of this lift."""
    variables: list[str]
    """All variables: the original ones, ``t`` if it occurs, and the new ones."""
    new: dict[str, str | None]
    """The new variables and the functions that they stand for; ``None`` for the work done since the start."""
    field: str
    """The quadratic field in the language of ``kahan!``, with claims for what its map preserves."""
    relations: list[Answer]
    """The relations between the variables: ``relation``, what happens to it ``along`` the orbit,
    ``formula``, ``rate``.
    """
    energy: str | None
    """The quantity that the map preserves instead of the energy."""

    def __init__(self, system: System, text: str) -> None:
        found = json.loads(text)
        new = {one["name"]: one["expression"] for one in found["new"]}
        super().__init__(found | {"new": new, "relations": [Answer(one) for one in found["relations"]]})
        self.__dict__["_of"] = system

    def embed(self, x: Any) -> Array:
        """Returns all variables at points of the original ones, of shape (…, variables)."""
        embedded: Array = self._of._embedded(self._of._at(x))
        return embedded

    def project(self, y: Any) -> Array:
        """Returns the original variables at points of all variables."""
        return np.asarray(y)[..., self._of._places]
