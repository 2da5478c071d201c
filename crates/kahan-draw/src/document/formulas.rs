//! Shows the formulas and claims of a field as HTML.

use kahan_algebra::render::Notation;
use kahan_algebra::syntax::ClaimKind;
use kahan_latex::{Latex, breaking};
use kahan_study::{ClaimShown, FormulaSheet};
use maud::{Markup, html};

use super::math::{LINE, display, displays, inline};
use super::readable::readable;

/// The LaTeX formulas that express ∂x̃/∂x and its determinant by A.
pub const JACOBIAN: &str = "\\frac{\\partial\\widetilde x}{\\partial x} = A(x,\\varepsilon)^{-1} A(\\widetilde x,-\\varepsilon), \\qquad \
    \\det\\frac{\\partial\\widetilde x}{\\partial x} = \
    \\frac{\\det A(\\widetilde x,-\\varepsilon)}{\\det A(x,\\varepsilon)}";

/// Writes the field, the matrix A, the vector b, the determinant of A and the map.
pub fn formulas(sheet: &FormulaSheet) -> Markup {
    let states: Vec<String> = sheet.variables.iter().map(|state| Latex.name(state)).collect();
    let equations = |accent: &str, values: &[String]| -> Vec<String> {
        states.iter().zip(values).map(|(state, value)| format!("\\{accent}{{{state}}} = {value}")).collect()
    };
    html! {
        h4 { "Field" }
        (displays(&equations("dot", sheet.field_at_eps.as_ref().unwrap_or(&sheet.field)), LINE))
        h4 { "Matrix" }
        (display(&format!("A(x,\\varepsilon) = {}", matrix(&sheet.matrix)), LINE))
        @if sheet.rhs != states {
            @let column: Vec<_> = sheet.rhs.iter().map(|entry| vec![entry.clone()]).collect();
            (display(&format!("b(x,\\varepsilon) = {}", matrix(&column)), LINE))
        }
        @if let Some(determinant) = &sheet.determinant {
            (display(&format!("\\det A(x,\\varepsilon) = {determinant}"), LINE))
        }
        @if let Some(factor) = &sheet.removed_factor {
            p { "The map has no pole where " (inline(&format!("{factor} = 0"))) ", a factor that cancels." }
        }
        @if let Some(map) = &sheet.map {
            h4 { "Map" }
            (displays(&equations("widetilde", map), LINE))
        }
    }
}

/// Writes a claim with its condition, source and formulas, followed by the text `besides`.
pub fn claim(claim: &ClaimShown, variables: usize, besides: &Markup) -> Markup {
    let is = |kind: ClaimKind| claim.kind == kind.keyword();
    let (kind, index) = match &claim.name {
        name if is(ClaimKind::Bracket) => ("Invariant Poisson bracket", format!("_{{{}}}", Latex.name(name))),
        _ if is(ClaimKind::Density) => ("Invariant density", String::new()),
        _ if is(ClaimKind::Drift) => ("Drift", String::new()),
        _ => ("Integral", String::new()),
    };
    let formulas = claim.equations.iter().map(|(left, right)| format!("{left}{index} = {right}"));
    html! {
        div.preserved {
            p.source {
                (kind)
                @if is(ClaimKind::Bracket) && claim.equations.len() < variables * (variables - 1) / 2 {
                    ", 0 for every other pair of variables"
                }
                @if !claim.when.is_empty() { ", when " (readable(&claim.when)) }
                @if let Some(source) = claim.source { "; " (readable(source)) }
                (besides)
            }
            (displays(&formulas.collect::<Vec<_>>(), LINE))
        }
    }
}

fn matrix(rows: &[Vec<String>]) -> String {
    const BEFORE: usize = 10;
    breaking::matrix("pmatrix", rows, LINE - BEFORE)
}
