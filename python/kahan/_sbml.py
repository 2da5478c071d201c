"""SBML models as text with equations, values and initial values."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from ._model import Model, Place, Refused, number_text
from ._totals import conserved

__all__ = ["sbml_model"]

_NUMBERED_ROOTS = 12
"""The largest denominator of an exponent that is written as a number; other exponents become parameters."""


def _functions(lib: Any) -> dict[int, tuple[str, Callable[..., float]]]:
    """Returns the functions of SBML: their text with the argument `u`, and functions that evaluate them."""
    inverse = {"sec": "cos", "csc": "sin", "cot": "tan", "sech": "cosh", "csch": "sinh", "coth": "tanh"}
    found: dict[str, tuple[str, Callable[..., float]]] = {
        name: (f"{name}(u)", getattr(math, name)) for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp")
    }
    for name, base in inverse.items():
        found[name] = (f"{name}(u)", lambda u, base=base: 1 / getattr(math, base)(u))
    for name in ("sin", "tan", "sinh", "cosh", "tanh"):
        found["arc" + name] = (f"a{name}(u)", getattr(math, "a" + name))
    found["arccos"] = ("(pi/2 - asin(u))", math.acos)
    # If g is the inverse of f, then g(1/u) is the inverse of 1/f.
    for name, base in inverse.items():
        if name != "sec":
            found["arc" + name] = (f"a{base}(1/u)", lambda u, base=base: getattr(math, "a" + base)(1 / u))
    found["arcsec"] = ("(pi/2 - asin(1/u))", lambda u: math.acos(1 / u))
    found["ln"] = ("log(u)", math.log)
    return {getattr(lib, f"AST_FUNCTION_{name.upper()}"): value for name, value in found.items()}


def _rough(lib: Any) -> dict[int, Callable[..., Any]]:
    """Returns the functions with jumps or corners, which are allowed in constants and initial values."""
    relations = {"EQ": operator.eq, "NEQ": operator.ne, "LT": operator.lt, "LEQ": operator.le, "GT": operator.gt, "GEQ": operator.ge}
    # `a < b < c` compares neighbours.
    found: dict[str, Callable[..., Any]] = {
        f"RELATIONAL_{name}": lambda *all_, of=of: all(map(of, all_, all_[1:])) for name, of in relations.items()
    }
    found |= {"FUNCTION_ABS": abs, "FUNCTION_MIN": lambda *all_: min(all_), "FUNCTION_MAX": lambda *all_: max(all_),
              "LOGICAL_NOT": operator.not_,
              "FUNCTION_FLOOR": lambda u: Fraction(math.floor(u)), "FUNCTION_CEILING": lambda u: Fraction(math.ceil(u)),
              "FUNCTION_FACTORIAL": lambda u: Fraction(math.factorial(int(u))), "LOGICAL_AND": lambda *all_: all(all_),
              "LOGICAL_OR": lambda *all_: any(all_), "LOGICAL_XOR": lambda *all_: sum(map(bool, all_)) % 2 == 1,
              "CONSTANT_TRUE": lambda: True, "CONSTANT_FALSE": lambda: False}
    return {getattr(lib, f"AST_{name}"): value for name, value in found.items()}


class _Reader:
    """A reader of a model: its symbols, their initial values, and its formulas in the language of texts."""

    def __init__(self, lib: Any, document: Any, place: Place) -> None:
        self.lib, self.place, self.model = lib, place, document.getModel()
        self.functions, self.rough = _functions(lib), _rough(lib)
        self.known: dict[str, Any] = {}
        """The elements with a value, by their ids."""
        model = self.model
        for kind in ("Compartments", "Species", "Parameters", "Reactions"):
            self.known |= {one.getId(): one for one in getattr(model, f"getListOf{kind}")()}
        for reaction in model.getListOfReactions():
            for reference in (*reaction.getListOfReactants(), *reaction.getListOfProducts()):
                if reference.isSetId():
                    self.known[reference.getId()] = reference
        # Rules without a formula are ignored.
        rules = [rule for rule in model.getListOfRules() if rule.getMath() is not None]
        self.rates = {rule.getVariable(): rule for rule in rules if rule.isRate()}
        self.formulas = {rule.getVariable(): rule for rule in rules if rule.isAssignment()}
        self.initial = {one.getSymbol(): one for one in model.getListOfInitialAssignments() if one.getMath() is not None}
        self.out = Model(place, list(self.known))
        self.changed = self._changed()
        self.values: dict[str, Fraction | float] = {}
        self.pending: list[str] = []

    # Values at the beginning.

    def value(self, name: str) -> Fraction | float:
        """Returns the value of a symbol at time 0, computed once."""
        if name not in self.values:
            if name in self.pending:
                circle = ", ".join(self.pending[self.pending.index(name):])
                raise self.refused(self.known[name], "its first value depends on itself", circle)
            self.pending.append(name)
            value = self._value(name)
            if not math.isfinite(value):
                raise self.refused(self.known[name], f"is {value}, and a field has numbers")
            self.values[name] = value
            self.pending.pop()
        return self.values[name]

    def _value(self, name: str) -> Fraction | float:
        one = self.known[name]
        given = self.initial.get(name) or self.formulas.get(name)
        if given is not None:
            return self.number(given.getMath(), given)
        kind = one.getElementName()
        if kind == "reaction":
            return self.rate_value(one)
        if kind == "species":
            return self._species_value(one)
        if kind == "compartment":
            if one.isSetSize():
                return _decimal(one.getSize())
            self.out.note(f"{name} has no volume, and is read with 1")
            return Fraction(1)
        if kind == "parameter":
            if one.isSetValue():
                return _decimal(one.getValue())
            raise self.refused(one, "a first value needs it, and it has none")
        return _decimal(one.getStoichiometry())

    def rate_value(self, reaction: Any) -> Fraction | float:
        return self.number(self.law(reaction), reaction)

    def _species_value(self, one: Any) -> Fraction | float:
        name = one.getId()
        volume = self.volume_value(one)
        if one.isSetInitialAmount():
            amount = _decimal(one.getInitialAmount())
            return amount if one.getHasOnlySubstanceUnits() else _divided(amount, volume)
        if one.isSetInitialConcentration():
            concentration = _decimal(one.getInitialConcentration())
            return concentration * volume if one.getHasOnlySubstanceUnits() else concentration
        self.out.note(f"{name} has no first value, and is read with 0")
        return Fraction(0)

    def compartment(self, species: Any) -> Any:
        """Returns the compartment of a species; ``None`` for a point without a size."""
        one = self.known[species.getCompartment()]
        is_point = one.isSetSpatialDimensions() and one.getSpatialDimensionsAsDouble() == 0
        return None if is_point and not one.isSetSize() else one

    def volume_value(self, species: Any) -> Fraction | float:
        compartment = self.compartment(species)
        return Fraction(1) if compartment is None else self.value(compartment.getId())

    def number(self, node: Any, of: Any) -> Fraction | float:
        """Returns the initial value of a formula; exact if it is rational."""
        lib, kind = self.lib, node.getType()
        arguments = [node.getChild(k) for k in range(node.getNumChildren())]
        if node.isNumber() or kind in (lib.AST_CONSTANT_PI, lib.AST_CONSTANT_E, lib.AST_NAME_AVOGADRO):
            return self.constant(node, of)
        if kind == lib.AST_NAME_TIME:
            return Fraction(0)
        if kind == lib.AST_NAME:
            return self.value(self.symbol(node, of))
        if kind == lib.AST_FUNCTION_PIECEWISE:
            pairs = zip(arguments[::2], arguments[1::2])
            chosen = next((one for one, condition in pairs if self.number(condition, of)), None)
            chosen = arguments[-1] if chosen is None and len(arguments) % 2 else chosen
            if chosen is None:
                raise self.refused(of, "no condition of its formula holds at the beginning")
            return self.number(chosen, of)
        if kind not in self.rough:
            self.supported(node, of)
        values = [self.number(one, of) for one in arguments]
        try:
            if kind in self.rough:
                found: Fraction | float = self.rough[kind](*values)
                return found
            if kind == lib.AST_PLUS:
                return sum(values, Fraction(0))
            if kind == lib.AST_TIMES:
                return math.prod(values, start=Fraction(1))
            if kind == lib.AST_MINUS:
                return -values[0] if len(values) == 1 else values[0] - values[1]
            if kind == lib.AST_DIVIDE:
                return _divided(*values)
            if kind in (lib.AST_POWER, lib.AST_FUNCTION_POWER):
                return _power(*values)
            if kind == lib.AST_FUNCTION_ROOT:
                index, radicand = values if len(values) == 2 else (Fraction(2), values[0])
                return _power(radicand, _divided(Fraction(1), index))
            if kind == lib.AST_FUNCTION_LOG:
                base, argument = values if len(values) == 2 else (Fraction(10), values[0])
                return math.log10(argument) if base == 10 else math.log(argument) / math.log(base)
            return self.functions[kind][1](float(values[0]))
        except (ArithmeticError, ValueError) as error:
            raise self.refused(of, f"its first value cannot be computed: {error}") from None

    def constant(self, node: Any, of: Any) -> Fraction | float:
        lib, kind = self.lib, node.getType()
        if kind == lib.AST_CONSTANT_PI:
            return math.pi
        if kind == lib.AST_CONSTANT_E:
            return math.e
        if kind == lib.AST_RATIONAL:
            return Fraction(node.getNumerator(), node.getDenominator())
        value = node.getValue()
        if not math.isfinite(value):
            raise self.refused(of, f"its formula has {value}, and a field has numbers")
        return _decimal(value)

    # Formulas.

    def symbol(self, node: Any, of: Any) -> str:
        name: str = node.getName()
        if name not in self.known:
            raise self.refused(of, f"its formula has `{name}`, which nothing defines")
        return name

    def supported(self, node: Any, of: Any) -> None:
        """Raises an error for a function that is not smooth."""
        lib, kind = self.lib, node.getType()
        own = (lib.AST_PLUS, lib.AST_MINUS, lib.AST_TIMES, lib.AST_DIVIDE, lib.AST_POWER, lib.AST_FUNCTION_POWER,
               lib.AST_FUNCTION_ROOT, lib.AST_FUNCTION_LOG, *self.functions)
        if kind in own:
            return
        name = node.getName() or lib.formulaToL3String(node)
        reason = "has a jump or a corner, and a field is smooth"
        if kind == lib.AST_FUNCTION_DELAY:
            name, reason = "delay", "is a value of the past: docs/how-to/texts.md shows a chain that comes near"
        elif kind == lib.AST_FUNCTION_RATE_OF:
            name, reason = "rateOf", "is the rate of another quantity: write out its formula"
        elif kind in (lib.AST_FUNCTION_FACTORIAL, lib.AST_FUNCTION):
            reason = "is no function that can be read"
        elif kind == lib.AST_FUNCTION_PIECEWISE:
            name = "piecewise"
        raise self.refused(of, f"`{name}` {reason}")

    def is_constant(self, node: Any) -> bool:
        """Returns whether a formula has the same value at all times."""
        if node.getType() == self.lib.AST_NAME_TIME:
            return False
        if node.getType() == self.lib.AST_NAME:
            name = node.getName()
            if name in self.formulas and name not in self.pending:
                self.pending.append(name)
                found = self.is_constant(self.formulas[name].getMath())
                self.pending.pop()
                return found
            return name in self.known and name not in self.changed
        return all(self.is_constant(node.getChild(k)) for k in range(node.getNumChildren()))

    def is_free(self, name: str) -> bool:
        """Returns whether a symbol is a parameter without a value."""
        one = self.known[name]
        return one.getElementName() == "parameter" and not one.isSetValue() and name not in self.initial

    def _changed(self) -> set[str]:
        """Returns the symbols whose values change, or may be free."""
        changed = set(self.rates) | {one.getId() for one in self.model.getListOfReactions()}
        for reaction in self.model.getListOfReactions():
            for reference in (*reaction.getListOfReactants(), *reaction.getListOfProducts()):
                species = self.known.get(reference.getSpecies())
                if species is not None and not species.getBoundaryCondition() and not species.getConstant():
                    changed.add(species.getId())
        changed |= set(self.formulas)
        changed |= {one.getId() for one in self.model.getListOfSpecies() if one.getCompartment() in self.rates}
        for name in self.known:
            changed |= {name} if self.is_free(name) else set()
        return changed

    def text(self, node: Any, of: Any, outer: int = 0) -> str:
        """Returns a formula in the language of texts, in parentheses if its context needs them."""
        own, written = self._text(node, of)
        return f"({written})" if own < outer else written

    def _text(self, node: Any, of: Any) -> tuple[int, str]:
        lib, kind = self.lib, node.getType()
        count = node.getNumChildren()
        arguments = [node.getChild(k) for k in range(count)]
        if kind in (lib.AST_CONSTANT_PI, lib.AST_CONSTANT_E, lib.AST_NAME_AVOGADRO) or node.isNumber():
            value = number_text(self.constant(node, of))
            return (0 if "-" in value[:1] or "/" in value else 5), value
        if kind == lib.AST_NAME_TIME:
            return 5, "t"
        if kind == lib.AST_NAME:
            name = self.symbol(node, of)
            return 5, self.out.name(name)
        if kind == lib.AST_PLUS:
            return (1, " + ".join(self.text(one, of, 1) for one in arguments)) if count else (5, "0")
        if kind == lib.AST_TIMES:
            return (2, "*".join(self.text(one, of, 2 if k == 0 else 3) for k, one in enumerate(arguments))) if count else (5, "1")
        if kind == lib.AST_MINUS and count == 1:
            return 1, f"-{self.text(arguments[0], of, 2)}"
        if kind == lib.AST_MINUS:
            return 1, f"{self.text(arguments[0], of, 1)} - {self.text(arguments[1], of, 2)}"
        if kind == lib.AST_DIVIDE:
            return 2, f"{self.text(arguments[0], of, 2)}/{self.text(arguments[1], of, 3)}"
        if not self.is_constant(node):
            self.supported(node, of)
        if kind in (lib.AST_POWER, lib.AST_FUNCTION_POWER):
            return self.power(arguments[0], arguments[1], of)
        if self.is_constant(node):
            # Coefficients of a field are rational, so the value of a function becomes a parameter.
            return 5, self.out.computed(lib.formulaToL3String(node), self.number(node, of))
        if kind == lib.AST_FUNCTION_ROOT:
            index = self.number(arguments[0], of) if count == 2 else Fraction(2)
            return 4, f"{self.text(arguments[-1], of, 5)}^({_divided(Fraction(1), index)})"
        if kind == lib.AST_FUNCTION_LOG:
            base = self.number(arguments[0], of) if count == 2 else Fraction(10)
            return 2, f"log({self.text(arguments[-1], of)})/{number_text(math.log(base))}"
        pattern = self.functions[kind][0]
        # An argument after `/` needs parentheses around a sum or a product.
        inner = self.text(arguments[0], of, 3 if "/u" in pattern else 0)
        return 5, re.sub(r"\bu\b", lambda _: inner, pattern)

    def power(self, base: Any, exponent: Any, of: Any) -> tuple[int, str]:
        """Returns a power. A constant exponent that is a simple fraction is written as a number, for a small lift."""
        inner = self.text(base, of, 5)
        if not self.is_constant(exponent):
            return 4, f"{inner}^({self.text(exponent, of)})"
        value = self.number(exponent, of)
        near = Fraction(value).limit_denominator(_NUMBERED_ROOTS)
        is_simple = abs(near - Fraction(value)) < 1e-15 and abs(near) <= 64
        if self.is_constant(base) and not (is_simple and near.denominator == 1):
            formula = f"{self.lib.formulaToL3String(base)}^{self.lib.formulaToL3String(exponent)}"
            return 5, self.out.computed(formula, _power(self.number(base, of), value))
        if not is_simple:
            return 4, f"{inner}^{self.out.computed(self.lib.formulaToL3String(exponent), value)}"
        if exponent.getType() == self.lib.AST_NAME:
            self.out.note(f"{exponent.getName()} = {near} is an exponent, and stands in the text as a number")
        if near == 1:
            return 5, inner
        written = str(near) if near.denominator == 1 and near > 0 else f"({near})"
        return 4, f"{inner}^{written}"

    # Equations.

    def law(self, reaction: Any) -> Any:
        law = reaction.getKineticLaw()
        if law is None or law.getMath() is None:
            raise self.refused(reaction, "has no kinetic law")
        return law.getMath()

    def refused(self, element: Any, reason: str, name: str | None = None) -> Refused:
        kind = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", element.getElementName()).lower()
        own = element.getId() or getattr(element, "getVariable", str)() or getattr(element, "getSymbol", str)() or ""
        return Refused(self.place, f"the {kind} `{name or own}`".replace(" ``", ""), reason, element.getLine(), name or own)

    def read(self) -> Model:
        """Returns the model as text."""
        model, out = self.model, self.out
        for name, one in self.known.items():
            is_formula = one.getElementName() == "compartment" and name in self.formulas
            if is_formula and not self.is_constant(self.formulas[name].getMath()):
                raise self.refused(self.formulas[name], "its volume follows a formula: make it a rate rule, or constant")
        flows = self._flows()
        states = [one.getId() for one in model.getListOfSpecies() if one.getId() in flows or one.getId() in self.rates]
        states += [name for name in self.rates if name not in states]
        for name in states:
            out.state(name, self.value(name), self._equation(name, flows.get(name, [])), self._meaning(name))
        formulas = {name: (rule.getMath(), rule) for name, rule in self.formulas.items()}
        for name, (node, of) in (formulas | {one.getId(): (self.law(one), one) for one in model.getListOfReactions()}).items():
            if _names(self.lib, [node]) or not self.is_constant(node):
                out.formula(name, self.text(node, of))
            else:
                out.parameter(name, self.number(node, of), "constant rate" if name not in self.formulas else "constant")
        for name, one in self.known.items():
            if name not in out.rights and name not in out.formulas and name not in out.parameters:
                if not self.is_free(name):
                    out.parameter(name, self.value(name), self._meaning(name))
                    if name in self.initial:
                        formula = self.lib.formulaToL3String(self.initial[name].getMath())
                        out.note(f"{name} = {formula} is computed once, from the values of this text")
        out.units = self._units()
        self._conserve(flows)
        return out

    def _flows(self) -> dict[str, list[tuple[Any, int, Any]]]:
        """Returns for each species that reactions change: the reference, its sign, the reaction."""
        flows: dict[str, list[tuple[Any, int, Any]]] = {}
        for reaction in self.model.getListOfReactions():
            for sign, references in ((-1, reaction.getListOfReactants()), (1, reaction.getListOfProducts())):
                for reference in references:
                    name = reference.getSpecies()
                    species = self.known.get(name)
                    if species is None:
                        raise self.refused(reaction, f"has the species `{name}`, which nothing defines")
                    if not species.getBoundaryCondition() and not species.getConstant():
                        if name in self.formulas or name in self.rates:
                            raise self.refused(reaction, f"changes `{name}`, which has a rule, too")
                        flows.setdefault(name, []).append((reference, sign, reaction))
        for name, species in self.known.items():
            # If the volume changes, a constant amount has a varying concentration.
            is_held = species.getElementName() == "species" and name not in {*flows, *self.rates, *self.formulas}
            if is_held and species.getCompartment() in self.rates and not species.getHasOnlySubstanceUnits():
                flows[name] = []
        return flows

    def _stoichiometry(self, reference: Any) -> Fraction | None:
        """Returns the stoichiometric number of a reference; ``None`` if it is a symbol that changes."""
        name = reference.getId()
        if name in self.rates or name in self.formulas:
            return None
        value = self.value(name) if name in self.initial else reference.getStoichiometry()
        if not math.isfinite(value):
            raise self.refused(reference, "has no stoichiometry", reference.getSpecies())
        return Fraction(repr(value)) if isinstance(value, float) else Fraction(value)

    def _equation(self, name: str, flows: Iterable[tuple[Any, int, Any]]) -> str:
        """Returns the right-hand side of a state: its rate rule, or the sum of its reactions."""
        if name in self.rates:
            return self.text(self.rates[name].getMath(), self.rates[name])
        species, sum_text = self.known[name], ""
        for reference, sign, reaction in flows:
            number = self._stoichiometry(reference)
            rate = self.out.name(reaction.getId())
            if number is None:
                rate = f"{self.out.name(reference.getId())}*{rate}"
            elif abs(number) != 1:
                rate = f"{number_text(abs(number), True)}*{rate}"
            if number is not None and number < 0:
                sign = -sign
            if number != 0:
                sum_text += f" {'+' if sign > 0 else '-'} {rate}"
        sum_text = sum_text.removeprefix(" + ").strip() or "0"
        sum_text = "-" + sum_text[2:] if sum_text.startswith("- ") else sum_text
        factor = species.getConversionFactor() or self.model.getConversionFactor()
        is_sum = " " in sum_text
        if factor:
            sum_text, is_sum = f"{self.out.name(factor)}*({sum_text})", False
        volume = self._volume_of(name)
        if not volume:
            return sum_text
        written = f"({sum_text})" if is_sum else sum_text
        sum_text = f"{written}/{self.out.name(volume)}" if sum_text != "0" else "0"
        if volume in self.rates:
            rate = self.text(self.rates[volume].getMath(), self.rates[volume])
            diluted = f"{self.out.name(name)}*({rate})/{self.out.name(volume)}"
            sum_text = f"-{diluted}" if sum_text == "0" else f"{sum_text} - {diluted}"
        return sum_text

    def _is_one(self, compartment: str) -> bool:
        """Returns whether a volume is constantly 1 and no formula uses its name, so that it can be left out."""
        return compartment not in {*self.rates, *self.formulas, *self._named} and self.value(compartment) == 1

    def _volume_of(self, name: str) -> str:
        """Returns the volume whose product with a species' value is the amount; empty if the value is the amount."""
        species = self.known[name]
        volume = None if species.getHasOnlySubstanceUnits() else self.compartment(species)
        return "" if volume is None or self._is_one(volume.getId()) else str(volume.getId())

    @property
    def _named(self) -> set[str]:
        """Returns all names in formulas."""
        if "_all_names" not in self.__dict__:
            own = [*self.rates.values(), *self.formulas.values(), *self.initial.values()]
            nodes = [one.getMath() for one in own] + [self.law(one) for one in self.model.getListOfReactions()]
            self.__dict__["_all_names"] = _names(self.lib, nodes)
        found: set[str] = self.__dict__["_all_names"]
        return found

    def _meaning(self, name: str) -> str:
        """Returns the meaning of a symbol's value: for a species, amount or concentration, and its compartment."""
        one = self.known[name]
        kind: str = one.getElementName()
        if kind != "species":
            return {"compartment": "volume", "speciesReference": "stoichiometry"}.get(kind, kind)
        where = one.getCompartment()
        quantity = "amount" if one.getHasOnlySubstanceUnits() or self.compartment(one) is None else "concentration"
        is_held = name not in self.changed
        return f"{quantity} in {where}" + (", held" if is_held else "")

    def _units(self) -> str:
        """Returns the units of the model, as far as they are given."""
        model, said = self.model, []
        for kind, getter in (("amounts", "Substance"), ("volumes", "Volume"), ("time", "Time")):
            unit = getattr(model, f"get{getter}Units")()
            if unit:
                definition = model.getUnitDefinition(unit)
                shown = self.lib.UnitDefinition.printUnits(definition, True) if definition is not None else unit
                shown = re.sub(r"\(1 (.+?)\)\^1", r"\1", shown)
                said.append(f"{kind} in {shown}")
        return "; ".join(said) or "none given"

    def _conserve(self, flows: Mapping[str, list[tuple[Any, int, Any]]]) -> None:
        """Claims the totals that reactions preserve."""
        columns: dict[str, dict[str, Fraction]] = {}
        for name, own in flows.items():
            species = self.known[name]
            volume = self.compartment(species)
            is_wrong = species.getConversionFactor() or self.model.getConversionFactor()
            if is_wrong or (volume is not None and volume.getId() in self.rates):
                return
            rows: dict[str, Fraction] = {}
            for reference, sign, reaction in own:
                number = self._stoichiometry(reference)
                if number is None:
                    return
                rows[reaction.getId()] = rows.get(reaction.getId(), Fraction(0)) + sign * number
            columns[name] = rows
        for total in conserved(columns):
            terms = []
            volumes = {name: self._volume_of(name) for name in total}
            # In a single volume, the sum of the concentrations is constant, too.
            is_one = len(set(volumes.values())) == 1
            for name, factor in total.items():
                pieces = [] if abs(factor) == 1 else [number_text(abs(factor), True)]
                pieces += [self.out.name(volumes[name])] if volumes[name] and not is_one else []
                terms.append(("- " if factor < 0 else "+ ") + "*".join([*pieces, self.out.name(name)]))
            self.out.total(" ".join(terms).removeprefix("+ "))


def _names(lib: Any, nodes: list[Any]) -> set[str]:
    """Returns the names in formulas."""
    names, nodes = set(), list(nodes)
    while nodes:
        node = nodes.pop()
        names |= {node.getName()} if node.getType() == lib.AST_NAME else set()
        nodes += [node.getChild(k) for k in range(node.getNumChildren())]
    return names


def _decimal(value: float) -> Fraction | float:
    """Returns the decimal that Python prints for a finite float; other floats unchanged."""
    return Fraction(repr(float(value))) if math.isfinite(value) else value


def _divided(left: Fraction | float, right: Fraction | float) -> Fraction | float:
    return left / right


def _power(base: Fraction | float, exponent: Fraction | float) -> Fraction | float:
    if isinstance(exponent, Fraction) and exponent.denominator == 1 and abs(exponent) <= 64:
        return base ** int(exponent)
    return math.pow(base, exponent)


def _refuse(lib: Any, document: Any, place: Place) -> None:
    """Raises an error for a part of a model that differential equations cannot represent."""
    for k in range(document.getNumErrors()):
        error = document.getError(k)
        if error.getSeverity() >= lib.LIBSBML_SEV_ERROR:
            raise Refused(place, "the file", " ".join(error.getMessage().split()), error.getLine())
    model = document.getModel()
    if model is None:
        raise Refused(place, "the file", "has no model", 1)
    for k in range(document.getNumPlugins()):
        package = document.getPlugin(k).getPackageName()
        if document.getLevel() > 2 and document.getPackageRequired(package) and package not in ("comp", "l3v2extendedmath"):
            raise Refused(place, f"the package `{package}`", "changes the meaning of the model, and is not read", 1)
    refused = [("event", model.getListOfEvents(),
                "stops the flow and changes values: run an orbit to it, change them, and go on"),
               ("algebraic rule", [rule for rule in model.getListOfRules() if rule.isAlgebraic()],
                "is no equation of a derivative: solve it for one of its names, as an assignment rule"),
               ("fast reaction", [one for one in model.getListOfReactions() if one.isSetFast() and one.getFast()],
                "is at its equilibrium at all times: write it so, or give it a rate")]
    for kind, elements, reason in refused:
        for one in elements:
            own = f" `{one.getId()}`" if one.getId() else ""
            raise Refused(place, f"the {kind}{own}", reason, one.getLine(), one.getId())


def sbml_model(lib: Any, document: Any, place: Place) -> Model:
    """Returns the model in an SBML document; ``lib`` is libsbml."""
    _refuse(lib, document, place)
    has_constraints = document.getModel().getNumConstraints() > 0

    def convert(name: str) -> None:
        properties = lib.ConversionProperties()
        properties.addOption(name, True)
        if document.convert(properties) != lib.LIBSBML_OPERATION_SUCCESS:
            raise Refused(place, "the file", f"cannot be converted ({name}): {document.getErrorLog().toString().strip()}", 1)

    if document.isPackageEnabled("comp"):
        convert("flatten comp")
        _refuse(lib, document, place)
    convert("promoteLocalParameters")
    convert("expandFunctionDefinitions")
    if (document.getLevel(), document.getVersion()) != (3, 2) and not document.setLevelAndVersion(3, 2, False):
        raise Refused(place, "the file", "cannot be read as SBML level 3", 1)
    out = _Reader(lib, document, place).read()
    if not out.rights:
        raise Refused(place, "the model", "has no species that a reaction changes, and no rate rule")
    out.title = (document.getModel().getName() or document.getModel().getId()).removeprefix("__main")
    if has_constraints:
        out.note("constraints are not watched")
    return out
