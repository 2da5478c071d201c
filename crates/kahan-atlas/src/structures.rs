//! Tables 1 to 4, typeset from the text that the claims check.

use maud::{Markup, html};

use super::found::{AtlasContent, CheckedClaim};
use super::text::{anchor, badge};
use kahan_draw::document::{cell, readable, table_of_formulas};
use kahan_paper::formula::latex_of;
use kahan_paper::{Outcome, StructureRow, structure};
use kahan_systems::registry::SYSTEMS;

fn latex(expression: &str) -> String {
    // `latex_of` accepts only statements, so the expression becomes the right side of a definition.
    let item = latex_of(&format!("value := {expression}")).ok().and_then(|items| items.into_iter().next());
    item.map_or_else(|| format!("\\text{{{expression}}}"), |item| item.right)
}

fn value(row: &StructureRow, name: &str) -> Markup {
    html! { @if let Some(value) = row.value(name) { (cell(&latex(value))) } }
}

/// Returns the names of a tensor's entries {x,y}, {y,z} and {z,x}, each with `suffix` at its end.
fn entries(tensor: &str, suffix: &str) -> [String; 3] {
    ["12", "23", "31"].map(|entry| format!("{tensor}{entry}{suffix}"))
}

fn rows(wanted: impl Fn(&StructureRow) -> bool) -> Vec<&'static StructureRow> {
    SYSTEMS.iter().filter_map(|entry| structure(entry.command)).filter(|row| wanted(row)).collect()
}

/// Writes the outcome of one claim, with a link to it. A failed claim is preferred, then a claim
/// with a misprint, then the first claim.
fn verdict(found: &AtlasContent<'_>, names: &[[&str; 2]]) -> Markup {
    let claims: Vec<&CheckedClaim<'_>> = names.iter().flat_map(|parts| found.claims_of(parts)).collect();
    let failed = claims.iter().find(|checked| checked.established.outcome == Outcome::Failed);
    let misprint = claims.iter().find(|checked| checked.established.outcome == Outcome::Misprint);
    let shown = failed.or(misprint).or(claims.first());
    match shown {
        None => html! { "not checked" },
        Some(checked) => html! {
            a href=(format!("#{}", anchor(&checked.claim.id))) {
                @if misprint.is_some() && failed.is_none() { span.badge.misprint { "✎ corrected" } }
                @else { (badge(checked.established.outcome)) }
            }
        },
    }
}

fn name(row: &StructureRow) -> String {
    row.system.to_uppercase()
}

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
    html! {
        section #tables {
            h2 { "Tables 1 to 4" }
            p {
                "Every entry is set from the text that its claim checks; the last column says how the row was "
                "established and leads to its claims. A Poisson tensor is given by its brackets {x,y}, {y,z}, {z,x}, one "
                "below the other."
            }
            (table1(found))
            (table2(found))
            (tensors(found, "table3", "Table 3. The tensors P(ε) of the maps", "P"))
            (tensors(found, "table4", "Table 4. The tensors Q(ε) of the maps; the invariant pair is P(ε), Q(ε)/c", "Q"))
        }
    }
}

fn table1(found: &AtlasContent<'_>) -> Markup {
    let cells = |row: &StructureRow| {
        let tensor = |tensor: &str| {
            html! { div.triple { @for entry in entries(tensor, "") { span { (value(row, &entry)) } } } }
        };
        let [h, k, c] = ["H", "K", "c"].map(|name| value(row, name));
        let algebras = html! { @for algebra in row.algebras { div { (readable(algebra.name)) } } };
        let checked = verdict(found, &[["table1", row.system], ["section3", row.system]]);
        vec![html! { (name(row)) }, tensor("P"), tensor("Q"), h, k, c, algebras, checked]
    };
    let headings = ["System", "P", "Q", "H", "K", "c", "Algebras of P and Q", "Checked"];
    let caption = "Table 1. The Lie–Poisson pairs of the flows; E7 to E9 are those of section 6";
    table_of_formulas("table1", caption, &headings, rows(|_| true).into_iter().map(cells))
}

/// Writes a table with a row for each map: its definitions, and the worst outcome of its claims.
fn of_maps<'a, const N: usize>(
    found: &AtlasContent<'_>,
    (id, caption): (&str, &str),
    columns: &[(&str, &str)],
    claims: impl Fn(&'a str) -> [[&'a str; 2]; N],
) -> Markup {
    let cells = |row: &'a StructureRow| {
        let first = html! { "d" (name(row)) };
        let values = columns.iter().map(|(_, name)| value(row, name));
        [first].into_iter().chain(values).chain([verdict(found, &claims(row.system))]).collect()
    };
    let headings = columns.iter().map(|(heading, _)| *heading);
    let headings: Vec<&str> = ["Map"].into_iter().chain(headings).chain(["Checked"]).collect();
    table_of_formulas(id, caption, &headings, rows(StructureRow::has_map).into_iter().map(cells))
}

fn table2(found: &AtlasContent<'_>) -> Markup {
    let columns = [("H(ε)", "H_eps"), ("K(ε)", "K_eps")];
    let about = ("table2", "Table 2. The integrals of the maps");
    of_maps(found, about, &columns, |system| [[system, "H"], [system, "K"]])
}

fn tensors(found: &AtlasContent<'_>, id: &'static str, caption: &str, tensor: &str) -> Markup {
    let headings = ["{x,y}", "{y,z}", "{z,x}"].map(|entry| format!("{tensor}(ε) {entry}"));
    let names = entries(tensor, "_eps");
    let columns: Vec<(&str, &str)> =
        headings.iter().zip(&names).map(|(heading, name)| (heading.as_str(), name.as_str())).collect();
    of_maps(found, (id, caption), &columns, |system| [[id, system]])
}
