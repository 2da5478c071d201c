//! Table 5 and Theorem 3: the solutions of the flows and of the maps, from the statements of their claims.

use maud::{Markup, html};

use super::found::Found;
use super::math::{cell, inline};
use super::words::{anchor, badge};
use kahan_paper::Outcome;
use kahan_paper::formula::{LatexItem, latex_of};
use kahan_systems::entry::Entry;
use kahan_systems::registry::SYSTEMS;

const CELLS: [&str; 5] = ["x", "y", "z", "H", "K"];

/// The section.
pub(super) fn section(found: &Found<'_>) -> Markup {
    html! {
        section #solutions {
            h2 { "Solutions" }
            p {
                "Table 5 solves the flows, with " (inline("T = t + \\alpha")) ", and Theorem 3 the maps, with "
                (inline("N(n) = n + \\tau")) ", " (inline("T(n) = 2\\delta n + \\kappa")) " and "
                (inline("v(n) = 2\\delta n + \\kappa")) "; one step is " (inline("n \\to n + 1"))
                ". Elliptic functions have the modulus " (inline("k")) ". The last columns are the values of the integrals."
            }
            (table(found, "table5", "Table 5. The solutions of the flows", ""))
            (table(found, "theorem3", "Theorem 3. The solutions of the maps", "d"))
        }
    }
}

fn table(found: &Found<'_>, id: &str, caption: &str, prefix: &str) -> Markup {
    let solved = |system: &&Entry| found.claim(&format!("{id}.{}.x", system.command)).is_some();
    let integrals = if prefix.is_empty() { ["H", "K"] } else { ["H(ε)", "K(ε)"] };
    html! {
        div.scroll tabindex="0" {
            table.formulas id=(id) {
                caption { (caption) }
                thead { tr {
                    th scope="col" { "System" }
                    @for title in ["x", "y", "z"].iter().chain(&integrals) { th scope="col" { (title) } }
                } }
                tbody {
                    @for system in SYSTEMS.iter().filter(solved) {
                        tr {
                            th scope="row" { (prefix) (system.name) }
                            @for name in CELLS { td { (entry(found, &format!("{id}.{}.{name}", system.command))) } }
                        }
                    }
                }
            }
        }
    }
}

/// What a claim says of one cell, linked to the claim.
fn entry(found: &Found<'_>, id: &str) -> Markup {
    let Some(checked) = found.claim(id) else { return html! { "not checked" } };
    let items = latex_of(&checked.claim.statement).unwrap_or_default();
    // A solution is defined first; a value is the right-hand side of the last relation.
    let formula = match items.first() {
        Some(LatexItem { sign: "\\coloneqq", right, .. }) if !id.ends_with(['H', 'K']) => Some(right),
        _ => items.last().map(|item| &item.right),
    };
    html! {
        @if let Some(formula) = formula {
            a.quiet href=(format!("#{}", anchor(id))) { (cell(formula)) }
        }
        @if checked.established.outcome == Outcome::Failed { (badge(Outcome::Failed)) }
    }
}
