"""Conversion of XPP files to the text of a field."""

from __future__ import annotations

import re

from ._model import is_taken

__all__ = ["xpp_text"]

_WORDS = frozenset(
    """par param params parameter parameters init number aux done wiener markov global table bdry volterra volt solv special
    sin cos tan atan atan2 sinh cosh tanh exp delay del_shft ln log log10 t pi if then else asin acos heav sign mod flr ran
    abs max min normal bessel erf sqrt poisson int sum of dt""".split()
)
"""Keywords of XPP, and names of its functions."""
_SKIPPED = ("#", '"', "@")
"""The beginnings of comments and options."""
_STATE = re.compile(r"^\s*(\w+)\s*'\s*=|^\s*d(\w+)\s*/\s*dt\s*=", re.MULTILINE)
_START = re.compile(r"(\w+)\s*\(0\)\s*=|^\s*(?:init|i)\s+(.*)", re.MULTILINE)


def xpp_text(text: str) -> str:
    """Returns the text with one spelling for each name and an initial value for every state.

    XPP ignores the case of letters. States without an initial value begin at 0.

    >>> print(xpp_text("par Eps=.1\\ninit X=1\\nx'=y\\ndY/dt=-EPS*x"), end="")
    par Eps_=.1
    init X=1
    X'=y
    dy/dt=-Eps_*X
    init y=0
    # `eps` means something else in a text, and is called Eps_
    # no start is given for y: it is 0
    """
    spelled: dict[str, str] = {}

    def spelling(name: str) -> str:
        key = name.lower()
        return spelled.setdefault(key, key if key in _WORDS else name + "_" * is_taken(key))

    lines: list[str] = []
    ended: list[str] = []
    for line in text.splitlines():
        if line.strip().lower() == "done":
            ended = ["done"]
            break
        if not line.lstrip().startswith(_SKIPPED):
            # `p` and `i` are keywords before a name, and otherwise names.
            word = re.match(r"\s*[pi](?=[ \t]+[^\W\d])", line, re.IGNORECASE)
            start = word.end() if word else 0
            line = line[:start].lower() + re.sub(
                r"(?<![\w.])(d(?=\w+\s*/\s*dt\b))?([^\W\d]\w*)",
                lambda found: (found[1] or "").lower() + spelling(found[2]), line[start:], flags=re.IGNORECASE)
        lines.append(line)
    code = "\n".join(line for line in lines if not line.lstrip().startswith(_SKIPPED)).replace("\\\n", " ")
    states = [primed or over for primed, over in _STATE.findall(code)]
    started = {name for one, several in _START.findall(code) for name in (one, *re.findall(r"(\w+)\s*=", several))}
    missing = [state for state in states if state not in started]
    notes = [f"# `{key}` means something else in a text, and is called {name}" for key, name in spelled.items()
             if name.lower() == key + "_"]
    if missing:
        notes.append(f"# no start is given for {', '.join(missing)}: it is 0")
    # Starts come before `done`, which ends the text. All lines of the file keep their numbers.
    return "\n".join([*lines, *(f"init {state}=0" for state in missing), *notes, *ended]) + "\n"
