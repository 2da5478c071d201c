//! Formulas behind options; what is wrong with them becomes a [`Refusal`].

use kahan_study::formula::{self, Formula, Known, NoFormula};

use crate::printing::Refusal;

/// One formula of the index of a site; `option` is what the text is called in reports.
pub(super) fn formula(text: &str, known: &Known, option: &str) -> Result<Formula, Refusal> {
    formula::formula(text, known).map_err(|why| refused(&why, option))
}

/// Formulas of the index of a site by name: `a = 1; b = i/n`.
pub(super) fn formulas(text: &str, known: &Known, option: &str) -> Result<Vec<(String, Formula)>, Refusal> {
    formula::formulas(text, known).map_err(|why| refused(&why, option))
}

pub(super) fn refused(why: &NoFormula, option: &str) -> Refusal {
    Refusal::reports(why.report(option))
}
