//! What a question about one point or one map says at a cell, in a row of a table.
//!
//! In: where the cell is, and the field at its parameters. Out: entries, a column each. What a
//! search finds must not depend on how fast a machine is, so nobody watches, and degrees end it.

use kahan_algebra::rational::Rational;

use super::cells::Entry;
use crate::rows::{Column, Kept};
use crate::study::Study;

/// A question that [`Over`](super::Over) can ask at each of its cells.
pub(in crate::question) trait AtCell: Sync {
    /// ε and the point of the question as it stands, where it has them.
    fn place(&self) -> (Option<&Rational>, Option<&[Rational]>);

    /// The columns of what is found, in a field of these variables, which are all of a lifted one.
    fn columns(&self, variables: &[String]) -> Vec<(Column, Kept)>;

    /// Asks at another ε and point. The point of a lifted field has its original variables alone.
    /// There are as many entries as columns, also where there is no answer.
    fn entries(&self, eps: &Rational, at: &[Rational], study: &Study) -> Vec<Entry>;
}

/// A column, and where its entries of one kind will be.
pub(in crate::question) fn column<V>(name: &str, meaning: &str, kind: fn(Vec<V>) -> Kept) -> (Column, Kept) {
    (Column { name: name.to_owned(), meaning: meaning.to_owned() }, kind(Vec::new()))
}
