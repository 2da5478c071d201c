//! HTML for a lift: the quadratic equations, the new variables, and the relations between them.

use kahan_algebra::render::Notation;
use kahan_latex::Latex;
use kahan_study::{LiftFound, WatchedOrbit};
use maud::{Markup, html};

use crate::document::{LINE, Table, display};

/// Returns the HTML of a lift.
#[must_use]
pub fn lift(found: &LiftFound) -> Markup {
    html! {
        h4 { "Quadratic equations, and what their map keeps" }
        pre tabindex="0" { code { (found.field.trim()) } }
        @if !found.new.is_empty() { h4 { "New variables" } }
        @for new in &found.new {
            @match &new.latex {
                Some(latex) => (display(&format!("{} = {latex}", Latex.name(&new.name)), LINE)),
                None => p { code { (new.name) } ", the work done since the start, where it is 0" },
            }
        }
        @if let Some(energy) = &found.energy {
            p { "The map keeps this energy exactly: " code { (energy) } "." }
        }
        p { "The choice: " (found.chosen) "; " (found.optimality()) "." }
        @for note in &found.notes { p.missing { "Note: " (note) "." } }
        @if !found.relations.is_empty() {
            (relations(found))
            @if let Some(WatchedOrbit { start, eps, .. }) = &found.watched {
                p {
                    "They were watched along the orbit from ("
                    @for (k, value) in start.iter().enumerate() { @if k > 0 { ", " } (value) }
                    ") at ε = " (eps) ", over 100 units of time."
                }
            }
        }
    }
}

fn relations(found: &LiftFound) -> Table {
    let rows = found.relations.iter().map(|relation| vec![found.equation(relation), relation.verdict()]);
    Table::new("Relations between the variables", ["relation", "along the orbit"], rows)
}
