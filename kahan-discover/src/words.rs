//! Verdicts in words: each sentence says what was shown, and no more.

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
        return vec!["Every orbit looked at ended at a pole, so nothing is known of relations.".to_owned()];
    };
    let from = match hilbert.orbits {
        4 => format!("from 4 orbits of up to {} points modulo two primes", hilbert.points),
        orbits => format!("from {} of up to {} points", counted(orbits, "orbit"), hilbert.points),
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
        None => format!("No invariant density 1/P shows up to degree {} of P.", report.density_degree),
    }
}

fn structure(report: &Report) -> Vec<String> {
    let structure = &report.structure;
    let mut sentences = vec![format!("The divergence of the field is {}.", structure.divergence)];
    if structure.is_even {
        sentences.push("det(I - t f'(x)) is even in t, so 1/det A is an invariant density.".to_owned());
    }
    sentences.push(format!(
        "The flow has {} and {} independent of it.",
        counted(structure.linear_integrals.len(), "independent linear integral"),
        counted(structure.quadratic_integrals.len(), "quadratic integral")
    ));
    sentences.push(match &structure.hamiltonian {
        Some(hamiltonian) => format!(
            "The field is K grad H with a constant antisymmetric K and H = {}{}.",
            hamiltonian.hamiltonian,
            if hamiltonian.modified_is_proved {
                "; the modified Hamiltonian is an integral of the map, proved"
            } else {
                ""
            }
        ),
        None => "No constant antisymmetric K with f = K grad H was found.".to_owned(),
    });
    sentences
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
