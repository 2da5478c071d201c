//! A question at every value of some axes: a chart, or a sweep.
//!
//! In: a question, and what goes through values. Out: a table with a row a cell. Cells are
//! numbered: first points run most slowly, then the axes, of which the last runs fastest, and the
//! draws, which go through all drawn axes together, run fastest of all. A row depends on its number
//! alone, and not on where, when, and beside what it is computed.

mod at_cell;
mod axis;
mod cells;
mod orbits;
mod waves;

use std::ops::{ControlFlow, Range};

use kahan_algebra::rational::Rational;
use kahan_discover::Watch;
use kahan_runtime::End;
use serde::{Deserialize, Serialize};

use super::{Question, one};
use crate::error::StudyError;
use crate::numbers::exact;
use crate::rows::{Column, Kept, MOST_CELLS, Rows, Table};
use crate::study::Study;

use cells::Cells;
use orbits::Orbits;
use waves::in_waves;

pub(super) use at_cell::{AtCell, column};
pub use axis::{Source, Through, Varied};
pub(super) use cells::Entry;

/// Asks a question at every value of some axes: [`Observe`](super::Observe), or one about a point
/// or a map, such as [`Heights`](super::Heights).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Over {
    /// What is asked; what goes through values takes the place of what stands there.
    pub question: Box<Question>,
    /// What goes through which values. All are multiplied with each other, but for those that are
    /// drawn.
    #[serde(default)]
    pub axes: Vec<Varied>,
    /// First points that are gone through, a coordinate for each variable; none where the
    /// question's is the only one.
    #[serde(default, with = "exact")]
    pub starts: Vec<Vec<Rational>>,
    /// How many values each drawn axis has.
    #[serde(default = "one")]
    pub draws: u64,
    /// The seed of what is drawn at random.
    #[serde(default = "one")]
    pub seed: u64,
}

/// A row a cell: where it is, and what was found there. What is not a number is null in JSON.
#[derive(Clone, Debug, Serialize)]
pub struct OverFound {
    /// The name of the system.
    pub system: String,
    /// The columns by name.
    pub columns: Vec<String>,
    /// The rows.
    pub rows: Table,
}

impl Over {
    /// Of one draw.
    #[must_use]
    pub fn new(question: Question, axes: Vec<Varied>) -> Self {
        Over { question: Box::new(question), axes, starts: Vec::new(), draws: 1, seed: 1 }
    }

    /// All cells. Costs the question at each.
    ///
    /// # Errors
    /// [`StudyError`]: as [`rows`](Study::rows), and more than [`MOST_CELLS`] cells.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<OverFound, StudyError> {
        let cells = self.cells(study)?;
        if cells > MOST_CELLS {
            return Err(StudyError::ManyCells { cells });
        }
        let mut rows = Table::default();
        self.rows(study, 0..cells, &mut rows, watch)?;
        let columns = rows.columns.iter().map(|column| column.name.clone()).collect();
        Ok(OverFound { system: study.name().to_owned(), columns, rows })
    }

    /// How many cells there are.
    ///
    /// # Errors
    /// [`StudyError`]: axes that the field does not have, or that are given twice, or without
    /// values; more than 2⁶² cells.
    pub fn cells(&self, study: &Study) -> Result<u64, StudyError> {
        Ok(Cells::of(self, study)?.count)
    }

    /// The rows of these cells, a block after the other. Of no cells there is one block without
    /// rows, which says what the columns are.
    pub(super) fn rows(
        &self,
        study: &Study,
        range: Range<u64>,
        rows: &mut dyn Rows,
        watch: &dyn Watch,
    ) -> Result<End, StudyError> {
        let cells = Cells::of(self, study)?;
        let found = match &*self.question {
            Question::Observe(asked) => Found::Orbits(Orbits::of(study, &cells, asked)?),
            other => Found::OneByOne(other.at_cell()?),
        };
        let (of_found, block) = match &found {
            Found::Orbits(orbits) => (orbits.columns(), orbits.at_once()),
            Found::OneByOne(asked) => (asked.columns(study.variables()), [1, 256]),
        };
        let (columns, kept): (Vec<Column>, Vec<Kept>) =
            cells.columns(study.coordinates()).into_iter().chain(of_found).unzip();
        let empty = Table { columns, values: kept };
        let range = range.start.min(cells.count)..range.end.min(cells.count);
        if range.is_empty() {
            let _ = empty.hand_to(rows);
            return Ok(End::Complete);
        }
        let make = |own: Range<u64>, goes_on: &dyn Fn(u64) -> bool| {
            // Of cells that follow each other many have the same parameters.
            let (mut table, mut field) = (empty.clone(), None);
            match &found {
                Found::Orbits(orbits) if goes_on(0) => {
                    let tell =
                        |_| if goes_on(0) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
                    orbits.rows(own, &tell).into_iter().for_each(|row| push(&mut table, row));
                    goes_on(table.count() as u64);
                }
                Found::Orbits(_) => {}
                Found::OneByOne(asked) => {
                    for index in own.take_while(|_| goes_on(0)) {
                        let (place, (in_doubles, values)) = (cells.exactly(index), cells.in_doubles(index));
                        let given: Vec<_> = place.parameters.into_iter().map(Some).collect();
                        let known = field.take().filter(|known: &Study| *known.given() == given);
                        let own = field.insert(known.unwrap_or_else(|| study.at(given)));
                        let mut row = cells.entries(index, &in_doubles, &values);
                        row.extend(asked.entries(&place.eps, &place.at, own));
                        push(&mut table, row);
                        goes_on(1);
                    }
                }
            }
            table
        };
        Ok(in_waves(range, block, &make, rows, watch))
    }

    /// ε and the first point where no axis changes them.
    fn begins(&self, study: &Study) -> Result<(Rational, Vec<Rational>), StudyError> {
        let (eps, at) = match &*self.question {
            Question::Observe(asked) => (Some(&asked.eps), Some(&asked.at[..])),
            other => other.at_cell()?.place(),
        };
        let at = match at {
            Some(at) => {
                study.has_coordinates(at)?;
                at.to_vec()
            }
            None => vec![Rational::zero(); study.coordinates().len()],
        };
        let is_varied = self.axes.iter().any(|axis| axis.name == "eps");
        let eps = eps.cloned().or(is_varied.then(Rational::zero)).ok_or(StudyError::MissingStep)?;
        Ok((eps, at))
    }
}

/// By what cells are answered.
enum Found<'a> {
    /// Orbits side by side.
    Orbits(Orbits<'a>),
    /// The question at each.
    OneByOne(&'a dyn AtCell),
}

/// Adds a row.
fn push(table: &mut Table, row: Vec<Entry>) {
    for (kept, entry) in table.values.iter_mut().zip(row) {
        match (kept, entry) {
            (Kept::Integer(list), Entry::Integer(entry)) => list.push(entry),
            (Kept::F64(list), Entry::Float(entry)) => list.push(entry),
            (Kept::Text(list), Entry::Text(entry)) => list.push(entry),
            (kept, entry) => unreachable!("{entry:?} in {kept:?}"),
        }
    }
}
