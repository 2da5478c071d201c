//! Evaluates constants such as `const c = 1/2;` from numbers and earlier constants.

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Block, Expr};
use kahan_syntax::token::Span;

use super::expand::{expand_unkept, is_spent};
use super::names::Scope;

pub(super) fn evaluate(
    block: &Block,
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> Vec<(String, Rational)> {
    let mut values = Vec::new();
    for constant in &block.constants {
        if !scope.is_free(&constant.name, "constant", diagnostics) {
            continue;
        }
        let value = constant.value.as_ref().filter(|_| !is_spent(scope));
        let value = value.and_then(|expr| {
            constant_value(expr, scope).map_err(|diagnostic| diagnostics.push(diagnostic)).ok()?
        });
        if let Some(value) = &value {
            values.push((constant.name.text.clone(), value.clone()));
        }
        scope.constants.insert(constant.name.text.clone(), value);
    }
    values
}

fn constant_value(expr: &Expr, scope: &Scope) -> Result<Option<Rational>, Diagnostic> {
    let mut foreign: Option<(String, Span)> = None;
    let mut poisoned = false;
    expr.visit_names(&mut |name, span| {
        let name = name.to_string();
        match scope.constants.get(&name) {
            Some(value) => poisoned |= value.is_none(),
            None if scope.is_poisoned(&name) => poisoned = true,
            None => foreign = foreign.take().or(Some((name, span))),
        }
    });
    if let Some((name, span)) = foreign {
        let message = format!("`{name}` is no constant");
        let help = "write a number here, or a `const` declared above";
        return Err(Diagnostic::new(Kind::UnknownName, span, message, help));
    }
    if poisoned {
        return Ok(None);
    }
    expand_unkept(expr, scope).map(|expansion| expansion.as_constant())
}
