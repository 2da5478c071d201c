"""Conversion of fields and formulas from and to SymPy, which is imported only when used."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ._errors import needed

__all__ = ["expression", "field_text"]


def field_text(equations: Any, expands: bool = True) -> str:
    """Returns the text of a field in the language of ``kahan!``, with or without expanding sums.

    The equations are a mapping ``{x: expression of dx/dt}``, a pair (symbols, expressions) or a
    list of ``Eq(x(t).diff(t), expression)``.

    Raises ``ValueError`` for expressions that exact numbers and names of a field cannot represent.
    """
    sympy = needed("sympy", "sympy")
    from sympy.core.function import AppliedUndef
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):  # type: ignore[misc]
        def _print_Float(self, number: Any) -> str:
            # Prints the exact decimal or fraction.
            return str(sympy.Rational(str(number)))

    printer = Printer({"sympy_integers": False})
    lines = []
    for variable, order, rate in _rates(equations):
        if not isinstance(variable, sympy.Basic) or not isinstance(rate, sympy.Basic):
            raise ValueError(f"{variable}: {rate} gives no derivative of a symbol; write {{x: expression of dx/dt}}")
        rate = sympy.expand(rate) if expands else rate
        for part in sympy.preorder_traversal(sympy.Tuple(variable, rate)):
            if isinstance(part, AppliedUndef):
                raise ValueError(f"{part} is a function; write symbols, as {part.func} = sympy.Symbol('{part.func}')")
            if part.is_number and not (part.is_Rational or part.is_Float):
                raise ValueError(f"{variable}: {part} is no fraction, and coefficients are exact; put a symbol in its place, "
                                 f"which becomes a parameter, and give its value as a float or a Fraction, as float({part})")
        text = printer.doprint(rate).replace("**", "^")
        lines.append(f"{variable}dot = {text};" if order == 1 else variable.name + "'" * order + f" = {text};")
    return " ".join(lines)


def _entries(given: Any) -> list[Any]:
    """Returns the entries of a SymPy list, matrix or single object."""
    sympy = needed("sympy", "sympy")

    given = sympy.sympify(given)
    return list(given) if hasattr(given, "__len__") else [given]


def _rates(equations: Any) -> list[tuple[Any, int, Any]]:
    """Returns for each equation the variable as a symbol, the order of its derivative, and the expression."""
    sympy = needed("sympy", "sympy")

    if isinstance(equations, Mapping):
        return [(sympy.sympify(variable), 1, sympy.sympify(rate)) for variable, rate in equations.items()]
    given = list(equations)
    equals = [part for part in given if isinstance(part, sympy.Equality)]
    if not equals:
        variables, rates = map(_entries, given) if len(given) == 2 else ([], [])
        if not variables or len(variables) != len(rates):
            raise ValueError("equations of SymPy are {x: expression, …}, a pair (symbols, expressions) of one length, or a list of "
                             "Eq(x(t).diff(t), expression)")
        return [(variable, 1, rate) for variable, rate in zip(variables, rates)]
    if len(equals) != len(given):
        raise ValueError(f"{next(part for part in given if part not in equals)} is no equation; write Eq(x(t).diff(t), …)")
    sides = [pair for equal in equals for pair in zip(_entries(equal.lhs), _entries(equal.rhs), strict=True)]
    parts = [part for pair in sides for side in pair for part in sympy.preorder_traversal(side)]
    derivatives = [part for part in dict.fromkeys(parts) if isinstance(part, sympy.Derivative)]
    if len({variable for derivative in derivatives for variable in derivative.variables}) != 1:
        raise ValueError("a field has derivatives by one symbol, the time; write Eq(x(t).diff(t), …)")
    orders = {derivative: derivative.derivative_count for derivative in derivatives}
    highest = {derivative.expr: max(orders[of] for of in derivatives if of.expr == derivative.expr) for derivative in derivatives}
    wanted = [derivative for derivative in derivatives if orders[derivative] == highest[derivative.expr]]
    lefts, rights = [left for left, _ in sides], [right for _, right in sides]
    if set(lefts) != set(wanted) or len(lefts) != len(wanted) or any(right.has(*wanted) for right in rights):
        # A single float would make SymPy solve in floats.
        zeros = [left - right for left, right in sides]
        exact = [zero.xreplace({number: sympy.Rational(str(number)) for number in zero.atoms(sympy.Float)}) for zero in zeros]
        solved = sympy.solve(exact, wanted, dict=True)
        if len(solved) != 1 or len(solved[0]) != len(wanted):
            raise ValueError(f"the equations do not say in one way what {', '.join(map(str, wanted))} are")
        lefts, rights = wanted, [solved[0][derivative] for derivative in wanted]
    # Derivatives contain functions, so derivatives are replaced first.
    names = {of: sympy.Symbol(f"{of.expr.func}" + "'" * orders[of]) for of in derivatives if of not in wanted}
    symbols = {function: sympy.Symbol(str(function.func)) for function in highest}
    twice = sorted(str(part) for part in set(parts) if part in symbols.values())
    if twice:
        raise ValueError(f"{twice[0]} is both a function of the time and a symbol; rename one of them")
    return [(symbols[left.expr], orders[left], right.subs(names).subs(symbols)) for left, right in zip(lefts, rights)]


def expression(text: str) -> Any:
    """Returns the SymPy expression of a formula; names become symbols."""
    import re

    sympy = needed("sympy", "sympy")

    # Symbols with other letters are left to SymPy, because Python would read ``ϕ`` as ``φ``.
    symbols = {name: sympy.Symbol(name) for name in re.findall(r"[^\W\d]\w*", text) if name.isascii()}
    return sympy.sympify(text, locals=symbols)
