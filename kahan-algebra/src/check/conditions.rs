//! `when NAME = number, …`: the specialisation on which a claim is made.
//!
//! Parameters and ε get values, once each; states cannot be fixed, and ε = 0 is no step. At the values the field itself
//! must exist.

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::field::Component;
use crate::poly::Variable;
use crate::rational::Rational;
use crate::syntax::Condition;

use super::constants::constant_value;
use super::names::{Scope, is_epsilon};

/// The values behind `when`; `None` if one is broken.
pub(super) fn evaluate(
    written: &[Condition],
    components: &[Component],
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(Variable, Rational)>> {
    let mut values: Vec<(Variable, Rational)> = Vec::new();
    let mut sound = true;
    for condition in written {
        match one_condition(condition, &values, scope) {
            Ok(Some(value)) => values.push(value),
            Ok(None) => sound = false,
            Err(diagnostic) => {
                diagnostics.push(diagnostic);
                sound = false;
            }
        }
    }
    (sound && is_field_defined(written, &values, components, diagnostics)).then_some(values)
}

/// A claim about a field that divides by zero says nothing.
fn is_field_defined(
    written: &[Condition],
    values: &[(Variable, Rational)],
    components: &[Component],
    diagnostics: &mut Diagnostics,
) -> bool {
    let vanishes = |component: &Component| {
        let divisor = values.iter().fold(component.denominator.clone(), |divisor, (variable, value)| {
            divisor.substitute(*variable, value)
        });
        divisor.is_zero()
    };
    let (Some(first), Some(last)) = (written.first(), written.last()) else { return true };
    let singular = components.iter().any(vanishes);
    if singular {
        diagnostics.report(
            Kind::Claim,
            first.name.span.to(last.value.span),
            "here the field divides by zero, so it has no map",
            "fix values at which every divisor of the equations is different from zero",
        );
    }
    !singular
}

fn one_condition(
    condition: &Condition,
    earlier: &[(Variable, Rational)],
    scope: &mut Scope,
) -> Result<Option<(Variable, Rational)>, Diagnostic> {
    let name = &condition.name;
    let wrong = |message: String, help: &str| Err(Diagnostic::new(Kind::Claim, name.span, message, help));
    let fixable = |name: &str| scope.variable(name).filter(|&variable| !scope.symbols.is_state(variable));
    let Some(variable) = fixable(&name.text) else {
        if scope.is_poisoned(&name.text) {
            return Ok(None);
        }
        let slip = scope.nearest(&name.text, true).filter(|nearest| fixable(nearest).is_some());
        let help = slip.map_or_else(
            || "`when` fixes parameters and `eps`, as in `when eps = 1`".to_owned(),
            |nearest| format!("did you mean `{nearest}`?"),
        );
        return wrong(
            format!("`{}` is neither a parameter nor `eps`, so it cannot be fixed by `when`", name.text),
            &help,
        );
    };
    if earlier.iter().any(|(known, _)| *known == variable) {
        return wrong(format!("`{}` is fixed twice", name.text), "remove one of the conditions");
    }
    scope.mark_used(&name.text);
    let Some(value) = constant_value(&condition.value, scope)? else { return Ok(None) };
    if is_epsilon(&name.text) && value.is_zero() {
        return wrong(
            "at eps = 0 the map is the identity, and every claim says nothing".to_owned(),
            "choose another value",
        );
    }
    Ok(Some((variable, value)))
}
