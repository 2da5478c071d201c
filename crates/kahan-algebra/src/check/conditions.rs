//! Checks relations `when expr = expr` between parameters and ε.
//!
//! Each relation is solved for a name that occurs linearly. A relation must not contain states,
//! imply ε = 0, or make a divisor of the field zero.

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::syntax;
use kahan_syntax::table::sorted_by_key;
use kahan_syntax::token::Span;

use crate::poly::{OverBudget, Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::relations::{Obstacle, Relations};
use crate::render::{Notation, Text};
use crate::symbols::Symbols;
use crate::system::Condition;

use super::expand::{Expansion, expand_as_written, is_spent};
use super::names::Scope;

pub(super) fn evaluate(
    written: &[syntax::Condition],
    components: &[RationalFunction],
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Condition>> {
    let mut relations = Relations::default();
    let mut solved = Vec::new();
    for condition in written {
        let before = relations.nonzero().len();
        match one_relation(condition, &mut relations, components, scope) {
            Ok(name) => solved.push((condition.clone(), name?, before..relations.nonzero().len())),
            Err(diagnostic) => {
                diagnostics.push(diagnostic);
                return None;
            }
        }
    }
    Some(Condition::all(solved, &relations))
}

/// Adds a relation and returns the name for which it was solved. Returns `Ok(None)` after a
/// reported mistake.
fn one_relation(
    condition: &syntax::Condition,
    relations: &mut Relations,
    components: &[RationalFunction],
    scope: &mut Scope,
) -> Result<Option<Variable>, Diagnostic> {
    let Some(names) = parameters_in(condition, scope)?.filter(|_| !is_spent(scope)) else { return Ok(None) };
    let span = condition.span();
    let wrong = |message: &str, help: &str| Diagnostic::new(Kind::Claim, span, message, help);
    let over_budget = |_: OverBudget| too_large(span);
    let (left, right) =
        (expand_as_written(&condition.left, scope)?, expand_as_written(&condition.right, scope)?);
    let is_first = relations.values().next().is_none();
    let divisors = [&left.denominator, &right.denominator];
    let polynomial = difference(&left, &right);
    let name = relations
        .add(&polynomial, &names)
        .map_err(|obstacle| explain_obstacle(&obstacle, span, is_first, &scope.symbols))?;
    if relations.value(scope.symbols.epsilon()).is_some_and(RationalFunction::is_zero) {
        let message = "at eps = 0 the map is the identity, and every claim says nothing";
        return Err(wrong(message, "choose another value"));
    }
    for divisor in divisors {
        if !relations.require(divisor).map_err(over_budget)? {
            let message = "where this relation holds it divides by zero";
            return Err(wrong(message, "write it without the division"));
        }
    }
    for component in components {
        if relations.makes_vanish(component.denominator()).map_err(over_budget)? {
            let help = "fix values at which every divisor of the equations is different from zero";
            return Err(wrong("here the field divides by zero, so it has no map", help));
        }
    }
    Ok(Some(name))
}

fn difference(left: &Expansion, right: &Expansion) -> Polynomial {
    let above = &(&left.numerator * &right.denominator) - &(&right.numerator * &left.denominator);
    let below = &left.denominator * &right.denominator;
    RationalFunction::new(above, below).map_or_else(Polynomial::zero, |quotient| quotient.numerator().clone())
}

/// Returns the parameters of a relation in order of occurrence, and ε last if it occurs. Returns
/// `Ok(None)` after a reported mistake.
fn parameters_in(
    condition: &syntax::Condition,
    scope: &mut Scope,
) -> Result<Option<Vec<Variable>>, Diagnostic> {
    let mut found: Vec<(String, Span)> = Vec::new();
    condition.visit_names(&mut |name, span| found.push((name.to_string(), span)));
    let epsilon = scope.symbols.epsilon();
    let mut names: Vec<Variable> = Vec::new();
    for (name, span) in found {
        scope.mark_used(&name);
        if scope.is_poisoned(&name) || matches!(scope.constants.get(&name), Some(None)) {
            return Ok(None);
        }
        if scope.constants.contains_key(&name) {
            continue;
        }
        match scope.variable(&name) {
            Some(variable) if scope.symbols.is_state(variable) => {
                let message =
                    format!("`{name}` is a state, and states move along an orbit: `when` cannot fix them");
                let help =
                    "a relation is between parameters and `eps`, as in `when eps = 1` or `when c = -a - b`";
                return Err(Diagnostic::new(Kind::Claim, span, message, help));
            }
            Some(variable) if !names.contains(&variable) => names.push(variable),
            Some(_) => {}
            None => return Err(unknown_name(&name, span, scope)),
        }
    }
    Ok(Some(sorted_by_key(names, |name| *name == epsilon)))
}

fn unknown_name(name: &str, span: Span, scope: &mut Scope) -> Diagnostic {
    let stands = |scope: &Scope, nearest: &str| {
        scope.constants.contains_key(nearest)
            || scope.variable(nearest).is_some_and(|variable| !scope.symbols.is_state(variable))
    };
    let help = match scope.nearest(name, true).filter(|nearest| stands(scope, nearest)) {
        Some(nearest) => {
            // The name that was probably meant is not reported as unused.
            scope.mark_used(&nearest);
            format!("did you mean `{nearest}`?")
        }
        None => {
            "a relation is between parameters and `eps`, as in `when eps = 1` or `when c = -a - b`".to_owned()
        }
    };
    let message = format!("`{name}` is neither a parameter nor `eps`, so it cannot stand behind `when`");
    Diagnostic::new(Kind::Claim, span, message, help)
}

fn too_large(span: Span) -> Diagnostic {
    let message = "this relation is too large to be solved, with those before it put in";
    let help = "write it with smaller powers";
    Diagnostic::new(Kind::TooLarge, span, message, help)
}

fn explain_obstacle(obstacle: &Obstacle, span: Span, is_first: bool, symbols: &Symbols) -> Diagnostic {
    let wrong = |message: &str, help: &str| Diagnostic::new(Kind::Claim, span, message, help);
    match obstacle {
        Obstacle::TooLarge => too_large(span),
        Obstacle::Identity if is_first => {
            wrong("this relation always holds, so it says nothing", "remove it")
        }
        Obstacle::Identity => wrong("this relation follows from those before it", "remove it"),
        Obstacle::Contradiction if is_first => {
            wrong("this relation never holds, so nothing is claimed", "correct it, or remove the claim")
        }
        Obstacle::Contradiction => {
            let help = "keep one of them; what a relation is divided by to be solved is not 0 either";
            wrong("this relation contradicts those before it", help)
        }
        Obstacle::NotLinear => {
            let form = "as in `when c = -a - b` or `when a*b = c^2`";
            let help = format!("write it with a parameter or `eps` of degree 1, {form}");
            wrong("no name enters this relation linearly, so it cannot be solved", &help)
        }
        Obstacle::Product(a, b) => {
            let [a, b] = [a, b].map(|factor| Text.polynomial(symbols, factor));
            let message = format!("this relation is a product, which holds where {a} = 0 and where {b} = 0");
            wrong(&message, &format!("write the factor that is meant, as in `when {a} = 0`"))
        }
    }
}
