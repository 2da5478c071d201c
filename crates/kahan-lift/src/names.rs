//! Writes polynomials in coordinates as expressions, and chooses names for new variables.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Notation, push_term};
use kahan_algebra::symbols::Symbols;

use crate::laurent::{Laurent, Monomial};
use crate::ring::{CoordinateDefinition, Function, Ring};

#[derive(Debug)]
pub(crate) struct Writer<'a> {
    ring: &'a Ring,
    pub(crate) states: &'a [String],
    parameters: Symbols,
}

impl<'a> Writer<'a> {
    pub(crate) fn new(ring: &'a Ring, states: &'a [String], parameters: &[String]) -> Self {
        let parameters = Symbols { states: Vec::new(), parameters: parameters.to_vec() };
        Writer { ring, states, parameters }
    }

    pub(crate) fn polynomial(&self, polynomial: &Laurent, notation: &dyn Notation) -> String {
        let mut text = String::new();
        for (monomial, coefficient) in polynomial.terms().rev() {
            let (negative, size) = signed(coefficient);
            push_term(&mut text, negative, &self.term(monomial, &size, notation));
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// Writes a term. Negative powers make a denominator; products of exponentials are merged.
    fn term(&self, monomial: &Monomial, coefficient: &RationalFunction, notation: &dyn Notation) -> String {
        let mut above = self.factors(coefficient.numerator(), notation);
        let mut below = self.factors(coefficient.denominator(), notation);
        let (exponent, rest) = self.split_exponentials(monomial);
        for (coordinate, exponent) in rest {
            let side = if exponent > 0 { &mut above } else { &mut below };
            side.push(self.power(coordinate, exponent.unsigned_abs(), notation));
        }
        if !exponent.is_zero() {
            above.push(format!("exp({})", self.polynomial(&exponent, notation)));
        }
        if above.is_empty() {
            above.push(notation.number(&Rational::one()));
        }
        if below.is_empty() {
            return notation.product(&above);
        }
        let side = |factors: &[String]| match factors {
            [sum] if sum.starts_with('(') && sum.find(')') == Some(sum.len() - 1) => {
                sum[1..sum.len() - 1].to_owned()
            }
            factors => notation.product(factors),
        };
        notation.quotient(&side(&above), &side(&below))
    }

    /// Splits a monomial into exp(u) and powers of coordinates. Returns u, and the powers.
    fn split_exponentials(&self, monomial: &Monomial) -> (Laurent, Vec<(usize, i16)>) {
        let mut sum = Laurent::zero();
        let mut rest = Vec::new();
        for (coordinate, exponent) in monomial.powers() {
            match &self.ring.coordinates[coordinate].meaning {
                CoordinateDefinition::Function(Function::Exp, argument) => {
                    let times = RationalFunction::constant(Rational::from(i64::from(exponent)));
                    sum.add_scaled(argument, &times);
                }
                _ => rest.push((coordinate, exponent)),
            }
        }
        (sum, rest)
    }

    fn factors(&self, polynomial: &Polynomial, notation: &dyn Notation) -> Vec<String> {
        if polynomial.is_one() {
            return Vec::new();
        }
        let text = notation.polynomial(&self.parameters, polynomial);
        vec![if polynomial.len() > 1 { format!("({text})") } else { text }]
    }

    fn power(&self, coordinate: usize, exponent: u16, notation: &dyn Notation) -> String {
        let call = |name: &str, argument: &Laurent| {
            let argument = self.polynomial(argument, notation);
            notation.power(&notation.call(name, &argument), i64::from(exponent))
        };
        match &self.ring.coordinates[coordinate].meaning {
            CoordinateDefinition::State(state) => {
                notation.power(&notation.name(&self.states[*state]), i64::from(exponent))
            }
            CoordinateDefinition::Function(function, argument) => call(function.name(), argument),
            CoordinateDefinition::Root(base, 1) | CoordinateDefinition::Sum(base) => call("", base),
            CoordinateDefinition::Root(base, 2) => call("sqrt", base),
            CoordinateDefinition::Root(base, 3) => call("cbrt", base),
            CoordinateDefinition::Root(base, index) => {
                let base = notation.call("", &self.polynomial(base, notation));
                notation.raised(&base, &format!("{exponent}/{index}"))
            }
            CoordinateDefinition::Power(base, power) => {
                let power = power * &RationalFunction::constant(Rational::from(i64::from(exponent)));
                let power = self.polynomial(&Laurent::constant(power), notation);
                let base = self.polynomial(base, notation);
                let is_name = base.chars().all(|one| one.is_alphanumeric() || one == '_');
                notation.raised(&if is_name { base } else { notation.call("", &base) }, &power)
            }
        }
    }

    /// Returns a name for a new variable, such as `x2`, `sin_x`, `inv_P` or `x_y`.
    pub(crate) fn name(&self, monomial: &Monomial) -> String {
        let mut above = Vec::new();
        let mut below = Vec::new();
        let (exponentials, rest) = self.split_exponentials(monomial);
        if !exponentials.is_zero() {
            let parts: Option<Vec<String>> = exponentials
                .terms()
                .rev()
                .map(|(one, value)| self.short(&Laurent::term(one.clone(), value.clone())))
                .collect();
            above.push(match parts {
                Some(parts) => format!("exp_{}", parts.join("_")),
                None => {
                    let (first, _) = monomial.powers().next().expect("an exponential occurs");
                    format!("exp_{}", first + 1 - self.states.len())
                }
            });
        }
        for (coordinate, exponent) in rest {
            let name = self.coordinate_name(coordinate);
            let size = exponent.unsigned_abs();
            let name = if size == 1 { name } else { raised(&name, size) };
            if exponent > 0 { above.push(name) } else { below.push(name) }
        }
        if !below.is_empty() {
            above.push(format!("inv_{}", below.join("_")));
        }
        above.join("_")
    }

    fn coordinate_name(&self, coordinate: usize) -> String {
        let of_kind = |kind: &dyn Fn(&CoordinateDefinition) -> bool| {
            let earlier = &self.ring.coordinates[..coordinate];
            earlier.iter().filter(|one| kind(&one.meaning)).count()
        };
        match &self.ring.coordinates[coordinate].meaning {
            CoordinateDefinition::State(state) => self.states[*state].clone(),
            CoordinateDefinition::Function(function, argument) => match self.short(argument) {
                Some(short) => format!("{}_{short}", function.name()),
                None => {
                    let is_same = |one: &CoordinateDefinition| matches!(one, CoordinateDefinition::Function(known, _) if known == function);
                    format!("{}_{}", function.name(), of_kind(&is_same) + 1)
                }
            },
            CoordinateDefinition::Root(base, index) => match (self.short(base), index) {
                (Some(short), 2) => format!("sqrt_{short}"),
                (Some(short), _) => format!("root_{short}"),
                (None, index) => {
                    let is_root = |one: &CoordinateDefinition| matches!(one, CoordinateDefinition::Root(base, _) if self.short(base).is_none());
                    let letters = if *index == 1 { ["P", "Q", "R", "S"] } else { ["r", "s", "u", "w"] };
                    let earlier = of_kind(&is_root);
                    letters
                        .get(earlier)
                        .map_or_else(|| format!("{}{earlier}", letters[0]), |&one| one.to_owned())
                }
            },
            CoordinateDefinition::Power(base, _) => match self.short(base) {
                Some(short) => format!("{short}_pow"),
                None => format!("pow{}", of_kind(&|one| matches!(one, CoordinateDefinition::Power(..))) + 1),
            },
            CoordinateDefinition::Sum(_) => {
                format!("sum{}", of_kind(&|one| matches!(one, CoordinateDefinition::Sum(_))) + 1)
            }
        }
    }

    fn short(&self, argument: &Laurent) -> Option<String> {
        let (monomial, coefficient) = argument.terms().next().filter(|_| argument.len() == 1)?;
        let (_, number) = coefficient.numerator().leading_term()?;
        let is_plain = coefficient.numerator().len() == 1 && coefficient.denominator().is_one();
        if !is_plain || !number.is_integer() || monomial.powers().any(|(_, exponent)| exponent < 0) {
            return None;
        }
        let mut short = if number.is_negative() { "minus_".to_owned() } else { String::new() };
        if !number.abs().is_one() {
            short.push_str(&number.abs().to_string());
        }
        let parameters = coefficient.numerator().leading_term()?.0.powers().iter();
        let parameters = parameters.map(|&(one, exponent)| (self.parameters.name(one), exponent));
        let coordinates = monomial.powers();
        let coordinates =
            coordinates.map(|(one, exponent)| (self.coordinate_name(one), exponent.cast_unsigned().into()));
        for (name, exponent) in parameters.chain(coordinates) {
            short.push_str(&name);
            if exponent > 1 {
                short.push_str(&exponent.to_string());
            }
        }
        Some(short)
    }
}

fn raised(name: &str, exponent: u16) -> String {
    let gap = if name.ends_with(|last: char| last.is_ascii_digit()) { "_" } else { "" };
    format!("{name}{gap}{exponent}")
}

/// Returns whether the numerator is a single negative term, and the coefficient without this sign.
pub(crate) fn signed(coefficient: &RationalFunction) -> (bool, RationalFunction) {
    let negative = coefficient.numerator().len() == 1
        && coefficient.numerator().leading_term().is_some_and(|(_, number)| number.is_negative());
    (negative, if negative { -coefficient } else { coefficient.clone() })
}
