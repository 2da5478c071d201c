//! Answers as HTML for the page, set and drawn by `kahan-draw`.

use kahan_algebra::rational::Rational;
use kahan_draw::document::{JACOBIAN, LINE, display};
use kahan_draw::picture::{self, PictureOptions};
use kahan_draw::{Canvas as Paper, answer};
use kahan_latex::breaking;
use kahan_study::{Answer, HeightsFound, LiftFound, FormulaSheet, ShownField};
use maud::{Markup, html};

pub(crate) use kahan_draw::document::readable;

/// The field, A, b, the map, the claims that came with the field; or the Jacobian, where it is
/// asked for. What is shown is LaTeX.
pub(crate) fn formulas(shown: ShownField, of_jacobian: bool) -> String {
    match shown {
        ShownField::Formulas(sheet) if of_jacobian => jacobian(&sheet).into_string(),
        shown => part(&Answer::Show(Box::new(shown))),
    }
}

/// The Jacobian of the map, or how it is found where an entry is too long.
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

/// The new variables of a lift, the relations and their fates.
pub(crate) fn lift(found: &LiftFound) -> String {
    answer::lift(found).into_string()
}

/// What an answer says on a page.
pub(crate) fn part(answer: &Answer) -> String {
    answer::html(answer).map_or_else(String::new, Markup::into_string)
}

/// The heights of an exact orbit as a picture.
pub(crate) fn heights(found: &HeightsFound, eps: &Rational) -> String {
    picture::heights(found, eps, &PictureOptions::on(Paper::page(480, 320))).drawing.inline().into_string()
}
