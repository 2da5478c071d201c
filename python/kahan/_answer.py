"""Answers to questions, with the names of the command's JSON."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ._errors import needed, unknown

__all__ = ["Answer", "Settings"]


class Answer(Mapping[str, Any]):
    """The answer to a question. Each name is an attribute and a key; exact numbers are fractions.

    >>> import kahan
    >>> values = kahan.catalog.lv.evaluate([1, "1/2"], eps="1/3", exact=True)
    >>> values.system, values["det_A"]
    ('lv', Fraction(8, 9))
    """

    _names: tuple[str, ...] = ()

    def __init__(self, found: Mapping[str, Any]) -> None:
        self.__dict__.update(found)
        self.__dict__["_names"] = tuple(found)

    def __getitem__(self, name: str) -> Any:
        if name not in self._names:
            raise KeyError(name)
        return getattr(self, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(unknown("part of this answer", name, self._names))

    def __repr__(self) -> str:
        lines = [f"  {name} = {_short(repr(value))}" for name, value in self.items()]
        return "\n".join([f"{type(self).__name__}:", *lines])


class Settings(list[dict[str, Any]]):
    """A list of rows with equal names. ``settings[0]`` is a row, ``settings["eps"]`` a column."""

    def columns(self) -> dict[str, Any]:
        """Returns the columns by name, as arrays."""
        return {name: np.array([row[name] for row in self]) for name in self.keys()}

    def keys(self) -> list[str]:
        """Returns the names of the columns."""
        return list(self[0]) if self else []

    def __getitem__(self, place: Any) -> Any:
        if not isinstance(place, str):
            return super().__getitem__(place)
        if place not in self.keys():
            raise KeyError(unknown("column", place, self.keys()))
        return self.columns()[place]

    def to_pandas(self) -> Any:
        """Returns a data frame of the rows. Needs pandas."""
        return needed("pandas").DataFrame(list(self))


def _short(text: str) -> str:
    return text if len(text) <= 90 else text[:89] + "…"
