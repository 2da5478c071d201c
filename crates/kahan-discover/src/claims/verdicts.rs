//! Writes the conclusions of a search as sentences.

mod drifts;
mod plane;
mod structure;

use kahan_algebra::render::Text;

use crate::modular::reconstruction::MOST_DIGITS;
use crate::orbits::basis::Basis;
use crate::orbits::hilbert::{Hilbert, MOST_MONOMIALS_AT_ALL};
use crate::report::{Bound, HamiltonianReport, MOST_READABLE, ModifiedPlace, Report};

use drifts::drifts;
use structure::structure;

fn counted(count: usize, what: &str) -> String {
    match count {
        0 => format!("no {what}"),
        1 => format!("one {what}"),
        _ if what.ends_with('y') => format!("{count} {}ies", &what[..what.len() - 1]),
        _ => format!("{count} {what}s"),
    }
}

/// Writes all sentences. `is_stopped` says that time ran out before higher degrees were searched.
pub(crate) fn sentences(report: &Report, is_stopped: bool) -> Vec<String> {
    let mut sentences = Vec::new();
    sentences.push(degrees(report));
    sentences.extend(orbits(report));
    sentences.extend(formulas(report));
    sentences.extend(polynomial_brackets(report));
    sentences.push(densities(report));
    sentences.extend(own_density(report));
    sentences.extend(drifts(report));
    sentences.extend(structure(report));
    sentences.extend(composition(report));
    sentences.extend(plane::quadratic(report));
    sentences.extend(ceiling(report));
    sentences.extend(bound(report, is_stopped));
    if is_stopped {
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
    if let Some(proof) = growth.proof {
        return plane::growth(proof, growth.growth.entropy());
    }
    let entropy = match growth.growth.entropy() {
        0.0 => String::new(),
        entropy => format!(", algebraic entropy about {entropy:.4}"),
    };
    format!(
        "The degrees of the iterates grow as follows: {}{entropy} (observed: {}).",
        growth.growth, growth.evidence
    )
}

fn ceiling(report: &Report) -> Option<String> {
    let ceiling = report.ceiling.as_ref()?;
    let n = report.variables.len();
    // The sentence on the upper bound is left out unless the bound is below n. It is also left out
    // if all integrals that orbits allow are found.
    if ceiling.integrals >= n || report.bound == Bound::Orbits {
        return None;
    }
    let most = match ceiling.integrals {
        0 => "no algebraic integral of any degree exists".to_owned(),
        count => format!("at most {} can exist, of whatever degree", counted(count, "independent integral")),
    };
    let squares = match n - ceiling.integrals {
        1 => "an eigenvalue that is not 0".to_owned(),
        count => format!("{count} eigenvalues that are not 0 and have different squares"),
    };
    let listed = |names: &[String], values: &[u64]| {
        let pairs = names.iter().zip(values).map(|(name, value)| format!("{name} = {value}"));
        pairs.collect::<Vec<_>>().join(", ")
    };
    let parameters = match &ceiling.parameters[..] {
        [] => String::new(),
        values => format!(" and {}", listed(&report.parameters, values)),
    };
    Some(format!(
        "For generic eps {most}, proved: modulo {} the field vanishes at {}{parameters}, where its Jacobian has {squares}.",
        ceiling.prime,
        listed(&report.variables, &ceiling.zero),
    ))
}

fn bound(report: &Report, is_stopped: bool) -> Option<String> {
    let degree = report.hilbert.as_ref().map_or(0, Hilbert::degree);
    match report.bound {
        Bound::Orbits if report.independent == report.variables.len() => None,
        Bound::Orbits => Some(format!(
            "A map in dimension {} whose orbits do not close has {}: nothing can be missing, and the search ended.",
            report.variables.len(),
            match report.independent {
                0 => "no integral".to_owned(),
                count => format!("at most {}", counted(count, "independent integral")),
            }
        )),
        Bound::Ceiling => Some(
            "So nothing can be missing (Ziglin's lemma at a fixed point), and the search ended.".to_owned(),
        ),
        Bound::Growth => Some(plane::GROWTH_ENDS.to_owned()),
        Bound::Drifts => Some(drifts::ENDS.to_owned()),
        Bound::Linear => plane::linear_ends(report),
        Bound::Degree => Some(format!(
            "The degree that was given, {degree}, ended the search: higher ones may show more integrals."
        )),
        Bound::Time if is_stopped => None,
        Bound::Time => Some(format!(
            "The time ended the search beyond degree {degree}: more seconds go on to higher degrees, which may show more integrals."
        )),
        Bound::Size => Some(format!(
            "The size ended the search: relations of degree {} would take more than {MOST_MONOMIALS_AT_ALL} monomials.",
            degree + 1
        )),
        Bound::Poles => report.hilbert.as_ref().map(|_| {
            format!(
                "Poles ended the search beyond degree {degree}: no orbit of a random point was long enough."
            )
        }),
    }
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
        4 => format!("seen on 4 orbits of up to {} modulo two primes", counted(hilbert.points, "point")),
        orbits => {
            format!("seen on {} of up to {}", counted(orbits, "orbit"), counted(hilbert.points, "point"))
        }
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
            "No algebraic integral shows: none of degree ≤ {degree}, {from}.{}",
            match report.bound {
                Bound::Orbits | Bound::Ceiling | Bound::Growth | Bound::Drifts if report.independent == 0 => "",
                _ => " This bounds the degree and does not prove that there is none.",
            }
        )
    } else {
        format!(
            "Polynomial relations of degree ≤ {degree} confine an orbit to a set of dimension {} in dimension {n}, which shows {}; this was {from}.",
            hilbert.dimension(n),
            counted(hilbert.integrals, "independent integral")
        )
    });
    if !hilbert.agree {
        sentences.push(
            "The orbits looked at did not all agree; what most of them show, those of a generic orbit, is given."
                .to_owned(),
        );
    }
    sentences
}

const MOST_CHARACTERS: usize = 200;

fn formulas(report: &Report) -> Vec<String> {
    let shown = report.hilbert.as_ref().map_or(0, |hilbert| hilbert.integrals);
    let formulas = report.integrals.len();
    let in_bases = report.integrals_in_bases();
    let alone: Vec<&HamiltonianReport> = report.standalone().collect();
    let mut sentences = Vec::new();
    if formulas > 0 {
        sentences.push(format!(
            "{} proved{}.",
            match formulas {
                1 => "A formula of one integral is".to_owned(),
                _ => format!("Formulas of {formulas} independent integrals are"),
            },
            match report.independent.saturating_sub(shown + alone.len()) {
                0 => String::new(),
                1 => "; one is of a higher degree than the relations looked at".to_owned(),
                more => format!("; {more} are of a higher degree than the relations looked at"),
            }
        ));
    }
    match &alone[..] {
        [] => {}
        [one] => {
            sentences.push(format!("One more integral, {}, is given in its compact form.", modified(&[one])));
        }
        several => sentences.push(format!(
            "{} more integrals, {}, are given in their compact forms.",
            several.len(),
            modified(several)
        )),
    }
    for found in report.compact() {
        if let ModifiedPlace::InsteadOf(index) = found.place {
            let replaced = &report.integrals[index];
            sentences.push(format!(
                "In place of {}, whose text has {} characters, {} stands in its compact form.",
                replaced.name(),
                replaced.text.len(),
                modified(&[found])
            ));
        }
    }
    if in_bases > 0 {
        let list = |basis: &Basis| {
            let terms = basis.term_texts(&report.variables, &Text);
            let text = terms.join(", ");
            if text.len() <= MOST_CHARACTERS { text } else { format!("{} terms", terms.len()) }
        };
        let lists: Vec<String> = report.bases.iter().map(list).collect();
        let proof = match report.bases.iter().all(|basis| basis.proof.is_some()) {
            true => "proved mod p (error < 2^-100)",
            false => "seen modulo primes",
        };
        sentences.push(format!(
            "{} no short formula with coefficients of at most {MOST_DIGITS} digits, but a Hirota-Kimura basis: along every orbit {} satisfy one linear relation, whose coefficients are constant there, {proof}.",
            match in_bases {
                1 => "One more integral has".to_owned(),
                count => format!("{count} more integrals have"),
            },
            lists.join("; and so do ")
        ));
    }
    let missing = report.not_reached();
    if missing > 0 {
        sentences.push(format!(
            "{} not reached.",
            match missing {
                1 => "The formula of one integral that orbits show was".to_owned(),
                _ => format!("The formulas of {missing} integrals that orbits show were"),
            }
        ));
    }
    sentences
}

fn modified(of: &[&HamiltonianReport]) -> String {
    let plural = if of.len() > 1 { "s" } else { "" };
    match &listed_labels(of)[..] {
        "" => "the modified Hamiltonian".to_owned(),
        labels => format!("the modified Hamiltonian{plural} of {labels}"),
    }
}

fn listed_labels(of: &[&HamiltonianReport]) -> String {
    let numbered = of.iter().filter(|found| found.number.is_some());
    let labels: Vec<String> = numbered.map(|found| found.label("K")).collect();
    match &labels[..] {
        [] => String::new(),
        [one] => one.clone(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

fn polynomial_brackets(report: &Report) -> Option<String> {
    let ranks: Vec<String> = report.brackets[..report.polynomial_brackets]
        .iter()
        .map(|bracket| bracket.rank.to_string())
        .collect();
    match &ranks[..] {
        [] => None,
        [rank] => {
            Some(format!("An invariant Poisson bracket of rank {rank} with polynomial entries is proved."))
        }
        _ => Some(format!(
            "{} invariant Poisson brackets with polynomial entries are proved, of ranks {}.",
            ranks.len(),
            ranks.join(", ")
        )),
    }
}

fn densities(report: &Report) -> String {
    let long = report.densities.first().map(|density| density.text.len()).filter(|&len| len > MOST_READABLE);
    let long = long.map(|len| format!(" Its formula has {len} characters; the answer holds it in full."));
    density(report) + &long.unwrap_or_default()
}

fn density(report: &Report) -> String {
    match report.densities.first() {
        Some(density) if density.degree == 0 => "The map preserves volume, proved.".to_owned(),
        Some(_) => match report.brackets.len() - report.polynomial_brackets {
            0 if report.polynomial_brackets == 0
                && !report.out_of_time
                && report.variables.len() >= 2
                && report.integrals.len() + 2 >= report.variables.len() =>
            {
                "An invariant density is proved; the Poisson brackets that it makes with integrals are too long to be written.".to_owned()
            }
            0 => "An invariant density is proved.".to_owned(),
            1 => "An invariant density is proved, and so is the Poisson bracket that it makes with integrals.".to_owned(),
            count => format!(
                "An invariant density is proved, and so are the {count} Poisson brackets that it makes with integrals."
            ),
        },
        None => match (report.density_search.seen, report.density_search.none_up_to) {
            (Some(degree), _) => format!(
                "One over a polynomial of degree {degree} is an invariant density, as seen modulo a prime; no formula of it was reached."
            ),
            (None, Some(degree)) => format!(
                "No invariant density shows that is one over a polynomial of degree {degree} or less, or made of factors of the integrals."
            ),
            (None, None) => "The time ran out before an invariant density was looked for.".to_owned(),
        },
    }
}

/// Writes the sentence on a density that the system's own block claims.
fn own_density(report: &Report) -> Option<String> {
    let own = report.own_density.as_ref().filter(|_| !report.densities.is_empty())?;
    Some(format!(
        "The field brings the density `{own}` along, and a block takes one: the one that was found would stand in its place. The quotient of two densities is an integral, if not a constant."
    ))
}

fn composition(report: &Report) -> Option<String> {
    let survivors = report.survivors.as_ref()?;
    let name = |index: usize| report.integrals[index].name();
    let kept = (0..report.integrals.len())
        .filter(|&index| survivors.formulas[index])
        .map(|index| name(index).to_owned());
    let quotients =
        survivors.quotients.iter().map(|&(above, below)| format!("{}/{}", name(above), name(below)));
    let kept: Vec<String> = kept.chain(quotients).collect();
    let which = match (kept.is_empty(), survivors.hilbert.integrals) {
        (true, 0) => String::new(),
        (true, _) => ", none of them a formula that was found or a quotient of two".to_owned(),
        (false, _) => format!(": {}", kept.join(", ")),
    };
    Some(format!(
        "The map itself keeps its integrals at one eps; compositions of order 4, 6 and 8, which step at several eps, keep {} of degree ≤ {}{which}.",
        counted(survivors.hilbert.integrals, "integral"),
        survivors.hilbert.degree()
    ))
}
