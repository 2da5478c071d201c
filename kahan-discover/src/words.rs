//! Verdicts in words: each sentence says what was shown, and no more.

use crate::hamiltonian::is_within_reach;
use crate::report::Report;

/// `one integral`, `3 integrals`.
fn counted(count: usize, what: &str) -> String {
    match count {
        0 => format!("no {what}"),
        1 => format!("one {what}"),
        _ if what.ends_with('y') => format!("{count} {}ies", &what[..what.len() - 1]),
        _ => format!("{count} {what}s"),
    }
}

/// All sentences of a report.
pub(crate) fn sentences(report: &Report) -> Vec<String> {
    let mut sentences = Vec::new();
    sentences.push(degrees(report));
    sentences.extend(orbits(report));
    sentences.extend(formulas(report));
    sentences.push(densities(report));
    sentences.extend(own_density(report));
    sentences.extend(structure(report));
    sentences.extend(composition(report));
    if report.out_of_time {
        sentences
            .push("The time ran out before everything was tried: more seconds may show more.".to_owned());
    }
    sentences
}

fn degrees(report: &Report) -> String {
    if report.degrees.is_empty() {
        return "No iterate of the map has a value on a random line.".to_owned();
    }
    let growth = &report.growth;
    let entropy = match growth.growth.entropy() {
        0.0 => String::new(),
        entropy => format!(", algebraic entropy about {entropy:.4}"),
    };
    format!("The degrees of the iterates grow as follows: {}{entropy} ({}).", growth.growth, growth.evidence)
}

fn orbits(report: &Report) -> Vec<String> {
    let Some(hilbert) = &report.hilbert else {
        let why = if report.out_of_time {
            "No orbit was followed to its end in the time"
        } else {
            "Every orbit looked at ended at a pole"
        };
        return vec![format!("{why}, so nothing is known of relations.")];
    };
    let from = match hilbert.orbits {
        4 => format!("from 4 orbits of up to {} modulo two primes", counted(hilbert.points, "point")),
        orbits => format!("from {} of up to {}", counted(orbits, "orbit"), counted(hilbert.points, "point")),
    };
    let mut sentences = Vec::new();
    if let Some(period) = hilbert.period {
        sentences.push(match period {
            1 => "Every point looked at is a fixed point: the map is the identity there.".to_owned(),
            _ => format!("Every orbit looked at closes after {period} steps: the map is periodic there."),
        });
    }
    let n = report.variables.len();
    let degree = hilbert.degree();
    sentences.push(if hilbert.is_full() {
        format!(
            "No algebraic integral shows: none of degree ≤ {degree}, {from}. This bounds the degree and does not prove that there is none."
        )
    } else {
        format!(
            "Relations of degree ≤ {degree} confine orbits to sets of dimension {} in dimension {n}: {} visible up to that degree, {from}.",
            hilbert.dimension(n),
            counted(hilbert.integrals, "independent algebraic integral")
        )
    });
    if !hilbert.agree {
        sentences.push(
            "The orbits looked at did not all agree; the larger ranks, those of a generic orbit, are given."
                .to_owned(),
        );
    }
    sentences
}

fn formulas(report: &Report) -> Option<String> {
    let wanted = report.independent_integrals();
    let found = report.integrals.len();
    if wanted == 0 && found == 0 {
        return None;
    }
    Some(if found >= wanted {
        format!("Formulas: {}, independent and proved.", counted(found, "integral"))
    } else {
        format!(
            "Formulas: {} of the {wanted} that orbits show, independent and proved; the others were not reached.",
            counted(found, "integral")
        )
    })
}

fn densities(report: &Report) -> String {
    match report.densities.first() {
        Some(density) if density.degree == 0 => "The map preserves volume, proved.".to_owned(),
        Some(density) => format!("An invariant density 1/P with P of degree {}, proved.", density.degree),
        None => match (report.density_search.seen, report.density_search.none_up_to) {
            (Some(degree), _) => format!(
                "An invariant density 1/P with P of degree {degree} shows modulo a prime; no formula of it was reached."
            ),
            (None, Some(degree)) => format!("No invariant density 1/P shows up to degree {degree} of P."),
            (None, None) => "The time ran out before an invariant density was looked for.".to_owned(),
        },
    }
}

/// A block takes one density without `when`.
fn own_density(report: &Report) -> Option<String> {
    let own = report.own_density.as_ref().filter(|_| !report.densities.is_empty())?;
    Some(format!(
        "The field brings the density `{own}` along, and a block takes one: the line printed would stand in its place. The quotient of two densities is an integral, if not a constant."
    ))
}

fn structure(report: &Report) -> Vec<String> {
    let structure = &report.structure;
    let mut sentences = vec![format!("The divergence of the field is {}.", structure.divergence)];
    if structure.is_even {
        sentences.push("det(I - t f'(x)) is even in t, so 1/det A is an invariant density.".to_owned());
    }
    sentences.push(flow(report));
    sentences.push(match &structure.hamiltonian {
        Some(hamiltonian) => format!(
            "The field is K grad H with a constant antisymmetric K and H = {}; the modified Hamiltonian is an integral of the map, {}.",
            hamiltonian.hamiltonian,
            if hamiltonian.modified_is_proved {
                "proved"
            } else {
                "by a theorem (Celledoni, McLachlan, Owren, Quispel 2013): its formula is too long to be written"
            }
        ),
        None if structure.linear_integrals.len() == report.variables.len() => {
            "The field is zero: every K grad H with H = 0.".to_owned()
        }
        None if is_within_reach(report.variables.len()) => "No constant antisymmetric K with f = K grad H was found.".to_owned(),
        None => {
            "In so many variables no constant antisymmetric K with f = K grad H is looked for.".to_owned()
        }
    });
    sentences
}

/// Linear and quadratic integrals of the flow, as far as they were looked for.
fn flow(report: &Report) -> String {
    let structure = &report.structure;
    let linear = structure.linear_integrals.len();
    let quadratic = structure.quadratic_integrals.len();
    match (structure.flow_degree, linear) {
        (0, _) => "Linear and quadratic integrals of the flow were not reached.".to_owned(),
        (1, 0) => "The flow has no linear integral; quadratic ones were not reached.".to_owned(),
        (1, _) => format!(
            "The flow has {}; quadratic ones were not reached.",
            counted(linear, "independent linear integral")
        ),
        (_, 0) => format!(
            "The flow has no linear integral and {}.",
            match quadratic {
                0 => "no quadratic one".to_owned(),
                1 => "one quadratic integral".to_owned(),
                count => format!("{count} independent quadratic ones"),
            }
        ),
        _ => format!(
            "The flow has {} and {} independent of {}.",
            counted(linear, "independent linear integral"),
            counted(quadratic, "quadratic integral"),
            if linear == 1 { "it" } else { "them" }
        ),
    }
}

fn composition(report: &Report) -> Option<String> {
    let survivors = report.survivors.as_ref()?;
    let name = |index: usize| report.integrals[index].name().unwrap_or_default();
    let kept = (0..report.integrals.len())
        .filter(|&index| survivors.formulas[index])
        .map(|index| name(index).to_owned());
    let quotients =
        survivors.quotients.iter().map(|&(above, below)| format!("{}/{}", name(above), name(below)));
    let kept: Vec<String> = kept.chain(quotients).collect();
    let which = if kept.is_empty() {
        "neither one as it stands nor a quotient of two".to_owned()
    } else {
        kept.join(", ")
    };
    Some(format!(
        "Of the integrals {} under symmetric composition, up to degree {}; among the formulas: {which}.",
        match survivors.hilbert.integrals {
            0 => "none survives".to_owned(),
            1 => "one survives".to_owned(),
            count => format!("{count} survive"),
        },
        survivors.hilbert.degree()
    ))
}
