//! Writes sentences on the structure of the field.

use crate::poisson::hamiltonian::is_within_reach;
use crate::report::{HamiltonianReport, Report};

use super::{counted, listed_labels};

pub(super) fn structure(report: &Report) -> Vec<String> {
    let structure = &report.structure;
    let mut sentences = vec![format!("The divergence of the field is {}.", structure.divergence)];
    if structure.is_even {
        sentences.push("det A(x,eps) is even in eps, so that 1/det A is an invariant density.".to_owned());
    }
    sentences.push(flow(report));
    let proof = |is_proved: bool| match is_proved {
        true => "proved",
        false => "by a theorem (Celledoni, McLachlan, Owren, Quispel 2013)",
    };
    sentences.push(match &structure.hamiltonians[..] {
        [one] => format!(
            "The field is K grad H with a constant antisymmetric K and H = {}; the modified Hamiltonian is an integral of the map, {}.",
            one.hamiltonian,
            proof(one.modified_is_proved)
        ),
        [_, _, ..] => several(&structure.hamiltonians, proof),
        [] if structure.linear_integrals.len() == report.variables.len() => {
            "The field is zero: every K grad H with H = 0.".to_owned()
        }
        [] if is_within_reach(report.variables.len()) => "No constant antisymmetric K with f = K grad H was found.".to_owned(),
        [] => {
            "No constant antisymmetric K with f = K grad H is looked for: H would have too many coefficients.".to_owned()
        }
    });
    let of_brackets: Vec<&HamiltonianReport> =
        structure.hamiltonians.iter().filter(|found| found.bracket_is_proved).collect();
    if !of_brackets.is_empty() {
        sentences.push(format!(
            "(I - eps^2 f'^2) K, where f' is the Jacobian of the field, is an invariant Poisson bracket of the map{}, proved.",
            match &listed_labels(&of_brackets)[..] {
                "" => String::new(),
                labels => format!(" for {labels}"),
            }
        ));
    }
    sentences
}

fn several(all: &[HamiltonianReport], proof: impl Fn(bool) -> &'static str) -> String {
    let pairs = all.iter().map(|found| format!("{} with H = {}", found.label("K"), found.hamiltonian));
    let are_proved = all.iter().all(|found| found.modified_is_proved);
    format!(
        "The field is K grad H with {} constant antisymmetric K: {}; the modified Hamiltonian of each is an integral of the map, {}.",
        all.len(),
        pairs.collect::<Vec<_>>().join(", "),
        proof(are_proved)
    )
}

/// Writes the sentence on linear and quadratic integrals of the flow.
fn flow(report: &Report) -> String {
    let structure = &report.structure;
    let (linear, quadratic) = (structure.linear_integrals.len(), structure.quadratic_integrals.len());
    let found = linear + quadratic;
    let of_flow = if structure.depends_on_eps { "The flow of the field at any one eps" } else { "The flow" };
    match structure.flow_degree {
        0 => "Linear and quadratic integrals of the flow were not reached.".to_owned(),
        1 if linear == 0 => format!("{of_flow} has no linear integral; quadratic ones were not reached."),
        1 => format!(
            "{of_flow} has {}, which the map keeps; quadratic ones were not reached.",
            counted(linear, "independent linear integral")
        ),
        _ if found == 0 => format!("{of_flow} has no linear integral and no quadratic one."),
        _ => {
            let of = match (linear, quadratic) {
                (0, quadratic) => counted(quadratic, "independent quadratic integral"),
                (linear, 0) => counted(linear, "independent linear integral"),
                _ => format!("{linear} linear and {quadratic} quadratic independent integrals"),
            };
            let kept = match structure.kept {
                0 if found == 1 => "which the map does not keep as it stands".to_owned(),
                0 => "which the map does not keep as they stand".to_owned(),
                1 if found == 1 => "which the map keeps as it stands".to_owned(),
                kept if kept == found => "which the map keeps as they stand".to_owned(),
                kept => format!("of which the map keeps {kept} as they stand"),
            };
            format!("{of_flow} has {of}, {kept}.")
        }
    }
}
