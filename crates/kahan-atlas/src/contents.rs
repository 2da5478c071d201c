//! Assembles the page: head, table of contents, sections and colophon.

use maud::{Markup, html};

use super::found::AtlasContent;
use super::{errata, figures, solutions, structures, systems, verification};
use kahan_draw::document::{PageCreation, colophon, document};

const TITLE: &str = "An atlas of Kahan’s maps";

/// Writes the page as one self-contained HTML document.
///
/// Cost: about a second.
#[must_use]
pub fn page(found: &AtlasContent<'_>, making: &PageCreation) -> String {
    let body = html! {
        header {
            h1 { (TITLE) }
            (introduction(found))
        }
        (table_of_contents(found))
        main {
            (systems::section(found))
            (systems::further_systems(found))
            (structures::section(found))
            (solutions::section(found))
            (figures::section(found))
            (verification::section(found))
            (errata::section(found))
            (errata::open_questions())
        }
        (colophon(making, &html! {
            code { "kahan atlas --out DIR" } ", or in the source tree " code { "cargo run --release -p kahan-cli -- atlas --out DIR" }
        }))
    };
    document(TITLE, ("systems", "the systems"), &body)
}

fn introduction(found: &AtlasContent<'_>) -> Markup {
    html! {
        p.lead {
            "Kahan’s method turns a quadratic differential equation into a rational map that can be run forwards and backwards, "
            "and the maps of Hone and Petrera’s paper “Three-dimensional discrete systems of Hirota–Kimura type and deformed "
            "Lie–Poisson algebras” keep much of what makes their flows solvable. This page shows the paper’s systems, tables, "
            "solutions and figures, further systems, and the " (found.claims.len()) " claims by which every formula was checked. All of it was "
            "computed when the page was written: "
            @if found.failed() == 0 { "no claim failed." } @else { b { (found.failed()) " of the claims failed." } }
        }
        (verification::counts(found))
    }
}

fn table_of_contents(found: &AtlasContent<'_>) -> Markup {
    let tables = [("table1", "Table 1"), ("table2", "Table 2"), ("table3", "Table 3"), ("table4", "Table 4")];
    html! {
        nav aria-label="Contents" {
            h2 { "Contents" }
            ol {
                li { a href="#systems" { "The systems" } }
                li { a href="#further" { "Further systems" } }
                li {
                    a href="#tables" { "Tables 1 to 4" }
                    ul { @for (id, title) in tables { li { a href=(format!("#{id}")) { (title) } } } }
                }
                li {
                    a href="#solutions" { "Solutions" }
                    ul { li { a href="#table5" { "Table 5" } } li { a href="#theorem3" { "Theorem 3" } } }
                }
                li {
                    a href="#figures" { "Figures" }
                    ul.long { @for (id, title) in figures::titles(found) { li { a href=(format!("#{id}")) { (title) } } } }
                }
                li { a href="#verification" { "Verification" } }
                li {
                    a href="#errata" { "Errata" }
                    ul { li { a href="#errata-formulas" { "Formulas" } } li { a href="#errata-statements" { "Statements" } } }
                }
                li { a href="#open" { "What is left open" } }
            }
        }
    }
}
