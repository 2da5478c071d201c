//! What drifts say of time, and of integrals that are not rational.

use crate::drift::DriftKind;
use crate::report::Report;

/// What grows evenly, by how much at a step, and what is constant because of that.
pub(super) fn drifts(report: &Report) -> Option<String> {
    let even: Vec<(String, String)> = report
        .drifts
        .iter()
        .filter_map(|drift| match &drift.kind {
            DriftKind::Sum(step) => Some((drift.name.clone(), step.clone())),
            DriftKind::Multiple(factor) => Some((format!("log({})", drift.name), format!("log({factor})"))),
            DriftKind::Image => None,
        })
        .collect();
    let ((first, step), others) = even.split_first()?;
    let all: Vec<String> = even.iter().map(|(drift, step)| format!("{drift} grows by {step}")).collect();
    let constant = |(drift, own): &(String, String)| format!("{first}/({step}) - {drift}/({own})");
    let constants: Vec<String> = others.iter().map(constant).collect();
    let constants = match &constants[..] {
        [] => format!("so it tells the time, and {first} - n*({step}) is constant, n the number of steps"),
        constants => format!("so these are constant along orbits: {}", constants.join(", ")),
    };
    Some(format!("At every step {}: {constants}.", all.join(" and ")))
}
