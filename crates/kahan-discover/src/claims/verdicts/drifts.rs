//! Writes sentences on drifts: functions F with F(x̃) = F(x) + c or F(x̃) = c·F(x), for example.

use crate::claims::writing::is_product;
use crate::drift::{Constant, Drift, DriftKind};
use crate::report::Report;

pub(super) const ENDS: &str = "By the drifts, each step adds a constant to one function and multiplies another by \
    a factor that is no root of unity. So the closure of a generic orbit has at least dimension 2, and rational \
    integrals are constant on it: nothing can be missing, and the search ended.";

struct ConstantIncrement {
    function: String,
    step: String,
    is_atom: bool,
}

impl ConstantIncrement {
    fn of(drift: &Drift) -> Option<Self> {
        match &drift.kind {
            DriftKind::Sum(Constant { text, .. }) => Some(ConstantIncrement {
                function: drift.claim.name.text.clone(),
                step: text.clone(),
                is_atom: text.chars().all(char::is_alphanumeric),
            }),
            DriftKind::Multiple(Constant { text, .. }) => Some(ConstantIncrement {
                function: format!("log|{}|", drift.claim.name.text),
                step: format!("log|{text}|"),
                is_atom: true,
            }),
            DriftKind::Image | DriftKind::Link(_) => None,
        }
    }

    fn quotient(&self) -> String {
        let ConstantIncrement { function, step, is_atom } = self;
        if *is_atom { format!("{function}/{step}") } else { format!("{function}/({step})") }
    }
}

/// Writes the sentence on drifts with a constant increment or a constant factor in each step.
pub(super) fn drifts(report: &Report) -> Option<String> {
    let even: Vec<ConstantIncrement> = report.drifts.iter().filter_map(ConstantIncrement::of).collect();
    let (ConstantIncrement { function, step, is_atom }, others) = even.split_first()?;
    if others.is_empty() {
        let is_name = |name: &&str| report.variables.iter().chain(&report.parameters).any(|own| own == name);
        let steps = ["n", "k", "m"].into_iter().find(|name| !is_name(name)).unwrap_or("N");
        let constant = match step.strip_prefix('-') {
            Some(size) if is_product(step) => format!("{function} + {steps}*{size}"),
            _ if *is_atom || is_product(step) && !step.contains('/') => {
                format!("{function} - {steps}*{step}")
            }
            _ => format!("{function} - {steps}*({step})"),
        };
        return Some(format!(
            "Every step adds {step} to {function}, so {constant} is constant, {steps} the number of steps."
        ));
    }
    let all: Vec<String> =
        even.iter().map(|ConstantIncrement { function, step, .. }| format!("{step} to {function}")).collect();
    let constants = others.iter().map(|other| match other.step == *step {
        true => format!("{function} - {}", other.function),
        false => format!("{} - {}", even[0].quotient(), other.quotient()),
    });
    let constants: Vec<String> = constants.collect();
    Some(format!(
        "Every step adds {}: along orbits {} {} constant.",
        all.join(" and "),
        constants.join(" and "),
        if constants.len() == 1 { "is" } else { "are" }
    ))
}
