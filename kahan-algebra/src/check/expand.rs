//! An expression of an equation, or of a relation behind `when`, to a fraction p/q, p expanded in
//! states and parameters, q free of states.
//!
//! What cancels, cancels: only the result counts, not what it passed through. Sizes are limited, so
//! that no input hangs the compiler.

use crate::diagnostics::{Diagnostic, Kind};
use crate::poly::{Budget, Polynomial};
use crate::rational::Rational;
use crate::syntax::{Expr, ExprKind, Factor, Reference, Term};
use crate::token::Span;

use super::names::{Meaning, Scope};

/// The largest number of terms of an expansion.
pub(super) const MOST_TERMS: usize = 100_000;
/// The largest number of products of terms in one expansion.
pub(super) const MOST_WORK: u64 = 300_000;
/// The largest degree in the states that a power of a sum may have; more does not cancel in
/// earnest, and takes long.
const HIGHEST_DEGREE: u64 = 64;
/// The largest exponent of something that depends on parameters.
const HIGHEST_PARAMETER_POWER: i64 = 64;
/// The largest size of a number, in bits.
pub(super) const MOST_BITS: u64 = 1 << 16;

/// p/q
#[derive(Clone, Debug)]
pub(super) struct Expansion {
    pub(super) numerator: Polynomial,
    /// Not zero; 1, or not constant.
    pub(super) denominator: Polynomial,
}

impl Expansion {
    fn polynomial(numerator: Polynomial) -> Self {
        Expansion { numerator, denominator: Polynomial::one() }
    }

    /// Its value, if it is a number.
    pub(super) fn as_constant(&self) -> Option<Rational> {
        if self.denominator.is_one() { self.numerator.as_constant() } else { None }
    }
}

/// Expands `expr`, whose names all mean something.
pub(super) fn expand(expr: &Expr, scope: &Scope) -> Result<Expansion, Diagnostic> {
    Expander { scope, in_claim: false, budget: Budget::new(MOST_TERMS, MOST_WORK) }.expand(expr)
}

/// The same in a claim, where exponents may be negative.
pub(super) fn expand_in_claim(expr: &Expr, scope: &Scope) -> Result<Expansion, Diagnostic> {
    Expander { scope, in_claim: true, budget: Budget::new(MOST_TERMS, MOST_WORK) }.expand(expr)
}

struct Expander<'a> {
    scope: &'a Scope,
    in_claim: bool,
    budget: Budget,
}

impl Expander<'_> {
    fn named(&self, name: &str) -> Expansion {
        Expansion::polynomial(match self.scope.meaning(name) {
            Some(Meaning::Variable(variable)) => Polynomial::variable(variable),
            Some(Meaning::Constant(value)) => Polynomial::constant(value),
            None => Polynomial::zero(),
        })
    }

    fn expand(&mut self, expr: &Expr) -> Result<Expansion, Diagnostic> {
        match &expr.kind {
            ExprKind::Number(value) => Ok(Expansion::polynomial(Polynomial::constant(value.clone()))),
            ExprKind::Name(name) => Ok(self.named(name)),
            ExprKind::Site { array, offset } => {
                Ok(self.named(&Reference::Site { array, offset: *offset }.to_string()))
            }
            ExprKind::Negation(inner) => {
                self.expand(inner).map(|inner| Expansion { numerator: -&inner.numerator, ..inner })
            }
            ExprKind::Sum(terms) => self.sum(terms, expr.span),
            ExprKind::Product(factors) => self.product(factors),
            ExprKind::Power(base, exponent) => self.power(base, *exponent, expr.span),
            ExprKind::OverSites(_) => Err(sum_out_of_place(expr.span)),
        }
    }

    /// Terms over the same denominator are added in one go, so that long sums cost a sort.
    fn sum(&mut self, terms: &[Term], span: Span) -> Result<Expansion, Diagnostic> {
        let mut groups: Vec<(Polynomial, Vec<Polynomial>)> = Vec::new();
        let mut length = 0;
        for term in terms {
            let Expansion { numerator, denominator } = self.expand(&term.expr)?;
            let numerator = if term.negative { -&numerator } else { numerator };
            length += numerator.len();
            if length > 4 * MOST_TERMS {
                return Err(too_large(span));
            }
            match groups.iter_mut().find(|(known, _)| *known == denominator) {
                Some((_, numerators)) => numerators.push(numerator),
                None => groups.push((denominator, vec![numerator])),
            }
        }
        let mut total = Expansion::polynomial(Polynomial::zero());
        for (denominator, numerators) in groups {
            let terms = numerators.iter().flat_map(Polynomial::terms);
            let numerator =
                Polynomial::from_terms(terms.map(|(monomial, value)| (monomial.clone(), value.clone())));
            if numerator.len() > MOST_TERMS {
                return Err(too_large(span));
            }
            total = if total.numerator.is_zero() {
                Expansion { numerator, denominator }
            } else {
                let left = self.multiply(&total.numerator, &denominator, span)?;
                let right = self.multiply(&numerator, &total.denominator, span)?;
                let denominator = self.multiply(&total.denominator, &denominator, span)?;
                Expansion { numerator: &left + &right, denominator }
            };
        }
        Ok(total)
    }

    fn product(&mut self, factors: &[Factor]) -> Result<Expansion, Diagnostic> {
        let mut product = Expansion::polynomial(Polynomial::one());
        for factor in factors {
            let span = factor.expr.span;
            let mut next = self.expand(&factor.expr)?;
            if factor.divides {
                self.check_divisor(&next.numerator, span)?;
                next = Expansion { numerator: next.denominator, denominator: next.numerator };
            }
            if let Some(divisor) = next.denominator.as_constant() {
                let inverse = divisor.recip().expect("a denominator is not zero");
                next = Expansion::polynomial(next.numerator.scale(&inverse));
            }
            product = Expansion {
                numerator: self.multiply(&product.numerator, &next.numerator, span)?,
                denominator: self.multiply(&product.denominator, &next.denominator, span)?,
            };
        }
        Ok(product)
    }

    /// A divisor is not zero and free of states, also after expansion.
    fn check_divisor(&self, divisor: &Polynomial, span: Span) -> Result<(), Diagnostic> {
        if divisor.is_zero() {
            return Err(Diagnostic::new(
                Kind::ZeroDivisor,
                span,
                "this divisor is zero",
                "correct the divisor, or remove the division",
            ));
        }
        let state = divisor.variables().into_iter().find(|&variable| self.scope.symbols.is_state(variable));
        state.map_or(Ok(()), |state| {
            let state = self.scope.symbols.name(state);
            Err(Diagnostic::new(
                Kind::StateDivisor,
                span,
                format!("this divisor depends on the state `{state}`, and the field must be polynomial in the states"),
                format!("divide by numbers and parameters only, or introduce a new variable for the quotient by `{state}`"),
            ))
        })
    }

    fn power(&mut self, base: &Expr, exponent: i64, span: Span) -> Result<Expansion, Diagnostic> {
        let wrong = |kind, message: String, help: &str| Err(Diagnostic::new(kind, span, message, help));
        if exponent < 0 && self.in_claim {
            let power =
                Expr { kind: ExprKind::Power(Box::new(base.clone()), exponent.saturating_neg()), span };
            return self.product(&[Factor { divides: true, expr: power }]);
        }
        if exponent < 0 {
            return wrong(
                Kind::Exponent,
                format!("the exponent {exponent} is negative"),
                "in an equation write a quotient, `1/(…)`; its divisor must be free of states",
            );
        }
        let base = self.expand(base)?;
        let degree = self.scope.symbols.degree(&base.numerator);
        let is_number = base.as_constant().is_some();
        if degree == 0 && !is_number && exponent > HIGHEST_PARAMETER_POWER {
            return wrong(
                Kind::TooLarge,
                format!("exponents of parameters go to {HIGHEST_PARAMETER_POWER}"),
                "declare the power as a parameter of its own",
            );
        }
        let size = base.numerator.terms().map(|(_, value)| value.bits()).max().unwrap_or(0);
        let is_trivial = base.as_constant().is_some_and(|value| value.is_zero() || value.bits() <= 1);
        if !is_trivial && is_number && size.saturating_mul(exponent.unsigned_abs()) > MOST_BITS {
            return wrong(
                Kind::TooLarge,
                "this number is too large".to_owned(),
                "rescale the variables or the time",
            );
        }
        if is_trivial {
            return Ok(self.trivial_power(&base, exponent));
        }
        let reached = u64::from(degree).saturating_mul(exponent.unsigned_abs());
        if base.numerator.len() > 1 && reached > HIGHEST_DEGREE {
            return Err(too_high(span, "this power", reached));
        }
        let exponent_or_most = u32::try_from(exponent).unwrap_or(u32::MAX);
        let power =
            |polynomial: &Polynomial, budget: &mut Budget| polynomial.pow_within(exponent_or_most, budget);
        match (power(&base.numerator, &mut self.budget), power(&base.denominator, &mut self.budget)) {
            (Ok(numerator), Ok(denominator)) => Ok(Expansion { numerator, denominator }),
            _ if degree > 0 => Err(too_high(span, "this power", reached)),
            _ => Err(too_large(span)),
        }
    }

    /// 0, 1 or −1 to any power; 0^0 is 1.
    fn trivial_power(&self, base: &Expansion, exponent: i64) -> Expansion {
        let value = base.as_constant().expect("the base is 0, 1 or −1");
        let one = exponent == 0 || (value.is_negative() && exponent % 2 == 0);
        Expansion::polynomial(Polynomial::constant(if one { Rational::one() } else { value }))
    }

    fn multiply(&mut self, a: &Polynomial, b: &Polynomial, span: Span) -> Result<Polynomial, Diagnostic> {
        if a.is_one() {
            return Ok(b.clone());
        }
        if b.is_one() {
            return Ok(a.clone());
        }
        a.mul_within(b, &mut self.budget).map_err(|_| too_large(span))
    }
}

/// The mistake of a sum over sites where there are none to sum over.
pub(super) fn sum_out_of_place(span: Span) -> Diagnostic {
    Diagnostic::new(
        Kind::Claim,
        span,
        "`sum(…)` runs over all sites, and stands in the claims of a family",
        "in an equation write the neighbours out, as in `x[i-1] + x[i+1]`",
    )
}

/// The mistake of a term of degree `degree` > 2.
pub(super) fn too_high(span: Span, term: &str, degree: u64) -> Diagnostic {
    Diagnostic::new(
        Kind::Degree,
        span,
        format!("{term} has degree {degree} in the states, and Kahan's method needs a quadratic field"),
        "lower the degree with a new variable, for example `w` for `x^2` with its own equation",
    )
}

/// The mistake of an expansion beyond the limits.
pub(super) fn too_large(span: Span) -> Diagnostic {
    Diagnostic::new(
        Kind::TooLarge,
        span,
        format!("the expansion has more than {MOST_TERMS} terms"),
        "write the field in fewer terms",
    )
}
