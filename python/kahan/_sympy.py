"""Fields from SymPy and formulas to it; SymPy is loaded by whoever brings or wants its objects."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["expression", "field_text"]


def field_text(equations: Mapping[Any, Any], expands: bool = True) -> str:
    """The equations ``{x: expression of dx/dt}`` in the language of ``kahan!``, multiplied out or not.

    Raises ``ValueError`` for what a field's exact numbers and names cannot say.
    """
    import sympy
    from sympy.core.function import AppliedUndef
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):  # type: ignore[misc]
        def _print_Float(self, number: Any) -> str:
            # All digits, exactly: a decimal, or the fraction that the float is.
            return str(sympy.Rational(str(number)))

    printer = Printer({"sympy_integers": False})
    lines = []
    for variable, rate in equations.items():
        rate = sympy.sympify(rate)
        rate = sympy.expand(rate) if expands else rate
        for part in sympy.preorder_traversal(sympy.Tuple(sympy.sympify(variable), rate)):
            if isinstance(part, AppliedUndef):
                raise ValueError(f"{part} is a function; write symbols, as {part.func} = sympy.Symbol('{part.func}')")
            if part.is_number and not (part.is_Rational or part.is_Float):
                raise ValueError(f"{variable}: {part} is no fraction, and coefficients are exact; put a symbol in its place, "
                                 f"which becomes a parameter, and give its value as a float or a Fraction, as float({part})")
        text = printer.doprint(rate).replace("**", "^")
        lines.append(f"{variable}dot = {text};")
    return " ".join(lines)


def expression(text: str) -> Any:
    """A formula that is written for SymPy as its expression, the names as symbols."""
    import re

    import sympy

    # A name beyond ASCII is a symbol to SymPy unasked. It must not be given: Python looks ``ϕ`` up
    # as ``φ``.
    symbols = {name: sympy.Symbol(name) for name in re.findall(r"[^\W\d]\w*", text) if name.isascii()}
    return sympy.sympify(text, locals=symbols)
