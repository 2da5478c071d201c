//! The sections on Table 5 and Theorem 3: solutions of flows and maps.

use maud::{Markup, html};

use super::found::AtlasContent;
use super::text::{anchor, badge};
use kahan_draw::document::{cell, inline, table_of_formulas};
use kahan_paper::formula::{LatexItem, latex_of};
use kahan_paper::{Id, Outcome};
use kahan_systems::entry::Entry;
use kahan_systems::registry::SYSTEMS;

const STATES: [&str; 3] = ["x", "y", "z"];
const INTEGRALS: [&str; 2] = ["H", "K"];

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
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

fn table(found: &AtlasContent<'_>, id: &str, caption: &str, prefix: &str) -> Markup {
    let solved = |system: &&Entry| found.claim(&Id::of([id, system.command, "x"])).is_some();
    let integrals = if prefix.is_empty() { INTEGRALS } else { ["H(ε)", "K(ε)"] };
    let headings = [&["System"][..], &STATES, &integrals].concat();
    let cells = |system: &Entry| {
        let names = STATES.into_iter().chain(INTEGRALS);
        let entries = names.map(|name| entry(found, [id, system.command, name]));
        [html! { (prefix) (system.name) }].into_iter().chain(entries).collect()
    };
    table_of_formulas(id, caption, &headings, SYSTEMS.iter().filter(solved).map(cells))
}

/// Writes a table's cell with a link to its claim. `cell_of` names the table, system and column.
fn entry(found: &AtlasContent<'_>, cell_of: [&str; 3]) -> Markup {
    let Some(checked) = found.claim(&Id::of(cell_of)) else { return html! { "not checked" } };
    let items = latex_of(&checked.claim.statement).unwrap_or_default();
    // The first item of a statement defines a solution. The last one is an integral's value.
    let formula = match items.first() {
        Some(LatexItem { sign: "\\coloneqq", right, .. }) if !INTEGRALS.contains(&cell_of[2]) => Some(right),
        _ => items.last().map(|item| &item.right),
    };
    html! {
        @if let Some(formula) = formula {
            a.quiet href=(format!("#{}", anchor(&checked.claim.id))) { (cell(formula)) }
        }
        @if checked.established.outcome == Outcome::Failed { (badge(Outcome::Failed)) }
    }
}
