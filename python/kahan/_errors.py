"""Exceptions for mistakes and for steps without a value."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from importlib import import_module
from typing import Any, NamedTuple, TypeVar

from ._kahan import names, nearest

__all__ = ["CHOICES", "FieldError", "Mistake", "Named", "SingularStep", "choice", "needed", "spelled", "unknown"]

CHOICES: dict[str, list[str]] = dict(names())
"""The valid names of each kind of argument."""


class Mistake(NamedTuple):
    """One mistake of a text in the language of ``kahan!``."""

    message: str
    """The description of the mistake."""
    line: int
    """The line of the text, counted from 1."""
    column: int
    """The column where the mistake begins, counted from 1."""
    help: str
    """Advice on what to write instead; empty if there is none."""


class FieldError(ValueError):
    """The error for a field that cannot be read, or whose claims do not hold.

    Its text shows the line of each mistake, with a caret below the position. The attributes
    ``message``, ``line``, ``column`` and ``help`` are those of the first mistake.
    """

    __module__ = "kahan"  # Tracebacks show the name that users catch.

    mistakes: tuple[Mistake, ...]
    """All mistakes, in the order of their positions."""

    def __init__(self, report: str, mistakes: list[tuple[str, int, int, str]]) -> None:
        super().__init__(report, mistakes)
        self.mistakes = tuple(Mistake(*mistake) for mistake in mistakes)

    def __str__(self) -> str:
        return "\n" + str(self.args[0])

    @property
    def message(self) -> str:
        """The description of the first mistake."""
        return self.mistakes[0].message

    @property
    def line(self) -> int:
        """The line of the first mistake, counted from 1."""
        return self.mistakes[0].line

    @property
    def column(self) -> int:
        """The column of the first mistake, counted from 1."""
        return self.mistakes[0].column

    @property
    def help(self) -> str:
        """Advice on what to write instead, for the first mistake."""
        return self.mistakes[0].help


class SingularStep(ArithmeticError):
    """The error for a point at which the map has no value: a pole, det A = 0, or an overflow of floats."""

    __module__ = "kahan"


def unknown(kind: str, name: str, known: Iterable[str]) -> str:
    """Returns a message for an unknown name of a kind, with the nearest known name, or else all of them."""
    known = list(known)
    near = nearest(name, known)
    return f"there is no {kind} `{name}`; " + (f"did you mean `{near}`?" if near else f"there is {', '.join(known) or 'none'}")


class Named(dict[str, Any]):
    """Values by name. The error for a missing name lists the known names and gives ``advice``, in
    which {name} stands for the missing name.
    """

    def __init__(self, values: Any, kind: str, advice: str) -> None:
        super().__init__(values)
        self._kind, self._advice = kind, advice

    def __missing__(self, name: str) -> Any:
        raise KeyError(f"{unknown(self._kind, str(name), self)}; {self._advice.format(name=name)}")

    def __reduce__(self) -> tuple[Any, ...]:
        return Named, (dict(self), self._kind, self._advice)


def needed(package: str, extra: str = "", project: str = "") -> Any:
    """Imports an optional package. Its ``ImportError`` says how to install it."""
    name = project or package
    try:
        return import_module(package)
    except ImportError:
        how = f"pip install {name}" + (f", or pip install 'kahan[{extra}]'" if extra else "")
        raise ImportError(f"the package {name} is needed for this: {how}") from None


def choice(value: str, kind: str) -> str:
    """Returns the value if it is valid for this kind of argument."""
    if value not in CHOICES[kind]:
        raise ValueError(unknown(kind, str(value), CHOICES[kind]))
    return value


_STEPS = ("h", "tau", "step_size", "stepsize", "time_step")
"""Names of the time step in other packages."""

Class = TypeVar("Class", bound=type)


def spelled(cls: Class) -> Class:
    """Makes the methods of a class, own and inherited, suggest the nearest name for a mistyped
    argument.

    A correct call costs one more function call; names are compared only if a call fails. The
    compiled ``step`` and ``try_step`` are unchanged, because they are as fast as that extra call.
    """
    for name, function in inspect.getmembers(cls, inspect.isfunction):
        if not name.startswith("_") and function.__module__.startswith("kahan."):
            setattr(cls, name, _spelled(inspect.unwrap(function), f"{cls.__name__}.{name}"))
    return cls


def _spelled(function: Callable[..., Any], shown: str) -> Callable[..., Any]:
    @wraps(function)
    def call(*args: Any, **named: Any) -> Any:
        try:
            return function(*args, **named)
        except TypeError:
            signature = inspect.signature(function)
            parameters = signature.parameters
            takes_all = any(one.kind is one.VAR_KEYWORD for one in parameters.values())
            for name in () if takes_all else named:
                if name not in parameters:
                    known = [known for known in parameters if known != "self"]
                    if name in _STEPS and "eps" in known:
                        raise TypeError(f"{shown}: there is no argument `{name}`; write dt, the time step, or eps, half of it") from None
                    raise TypeError(f"{shown}: {unknown('argument', name, known)}") from None
            raise

    return call
