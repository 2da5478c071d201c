//! Shows answers as HTML, and as tables that text output also prints.

mod discovered;
mod lifted;
mod observed;
mod poles;
mod section;
mod traded;

use kahan_study::{Answer, ShownField};
use maud::{Markup, html};

use crate::document::{JACOBIAN, LINE, claim, display, formulas};

pub use discovered::{evaluation, numbers, states_and_images};
pub use lifted::lift;
pub use observed::{convergence, observed, out_of_range};
pub use poles::poles;
pub use section::jumps;
pub use traded::{choice, front};

const MOST_VARIABLES: usize = 8;

/// Returns the HTML of an answer. Returns `None` for answers that pages omit or that
/// [`crate::picture`] draws.
#[must_use]
pub fn html(answer: &Answer) -> Option<Markup> {
    Some(match answer {
        Answer::Show(shown) => match &**shown {
            ShownField::Formulas(sheet) => html! {
                @if sheet.variables.len() <= MOST_VARIABLES {
                    (formulas(sheet))
                    h4 { "Jacobian" }
                    (display(JACOBIAN, LINE))
                } @else {
                    p { (sheet.variables.len()) " variables have formulas too long for a page." }
                }
                @if !sheet.claims.is_empty() { h4 { "What is claimed, and proved" } }
                @for shown in &sheet.claims { (claim(shown, sheet.variables.len(), &html! {})) }
            },
            ShownField::Block { .. } | ShownField::Plan(_) => return None,
        },
        Answer::Observe(seen) => html! {
            @for table in observed(seen) { (table) }
            @if let Some(words) = convergence(seen) { p { (words) } }
            @if let Some(why) = out_of_range(seen) { p.missing { "Note: " (why) "." } }
        },
        Answer::Poles(found) if found.found.patterns.is_empty() => html! {
            p { "The map sends no curve to infinity and blows none down." }
        },
        Answer::Poles(found) => html! { (poles(found)) },
        Answer::Discover(found) => discovered::html(found),
        Answer::Trade(traded) => traded::html(traded),
        _ => return None,
    })
}
