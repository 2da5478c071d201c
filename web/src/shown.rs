//! Answers as HTML for the page, set and drawn by `kahan-draw`.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Formulas, condition_text};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_discover::poles::Pattern;
use kahan_draw::Sheet;
use kahan_draw::document::{LINE, derived, display, rows, statements};
use kahan_draw::picture::{self, Look};
use kahan_latex::{Latex, breaking};
use kahan_study::{Discovered, HeightsFound, PolesFound, Study, StudyError};
use maud::{Markup, html};

pub(crate) use kahan_draw::document::readable;

/// Larger matrices are no reading.
const MOST_VARIABLES: usize = 8;

/// The field, A, b, the map, the claims that came with the field; the Jacobian where it is asked for.
///
/// # Errors
/// Where the field divides by zero at its parameters.
pub(crate) fn formulas(study: &Study, with_jacobian: bool) -> Result<String, StudyError> {
    let system = study.specialised()?;
    let markup = html! {
        @if system.field.dimension() > MOST_VARIABLES {
            p { (system.field.dimension()) " variables have formulas too long for a page; copy them as text." }
        } @else if with_jacobian {
            (jacobian(&system))
        } @else {
            (derived(&system))
            @if !system.claims.is_empty() {
                h4 { "What is claimed, and proved" }
                @for claim in &system.claims { (stated(&system, claim, study.source(&claim.name.text))) }
            }
        }
    };
    Ok(markup.into_string())
}

/// The Jacobian of the map, or how it is found where an entry is too long.
fn jacobian(system: &System) -> Markup {
    let map = RationalMap::of(&system.field);
    let formulas = Formulas { field: &system.field, map: map.as_ref(), notation: &Latex };
    let general =
        "\\frac{\\partial\\widetilde x}{\\partial x} = A(x,\\varepsilon)^{-1} A(\\widetilde x,-\\varepsilon)";
    html! {
        (display(general, LINE))
        @if let Some(rows) = formulas.jacobian() {
            (display(&format!("\\frac{{\\partial\\widetilde x}}{{\\partial x}} = {}", breaking::matrix("pmatrix", &rows, LINE - 10)), LINE))
        } @else {
            p { "Its entries are too long to be written out." }
        }
    }
}

/// What a search found, each formula proved.
///
/// # Errors
/// Where the text of the claims has mistakes, which the search excludes.
pub(crate) fn findings(found: &Discovered) -> Result<String, StudyError> {
    let (claimed, report) = (found.readable()?, &found.report);
    let markup = html! {
        @if claimed.claims.is_empty() && report.bases.is_empty() && report.compact().is_none() {
            p { "No integral, density or bracket was found." }
        }
        @for claim in &claimed.claims { (stated(&claimed, claim, None)) }
        @if let Some(hamiltonian) = &report.structure.hamiltonian {
            p { "The flow is Hamiltonian: f = K ∇H with a constant antisymmetric K." }
            (display(&format!("K = {}", breaking::matrix("pmatrix", &hamiltonian.tensor, LINE)), LINE))
        }
        @if let Some(hamiltonian) = report.compact() {
            p { "The modified Hamiltonian, of a point and its image:" }
            (display(&format!("\\widetilde{{H}} = {}", hamiltonian.modified(&Latex)), LINE))
        }
        @for basis in &report.bases {
            p { "A Hirota–Kimura basis, " @if basis.proof.is_none() { "as seen modulo primes" } @else { "proved" } ":" }
            (display(&basis.relation(&report.variables, &Latex), LINE))
        }
        ul { @for sentence in &report.sentences { li { (readable(sentence)) } } }
    };
    Ok(markup.into_string())
}

/// One claim, with its kind, its condition and its source.
fn stated(system: &System, claim: &Claim, source: Option<&str>) -> Markup {
    let kind = match claim.kind {
        ClaimKind::Integral => "Integral",
        ClaimKind::Density => "Invariant density",
        ClaimKind::Bracket => "Invariant Poisson bracket",
    };
    let condition = condition_text(system, claim);
    html! {
        div.preserved {
            p.source {
                b { (kind) } " proved"
                @if !condition.is_empty() { ", when " (readable(&condition)) }
                @if let Some(source) = source { "; " (readable(source)) }
            }
            (statements(claim))
        }
    }
}

/// The heights of an exact orbit as a picture.
pub(crate) fn heights(found: &HeightsFound, eps: &Rational) -> String {
    picture::heights(found, eps, &Look::on(Sheet::page(480, 320))).drawing.inline().into_string()
}

/// What becomes of the curves that the map loses.
pub(crate) fn patterns(answer: &PolesFound) -> String {
    let found = &answer.found;
    let row = |pattern: &Pattern| {
        let verdict = match pattern.confined {
            Some(true) if !pattern.is_blown_down() => "not blown down".to_owned(),
            Some(true) => format!("confined after {} steps", pattern.steps),
            Some(false) => format!("none within {} steps", found.bound),
            None => "undecided".to_owned(),
        };
        vec![readable(&pattern.name(&found.symbols)), verdict]
    };
    let headings = vec!["curve = 0".to_owned(), "what is lost comes back".to_owned()];
    let table: Vec<Vec<String>> = [headings].into_iter().chain(found.patterns.iter().map(row)).collect();
    let degrees: Vec<String> = found.degrees.iter().map(ToString::to_string).collect();
    let markup = html! {
        @if table.len() > 1 {
            (rows("Curves that the map sends to infinity or blows down", &table))
        } @else {
            p { "The map sends no curve to infinity and blows none down." }
        }
        p { "The degrees of the iterates are " (degrees.join(", ")) ": growth is " (answer.growth.growth.word()) "." }
    };
    markup.into_string()
}
