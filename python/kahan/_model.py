"""Models read from files of other programs, converted to text: equations, values, initial values, comments."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

__all__ = ["Model", "Place", "Refused", "is_taken", "number_text"]

_TAKEN = frozenset(
    """as async await break const continue crate dyn else enum extern false fn for if impl in let loop match mod move
    mut pub ref return self Self static struct super trait true type unsafe use where while abstract become box do final
    gen macro override priv try typeof unsized virtual yield t eps dt pi PI par param params parameter parameters init
    number aux done when lift integral density bracket hamiltonian sin cos tan cot sec csc sinh cosh tanh coth sech
    csch exp log ln sqrt cbrt asin atan asinh acosh atanh acos arcsin arccos arctan pow Derivative Eq""".split()
)
"""Names that are reserved in the text of a field."""

_NAME = re.compile(r"[^\W\d]\w*")


def is_taken(name: str) -> bool:
    """Returns whether a name is reserved, so that it cannot name a state, a parameter or a function."""
    return name in _TAKEN or not name.strip("_") or name.endswith("dot")


class Refused(ValueError):
    """The error for a wrong or unsupported part of a file, with its position and advice."""

    def __init__(self, place: Place, part: str, reason: str, line: int = 0, name: str = "") -> None:
        line = place.line_of(name, line)
        where = f"{place.path}:{line}" if line else place.path
        link = "" if reason.startswith(("has ", "is ", "stops ", "changes ", "cannot ")) else ":"
        super().__init__(f"{where}: {part}{link} {reason}")


@dataclass
class Place:
    """A file, with the text that determines line numbers."""

    path: str
    text: str | None = None
    """The user's text, if errors should refer to its lines instead of those of a converted text."""

    def line_of(self, name: str, line: int) -> int:
        """Returns the line of a name in the user's text, or else the known line."""
        if self.text is None:
            return line
        # Finds the definition of a name, or else the first use of the name.
        own = re.escape(name)
        patterns = [r"\bat\b"] if name.startswith("_") else [rf"\b{own}\s*(:|=|')", rf"\b{own}\b"] if name else []
        found = next((found for pattern in patterns if (found := re.search(pattern, self.text))), None)
        return self.text.count("\n", 0, found.start()) + 1 if found else 0


def number_text(value: Fraction | float, in_product: bool = False) -> str:
    """Returns a number as text with all digits: a decimal if possible, otherwise a fraction."""
    if isinstance(value, float):
        return repr(value)
    if Fraction(repr(float(value))) == value:
        written = repr(float(value)).removesuffix(".0")
        return written if "inf" not in written else str(value)
    return f"({value})" if in_product else str(value)


class Model:
    """A model that is being read."""

    def __init__(self, place: Place, names: Iterable[str]) -> None:
        self.place, self.title, self.units = place, "", ""
        self.names: dict[str, str] = {}
        self.rights: dict[str, str] = {}
        self.starts: dict[str, Fraction | float] = {}
        self.formulas: dict[str, str] = {}
        self.parameters: dict[str, Fraction | float] = {}
        self.meanings: dict[str, str] = {}
        self.totals: list[str] = []
        self.notes: list[str] = []
        taken = set(names)
        for name in sorted(taken):
            self.names[name] = self._fresh(name, taken) if is_taken(name) else name
            if self.names[name] != name:
                taken.add(self.names[name])
                self.note(f"`{name}` means something else in a text, and is called {self.names[name]}")
        self._all = taken
        self._computed: dict[str, str] = {}

    @staticmethod
    def _fresh(name: str, taken: set[str]) -> str:
        start = name.strip("_") or "x"
        candidates = (start + "_" * (k == 0) + (f"_{k}" if k else "") for k in range(len(taken) + 2))
        return next(one for one in candidates if one not in taken and one not in _TAKEN)

    def name(self, name: str) -> str:
        """Returns the name in the text."""
        return self.names[name]

    def note(self, note: str) -> None:
        if note not in self.notes:
            self.notes.append(note)

    def state(self, name: str, start: Fraction | float, right: str, meaning: str) -> None:
        self.rights[name], self.starts[name], self.meanings[name] = right, start, meaning

    def formula(self, name: str, text: str) -> None:
        self.formulas[name] = text

    def parameter(self, name: str, value: Fraction | float, meaning: str) -> None:
        self.parameters[name], self.meanings[name] = value, meaning

    def total(self, text: str) -> None:
        self.totals.append(text)

    def computed(self, formula: str, value: Fraction | float) -> str:
        """Returns the name of a parameter that has the value of a constant formula."""
        if formula not in self._computed:
            start = "_".join(_NAME.findall(formula) or ["value"])[:24]
            name = next(one for k in range(len(self._all) + 2) if (one := f"{start}_{k + 1}") not in self._all)
            self._all.add(name)
            self.names[name] = self._computed[formula] = name
            self.parameter(name, value, f"computed once as {formula}")
            self.note(f"{name} = {formula} is a constant, computed once from the values of this text")
        return self._computed[formula]

    def used(self) -> set[str]:
        """Returns the names in the text that the equations need."""
        needed: set[str] = set()
        formulas = {self.name(name): text for name, text in self.formulas.items()}
        left = [*self.rights.values(), *self.totals]
        while left:
            new = set(_NAME.findall(left.pop())) - needed
            needed |= new
            left += [formulas[name] for name in new if name in formulas]
        return needed

    def text(self) -> str:
        """Returns the model as text: comments on the reading, values, initial values, formulas, equations."""
        used = self.used()
        title = f'The model "{self.title}" of' if self.title else "A model of"
        lines = [f"{title} {self.place.path.replace(chr(92), '/').rsplit('/', 1)[-1]}"]
        lines += [f"units: {self.units}"] if self.units else []
        lines += self.notes
        out = [f"# {line}" for line in _flat(lines)]
        unused = [f"{self.name(name)}" for name in (*self.parameters, *self.formulas) if self.name(name) not in used]
        if unused:
            out.append(f"# no equation needs {', '.join(unused)}")

        def values(word: str, of: dict[str, Fraction | float], wanted: Iterable[str]) -> Iterable[str]:
            for name in wanted:
                meaning = "".join(_flat([self.meanings[name]]))
                comment = f"  # {meaning}" if meaning and meaning != "parameter" else ""
                yield f"{word} {self.name(name)}={number_text(of[name])}{comment}"

        out += values("par", self.parameters, [name for name in self.parameters if self.name(name) in used])
        out += values("init", self.starts, self.rights)
        out += [f"{self.name(name)} = {text}" for name, text in self.formulas.items() if self.name(name) in used]
        out += [f"{self.name(name)}' = {text}" for name, text in self.rights.items()]
        totals = (name for k in range(1, 10**9) if (name := f"total{k}") not in self._all)
        out += [f"integral {name} = {text};" for name, text in zip(totals, self.totals)]
        return "\n".join(out) + "\n"


def _flat(lines: Iterable[str]) -> list[str]:
    return [" ".join(line.split()) for line in lines]
