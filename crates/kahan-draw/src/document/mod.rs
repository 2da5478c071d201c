//! HTML pages that need no network and no script. Formulas are MathML, and drawings are SVG.

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

/// The date of a page and the time spent on it.
#[derive(Clone, Debug)]
pub struct PageCreation {
    /// The day, such as `2026-01-31`.
    pub date: String,
    /// The seconds spent so far.
    pub seconds: f64,
}

/// The content security policy of pages. Only inline styles and `data:` images are allowed.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// Returns the style of pages, formulas and inline drawings, for light and dark viewers.
#[must_use]
pub fn style_sheet() -> String {
    [&variables(), include_str!("style.css"), &style(Theme::Viewer)].concat()
}

/// Returns a page. A link "Skip to `main`" at its top leads to the element with the id `anchor`.
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

/// Writes the footer of a page. `again` shows the command that makes the page again.
pub fn colophon(making: &PageCreation, again: &Markup) -> Markup {
    html! {
        footer {
            p {
                "Written by kahan " (env!("CARGO_PKG_VERSION")) " on " time datetime=(making.date) { (making.date) } " in "
                (format!("{:.1}", making.seconds)) " seconds. To write it again: " (again) "."
            }
        }
    }
}
