//! Rows of a table for a question that is asked at each combination of axis values.
//!
//! Searches are limited by degree, and heights by digits. No time limit applies, so that results do
//! not depend on the machine.

use kahan_algebra::rational::Rational;

use super::cells::CellEntry;
use crate::rows::{Column, StoredColumn};
use crate::study::Study;

/// A question that [`Over`](super::Over) can ask at each of its cells.
pub(in crate::question) trait AtCell: Sync {
    fn place(&self) -> (Option<&Rational>, Option<&[Rational]>);

    /// Returns the columns of the results for a field with these variables.
    fn columns(&self, variables: &[String]) -> Vec<(Column, StoredColumn)>;

    /// Asks the question, with this ε and this point in place of its own. Returns an entry for each
    /// column even if the question has no answer.
    fn entries(&self, eps: &Rational, at: &[Rational], study: &Study) -> Vec<CellEntry>;
}

pub(in crate::question) fn column<V>(
    name: &str,
    meaning: &str,
    kind: fn(Vec<V>) -> StoredColumn,
) -> (Column, StoredColumn) {
    (Column { name: name.to_owned(), meaning: meaning.to_owned() }, kind(Vec::new()))
}
