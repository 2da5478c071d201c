//! Shows answers as HTML for the page, by means of `kahan-draw`.

use kahan_algebra::rational::Rational;
use kahan_draw::document::{JACOBIAN, LINE, display};
use kahan_draw::picture::{self, PictureOptions};
use kahan_draw::{Canvas as Paper, answer};
use kahan_latex::breaking;
use kahan_study::{Answer, FormulaSheet, HeightsFound, LiftFound, ShownField};
use maud::{Markup, html};

pub(crate) use kahan_draw::document::readable;

/// Returns the formulas of a field as HTML; if `of_jacobian`, only the Jacobian of the map.
pub(crate) fn formulas(shown: ShownField, of_jacobian: bool) -> String {
    match shown {
        ShownField::Formulas(sheet) if of_jacobian => jacobian(&sheet).into_string(),
        shown => part(&Answer::Show(Box::new(shown))),
    }
}

/// Shows the formula for the map's Jacobian matrix, and its entries if they are short.
fn jacobian(sheet: &FormulaSheet) -> Markup {
    html! {
        (display(JACOBIAN, LINE))
        @if let Some(rows) = &sheet.jacobian {
            (display(&format!("\\frac{{\\partial\\widetilde x}}{{\\partial x}} = {}", breaking::matrix("pmatrix", rows, LINE - 10)), LINE))
        } @else {
            p { "Its entries are too long to be written out." }
        }
    }
}

/// Returns the new variables of a lift, the relations, and the behaviour of their errors.
pub(crate) fn lift(found: &LiftFound) -> String {
    answer::lift(found).into_string()
}

/// Returns the HTML that shows an answer on a page.
pub(crate) fn part(answer: &Answer) -> String {
    answer::html(answer).map_or_else(String::new, Markup::into_string)
}

/// Returns a picture of the heights log max(|p|, |q|) of coordinates p/q along an exact orbit.
pub(crate) fn heights(found: &HeightsFound, eps: &Rational) -> String {
    picture::heights(found, eps, &PictureOptions::on(Paper::page(480, 320))).drawing.inline().into_string()
}
