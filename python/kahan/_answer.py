"""Answers: what a question found, by the names that the command's JSON has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

__all__ = ["Answer"]


class Answer(Mapping[str, Any]):
    """The answer to a question. Each name is an attribute and a key; exact numbers are fractions.

    >>> import kahan
    >>> values = kahan.catalog.lv.evaluate([1, "1/2"], eps="1/3", exact=True)
    >>> values.system, values["det_A"]
    ('lv', Fraction(8, 9))
    """

    def __init__(self, found: Mapping[str, Any]) -> None:
        self.__dict__.update(found)

    def __getitem__(self, name: str) -> Any:
        return self.__dict__[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.__dict__)

    def __len__(self) -> int:
        return len(self.__dict__)

    def __getattr__(self, name: str) -> Any:
        names = ", ".join(self.__dict__)
        raise AttributeError(f"there is no `{name}` in this answer; it has {names}", name=name, obj=self)

    def __repr__(self) -> str:
        lines = [f"  {name} = {_short(value)}" for name, value in self.__dict__.items()]
        return "\n".join([f"{type(self).__name__}:", *lines])


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 90 else text[:89] + "…"
