//! Writes formulas as claims in the language of `kahan!`, and proves them.
//!
//! A formula becomes a claim if the prover accepts its text. It also does if a theorem proves it
//! and the text equals it up to sign. All other formulas are dropped.

use std::slice::from_ref;

use kahan_algebra::arithmetic::{Arithmetic, Functions};
use kahan_algebra::check::claims_of;
use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::prove::check_claims;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::equation_lines;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_algebra::token::Token;
use kahan_algebra::{lexer, seed};

use crate::claims::writing::{is_product, quotient, state_factors};
use crate::poisson::brackets::Bracket;

const MOST_TERMS: usize = 100_000;
const MOST_WORK: u64 = 10_000_000;

const DENSITY_NAME: &str = "rho";

/// A proved claim.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The claim in the language of `kahan!`, for example `integral H1 = …;`.
    pub text: String,
    /// The claim as read from the text.
    pub claim: Claim,
    /// The larger of the degrees of numerator and denominator, as polynomials in the states.
    pub degree: u32,
    /// The numerator.
    pub numerator: Polynomial,
    /// The denominator.
    pub denominator: Polynomial,
    /// The irreducible factors of an integral that depend on states. For a density the list is
    /// empty.
    pub factors: Vec<Polynomial>,
}

impl Formula {
    /// Returns the claim's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.claim.name.text
    }
}

/// A writer and prover of claims about one field. Parameters of the field and ε may be fixed.
#[derive(Clone, Debug)]
pub struct Claims<'a> {
    system: &'a System,
    bare: System,
    /// The equations of the field. Proofs choose random points from a seed made of these tokens.
    equations: Vec<Token>,
    /// The text of the fixed values, for example ` when a = 1, eps = 1/2`.
    pub(crate) condition: String,
}

impl<'a> Claims<'a> {
    /// Prepares claims about the field of `system` at fixed parameters and ε (half the time step).
    #[must_use]
    pub fn new(system: &'a System, parameters: &[(String, Rational)], eps: Option<&Rational>) -> Self {
        let field = &system.field;
        let symbols = &field.symbols;
        let equations = equation_lines(field).collect::<Vec<_>>().join(" ");
        let occurs = |name: &str| {
            symbols
                .named(name)
                .is_some_and(|variable| field.components.iter().any(|component| component.contains(variable)))
        };
        let mut conditions: Vec<String> = parameters
            .iter()
            .filter(|(name, _)| occurs(name))
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        conditions.extend(eps.map(|value| format!("eps = {value}")));
        let condition =
            if conditions.is_empty() { String::new() } else { format!(" when {}", conditions.join(", ")) };
        let bare = System { claims: Vec::new(), ..system.clone() };
        Claims { system, bare, equations: lexer::lex(&equations).tokens, condition }
    }

    /// Returns the name of the system's own density if a found density must replace it: a block may
    /// hold only one density without `when`. Returns `None` if values are fixed, because found
    /// claims then have a `when` clause.
    #[must_use]
    pub fn own_density(&self) -> Option<&str> {
        let own = self.system.accessors(ClaimKind::Density).next()?;
        self.condition.is_empty().then_some(own.name.text.as_str())
    }

    /// Returns an unused name that begins with `stem` and `index`. The name of a density that will
    /// be [replaced](Self::own_density) may be used again.
    pub(crate) fn name(&self, stem: &str, index: Option<usize>) -> String {
        let mut name = match index {
            Some(index) => format!("{stem}{index}"),
            None => stem.to_owned(),
        };
        let symbols = &self.system.field.symbols;
        let is_taken = |name: &String| {
            symbols.states.contains(name)
                || symbols.parameters.contains(name)
                || name == "eps"
                || self.system.constants.iter().any(|(known, _)| known == name)
                || self.system.claims.iter().any(|claim| claim.name.text == *name)
                    && !(stem == DENSITY_NAME && self.own_density() == Some(name.as_str()))
        };
        while is_taken(&name) {
            name.push('_');
        }
        name
    }

    /// Writes the integral numerator/denominator with the name H`index`, and proves it. Returns
    /// `None` if the proof fails. A long factor is written in powers of one of the polynomials `by`
    /// if its text becomes shorter.
    #[must_use]
    pub fn integral(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
        by: &[Polynomial],
    ) -> Option<Formula> {
        let text = self.written(symbols, index, numerator, denominator, by);
        let claim = self.proved(&[], &text)?;
        Some(formula(symbols, text, claim, numerator, denominator))
    }

    /// Writes the integral numerator/denominator, without a proof, for functions that are integrals
    /// by a theorem. Returns `None` if the written text does not equal numerator/denominator.
    pub(crate) fn integral_by_theorem(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Option<Formula> {
        let text = self.written(symbols, index, numerator, denominator, &[]);
        let claim = claims_of(self.system, &lexer::lex(&text).tokens).ok()?.pop()?;
        let value = |variable: Variable| {
            let own = symbols.named(&self.system.field.symbols.name(variable));
            own.map(|own| Polynomial::variable(own).into())
        };
        let functions = Functions::new(Budget::new(MOST_TERMS, MOST_WORK));
        let stated = claim.plan.evaluate(&functions, |input| input.variable().map(value)).pop()??;
        let [above, below] = [numerator, denominator].map(|side| Some(side.clone().into()));
        let meant = functions.divide(&above, &below)?;
        let is_stated = [functions.subtract(&stated, &meant), functions.add(&stated, &meant)]
            .iter()
            .any(|difference| functions.is_zero(difference));
        is_stated.then(|| formula(symbols, text, claim, numerator, denominator))
    }

    fn written(
        &self,
        symbols: &Symbols,
        index: usize,
        numerator: &Polynomial,
        denominator: &Polynomial,
        by: &[Polynomial],
    ) -> String {
        let value = unsigned(quotient(symbols, from_ref(numerator), from_ref(denominator), by));
        format!("integral {} = {value}{};", self.name("H", Some(index)), self.condition)
    }

    /// Writes the invariant density ∏ factorᵏ, and proves it. Returns `None` if the proof fails. A
    /// long factor is written in powers of one of the polynomials `by` if the text becomes shorter.
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
        let text = format!("density {} = {value}{};", self.name(DENSITY_NAME, index), self.condition);
        let product =
            |side: &[Polynomial]| side.iter().fold(Polynomial::one(), |product, factor| &product * factor);
        let claim = self.proved(&[], &text)?;
        Some(formula(symbols, text, claim, &product(&above), &product(&below)))
    }

    /// Writes the entries of a bracket. `tensor` has the entries above the diagonal, row by row.
    pub(crate) fn bracket_entries(&self, symbols: &Symbols, tensor: &[RationalFunction]) -> String {
        let states = &symbols.states;
        let places = (0..states.len()).flat_map(|i| (i + 1..states.len()).map(move |j| (i, j)));
        let entry = |((i, j), value): ((usize, usize), &RationalFunction)| {
            let text = quotient(symbols, from_ref(value.numerator()), from_ref(value.denominator()), &[]);
            (!value.is_zero()).then(|| format!("{{{}, {}}} = {text};", states[i], states[j]))
        };
        places.zip(tensor).filter_map(entry).collect::<Vec<_>>().join(" ")
    }

    pub(crate) fn bracket(&self, index: usize, rank: usize, entries: &str) -> Option<Bracket> {
        let text = format!("bracket {} {{ {entries} }}{};", self.name("P", Some(index)), self.condition);
        let claim = self.proved(&[], &text)?;
        Some(Bracket { text, claim, rank })
    }

    /// Reads a claim that may refer to `earlier` claims, and returns it if it is proved.
    pub(crate) fn proved(&self, earlier: &[&str], text: &str) -> Option<Claim> {
        let tokens = lexer::lex(&format!("{} {text}", earlier.join(" "))).tokens;
        let claims = claims_of(self.system, &tokens).ok()?;
        let mut system = System { claims, ..self.bare.clone() };
        system.claims.drain(..earlier.len());
        let mut diagnostics = Diagnostics::default();
        check_claims(&system, seed(&[&self.equations[..], &tokens].concat()), &mut diagnostics);
        if diagnostics.finish().is_empty() { system.claims.pop() } else { None }
    }
}

fn formula(
    symbols: &Symbols,
    text: String,
    claim: Claim,
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Formula {
    let sides = if claim.kind == ClaimKind::Integral { &[numerator, denominator][..] } else { &[] };
    Formula {
        degree: symbols.degree(numerator).max(symbols.degree(denominator)),
        factors: sides.iter().flat_map(|side| state_factors(symbols, side)).collect(),
        numerator: numerator.clone(),
        denominator: denominator.clone(),
        text,
        claim,
    }
}

fn unsigned(value: String) -> String {
    match value.strip_prefix('-') {
        Some(positive) if is_product(&value) => positive.to_owned(),
        _ => value,
    }
}
