//! Shows the results of a search, as HTML and as a table.

use kahan_algebra::prove::ERROR_EXPONENT;
use kahan_algebra::render::{Notation, Text};
use kahan_discover::Report;
use kahan_discover::orbits::basis::Basis;
use kahan_latex::{Latex, breaking};
use kahan_study::{ClaimShown, Discovered};
use maud::{Markup, html};

use crate::document::{LINE, Table, claim, display, readable};

pub(super) fn html(found: &Discovered) -> Markup {
    let claimed = &found.readable();
    let report = &found.report;
    html! {
        @if claimed.claims.is_empty() && report.bases.is_empty() && report.compact().next().is_none() {
            p { "No integral, density, bracket or drift was found." }
        } @else if !claimed.claims.is_empty() {
            @let named = [&report.variables[..], &report.parameters[..]].concat().join(", ");
            p {
                "Each formula was proved before it was shown, as an identity in " (readable(&named)) ", ε: at random points \
                 modulo primes, so many that a false one passes with a chance below 2"
                sup { "−" (ERROR_EXPONENT) } ", and at an exact one."
            }
            @for one in &claimed.claims {
                (claim(&ClaimShown::of(claimed, one, &Latex), report.variables.len(), &html! {}))
            }
        }
        @if !report.structure.hamiltonians.is_empty() {
            p { "The flow is Hamiltonian: f = K ∇H with a constant antisymmetric K." }
        }
        @for found in &report.structure.hamiltonians {
            @let tensor = breaking::matrix("pmatrix", &found.tensor, LINE);
            (display(&format!("{} = {tensor}", Latex.name(&found.label("K"))), LINE))
        }
        @for found in report.compact() {
            @let [states, images] = states_and_images(report, &Text);
            @let left = Latex.name(&found.label("H")).replacen('H', "\\widetilde{H}", 1);
            p { "The modified Hamiltonian, where " (readable(&images)) " is the image of " (readable(&states)) ":" }
            (display(&format!("{left} = {}", found.modified(&Latex)), LINE))
        }
        @for basis in &report.bases {
            p { "A Hirota–Kimura basis, " @if basis.proof.is_none() { "as seen modulo primes" } @else { "proved" } ":" }
            (display(&basis.relation(&report.variables, &Latex), LINE))
            p { (readable(&evaluation(basis, &Text, ""))) }
        }
        ul { @for sentence in &report.sentences { li { (readable(sentence)) } } }
        (numbers(found))
    }
}

/// Returns a table of the numbers that the search found.
#[must_use]
pub fn numbers(found: &Discovered) -> Table {
    let report = &found.report;
    let listing = |values: &[usize]| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let listed = |texts: &[String]| if texts.is_empty() { "none".to_owned() } else { texts.join(", ") };
    let mut fixed: Vec<String> =
        found.fixed.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let mut generic = report.parameters.clone();
    match &found.eps {
        Some(eps) => fixed.push(format!("eps = {eps}")),
        None => generic.push("eps".to_owned()),
    }
    let mut rows = vec![
        ["system".to_owned(), found.system.clone()],
        ["variables".to_owned(), report.variables.join(", ")],
        ["generic".to_owned(), listed(&generic)],
    ];
    if !fixed.is_empty() {
        rows.push(["fixed".to_owned(), fixed.join(", ")]);
    }
    rows.push(["degrees of iterates".to_owned(), listing(&report.degrees)]);
    // Without a relation on an orbit, one row states the highest degree searched.
    let hilbert = report.hilbert.as_ref();
    if let Some(hilbert) = hilbert.filter(|hilbert| hilbert.is_full()) {
        rows.push(["relations on an orbit".to_owned(), format!("none of degree ≤ {}", hilbert.degree())]);
    } else if let Some(hilbert) = hilbert {
        let degrees: Vec<usize> = (1..=hilbert.values.len()).collect();
        rows.push(["monomials of degree".to_owned(), format!("≤ {}", listing(&degrees))]);
        rows.push(["  on an orbit".to_owned(), listing(&hilbert.values)]);
        rows.push(["  of all".to_owned(), listing(&hilbert.full)]);
    }
    let structure = &report.structure;
    // Without known integrals of the flow there is no row, because the search ends at degree 2.
    let of_flow = [structure.linear_integrals.as_slice(), &structure.quadratic_integrals].concat();
    if !of_flow.is_empty() {
        rows.push(["integrals of the flow".to_owned(), of_flow.join(", ")]);
    }
    rows.push(["seconds".to_owned(), format!("{:.2}", found.seconds.unwrap_or_default())]);
    Table::new("Numbers of the search", ["what", "found"], rows.into_iter().map(Vec::from))
}

/// Returns a state and its image under the map, written as vectors in the given notation.
#[must_use]
pub fn states_and_images(report: &Report, notation: &dyn Notation) -> [String; 2] {
    let states = report.variables.iter();
    let vector = |entries: Vec<String>| format!("({})", entries.join(", "));
    [
        vector(states.clone().map(|state| notation.name(state)).collect()),
        vector(states.map(|state| notation.image(state)).collect()),
    ]
}

/// Says which quotients of a basis's coefficients c₁, c₂, … are integrals, and how many points
/// determine the coefficients. The text `mark` is put on both sides of each quotient.
#[must_use]
pub fn evaluation(basis: &Basis, notation: &dyn Notation, mark: &str) -> String {
    let quotient = |(above, below): (usize, usize)| {
        let [above, below] = [above, below].map(|number| notation.name(&format!("c{number}")));
        format!("{mark}{above}/{below}{mark}")
    };
    let quotients: Vec<String> = basis.quotients().into_iter().map(quotient).collect();
    let are = match quotients.len() {
        1 => "is an integral",
        _ => "are independent integrals",
    };
    let points = match basis.points() {
        1 => "one point".to_owned(),
        points => format!("{points} consecutive points"),
    };
    format!(
        "{} {are}: along an orbit the coefficients are constant, and the linear equations at {points} of it determine their quotients.",
        quotients.join(", ")
    )
}
