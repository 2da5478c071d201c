"""What can be wrong, as exceptions."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["FieldError", "Mistake", "SingularStep"]


class Mistake(NamedTuple):
    """One mistake of a text in the language of ``kahan!``."""

    message: str
    """What is wrong."""
    line: int
    """The line of the text, counted from 1."""
    column: int
    """The column where the mistake begins, counted from 1."""
    help: str
    """What to write instead; empty where there is nothing to say."""


class FieldError(ValueError):
    """A field that cannot be read, or whose claims do not hold.

    As text it shows the line of each mistake with a caret under its place. The attributes
    ``message``, ``line``, ``column`` and ``help`` are those of the first mistake.
    """

    __module__ = "kahan"  # The name that a traceback shows is the one to catch.

    mistakes: tuple[Mistake, ...]
    """All mistakes, in the order of their places."""

    def __init__(self, report: str, mistakes: list[tuple[str, int, int, str]]) -> None:
        super().__init__(report, mistakes)
        self.mistakes = tuple(Mistake(*mistake) for mistake in mistakes)

    def __str__(self) -> str:
        return "\n" + str(self.args[0])

    @property
    def message(self) -> str:
        """What is wrong first."""
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
        """What to write instead."""
        return self.mistakes[0].help


class SingularStep(ArithmeticError):
    """The map has no value at a point: a pole, det A = 0, or numbers beyond the range of floats."""

    __module__ = "kahan"
