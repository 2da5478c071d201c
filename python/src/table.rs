//! Tables of answers, with an array for each column of floats or counts, and a list for each other
//! column.

use kahan_algebra::rational::Rational;
use kahan_study::{ColourColumn, Exact, Question, StoredColumn, Table};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyList;

use crate::background::{Listener, run_detached};
use crate::errors::of_study;
use crate::field::Field;

#[pymethods]
impl Field {
    /// Returns the columns of the table that answers a question, the reason why its rows end, and
    /// the number of steps. `color` is an observable that becomes the last column.
    #[pyo3(name = "_table", signature = (question, *, color = None, threads = None, listener = None))]
    #[expect(clippy::type_complexity, reason = "Python takes it apart at once")]
    fn table<'py>(
        &self,
        py: Python<'py>,
        question: &str,
        color: Option<&str>,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Vec<(String, String, Bound<'py, PyAny>)>, &'static str, u64)> {
        let (mut question, study) = (crate::field::question(question)?, self.study().clone());
        let shade = color.map(|color| ColourColumn::read(color, &study)).transpose();
        let shade = shade.map_err(|error| of_study(py, &error))?;
        if let (Some(shade), Question::Over(over)) = (&shade, &mut question)
            && let Question::Observe(observe) = &mut *over.question
        {
            observe.observe = vec![shade.observable];
        }
        let asked = if let Question::Orbit(orbit) = &question { orbit.steps_in_all() } else { 0 };
        let (table, end) = run_detached(py, threads, &Listener(listener), move |caller| {
            let mut table = Table::default();
            let end = study.rows(&question, 0..u64::MAX, &mut table, caller);
            end.map(|end| (table, end))
        })?
        .map_err(|error| of_study(py, &error))?;
        let shown = shade.map(|shade| {
            let own = table.columns.iter().find(|column| column.name == shade.column);
            let meaning = own.map_or(shade.observable.meaning(), |own| &own.meaning).to_owned();
            (shade.column.clone(), meaning, shade.values(&table).into_pyarray(py).into_any())
        });
        let columns = table.columns.into_iter().zip(table.values);
        let columns = columns.map(|(column, kept)| Ok((column.name, column.meaning, array(py, kept)?)));
        let columns = columns.chain(shown.map(Ok)).collect::<PyResult<_>>()?;
        Ok((columns, end.name(), end.steps(asked)))
    }
}

/// Converts a column: floats and counts to an array, other values to a list.
pub(crate) fn array(py: Python<'_>, kept: StoredColumn) -> PyResult<Bound<'_, PyAny>> {
    Ok(match kept {
        StoredColumn::F64(values) => values.into_pyarray(py).into_any(),
        StoredColumn::F32(values) => values.into_pyarray(py).into_any(),
        StoredColumn::Integer(values) => values.into_pyarray(py).into_any(),
        StoredColumn::Dd(values) => {
            let parts: Vec<f64> = values.iter().flat_map(|value| [value.high(), value.low()]).collect();
            parts.into_pyarray(py).call_method1("reshape", ((-1, 2),))?
        }
        StoredColumn::Text(values) => PyList::new(py, values)?.into_any(),
        StoredColumn::Exact(values) => {
            let values = values.iter().map(|value| fraction(py, value)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, values)?.into_any()
        }
    })
}

/// Converts a number to a Python fraction, an infinite value to a float, a missing one to `None`.
fn fraction<'py>(py: Python<'py>, value: &Exact) -> PyResult<Bound<'py, PyAny>> {
    static FRACTION: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    match value {
        Exact::Number(value) => {
            let value = Rational::from(value);
            let parts = (value.numerator().clone(), value.denominator().clone());
            FRACTION.import(py, "fractions", "Fraction")?.call1(parts)
        }
        Exact::Infinite => Ok(f64::INFINITY.into_pyobject(py)?.into_any()),
        Exact::Undefined => Ok(py.None().into_bound(py)),
    }
}
