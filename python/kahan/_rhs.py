"""The field as a right-hand side for ODE solvers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import named
from ._errors import unknown
from ._exact import nearest
from ._orbit import Array

if TYPE_CHECKING:
    from ._system import System

__all__ = ["RightSide"]


@dataclass(frozen=True)
class RightSide:
    """The right-hand side f(t, y, ...) of a field; points are columns, and ``parameters`` are
    further arguments in order.

    Only a lifted field depends on the time.
    """

    system: System
    parameters: tuple[str, ...]

    @classmethod
    def of(cls, system: System, names: tuple[str, ...]) -> RightSide:
        """Returns f with these parameters as arguments; by default those without a value, or else all."""
        known = system.parameters
        for name in names:
            if name not in known:
                raise TypeError(f"rhs: {unknown('parameter', str(name), known)}")
        free = tuple(name for name, value in known.items() if value is None)
        return cls(system, names or free or tuple(known))

    def __call__(self, t: float, y: Any, *args: Any) -> Array:
        system, values = self.system, self._values(args)
        at = named(y, system, "y")
        points = np.asarray(at)
        if points.ndim == 2 and at is y:
            if len(points) != len(system.variables):
                raise ValueError(f"y: the shape ({len(system.variables)}, points) is needed, and this is {points.shape}")
            points = points.T
        if system._lifting is not None:
            points = system._embedded(points, values, t)
        return system._out_of_all(system._field_at(points, parameters=values)).T

    def jacobian(self, t: float, y: Any, *args: Any) -> Array:
        """Returns the matrix f'(y) at a point."""
        if self.system._lifting is not None:
            raise ValueError("the Jacobian of a lifted field is one of all variables: s.field_jacobian has it as a formula")
        return self.system._field_at(named(y, self.system, "y"), parameters=self._values(args), jacobian=True)

    def _values(self, args: tuple[Any, ...]) -> list[float | None]:
        """Returns the values of all parameters; ``None`` for those that the field has."""
        if not args:
            return []
        if len(args) != len(self.parameters):
            names = ", ".join(self.parameters) or "none"
            raise TypeError(f"args: {len(args)} values are given, and those of the parameters {names} are needed, in this order; "
                            "s.rhs(\"a\", \"b\") is a function of a and b")
        given = {name: nearest(value, name) for name, value in zip(self.parameters, args)}
        return [given.get(name) for name in self.system.parameters]
