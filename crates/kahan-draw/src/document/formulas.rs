//! The formulas of a system as the library derives them from its field.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::render::{Formulas, Notation, claim_statement};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_latex::{Latex, breaking};
use maud::{Markup, html};

use super::math::{LINE, display, displays, inline};

/// The field, A and b, the determinant and the map, in lowest terms.
pub fn derived(system: &System) -> Markup {
    let map = RationalMap::of(&system.field);
    let formulas = Formulas { field: &system.field, map: map.as_ref(), notation: &Latex };
    let states: Vec<String> = system.field.symbols.states.iter().map(|state| Latex.name(state)).collect();
    let equations = |accent: &str, values: &[String]| -> Vec<String> {
        states.iter().zip(values).map(|(state, value)| format!("\\{accent}{{{state}}} = {value}")).collect()
    };
    html! {
        h4 { "Field" }
        (displays(&equations("dot", &formulas.field()), LINE))
        h4 { "Matrix" }
        (display(&format!("A(x,\\varepsilon) = {}", matrix(&formulas.matrix())), LINE))
        @if !is_homogeneous(system) {
            (display(&format!("b(x,\\varepsilon) = {}", matrix(&column(formulas.rhs()))), LINE))
        }
        @if let Some(determinant) = formulas.determinant() {
            (display(&format!("\\det A(x,\\varepsilon) = {determinant}"), LINE))
        }
        @if let Some(factor) = formulas.removed_factor() {
            p { "The map has no pole where " (inline(&format!("{factor} = 0"))) ", a factor that cancels." }
        }
        @if let Some(map) = formulas.map() {
            h4 { "Map" }
            (displays(&equations("widetilde", &map), LINE))
        }
    }
}

/// Whether b is x.
fn is_homogeneous(system: &System) -> bool {
    let mut terms = system.field.components.iter().flat_map(|component| component.numerator.terms());
    terms.all(|(monomial, _)| monomial.degree() >= 2)
}

/// What a claim says, a formula each.
pub fn statements(claim: &Claim) -> Markup {
    let index = match claim.kind {
        ClaimKind::Bracket => format!("_{{{}}}", Latex.name(&claim.name.text)),
        _ => String::new(),
    };
    let statements = claim_statement(claim, &Latex).into_iter();
    let formulas: Vec<String> = statements.map(|(left, right)| format!("{left}{index} = {right}")).collect();
    displays(&formulas, LINE)
}

fn column(entries: Vec<String>) -> Vec<Vec<String>> {
    entries.into_iter().map(|entry| vec![entry]).collect()
}

fn matrix(rows: &[Vec<String>]) -> String {
    /// The characters of what stands before a matrix.
    const BEFORE: usize = 10;
    breaking::matrix("pmatrix", rows, LINE - BEFORE)
}
