"""Fields from SymPy and formulas to it; SymPy is loaded by whoever brings or wants its objects."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["expression", "field_text"]


def field_text(equations: Mapping[Any, Any]) -> str:
    """The equations ``{x: expression of dx/dt}`` in the language of ``kahan!``."""
    import sympy
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):  # type: ignore[misc]
        def _print_Float(self, number: Any) -> str:
            # All digits, exactly: a decimal, or the fraction that the float is.
            return str(sympy.Rational(str(number)))

    printer = Printer({"sympy_integers": False})
    lines = []
    for variable, rate in equations.items():
        text = printer.doprint(sympy.expand(sympy.sympify(rate))).replace("**", "^")
        lines.append(f"{variable}dot = {text};")
    return " ".join(lines)


def expression(text: str) -> Any:
    """A formula that is written for SymPy as its expression, the names as symbols."""
    import re

    import sympy

    # A name beyond ASCII is a symbol to SymPy unasked. It must not be given: Python looks ``ϕ`` up as ``φ``.
    symbols = {name: sympy.Symbol(name) for name in re.findall(r"[^\W\d]\w*", text) if name.isascii()}
    return sympy.sympify(text, locals=symbols)
