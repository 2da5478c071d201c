//! Equations: expanded exactly, of degree at most two in the states.

use crate::diagnostics::{Diagnostic, Diagnostics};
use crate::field::Component;
use crate::poly::{Budget, Monomial, Polynomial};
use crate::rational_function::RationalFunction;
use crate::syntax::{Block, Expr, ExprKind};
use crate::token::Span;

use super::expand::{Expansion, MOST_TERMS, MOST_WORK, expand, too_high, too_large};
use super::names::Scope;

/// Expands every equation; a broken one becomes zero.
pub(super) fn expand_all(block: &Block, scope: &mut Scope, diagnostics: &mut Diagnostics) -> Vec<Component> {
    let mut components = Vec::new();
    let mut seen: Vec<&str> = Vec::new();
    for equation in &block.equations {
        let sound = equation.value.as_ref().filter(|value| scope.resolve(value, false, diagnostics));
        if seen.contains(&equation.state.text.as_str()) {
            continue;
        }
        seen.push(&equation.state.text);
        components.push(sound.map_or_else(zero, |value| component(value, scope, diagnostics)));
    }
    components
}

fn zero() -> Component {
    Component { numerator: Polynomial::zero(), denominator: Polynomial::one() }
}

fn component(value: &Expr, scope: &Scope, diagnostics: &mut Diagnostics) -> Component {
    let outcome = expand(value, scope).and_then(|expansion| match check_degree(value, &expansion, scope) {
        Some(diagnostic) => Err(diagnostic),
        None => reduced(expansion, value.span),
    });
    outcome.unwrap_or_else(|diagnostic| {
        diagnostics.push(diagnostic);
        zero()
    })
}

/// p/q in lowest terms. A constant divisor is a factor of p already.
pub(super) fn reduced(expansion: Expansion, span: Span) -> Result<Component, Diagnostic> {
    if expansion.denominator.is_one() {
        return Ok(Component { numerator: expansion.numerator, denominator: expansion.denominator });
    }
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
    match RationalFunction::new_within(expansion.numerator, expansion.denominator, &mut budget) {
        Ok(Some(function)) => Ok(Component {
            numerator: function.numerator().clone(),
            denominator: function.denominator().clone(),
        }),
        Ok(None) | Err(_) => Err(too_large(span)),
    }
}

/// Kahan's method is for quadratic fields: no term of degree three or more may be left.
fn check_degree(value: &Expr, expansion: &Expansion, scope: &Scope) -> Option<Diagnostic> {
    let degree = |monomial: &Monomial| monomial.degree_where(|variable| scope.symbols.is_state(variable));
    let (monomial, _) = expansion.numerator.terms().max_by_key(|(monomial, _)| degree(monomial))?;
    let highest = degree(monomial);
    if highest <= 2 {
        return None;
    }
    Some(too_high(raising_factor(value, scope), &describe(monomial, scope), highest.into()))
}

/// The term in words, parameters left out.
fn describe(monomial: &Monomial, scope: &Scope) -> String {
    let (states, _) = monomial.split(|variable| scope.symbols.is_state(variable));
    let powers: Vec<String> = states
        .powers()
        .iter()
        .map(|&(variable, exponent)| match exponent {
            1 => scope.symbols.name(variable),
            _ => format!("{}^{exponent}", scope.symbols.name(variable)),
        })
        .collect();
    format!("the term `{}`", powers.join("*"))
}

/// The place that raises the degree above two: of a sum its first term that is too high, of a
/// product the factor at which the degree passes two, of a power the whole of it.
fn raising_factor(expr: &Expr, scope: &Scope) -> Span {
    let degree =
        |expr: &Expr| expand(expr, scope).map_or(0, |expansion| scope.symbols.degree(&expansion.numerator));
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
        ExprKind::Power(..)
        | ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Site { .. }
        | ExprKind::OverSites(_) => expr.span,
    }
}
