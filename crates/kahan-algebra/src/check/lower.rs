//! Lowers expressions to fractions or plans.
//!
//! Equations, constants, relations and the sums of families become fractions
//! ([`expand`](super::expand)). Other claims become plans ([`claims`](super::claims)). [`lower`]
//! reports zero divisors, invalid negative exponents and misplaced `sum(…)`.

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Expr, ExprKind, FamilySyntax, Reference};
use kahan_syntax::token::Span;

use crate::render::{Notation, Text};

/// The largest exponent of a parameter in an equation, and of a power in a claim. The power of a
/// number may have a larger exponent if its value has at most `MOST_BITS` bits.
pub(super) const HIGHEST_EXPONENT: i64 = 64;
pub(super) const MOST_BITS: u64 = 1 << 16;

/// A representation into which expressions are lowered.
pub(super) trait LoweringTarget {
    type Value;

    fn number(&mut self, value: &Rational) -> Self::Value;
    fn named(&mut self, reference: Reference<'_>, span: Span) -> Result<Self::Value, Diagnostic>;
    fn negate(&mut self, a: Self::Value) -> Self::Value;
    /// Returns the sum of all terms. Terms with the flag `true` are subtracted.
    fn sum(&mut self, terms: Vec<(bool, Self::Value)>, span: Span) -> Result<Self::Value, Diagnostic>;
    fn multiply(&mut self, a: Self::Value, b: Self::Value, span: Span) -> Result<Self::Value, Diagnostic>;
    fn divide(&mut self, a: Self::Value, b: Self::Value, span: Span) -> Result<Self::Value, Diagnostic>;
    fn power(&mut self, a: Self::Value, exponent: u64, span: Span) -> Result<Self::Value, Diagnostic>;
    fn is_zero(&self, a: &Self::Value) -> bool;
    /// Returns whether expressions may contain negative exponents.
    fn allows_negative_exponents(&self) -> bool;
}

pub(super) fn lower<T: LoweringTarget>(expr: &Expr, target: &mut T) -> Result<T::Value, Diagnostic> {
    match &expr.kind {
        ExprKind::Number(value) => Ok(target.number(value)),
        ExprKind::Name(name) => target.named(Reference::Name(name), expr.span),
        ExprKind::Special(FamilySyntax::Site { array, offset }) => {
            target.named(Reference::Site { array, offset: *offset }, expr.span)
        }
        ExprKind::Negation(inner) => {
            let inner = lower(inner, target)?;
            Ok(target.negate(inner))
        }
        ExprKind::Sum(terms) => {
            let mut lowered = Vec::with_capacity(terms.len());
            for term in terms {
                lowered.push((term.negative, lower(&term.expr, target)?));
            }
            target.sum(lowered, expr.span)
        }
        ExprKind::Product(factors) => {
            let mut product = target.number(&Rational::one());
            for factor in factors {
                let span = factor.expr.span;
                let next = lower(&factor.expr, target)?;
                product = match factor.divides {
                    true => divide(target, product, next, span)?,
                    false => target.multiply(product, next, span)?,
                };
            }
            Ok(product)
        }
        ExprKind::Power(base, exponent) => {
            let lowered = lower(base, target)?;
            let power = target.power(lowered, exponent.unsigned_abs(), expr.span)?;
            if *exponent >= 0 {
                return Ok(power);
            }
            let one = target.number(&Rational::one());
            let inverse = divide(target, one, power, base.span)?;
            if target.allows_negative_exponents() {
                return Ok(inverse);
            }
            let base = if let ExprKind::Name(name) = &base.kind { name } else { "(…)" };
            let shown = Text.power(base, exponent.saturating_neg());
            let message = format!("the exponent {exponent} is negative");
            let help = format!("in an equation write a quotient, `1/{shown}`");
            Err(Diagnostic::new(Kind::Exponent, expr.span, message, help))
        }
        ExprKind::Special(FamilySyntax::OverSites(_)) => Err(sum_out_of_place(expr.span)),
    }
}

fn divide<T: LoweringTarget>(
    target: &mut T,
    dividend: T::Value,
    divisor: T::Value,
    span: Span,
) -> Result<T::Value, Diagnostic> {
    if target.is_zero(&divisor) {
        let message = "this divisor is zero";
        let help = "correct the divisor, or remove the division";
        return Err(Diagnostic::new(Kind::ZeroDivisor, span, message, help));
    }
    target.divide(dividend, divisor, span)
}

fn sum_out_of_place(span: Span) -> Diagnostic {
    let message = "`sum(…)` runs over all sites, and stands in the claims of a family";
    let help = "in an equation write the neighbours out, as in `x[i-1] + x[i+1]`";
    Diagnostic::new(Kind::Claim, span, message, help)
}
