//! Expands equations, constants, relations and the sums of families to fractions p/q.
//!
//! The numerator p is a polynomial in states, parameters and ε, and q contains no state. Limits on
//! sizes bound compile times. The caller checks the degree of the result.
//!
//! The [expression as written](crate::subexpressions) is stored beside p/q. It is dropped if
//! cancellation in p/q lowers the degree, or removes a variable or a divisor.

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::spelling::{LIFTS, NOT_QUADRATIC};
use kahan_syntax::syntax::{Expr, Reference};
use kahan_syntax::token::Span;

use crate::poly::{Budget, Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::subexpressions::Subexpressions;
use crate::symbols::Symbols;

use super::lower::{HIGHEST_EXPONENT, LoweringTarget, MOST_BITS, lower};
use super::names::{NameMeaning, Scope};

const MOST_TERMS: usize = 100_000;
const MOST_WORK: u64 = 300_000;
const MOST_WORK_OF_BLOCK: u64 = 2_000_000;
/// The order of the terms is stored only for sums of at most this many terms.
const MOST_IN_ORDER: usize = 64;
/// Powers of sums are expanded only up to this degree in the states.
const HIGHEST_DEGREE: u64 = 64;

/// A fraction p/q, in expanded form and as written.
#[derive(Clone, Debug)]
pub(super) struct Expansion {
    pub(super) numerator: Polynomial,
    /// The denominator q. A constant denominator is 1.
    pub(super) denominator: Polynomial,
    /// The fraction as written, with sums and divisors as named subexpressions. `None` if it is
    /// just `numerator`.
    kept: Option<Polynomial>,
    /// The terms of a sum in order of addition, if the sum has 3 to 64 terms.
    order: Vec<Polynomial>,
}

impl Expansion {
    fn polynomial(numerator: Polynomial) -> Self {
        Expansion { numerator, denominator: Polynomial::one(), kept: None, order: Vec::new() }
    }

    pub(super) fn as_constant(&self) -> Option<Rational> {
        if self.denominator.is_one() { self.numerator.as_constant() } else { None }
    }

    pub(super) fn zero() -> Self {
        Expansion::polynomial(Polynomial::zero())
    }

    pub(super) fn function(self) -> RationalFunction {
        RationalFunction::from_coprime(self.numerator, self.denominator)
    }

    pub(super) fn written_form(&self) -> &Polynomial {
        self.kept.as_ref().unwrap_or(&self.numerator)
    }
}

/// Expands an expression, and adds its sums and divisors to `values` as named subexpressions.
pub(super) fn expand(
    expr: &Expr,
    scope: &Scope,
    values: &mut Subexpressions,
) -> Result<Expansion, Diagnostic> {
    let (inverts, reduces) = (false, true);
    FractionExpander { scope, inverts, reduces, values, budget: budget(scope) }.expanded(expr)
}

pub(super) fn expand_unkept(expr: &Expr, scope: &Scope) -> Result<Expansion, Diagnostic> {
    expand(expr, scope, &mut Subexpressions::of(&scope.symbols))
}

/// Expands one side of a relation. Divisors are not cancelled, because the relation holds only
/// where divisors are nonzero.
pub(super) fn expand_as_written(expr: &Expr, scope: &Scope) -> Result<Expansion, Diagnostic> {
    let (inverts, reduces, values) = (true, false, &mut Subexpressions::of(&scope.symbols));
    FractionExpander { scope, inverts, reduces, values, budget: budget(scope) }.expanded(expr)
}

/// Expands an expression of a claim to lowest terms.
pub(super) fn expand_in_claim(expr: &Expr, scope: &Scope) -> Result<Expansion, Diagnostic> {
    let (inverts, reduces, values) = (true, true, &mut Subexpressions::of(&scope.symbols));
    FractionExpander { scope, inverts, reduces, values, budget: budget(scope) }.expanded(expr)
}

fn budget(scope: &Scope) -> Budget {
    Budget::new(MOST_TERMS, MOST_WORK.min(MOST_WORK_OF_BLOCK.saturating_sub(scope.products.get())))
}

pub(super) fn is_spent(scope: &Scope) -> bool {
    scope.products.get() >= MOST_WORK_OF_BLOCK
}

struct FractionExpander<'a> {
    scope: &'a Scope,
    inverts: bool,
    reduces: bool,
    values: &'a mut Subexpressions,
    budget: Budget,
}

impl LoweringTarget for FractionExpander<'_> {
    type Value = Expansion;

    fn number(&mut self, value: &Rational) -> Expansion {
        Expansion::polynomial(Polynomial::constant(value.clone()))
    }

    fn named(&mut self, reference: Reference<'_>, _: Span) -> Result<Expansion, Diagnostic> {
        Ok(Expansion::polynomial(match self.scope.meaning(&reference.key()) {
            Some(NameMeaning::Variable(variable)) => Polynomial::variable(variable),
            Some(NameMeaning::Constant(value)) => Polynomial::constant(value),
            None => Polynomial::zero(),
        }))
    }

    fn negate(&mut self, a: Expansion) -> Expansion {
        let kept = a.kept.as_ref().map(|kept| -kept);
        let order = a.order.iter().map(|term| -term).collect();
        Expansion { numerator: -&a.numerator, denominator: a.denominator, kept, order }
    }

    fn sum(&mut self, terms: Vec<(bool, Expansion)>, span: Span) -> Result<Expansion, Diagnostic> {
        if terms.iter().map(|(_, term)| term.numerator.len()).sum::<usize>() > 4 * MOST_TERMS {
            return Err(too_large(span));
        }
        let (kept, order) = self.kept_sum(&terms, span)?;
        let extents = kept.iter().flat_map(|_| terms.iter().map(|(_, term)| self.extent(term)));
        let extents: Vec<(Vec<Variable>, u32)> = extents.collect();
        let mut groups: Vec<(Polynomial, Vec<(bool, Polynomial)>)> = Vec::new();
        for (negative, Expansion { numerator, denominator, .. }) in terms {
            match groups.iter_mut().find(|(known, _)| *known == denominator) {
                Some((_, numerators)) => numerators.push((negative, numerator)),
                None => groups.push((denominator, vec![(negative, numerator)])),
            }
        }
        let mut total: Option<(Polynomial, Polynomial)> = None;
        for (denominator, numerators) in groups {
            let numerator = self.sum_of(&numerators, span)?;
            total = Some(match total {
                None => (numerator, denominator),
                Some((above, below)) => {
                    let left = self.product(&above, &denominator, span)?;
                    let right = self.product(&numerator, &below, span)?;
                    (&left + &right, self.product(&below, &denominator, span)?)
                }
            });
        }
        let (numerator, denominator) = total.unwrap_or_else(|| (Polynomial::zero(), Polynomial::one()));
        let sum = self.reduced(Expansion { numerator, denominator, kept, order }, span)?;
        let (left, reached) = self.extent(&sum);
        let still_has = |(variables, degree): (Vec<Variable>, u32)| {
            degree <= reached && variables.iter().all(|variable| left.contains(variable))
        };
        Ok(if extents.into_iter().all(still_has) { sum } else { self.without_kept(sum) })
    }

    fn multiply(&mut self, a: Expansion, b: Expansion, span: Span) -> Result<Expansion, Diagnostic> {
        if a.as_constant().is_some_and(|value| value.is_one()) {
            return Ok(b);
        }
        let kept = self.kept_product(&a, &b);
        let numerator = self.product(&a.numerator, &b.numerator, span)?;
        let denominator = match a.denominator.is_one() {
            true => b.denominator,
            false => self.product(&a.denominator, &b.denominator, span)?,
        };
        self.reduced(Expansion { numerator, denominator, kept, order: Vec::new() }, span)
    }

    fn divide(&mut self, a: Expansion, b: Expansion, span: Span) -> Result<Expansion, Diagnostic> {
        let Expansion { numerator, denominator, .. } = &b;
        let variables = numerator.variables();
        if let Some(state) = variables.into_iter().find(|&variable| self.scope.symbols.is_state(variable)) {
            return Err(state_divisor(self.scope, state, &b, span));
        }
        let inverse = match numerator.as_constant() {
            Some(divisor) => {
                let scale = divisor.recip().expect("a divisor is not zero");
                Expansion::polynomial(denominator.scale(&scale))
            }
            None => {
                Expansion { denominator: numerator.clone(), ..Expansion::polynomial(denominator.clone()) }
            }
        };
        let is_single = inverse.denominator.is_one() || !denominator.is_one();
        let kept = if is_single {
            None
        } else {
            let (a, b) = (self.factor(&a), self.factor(&b));
            self.values.quotient(&a, &b)
        };
        let numerator = self.product(&a.numerator, &inverse.numerator, span)?;
        let inverse = self.without_kept(inverse);
        let kept = kept.or_else(|| self.kept_product(&a, &inverse));
        let denominator = self.product(&a.denominator, &inverse.denominator, span)?;
        self.reduced(Expansion { numerator, denominator, kept, order: Vec::new() }, span)
    }

    fn power(&mut self, base: Expansion, exponent: u64, span: Span) -> Result<Expansion, Diagnostic> {
        let degree = self.scope.symbols.degree(&base.numerator);
        let number = base.as_constant();
        if degree == 0 && number.is_none() && exponent > HIGHEST_EXPONENT.unsigned_abs() {
            return Err(exponent_too_high(span, ""));
        }
        if let Some(value) = number {
            if value.is_zero() || value.bits() <= 1 {
                // All powers of 0, 1 and −1 are written without multiplication. The power 0^0 is 1.
                let one = exponent == 0 || (value.is_negative() && exponent.is_multiple_of(2));
                return Ok(self.number(&if one { Rational::one() } else { value }));
            }
            if value.bits().saturating_mul(exponent) > MOST_BITS {
                let message = "this number is too large";
                let help = "rescale the variables or the time";
                return Err(Diagnostic::new(Kind::TooLarge, span, message, help));
            }
            let exponent = i32::try_from(exponent).expect("it is no more than the bits");
            return Ok(self.number(&value.pow(exponent).expect("the exponent is not negative")));
        }
        let reached = u64::from(degree).saturating_mul(exponent);
        if base.numerator.len() > 1 && reached > HIGHEST_DEGREE {
            return Err(self.power_too_high(&base, span, reached));
        }
        let exponent = u32::try_from(exponent).unwrap_or(u32::MAX);
        let power = |polynomial: &Polynomial, budget: &mut Budget| polynomial.pow_within(exponent, budget);
        let powers = (power(&base.numerator, &mut self.budget), power(&base.denominator, &mut self.budget));
        let (Ok(numerator), Ok(denominator)) = powers else {
            let mistake =
                if reached > 2 { self.power_too_high(&base, span, reached) } else { too_large(span) };
            return Err(mistake);
        };
        let kept = match exponent {
            0 => None,
            1 => return Ok(base),
            _ if base.kept.is_none() && base.numerator.len() < 2 => None,
            _ => power(&self.factor(&base), &mut self.budget).ok(),
        };
        Ok(Expansion { numerator, denominator, kept, order: Vec::new() })
    }

    fn is_zero(&self, a: &Expansion) -> bool {
        a.numerator.is_zero()
    }

    fn allows_negative_exponents(&self) -> bool {
        self.inverts
    }
}

impl FractionExpander<'_> {
    fn expanded(mut self, expr: &Expr) -> Result<Expansion, Diagnostic> {
        let before = self.budget.work_left();
        let expansion = lower(expr, &mut self);
        self.scope.products.set(self.scope.products.get() + before - self.budget.work_left());
        if is_spent(self.scope) {
            return Err(block_too_large(expr.span));
        }
        let expansion = expansion?;
        match highest_power(&expansion, &self.scope.symbols) {
            Some((parameter, exponent)) if i64::from(exponent) > HIGHEST_EXPONENT => {
                let power = Text.power(&self.scope.symbols.name(parameter), exponent.into());
                Err(exponent_too_high(expr.span, &format!(", and this holds `{power}`")))
            }
            _ => Ok(expansion),
        }
    }

    fn sum_of(&mut self, terms: &[(bool, Polynomial)], span: Span) -> Result<Polynomial, Diagnostic> {
        let terms = terms.iter().map(|(negative, of)| (*negative, of));
        Polynomial::sum_within(terms, &mut self.budget).map_err(|_| too_large(span))
    }

    fn power_too_high(&self, base: &Expansion, span: Span, degree: u64) -> Diagnostic {
        let symbols = &self.scope.symbols;
        let state = base.numerator.variables().into_iter().find(|&variable| symbols.is_state(variable));
        let name = symbols.name(state.expect("a degree in the states is that of a state"));
        too_high(self.scope, span, "this power", &Text.power(&name, 2), degree)
    }

    fn product(&mut self, a: &Polynomial, b: &Polynomial, span: Span) -> Result<Polynomial, Diagnostic> {
        if a.is_one() {
            return Ok(b.clone());
        }
        if b.is_one() {
            return Ok(a.clone());
        }
        a.mul_within(b, &mut self.budget).map_err(|_| too_large(span))
    }

    /// Returns the sum of the terms as written, and the terms in order of addition. The first
    /// result is `None` if the written sum does not differ from the expanded one.
    fn kept_sum(
        &mut self,
        terms: &[(bool, Expansion)],
        span: Span,
    ) -> Result<(Option<Polynomial>, Vec<Polynomial>), Diagnostic> {
        let is_whole = |(_, term): &(bool, Expansion)| term.kept.is_none() && term.written_form().len() < 2;
        let is_plain = terms.len() < 2 || terms.iter().all(is_whole);
        if is_plain && terms.len() > MOST_IN_ORDER {
            return Ok((None, Vec::new()));
        }
        let mut written: Vec<(bool, Polynomial)> = Vec::with_capacity(terms.len());
        for (negative, term) in terms {
            let factor = if terms.len() < 2 { term.written_form().clone() } else { self.factor(term) };
            written.push((false, if *negative { -&factor } else { factor }));
        }
        let is_kept = !is_plain || terms.iter().any(|(_, term)| term.kept.is_some());
        let kept = if is_kept { Some(self.sum_of(&written, span)?) } else { None };
        let has_order = (3..=MOST_IN_ORDER).contains(&written.len());
        let order = if has_order { written } else { Vec::new() };
        Ok((kept, order.into_iter().map(|(_, term)| term).collect()))
    }

    /// Returns the fraction `of` as written, for use as a factor. A sum becomes a named
    /// subexpression.
    fn factor(&mut self, of: &Expansion) -> Polynomial {
        let Some((first, others)) = of.order.split_first() else {
            return self.values.factor(of.written_form());
        };
        others.iter().fold(first.clone(), |sum, term| self.values.factor(&(&sum + term)))
    }

    fn kept_product(&mut self, a: &Expansion, b: &Expansion) -> Option<Polynomial> {
        let is_sign = |value: Rational| (&value * &value).is_one();
        let is_single = |of: &Expansion| of.kept.is_none() && of.numerator.len() < 2;
        if is_single(a) && is_single(b) {
            return None;
        }
        if let Some(sign) = a.as_constant().filter(|value| is_sign(value.clone())) {
            return b.kept.as_ref().map(|kept| kept.scale(&sign));
        }
        if let Some(sign) = b.as_constant().filter(|value| is_sign(value.clone())) {
            return a.kept.as_ref().map(|kept| kept.scale(&sign));
        }
        Some(&self.factor(a) * &self.factor(b))
    }

    fn extent(&self, of: &Expansion) -> (Vec<Variable>, u32) {
        let variables = [of.numerator.variables(), of.denominator.variables()].concat();
        (variables, self.scope.symbols.degree(&of.numerator))
    }

    /// Reduces p/q to lowest terms. The form as written is dropped if one of its divisors cancels.
    fn reduced(&mut self, expansion: Expansion, span: Span) -> Result<Expansion, Diagnostic> {
        if expansion.denominator.is_one() || !self.reduces {
            return Ok(expansion);
        }
        let Expansion { numerator, denominator, kept, order } = expansion;
        match RationalFunction::new_within(numerator, denominator, &mut self.budget) {
            Ok(Some(function)) => {
                let (numerator, denominator) = (function.numerator().clone(), function.denominator().clone());
                let kept = kept.filter(|kept| self.values.divide_only_by(kept, &denominator));
                let reduced = Expansion { numerator, denominator, kept, order };
                Ok(if reduced.kept.is_some() { reduced } else { self.without_kept(reduced) })
            }
            Ok(None) | Err(_) => Err(too_large(span)),
        }
    }

    fn without_kept(&mut self, expansion: Expansion) -> Expansion {
        if expansion.denominator.is_one() {
            return Expansion { kept: None, order: Vec::new(), ..expansion };
        }
        let kept = self.values.reciprocal(&expansion.denominator);
        let kept = kept.map(|reciprocal| &expansion.numerator * &reciprocal);
        Expansion { kept, order: Vec::new(), ..expansion }
    }
}

/// Returns the diagnostic of a term with a degree above 2. The text `product` is a product of two
/// states in the term.
pub(super) fn too_high(scope: &Scope, span: Span, term: &str, product: &str, degree: u64) -> Diagnostic {
    let new = scope.new_variable();
    let message =
        format!("{term} has degree {degree} in the states, and Kahan's method needs a quadratic field");
    let help = instead_of(&new, &format!("`{product}`"));
    Diagnostic::new(Kind::Degree, span, message, help)
}

/// Returns a hint to introduce a variable for a function that is not quadratic.
fn instead_of(new: &str, function: &str) -> String {
    let by = if new.contains('[') { "introduce a new variable" } else { LIFTS };
    let such_as = if new.contains('[') { "" } else { ", for example with" };
    format!("{by}{such_as} `{new}` for {function}: {NOT_QUADRATIC} shows how")
}

fn state_divisor(scope: &Scope, state: Variable, divisor: &Expansion, span: Span) -> Diagnostic {
    const MOST: usize = 4;

    let name = scope.symbols.name(state);
    let Expansion { numerator, denominator, .. } = divisor;
    let quotient = if denominator.is_one() && numerator.len() <= MOST {
        let divisor = Text.polynomial(&scope.symbols, numerator);
        if divisor == name { format!("`1/{divisor}`") } else { format!("`1/({divisor})`") }
    } else {
        "the quotient".to_owned()
    };
    let new = scope.new_variable();
    let message =
        format!("this divisor depends on the state `{name}`, and the field must be polynomial in the states");
    let help = instead_of(&new, &quotient);
    Diagnostic::new(Kind::StateDivisor, span, message, help)
}

fn too_large(span: Span) -> Diagnostic {
    let message = format!(
        "the expansion has more than {MOST_TERMS} terms, or takes more than {MOST_WORK} products of terms"
    );
    let help = "write the field in fewer terms, with shorter numbers";
    Diagnostic::new(Kind::TooLarge, span, message, help)
}

fn highest_power(expansion: &Expansion, symbols: &Symbols) -> Option<(Variable, u32)> {
    let terms = expansion.numerator.terms().chain(expansion.denominator.terms());
    let powers = terms.flat_map(|(monomial, _)| monomial.powers().iter().copied());
    powers.filter(|(variable, _)| !symbols.is_state(*variable)).max_by_key(|(_, exponent)| *exponent)
}

fn exponent_too_high(span: Span, place: &str) -> Diagnostic {
    let message = format!("exponents of parameters go to {HIGHEST_EXPONENT}{place}");
    let help = "declare the power as a parameter of its own";
    Diagnostic::new(Kind::TooLarge, span, message, help)
}

fn block_too_large(span: Span) -> Diagnostic {
    let message = format!(
        "the expressions of this block take more than {MOST_WORK_OF_BLOCK} products of terms to expand"
    );
    let help =
        "give powers and products of long sums names of their own: parameters, or states with an equation";
    Diagnostic::new(Kind::TooLarge, span, message, help)
}
