//! Tables 1 to 4, from the text that the claims check.

use maud::{Markup, html};

use super::found::{Checked, Found};
use super::words::{anchor, badge};
use kahan_draw::document::cell;
use kahan_draw::document::readable;
use kahan_paper::formula::latex_of;
use kahan_paper::{Outcome, Structure, structure};
use kahan_systems::registry::SYSTEMS;

/// An expression of the language of claims in LaTeX.
fn latex(expression: &str) -> String {
    // The right-hand side of a definition may be any expression.
    let item = latex_of(&format!("value := {expression}")).ok().and_then(|items| items.into_iter().next());
    item.map_or_else(|| format!("\\text{{{expression}}}"), |item| item.right)
}

/// The cell of a row that is defined by this name.
fn value(row: &Structure, name: &str) -> Markup {
    html! { @if let Some(value) = row.value(name) { (cell(&latex(value))) } }
}

/// The names of a tensor's entries {x,y}, {y,z}, {z,x}; behind them stands `_eps` for a map.
fn entries(tensor: &str, suffix: &str) -> [String; 3] {
    ["12", "23", "31"].map(|entry| format!("{tensor}{entry}{suffix}"))
}

fn rows(wanted: impl Fn(&Structure) -> bool) -> Vec<&'static Structure> {
    SYSTEMS.iter().filter_map(|entry| structure(entry.command)).filter(|row| wanted(row)).collect()
}

/// How the claims whose names begin so came out: the worst of them, with a link to the first.
fn verdict(found: &Found<'_>, names: &[[&str; 2]]) -> Markup {
    let claims: Vec<&Checked<'_>> = names.iter().flat_map(|parts| found.claims_of(parts)).collect();
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

fn name(row: &Structure) -> String {
    row.system.to_uppercase()
}

/// The section.
pub(super) fn section(found: &Found<'_>) -> Markup {
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

fn table(id: &str, caption: &str, head: &[&str], body: &Markup) -> Markup {
    html! {
        div.scroll tabindex="0" {
            table.formulas id=(id) {
                caption { (caption) }
                thead { tr { @for title in head { th scope="col" { (title) } } } }
                tbody { (body) }
            }
        }
    }
}

fn table1(found: &Found<'_>) -> Markup {
    let body = html! {
        @for row in rows(|_| true) {
            tr {
                th scope="row" { (name(row)) }
                @for tensor in ["P", "Q"] {
                    td { div.triple { @for entry in entries(tensor, "") { span { (value(row, &entry)) } } } }
                }
                @for name in ["H", "K", "c"] { td { (value(row, name)) } }
                td { @for algebra in row.algebras { div { (readable(algebra.name)) } } }
                td { (verdict(found, &[["table1", row.system], ["section3", row.system]])) }
            }
        }
    };
    let head = ["System", "P", "Q", "H", "K", "c", "Algebras of P and Q", "Checked"];
    table(
        "table1",
        "Table 1. The Lie–Poisson pairs of the flows; E7 to E9 are those of section 6",
        &head,
        &body,
    )
}

fn table2(found: &Found<'_>) -> Markup {
    let body = html! {
        @for row in rows(Structure::has_map) {
            tr {
                th scope="row" { "d" (name(row)) }
                @for name in ["H_eps", "K_eps"] { td { (value(row, name)) } }
                td { (verdict(found, &[[row.system, "H"], [row.system, "K"]])) }
            }
        }
    };
    table("table2", "Table 2. The integrals of the maps", &["Map", "H(ε)", "K(ε)", "Checked"], &body)
}

fn tensors(found: &Found<'_>, id: &str, caption: &str, tensor: &str) -> Markup {
    let body = html! {
        @for row in rows(Structure::has_map) {
            tr {
                th scope="row" { "d" (name(row)) }
                @for entry in entries(tensor, "_eps") { td { (value(row, &entry)) } }
                td { (verdict(found, &[[id, row.system]])) }
            }
        }
    };
    let [xy, yz, zx] = ["{x,y}", "{y,z}", "{z,x}"].map(|entry| format!("{tensor}(ε) {entry}"));
    table(id, caption, &["Map", &xy, &yz, &zx, "Checked"], &body)
}
