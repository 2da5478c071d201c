//! Formulas as claims in the language of `kahan!`: written, read again, and proved.
//!
//! What is printed is what was proved: the text of the claim is parsed behind the equations of the
//! field and goes through the prover of claims, or states exactly a formula that a theorem proves.
//! A formula that does not pass is not returned.

use std::slice::from_ref;

use kahan_algebra::arithmetic::{Arithmetic, Functions};
use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::prove::{Verdict, prove_all};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Formulas, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_algebra::{lexer, read, read_unproved, seed};

use crate::claims::writing::{is_product, quotient, state_factors};

/// The most work for the comparison of a formula with its text.
const MOST_TERMS: usize = 100_000;
const MOST_WORK: u64 = 10_000_000;

/// What densities are called.
const DENSITY: &str = "rho";

/// A proved claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// What is claimed: an integral or a density.
    pub kind: ClaimKind,
    /// The claim as a line of the language of `kahan!`: `integral H1 = …;`.
    pub text: String,
    /// The degree in the states of numerator and denominator, the larger.
    pub degree: u32,
    /// The numerator.
    pub numerator: Polynomial,
    /// The denominator.
    pub denominator: Polynomial,
    /// The irreducible factors of an integral that depend on states.
    pub factors: Vec<Polynomial>,
}

impl Formula {
    /// The claim's name.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        name_of(&self.text)
    }
}

/// The name of a claim that is written as a line.
pub(crate) fn name_of(text: &str) -> Option<&str> {
    text.split_whitespace().nth(1)
}

/// Writes and proves claims about one field, some of its parameters and ε perhaps fixed.
#[derive(Clone, Debug)]
pub struct Claims<'a> {
    system: &'a System,
    equations: String,
    /// ` when a = 1, eps = 1/2`, or empty.
    pub(crate) condition: String,
    taken: Vec<String>,
}

impl<'a> Claims<'a> {
    /// For the field of `system`, at these values of parameters and of ε (half the time step).
    #[must_use]
    pub fn new(system: &'a System, parameters: &[(String, Rational)], eps: Option<&Rational>) -> Self {
        let field = &system.field;
        let symbols = &field.symbols;
        let values = Formulas { field, map: None, notation: &Text }.field();
        let lines: Vec<String> = symbols
            .states
            .iter()
            .zip(values)
            .map(|(state, value)| format!("{state}dot = {value};"))
            .collect();
        // A parameter that cancelled from the equations is unknown to them.
        let occurs = |name: &str| {
            symbols.parameters.iter().position(|known| known == name).is_some_and(|k| {
                field.components.iter().any(|component| component.contains(symbols.parameter(k)))
            })
        };
        let mut conditions: Vec<String> = parameters
            .iter()
            .filter(|(name, _)| occurs(name))
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        conditions.extend(eps.map(|value| format!("eps = {value}")));
        let condition =
            if conditions.is_empty() { String::new() } else { format!(" when {}", conditions.join(", ")) };
        let taken = [symbols.states.clone(), symbols.parameters.clone(), vec!["eps".to_owned()]].concat();
        Claims { system, equations: lines.join(" "), condition, taken }
    }

    /// The name of the density that the field brings along, if one found here would have to stand
    /// in its place: a block takes one density without `when`.
    #[must_use]
    pub fn own_density(&self) -> Option<&str> {
        let own = self.system.accessors(ClaimKind::Density).next()?;
        self.condition.is_empty().then_some(own.name.text.as_str())
    }

    /// A name that nothing else in the block has, but for a density that is replaced: the stem, or
    /// with a number or more letters.
    pub(crate) fn name(&self, stem: &str, index: Option<usize>) -> String {
        let mut name = match index {
            Some(index) => format!("{stem}{index}"),
            None => stem.to_owned(),
        };
        let is_taken = |name: &String| {
            self.taken.contains(name)
                || self.system.constants.iter().any(|(known, _)| known == name)
                || self.system.claims.iter().any(|claim| claim.name.text == *name)
                    && !(stem == DENSITY && self.own_density() == Some(name.as_str()))
        };
        while is_taken(&name) {
            name.push('_');
        }
        name
    }

    /// The claim that numerator/denominator is an integral, if it is proved; `index` numbers its
    /// name. It is written in factors, and by powers of one of the polynomials `by` where that is
    /// shorter.
    #[must_use]
    pub fn integral(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
        by: &[Polynomial],
    ) -> Option<Formula> {
        let formula = self.written(symbols, index, numerator, denominator, by);
        self.is_proved(&formula.text).then_some(formula)
    }

    /// The claim that numerator/denominator is an integral, which a theorem proves; `None` where
    /// the text, read again, would say something else. A proof would take minutes in hundreds of
    /// variables.
    pub(crate) fn integral_by_theorem(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Option<Formula> {
        let formula = self.written(symbols, index, numerator, denominator, &[]);
        let reading = read_unproved(&lexer::lex(&format!("{} {}", self.equations, formula.text)).tokens);
        let system = reading.system().ok()?;
        let own = |name: &str| {
            let mut all = (0..symbols.count()).map(|index| Variable(index as u16));
            all.find(|&variable| symbols.name(variable) == name)
        };
        let value = |variable: Variable| {
            let own = own(&system.field.symbols.name(variable));
            own.map(|own| Polynomial::variable(own).into())
        };
        let functions = Functions::new(Budget::new(MOST_TERMS, MOST_WORK));
        let stated =
            system.claims.last()?.plan.evaluate(&functions, |input| input.variable().map(value)).pop()??;
        let [above, below] = [numerator, denominator].map(|side| Some(side.clone().into()));
        let meant = functions.divide(&above, &below)?;
        let is_stated = [functions.subtract(&stated, &meant), functions.add(&stated, &meant)]
            .iter()
            .any(|difference| functions.is_zero(difference));
        is_stated.then_some(formula)
    }

    fn written(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
        by: &[Polynomial],
    ) -> Formula {
        let value = unsigned(quotient(symbols, from_ref(numerator), from_ref(denominator), by));
        let text = format!("integral {} = {value}{};", self.name("H", Some(index)), self.condition);
        let factors = [numerator, denominator].map(|side| state_factors(symbols, side)).concat();
        formula(symbols, ClaimKind::Integral, text, numerator, denominator, factors)
    }

    /// The claim that ∏ factorᵏ is an invariant density, if it is proved; written as integrals are.
    #[must_use]
    pub fn density(
        &self,
        symbols: &Symbols,
        index: Option<usize>,
        factors: &[(Polynomial, i32)],
        by: &[Polynomial],
    ) -> Option<Formula> {
        let side = |sign: i32| -> Vec<Polynomial> {
            let own = factors.iter().filter(|(_, exponent)| exponent * sign > 0);
            own.flat_map(|(factor, exponent)| vec![factor.clone(); exponent.unsigned_abs() as usize])
                .collect()
        };
        let (above, below) = (side(1), side(-1));
        let value = unsigned(quotient(symbols, &above, &below, by));
        let text = format!("density {} = {value}{};", self.name(DENSITY, index), self.condition);
        let product =
            |side: &[Polynomial]| side.iter().fold(Polynomial::one(), |product, factor| &product * factor);
        self.is_proved(&text).then(|| {
            formula(symbols, ClaimKind::Density, text, &product(&above), &product(&below), Vec::new())
        })
    }

    /// The entries of a bracket in factors, as they stand in a claim; `tensor` has those above the
    /// diagonal, row by row.
    pub(crate) fn bracket_entries(&self, symbols: &Symbols, tensor: &[RationalFunction]) -> String {
        let states = &symbols.states;
        let places = (0..states.len()).flat_map(|i| (i + 1..states.len()).map(move |j| (i, j)));
        let entry = |((i, j), value): ((usize, usize), &RationalFunction)| {
            let text = quotient(symbols, from_ref(value.numerator()), from_ref(value.denominator()), &[]);
            (!value.is_zero()).then(|| format!("{{{}, {}}} = {text};", states[i], states[j]))
        };
        places.zip(tensor).filter_map(entry).collect::<Vec<_>>().join(" ")
    }

    /// The claim of an invariant bracket with these entries, if it is proved.
    pub(crate) fn bracket(&self, index: usize, entries: &str) -> Option<String> {
        let text = format!("bracket {} {{ {entries} }}{};", self.name("P", Some(index)), self.condition);
        self.is_proved(&text).then_some(text)
    }

    /// Whether a claim holds that may name earlier claims. These are not proved again.
    pub(crate) fn is_proved_behind(&self, earlier: &[&str], text: &str) -> bool {
        let tokens = lexer::lex(&format!("{} {} {text}", self.equations, earlier.join(" "))).tokens;
        let Ok(mut system) = read_unproved(&tokens).system() else { return false };
        system.claims.drain(..earlier.len());
        matches!(prove_all(&system, seed(&tokens))[..], [Verdict::Proved(_)])
    }

    /// Whether a claim holds.
    pub(crate) fn is_proved(&self, text: &str) -> bool {
        read(&lexer::lex(&format!("{} {text}", self.equations)).tokens).diagnostics().is_empty()
    }
}

fn formula(
    symbols: &Symbols,
    kind: ClaimKind,
    text: String,
    numerator: &Polynomial,
    denominator: &Polynomial,
    factors: Vec<Polynomial>,
) -> Formula {
    let degree = symbols.degree(numerator).max(symbols.degree(denominator));
    Formula { kind, text, degree, numerator: numerator.clone(), denominator: denominator.clone(), factors }
}

/// Without the sign in front of a product: what is conserved is so with the other sign, too.
fn unsigned(value: String) -> String {
    match value.strip_prefix('-') {
        Some(positive) if is_product(&value) => positive.to_owned(),
        _ => value,
    }
}
