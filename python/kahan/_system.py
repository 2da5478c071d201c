"""A field, with all its methods."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, cast

from ._coefficients import Entries, coefficients, dense, named_wrongly
from ._crossings import Crossings
from ._errors import FieldError, spelled
from ._exact import Number, exact
from ._kahan import Field, is_family
from ._lattice import Lattice
from ._lifted import Lift, lifting
from ._orbit import Array
from ._questions import Questions
from ._trajectories import Trajectories

__all__ = ["Family", "System"]


@spelled
class System(Trajectories, Crossings, Questions):
    """A quadratic vector field x' = f(x) with its Kahan map.

    ``field`` is the text of the equations, in the language of ``kahan!`` or a common notation such
    as ``x' = y, y' = -x``. It may also consist of SymPy equations: a mapping of symbols to
    expressions, a pair (symbols, expressions), or a list of ``Eq(x(t).diff(t), …)``. ``notes``
    reports unusual readings. Names without an equation are parameters. Their values are given by
    name, as integers, fractions or text, or as a float, which stands for the decimal that Python
    prints. ``sites`` is the number of sites of a chain ``for i in … { … }``.

    With ``lift=True``, the equations may contain functions, quotients, powers and ``t``. They are
    lifted to a quadratic field in more variables, which ``lifted`` describes; formulas are those of
    the quadratic field. Arrays in and out are in the original variables, or with ``all=True`` in
    all variables except ``t``. The initial time is ``t0``. ``lift`` may also select the kind of
    lift: "energy", "relations", "stable" or "smallest". ``at`` is an initial point; the relations
    should remain accurate along its orbit.

    With ``fused=True``, steps in floats fuse multiply-adds: they take 3 to 14 % less time, and
    their last digits are others, the same on every processor with fused operations.

    >>> import kahan
    >>> s = kahan.System("xdot = y; ydot = a - x^2;", a="1/2")
    >>> s.variables, s.parameters
    (('x', 'y'), {'a': Fraction(1, 2)})

    Raises ``FieldError`` with the position of each mistake, and ``TypeError`` for a value whose
    name is not a parameter. Reading a field takes some milliseconds, and the first orbit some more.

    Methods that make steps take ``eps``, half the time step, or ``dt`` = 2 eps. With
    ``progress=True``, methods that may take long show a bar of tqdm, which must be installed.
    """

    def __new__(
        cls, field: str | Mapping[Any, Any] | Sequence[Any], /, *, sites: int | None = None, lift: bool | str | None = None,
        at: Any = None, t0: Number | None = None, all: Any = None, fused: bool | Number = False, **parameters: Number
    ) -> System:
        if not isinstance(fused, bool):
            parameters["fused"], fused = fused, False
        if not lift:
            # Without a lift, these names are ordinary parameters.
            parameters |= {name: value for name, value in {"at": at, "t0": t0, "all": all}.items() if value is not None}
        if isinstance(field, (Mapping, list, tuple)):
            from ._sympy import field_text

            field = field_text(field, expands=not lift)
        if not isinstance(field, str):
            raise TypeError(f"a field is text or equations of SymPy, not {type(field).__name__}")
        try:
            given = {name: exact(value, name) for name, value in parameters.items()}
            return cls._of(field, False, sites, given, lifting(lift, at, t0, all), fused)
        except FieldError:
            if sites is None and not parameters and not lift and is_family(field):
                return cast(System, Family(field))
            raise

    @classmethod
    def _of(
        cls, text: str | Entries, is_name: bool, sites: int | None, parameters: dict[str, str],
        lift: Lift | None = None, fused: bool = False, of: System | None = None,
    ) -> System:
        system: System = Field.__new__(
            cls, text, is_name=is_name, sites=sites, parameters=list(parameters.items()), lift=lift, fused=fused, of=of
        )
        system._call, system._lifting = (text, is_name, sites, parameters), lift
        if lift and lift[1] and lift[1][1]:
            system._matched(lift[1][1], "at", False)
        return system

    @classmethod
    def from_arrays(
        cls, c: Any = None, B: Any = None, Q: Any = None, names: Sequence[str] | None = None,
        parameters: Mapping[str, Any] | None = None, *, order: str = "tril", **values: Number
    ) -> System:
        """Returns the field ẋ = c + Bx + Q(x, x) of dense arrays or sparse SciPy arrays; ``None``
        stands for 0.

        ``c`` has shape (n,), ``B`` has (n, n), and ``Q`` has (n, n, n), or (n, n·n) with the
        columns xⱼxₖ row by row, or (n, n(n + 1)/2) with each product once: j ≥ k as in operator
        inference, or j ≤ k with ``order="triu"``. ``names`` are the names of the variables, by
        default x1 to xn. ``parameters`` maps names to the arrays (c, B, Q) that they multiply, or
        to a dict of some of these arrays; ``values`` are values of parameters.

        Floats are taken exactly. Raises ``ValueError`` for an array of another shape or with
        numbers that are not finite, and ``FieldError`` for invalid names of variables.

        >>> import kahan
        >>> s = kahan.System.from_arrays(B=[[0, 1], [0, 0]], Q=[[0, 0, 0], [-1, 0, 0]], names=["x", "v"])
        >>> s.text
        'xdot = v;\\nvdot = -x^2;'
        >>> kahan.System.from_arrays(parameters={"r": {"B": [[1]], "Q": [[-1]]}}, names=["x"], r=2).text
        'xdot = r*x - r*x^2;'
        """
        given = {name: exact(value, name) for name, value in values.items()}
        entries = coefficients((c, B, Q), names, parameters, order)
        try:
            return cls._of(entries, False, None, given)
        except FieldError:
            wrong = named_wrongly(entries)
            if wrong:
                raise FieldError(wrong, [(wrong, 1, 1, "")]) from None
            raise

    def arrays(self, *, sparse: bool = False) -> tuple[Any, Any, Any]:
        """Returns the arrays (c, B, Q) of the field at its parameters, as floats: ẋ = c + Bx + Q(x,
        x).

        ``Q`` is symmetric and has shape (n, n, n). With ``sparse=True``, B and Q are sparse SciPy
        arrays, Q with the columns xⱼxₖ row by row. For a lifted field they are in all variables.
        Raises ``ValueError`` for a parameter without a value.

        >>> import kahan
        >>> kahan.System("xdot = x*y; ydot = 1 - 2*x;").arrays()[1]
        array([[ 0.,  0.],
               [-2.,  0.]])
        """
        indices, values = self._coefficients()
        return dense(len(self._all_variables), (*indices, values), sparse)

    def __reduce__(self) -> tuple[Callable[..., System], tuple[Any, ...]]:
        return (type(self)._of, (*self._call, self._lifting, self.fused))

    def lattice(self, sites: int, eps: Number | None = None, *, dt: Number | None = None, **values: float | Array) -> Lattice:
        """Returns the chain with this number of sites, for steps on arrays; see ``Lattice``.

        The text of the chain is enough: ``kahan.System("for i in periodic { … }").lattice(1000,
        0.01)``.
        """
        text, _, _, own = self._call
        return Lattice(text if isinstance(text, str) else self.text, sites, eps, dt=dt, **({name: float(Fraction(value)) for name, value in own.items()} | values))

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, System) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[Any, ...]:
        return (self.name, self.text, self.variables, self.fused, *self.parameters.items())

    def __call__(self, *, sites: int | None = None, fused: bool | Number | None = None, **parameters: Number) -> System:
        """Returns this field with additional or other values of parameters; for a chain, also
        another number of ``sites``. ``fused`` selects whether steps fuse multiply-adds.

        >>> import kahan
        >>> kahan.catalog.euler(a1=1, a2=-3, a3=1).parameters["a2"]
        Fraction(-3, 1)
        """
        text, is_name, own_sites, own = self._call
        if sites is not None and "sites" in self.parameters:
            parameters["sites"], sites = sites, None
        if not isinstance(fused, bool):
            parameters |= {} if fused is None else {"fused": fused}
            fused = self.fused
        given = {name: exact(value, name) for name, value in parameters.items()}
        sites = own_sites if sites is None else sites
        # The new field shares code unless it has a lift or another number of sites.
        known = self if self._lifting is None and sites == own_sites else None
        return self._of(text, is_name, sites, own | given, self._lifting, fused, known)

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={value}" for name, value in self.parameters.items() if value is not None)
        return f"<System {self.name}: {', '.join(self.variables)}{'; ' + values if values else ''}>"

    @property
    def source(self) -> str:
        """The text of the field as given, or as made from a model file, with values, initial point
        and comments. ``read`` accepts it.
        """
        return self._call[0] if isinstance(self._call[0], str) else self.text


class Family:
    """A chain ``for i in periodic { … }`` without a number of sites; a call supplies it.

    >>> import kahan
    >>> ring = kahan.System("for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }")
    >>> ring(sites=3).variables
    ('x0', 'x1', 'x2')
    >>> ring.lattice(1000, eps=0.01)
    <Lattice of 1000 sites: x>
    """

    name: str
    """The name in the catalog, or the text."""

    def __init__(self, name: str, is_name: bool = False) -> None:
        self.name, self._is_name = name, is_name

    def __call__(self, *, sites: int, **parameters: Number) -> System:
        return System._of(self.name, self._is_name, sites, {name: exact(value, name) for name, value in parameters.items()})

    def lattice(self, sites: int, eps: Number | None = None, *, dt: Number | None = None, **values: float | Array) -> Lattice:
        """Returns the chain with this number of sites, for steps on arrays."""
        return Lattice(self.name, sites, eps, dt=dt, **values)

    def __repr__(self) -> str:
        return f"<Family {self.name}>"
