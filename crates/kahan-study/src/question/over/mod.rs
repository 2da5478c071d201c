//! A question at every combination of values on some axes, for charts and sweeps. Drawn axes vary
//! together.
//!
//! The answer is a table with a row for each cell (combination). The field, the question and the
//! row's number determine a row, independently of threads, time and other rows.

mod at_cell;
mod axis;
mod cells;
mod orbits;
mod parallel_blocks;

use std::ops::{ControlFlow, Range};

use kahan_algebra::rational::Rational;
use kahan_discover::Watch;
use kahan_runtime::End;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value, json};

use super::{Question, one};
use crate::axes;
use crate::error::StudyError;
use crate::misread::{Misread, read};
use crate::numbers::exact;
use crate::rows::{Column, MOST_CELLS, Rows, StoredColumn, Table};
use crate::study::Study;

use orbits::Orbits;
use parallel_blocks::in_parallel_blocks;

pub(super) use at_cell::{AtCell, column};
pub use axis::{AxisOver, AxisValues, Source};
pub(super) use cells::{CellEntry, Cells};

/// A question asked at each combination of axis values: [`Observe`](super::Observe), or a question
/// about a point or a map, such as [`Heights`](super::Heights).
///
/// The JSON has the fields of the question and `over`, and optionally `starts`, `draws` and `seed`:
/// `{"ask": "heights", "steps": 9, "over": {"x": "0:1:/9", "y": 1, "eps": ["1/10", "1/20"]}}`. The
/// question's `at` and `eps` may be left out if axes give all their values.
#[derive(Clone, Debug, PartialEq)]
pub struct Over {
    /// The question. The values of the axes replace those of the question.
    pub question: Box<Question>,
    /// The axes. All combinations of their values occur, but drawn axes vary together.
    pub over: Vec<AxisOver>,
    /// The first points; empty to use the question's point.
    pub starts: Vec<Vec<Rational>>,
    /// The number of values of each drawn axis.
    pub draws: u64,
    /// The seed of random draws.
    pub seed: u64,
}

/// The fields of [`Over`] in JSON, without the question.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct OverFields {
    #[serde(with = "axes")]
    over: Vec<AxisOver>,
    #[serde(default, with = "exact")]
    starts: Vec<Vec<Rational>>,
    #[serde(default = "one")]
    draws: u64,
    #[serde(default = "one")]
    seed: u64,
}

/// The answer to [`Over`]: a row for each cell, with the cell's coordinates and the results. NaN is
/// null in JSON.
#[derive(Clone, Debug, Serialize)]
pub struct OverFound {
    /// The name of the system.
    pub system: String,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The rows.
    pub rows: Table,
}

impl Over {
    /// Returns an error if drifts of integrals are requested explicitly, but none are claimed.
    pub fn has_integrals(&self, study: &Study) -> Result<(), StudyError> {
        match &*self.question {
            Question::Observe(asked) => asked.has_integrals(study),
            _ => Ok(()),
        }
    }

    /// Asks the question at all combinations of the axes' values. A random axis gets one draw.
    #[must_use]
    pub fn new(question: Question, over: Vec<AxisOver>) -> Self {
        Over { question: Box::new(question), over, starts: Vec::new(), draws: 1, seed: 1 }
    }

    pub(super) fn read(name: &str, mut object: Map<String, Value>) -> Result<Self, Misread> {
        let keys = ["over", "starts", "draws", "seed"];
        let beside = keys.into_iter().filter_map(|key| Some((key.to_owned(), object.remove(key)?)));
        let OverFields { over, starts, draws, seed } = read(beside.collect::<Map<_, _>>().into())?;
        if object.contains_key("seconds") {
            return Err(Misread::at("seconds", "no clock ends a row; leave `seconds` out"));
        }
        // A search for preserved structures needs no first point, and may leave ε generic.
        if name != "discover" {
            object.entry("at").or_insert_with(|| json!([]));
            if over.iter().any(|axis| axis.name == "eps") {
                object.entry("eps").or_insert_with(|| json!(0));
            }
        }
        let question = Box::new(Question::from_fields(name, object)?);
        Ok(Over { question, over, starts, draws, seed })
    }

    fn to_json(&self) -> Map<String, Value> {
        let Over { question, over, starts, draws, seed } = self.clone();
        let mut object = Map::from_iter([("ask".to_owned(), json!(question.name()))]);
        if let Some(Value::Object(own)) = question.rest() {
            let is_gone_through = over.iter().any(|axis| axis.name == "eps");
            let is_kept = |(name, value): &(String, Value)| match &**name {
                "eps" => !is_gone_through && !value.is_null(),
                "at" => value.as_array().is_none_or(|at| !at.is_empty()),
                "seconds" => false,
                _ => true,
            };
            object.extend(own.into_iter().filter(is_kept));
        }
        if let Value::Object(beside) = json!(OverFields { over, starts, draws, seed }) {
            object.extend(beside);
        }
        object
    }

    /// Answers the question at all cells.
    ///
    /// # Errors
    /// [`StudyError`]: the errors of [`rows`](Study::rows), or more than [`MOST_CELLS`] cells.
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

    /// Returns the number of cells.
    ///
    /// # Errors
    /// [`StudyError`]: axes that are unknown, given twice, or empty, or more than 2⁶² cells.
    pub fn cells(&self, study: &Study) -> Result<u64, StudyError> {
        Ok(Cells::of(self, study)?.count)
    }

    /// Passes the rows of a range of cells to a consumer, block by block. An empty range gives one
    /// block without rows, which describes the columns.
    pub(super) fn rows(
        &self,
        study: &Study,
        range: Range<u64>,
        rows: &mut dyn Rows,
        watch: &dyn Watch,
    ) -> Result<End, StudyError> {
        let cells = Cells::of(self, study)?;
        let found = match &*self.question {
            Question::Observe(asked) => CellRows::Orbits(Orbits::of(study, &cells, asked)?),
            other => CellRows::OneByOne(other.at_cell()?),
        };
        let (of_found, block) = match &found {
            CellRows::Orbits(orbits) => (orbits.columns(), orbits.at_once()),
            CellRows::OneByOne(asked) => (asked.columns(study.variables()), [1, 256]),
        };
        let (columns, kept): (Vec<Column>, Vec<StoredColumn>) =
            cells.columns(study.coordinates()).into_iter().chain(of_found).unzip();
        let empty = Table { columns, values: kept };
        let range = range.start.min(cells.count)..range.end.min(cells.count);
        if range.is_empty() {
            let _ = empty.pass_to(rows);
            return Ok(End::Complete);
        }
        let make = |own: Range<u64>, goes_on: &dyn Fn(u64) -> bool| {
            // Consecutive cells often have equal parameters, so cache the last field.
            let (mut table, mut field) = (empty.clone(), None);
            match &found {
                CellRows::Orbits(orbits) if goes_on(0) => {
                    let tell =
                        |_| if goes_on(0) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
                    orbits.rows(own, &tell).into_iter().for_each(|row| push(&mut table, row));
                    goes_on(table.count() as u64);
                }
                CellRows::Orbits(_) => {}
                CellRows::OneByOne(asked) => {
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
        Ok(in_parallel_blocks(range, block, &make, rows, watch))
    }

    fn begins(&self, study: &Study) -> Result<(Rational, Vec<Rational>), StudyError> {
        let is_varied = |name: &str| self.over.iter().any(|axis| axis.name == name);
        let (eps, at) = match &*self.question {
            Question::Observe(asked) => (Some(&asked.eps), Some(&asked.at[..])),
            Question::Section(asked) => (asked.eps.as_ref(), Some(&asked.at[..])),
            other => other.at_cell()?.place(),
        };
        let at = match at {
            Some(at) if !at.is_empty() => {
                study.has_coordinates(at)?;
                at.to_vec()
            }
            of_axes => {
                let is_missing =
                    |name: &&String| of_axes.is_some() && self.starts.is_empty() && !is_varied(name);
                let names: Vec<String> = study.coordinates().iter().filter(is_missing).cloned().collect();
                if !names.is_empty() {
                    return Err(StudyError::MissingCoordinates { names });
                }
                vec![Rational::zero(); study.coordinates().len()]
            }
        };
        let eps = eps.cloned().or(is_varied("eps").then(Rational::zero)).ok_or(StudyError::MissingStep)?;
        Ok((eps, at))
    }
}

impl Serialize for Over {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.to_json().serialize(serializer)
    }
}

enum CellRows<'a> {
    /// Orbits, followed in SIMD lanes.
    Orbits(Orbits<'a>),
    /// Another question, asked at one cell after another.
    OneByOne(&'a dyn AtCell),
}

fn push(table: &mut Table, row: Vec<CellEntry>) {
    for (kept, entry) in table.values.iter_mut().zip(row) {
        match (kept, entry) {
            (StoredColumn::Integer(list), CellEntry::Integer(entry)) => list.push(entry),
            (StoredColumn::F64(list), CellEntry::Float(entry)) => list.push(entry),
            (StoredColumn::Text(list), CellEntry::Text(entry)) => list.push(entry),
            (kept, entry) => unreachable!("{entry:?} in {kept:?}"),
        }
    }
}
