//! Returns the crossings of orbits with a section as arrays, either all at once or in blocks.

use std::ops::ControlFlow;

use kahan_study::{Column, Crossed, Question, Rows, StoredColumn, Table, Values};
use numpy::IntoPyArray;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::background::{Caller, Listener, run_watched};
use crate::errors::of_study;
use crate::field::Field;
use crate::table::array;

/// The columns of a table, each with name, meaning and values.
type Columns<'py> = Vec<(String, String, Bound<'py, PyAny>)>;
/// The end of each orbit, and for each orbit the numbers of steps, crossings and jumps.
type Ends<'py> = (Vec<&'static str>, [Bound<'py, PyAny>; 3]);

#[pymethods]
impl Field {
    /// Returns the crossings of a section, and how each orbit ended. If `part` is given, it is
    /// called with each block of crossings, and the result holds the last block.
    #[pyo3(name = "_crossings", signature = (question, *, part = None, threads = None, listener = None))]
    fn crossings<'py>(
        &self,
        py: Python<'py>,
        question: &str,
        part: Option<Py<PyAny>>,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Columns<'py>, Ends<'py>)> {
        let study = self.study();
        let Question::Section(asked) = crate::field::question(question)? else {
            return Err(PyValueError::new_err("a question about a section is needed"));
        };
        let listener = Listener(listener);
        let (orbits, rows) = match part {
            None => {
                let found = run_watched(py, threads, &listener, |caller| asked.ask(study, caller))?;
                found.map(|found| (found.orbits, found.rows))
            }
            Some(part) => {
                let columns = asked.columns(study).map_err(|error| of_study(py, &error))?;
                let (found, rows, raised) = run_watched(py, threads, &listener, |caller| {
                    let mut parts = Parts { caller, rows: Table::default(), part, raised: None };
                    let found = asked.find(study, &mut parts, caller);
                    (found, parts.rows, parts.raised)
                })?;
                raised.map_or(Ok(()), Err)?;
                let rows = if rows.values.is_empty() { Table { columns, values: Vec::new() } } else { rows };
                found.map(|orbits| (orbits, rows))
            }
        }
        .map_err(|error| of_study(py, &error))?;
        let columns = in_arrays(py, rows)?;
        let counts = |of: fn(&Crossed) -> u64| {
            let counts: Vec<i64> = orbits.iter().map(|one| of(one) as i64).collect();
            counts.into_pyarray(py).into_any()
        };
        let counts = [counts(|one| one.steps), counts(|one| one.crossings), counts(|one| one.jumps)];
        Ok((columns, (orbits.iter().map(|one| one.end.name()).collect(), counts)))
    }

    /// Returns the derivative of a variable, which is a component of the field, as a formula.
    #[pyo3(name = "_rate")]
    fn rate(&self, py: Python<'_>, variable: &str) -> PyResult<String> {
        self.study().rate(variable).map_err(|error| of_study(py, &error))
    }
}

/// A consumer that passes crossings to Python in large blocks.
struct Parts<'a> {
    caller: &'a Caller,
    rows: Table,
    part: Py<PyAny>,
    /// The exception that Python code raised.
    raised: Option<PyErr>,
}

const AT_ONCE: usize = 1 << 20;

impl Rows for Parts<'_> {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        self.caller.goes_on()?;
        self.rows.block(columns, values)?;
        if self.rows.count() * columns.len() < AT_ONCE {
            return ControlFlow::Continue(());
        }
        let rows = std::mem::take(&mut self.rows);
        let told = Python::attach(|py| self.part.call1(py, (in_arrays(py, rows)?,)).map(|_| ()));
        told.map_or_else(
            |raised| {
                self.raised = Some(raised);
                ControlFlow::Break(())
            },
            ControlFlow::Continue,
        )
    }
}

/// Converts the columns of a table to arrays. An empty table becomes empty arrays of doubles.
fn in_arrays(py: Python<'_>, rows: Table) -> PyResult<Columns<'_>> {
    let mut values = rows.values.into_iter();
    let columns = rows.columns.into_iter().map(|column| {
        let kept = values.next().unwrap_or(StoredColumn::F64(Vec::new()));
        Ok((column.name, column.meaning, array(py, kept)?))
    });
    columns.collect()
}
