//! Pages of HTML that need no network and no script: what the atlas and the pages of single fields
//! share.
//!
//! Formulas are MathML, drawings are SVG, and the browser is told to fetch nothing.

mod formulas;
mod math;
mod readable;
mod tables;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::plot::{Theme, style, variables};

pub use formulas::{JACOBIAN, claim, formulas};
pub use math::{COLUMN, LINE, cell, display, displays, inline};
pub use readable::readable;
pub use tables::{Rows, Table, table_of_formulas};

/// When a page is made, for its foot.
#[derive(Clone, Debug)]
pub struct Making {
    /// The day: `2026-01-31`.
    pub date: String,
    /// How long it took so far, in seconds.
    pub seconds: f64,
}

/// No style sheet, font or script is fetched, and the browser is told to refuse any; images are
/// those within the page.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The style of pages, of their formulas and of drawings within them, light or dark as the reader
/// has it.
#[must_use]
pub fn style_sheet() -> String {
    [&variables(), include_str!("style.css"), &style(Theme::Viewer)].concat()
}

/// A whole document; `main` is the anchor to which one can skip, and what it is.
pub fn document(title: &str, (anchor, main): (&str, &str), body: &Markup) -> String {
    let document = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { (title) }
                style { (PreEscaped(style_sheet())) }
            }
            body {
                a.skip href=(format!("#{anchor}")) { "Skip to " (main) }
                (body)
            }
        }
    };
    document.into_string()
}

/// Who wrote the page, when, and `again`: how to write it once more.
pub fn colophon(making: &Making, again: &Markup) -> Markup {
    html! {
        footer {
            p {
                "Written by kahan " (env!("CARGO_PKG_VERSION")) " on " time datetime=(making.date) { (making.date) } " in "
                (format!("{:.1}", making.seconds)) " seconds. To write it again: " (again) "."
            }
        }
    }
}
