//! Drifts in words: functions that grow evenly, and the functions of them that are constant.

use crate::drift::DriftKind;
use crate::report::Report;
use crate::writing::is_product;

/// The sentence on the end of a search by the drifts.
pub(super) const ENDS: &str = "By the drifts, each step adds a constant to one function and multiplies another by \
    a factor that is no root of unity. So the closure of a generic orbit has at least dimension 2, and rational \
    integrals are constant on it: nothing can be missing, and the search ended.";

/// The sentence on drifts that change by a constant at every step, or whose logarithms do.
pub(super) fn drifts(report: &Report) -> Option<String> {
    let even: Vec<(String, String)> = report
        .drifts
        .iter()
        .filter_map(|drift| match &drift.kind {
            DriftKind::Sum(step) => Some((drift.name.clone(), step.clone())),
            DriftKind::Multiple(factor) => Some((format!("log|{}|", drift.name), format!("log|{factor}|"))),
            DriftKind::Image | DriftKind::Link => None,
        })
        .collect();
    let factor = |step: &String| {
        let is_one = step.starts_with("log|") || is_product(step) && !step.contains('/');
        if is_one { step.clone() } else { format!("({step})") }
    };
    let ((first, step), others) = even.split_first()?;
    if others.is_empty() {
        let constant = match step.strip_prefix('-') {
            Some(size) if is_product(step) => format!("{first} + n*{size}"),
            _ => format!("{first} - n*{}", factor(step)),
        };
        return Some(format!(
            "Every step adds {step} to {first}, so {constant} is constant, n the number of steps."
        ));
    }
    let all: Vec<String> = even.iter().map(|(drift, step)| format!("{step} to {drift}")).collect();
    let divisor = |step: &String| {
        let is_one = step.starts_with("log|") || step.chars().all(char::is_alphanumeric);
        if is_one { step.clone() } else { format!("({step})") }
    };
    let constants: Vec<String> = others
        .iter()
        .map(|(drift, own)| match own == step {
            true => format!("{first} - {drift}"),
            false => format!("{first}/{} - {drift}/{}", divisor(step), divisor(own)),
        })
        .collect();
    Some(format!(
        "Every step adds {}: along orbits {} {} constant.",
        all.join(" and "),
        constants.join(" and "),
        if constants.len() == 1 { "is" } else { "are" }
    ))
}
