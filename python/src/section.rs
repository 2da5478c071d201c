//! Crossings of orbits as arrays.

use kahan_study::{Crossed, Kept, Question, SectionFound};
use numpy::IntoPyArray;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::beside::{Listener, apart};
use crate::errors::of_study;
use crate::field::Field;
use crate::table::array;

/// The columns of a table with their meanings.
type Columns<'py> = Vec<(String, String, Bound<'py, PyAny>)>;
/// Of each orbit how it ended, its steps, its crossings, and its jumps.
type Ends<'py> = (Vec<&'static str>, [Bound<'py, PyAny>; 3]);

#[pymethods]
impl Field {
    /// The crossings that a question about a section finds, which is JSON: its columns, and how
    /// each orbit ended.
    #[pyo3(name = "_crossings", signature = (question, *, threads = None, listener = None))]
    fn crossings<'py>(
        &self,
        py: Python<'py>,
        question: &str,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Columns<'py>, Ends<'py>)> {
        let study = self.study().clone();
        let Question::Section(asked) = crate::field::question(question)? else {
            return Err(PyValueError::new_err("a question about a section is needed"));
        };
        let found = apart(py, threads, &Listener(listener), move |caller| asked.ask(&study, caller))?;
        let SectionFound { orbits, rows, .. } = found.map_err(|error| of_study(py, &error))?;
        let mut values = rows.values.into_iter();
        let columns = rows.columns.into_iter().map(|column| {
            // Without crossings there are no values.
            let kept = values.next().unwrap_or(Kept::F64(Vec::new()));
            Ok((column.name, column.meaning, array(py, kept)?))
        });
        let columns = columns.collect::<PyResult<_>>()?;
        let counts = |of: fn(&Crossed) -> u64| {
            let counts: Vec<i64> = orbits.iter().map(|one| of(one) as i64).collect();
            counts.into_pyarray(py).into_any()
        };
        let counts = [counts(|one| one.steps), counts(|one| one.crossings), counts(|one| one.jumps)];
        Ok((columns, (orbits.iter().map(|one| one.end.name()).collect(), counts)))
    }

    /// The component of the field that is the derivative of a variable, as a formula.
    #[pyo3(name = "_rate")]
    fn rate(&self, py: Python<'_>, variable: &str) -> PyResult<String> {
        self.study().rate(variable).map_err(|error| of_study(py, &error))
    }
}
