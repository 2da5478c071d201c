//! Expands equations exactly and checks that their degree in the states is at most 2.

use rustc_hash::FxHashSet;

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Block, Expr, ExprKind};
use kahan_syntax::token::Span;

use crate::poly::Monomial;
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::subexpressions::{FieldWithSubexpressions, Subexpressions};

use super::expand::{Expansion, expand, expand_unkept, is_spent, too_high};
use super::names::{Scope, is_epsilon};

/// Expands every equation. An equation with a mistake becomes zero.
pub(super) fn expand_all(
    block: &Block,
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> (Vec<RationalFunction>, FieldWithSubexpressions) {
    let mut values = Subexpressions::of(&scope.symbols);
    let (mut components, mut kept) = (Vec::new(), Vec::new());
    let mut seen: FxHashSet<&str> = FxHashSet::default();
    for equation in &block.equations {
        let sound = equation.value.as_ref().filter(|value| scope.resolve(value, false, diagnostics));
        if !seen.insert(&equation.state.text) {
            continue;
        }
        let expansion = sound.filter(|_| !is_spent(scope)).and_then(|value| {
            let expansion = expand(value, scope, &mut values);
            let expansion = expansion.and_then(|expansion| check_degree(value, expansion, scope));
            let expansion = expansion.and_then(|expansion| {
                check_eps(value, &expansion, block.family.is_some(), scope).map(|()| expansion)
            });
            expansion.map_err(|diagnostic| diagnostics.push(diagnostic)).ok()
        });
        let expansion = expansion.unwrap_or_else(Expansion::zero);
        kept.push(expansion.written_form().clone());
        components.push(expansion.function());
    }
    (components, FieldWithSubexpressions::new(values, kept))
}

fn check_degree(value: &Expr, expansion: Expansion, scope: &Scope) -> Result<Expansion, Diagnostic> {
    let degree = |monomial: &Monomial| monomial.degree_where(|variable| scope.symbols.is_state(variable));
    let monomials = expansion.numerator.terms().map(|(monomial, _)| (degree(monomial), monomial));
    match monomials.max_by_key(|(degree, _)| *degree) {
        Some((highest @ 3.., monomial)) => {
            let (term, product) = describe(monomial, scope);
            Err(too_high(scope, raising_factor(value, scope), &term, &product, highest.into()))
        }
        _ => Ok(expansion),
    }
}

/// Reports coefficients that contain odd powers of ε or are undefined at ε = 0. In a family,
/// reports every coefficient that contains ε.
fn check_eps(value: &Expr, expansion: &Expansion, in_family: bool, scope: &Scope) -> Result<(), Diagnostic> {
    let eps = scope.symbols.epsilon();
    let Expansion { numerator, denominator, .. } = expansion;
    let (message, help) = if !numerator.contains(eps) && !denominator.contains(eps) {
        return Ok(());
    } else if in_family {
        (
            "the coefficients of a family are free of `eps`",
            "write the equations of each site, or declare a parameter for the coefficient",
        )
    } else if has_odd_powers(expansion, scope) {
        (
            "`eps` stands in odd powers: the map would not be reversible",
            "write even powers of it, as in `c*eps^2*x`",
        )
    } else if denominator.substitute(eps, &Rational::ZERO).is_zero() {
        (
            "this divides by a power of `eps`: the field has no value at `eps = 0`",
            "divide by what is not 0 at `eps = 0`, as in `x/(1 + c*eps^2)`",
        )
    } else {
        return Ok(());
    };
    Err(Diagnostic::new(Kind::Name, place_of_eps(value, scope), message, help))
}

fn has_odd_powers(Expansion { numerator, denominator, .. }: &Expansion, scope: &Scope) -> bool {
    [numerator, denominator].iter().any(|part| !part.is_even_in(scope.symbols.epsilon()))
}

/// Returns the span of the first `eps` in the innermost subexpression that contains odd powers of
/// ε.
fn place_of_eps(expr: &Expr, scope: &Scope) -> Span {
    let is_odd =
        |expr: &Expr| expand_unkept(expr, scope).is_ok_and(|expansion| has_odd_powers(&expansion, scope));
    if let Some(part) = expr.parts().into_iter().find(|part| is_odd(part)) {
        return place_of_eps(part, scope);
    }
    let mut place = None;
    expr.visit_names(&mut |name, span| {
        if is_epsilon(&name.key()) {
            place = place.or(Some(span));
        }
    });
    place.unwrap_or(expr.span)
}

/// Returns texts such as `x^2*y` for the states of a term, and `x^2` for a product of two of them.
fn describe(monomial: &Monomial, scope: &Scope) -> (String, String) {
    let (states, _) = monomial.split(|variable| scope.symbols.is_state(variable));
    let power = |name: &str, exponent: u32| Text.power(name, exponent.into());
    let powers = states.powers().iter().map(|&(variable, exponent)| (scope.symbols.name(variable), exponent));
    let powers: Vec<(String, u32)> = powers.collect();
    let square = powers.iter().find(|(_, exponent)| *exponent > 1).map(|(name, _)| power(name, 2));
    let names = || powers.iter().take(2).map(|(name, _)| name.clone()).collect::<Vec<_>>();
    let product = square.unwrap_or_else(|| Text.product(&names()));
    let powers: Vec<String> = powers.iter().map(|(name, exponent)| power(name, *exponent)).collect();
    (format!("the term `{}`", Text.product(&powers)), product)
}

/// Returns the span of the factor with which the degree in the states first exceeds 2.
fn raising_factor(expr: &Expr, scope: &Scope) -> Span {
    let degree = |expr: &Expr| {
        expand_unkept(expr, scope).map_or(0, |expansion| scope.symbols.degree(&expansion.numerator))
    };
    match &expr.kind {
        ExprKind::Negation(inner) => raising_factor(inner, scope),
        ExprKind::Sum(terms) => match terms.iter().find(|term| degree(&term.expr) > 2) {
            Some(term) => raising_factor(&term.expr, scope),
            None => expr.span,
        },
        ExprKind::Product(factors) => {
            let mut reached = 0;
            for factor in factors {
                let own = degree(&factor.expr);
                reached += own;
                if own > 2 {
                    return raising_factor(&factor.expr, scope);
                }
                if reached > 2 {
                    return factor.expr.span;
                }
            }
            expr.span
        }
        ExprKind::Power(inner, _) if degree(inner) > 2 => raising_factor(inner, scope),
        ExprKind::Power(..) | ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Special(_) => expr.span,
    }
}
