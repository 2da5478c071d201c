//! Hirota–Kimura bases that a search found, and their coefficients along orbits.

use kahan_algebra::rational::Rational;
use kahan_discover::orbits::basis::BasisError;
use kahan_study::Answer;
use kahan_study::numbers::number;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::doubles;
use crate::background::{Listener, run_detached, run_watched};
use crate::errors::of_study;
use crate::field::{Field, question};

/// Monomials that satisfy one linear relation along every orbit. `kahan.Basis` is derived from this
/// class.
#[pyclass(frozen, module = "kahan._kahan")]
pub(crate) struct Relation(kahan_discover::Basis);

/// The arguments of the constructor `new`, in their order.
type Parts = (Vec<Vec<u32>>, Vec<Vec<(usize, i64)>>, usize, Vec<usize>, Option<u32>);

#[pymethods]
impl Relation {
    #[new]
    fn new(
        monomials: Vec<Vec<u32>>,
        terms: Vec<Vec<(usize, i64)>>,
        unit: usize,
        integrals: Vec<usize>,
        proof: Option<u32>,
    ) -> PyResult<Self> {
        let width = monomials.len();
        let mut places: Vec<usize> = terms.iter().flatten().map(|&(place, _)| place).collect();
        places.sort_unstable();
        let is_whole = places == (0..width).collect::<Vec<_>>() && terms.iter().all(|term| !term.is_empty());
        let is_even = monomials.iter().all(|exponents| exponents.len() == monomials[0].len());
        let is_within = [unit].iter().chain(&integrals).all(|&place| place < width);
        if !(is_whole && is_even && is_within) {
            return Err(PyValueError::new_err("these are no parts of a relation; take it from a discovery"));
        }
        Ok(Relation(kahan_discover::Basis { monomials, terms, unit, integrals, proof }))
    }

    /// Returns the arguments of the constructor, which pickling needs.
    fn __getnewargs__(&self) -> Parts {
        let kahan_discover::Basis { monomials, terms, unit, integrals, proof } = self.0.clone();
        (monomials, terms, unit, integrals, proof)
    }

    /// The exponents of the variables, with a row for each monomial.
    #[getter]
    fn exponents(&self) -> Vec<Vec<u32>> {
        self.0.monomials.clone()
    }

    /// The indices of the coefficients that are independent integrals.
    #[getter]
    fn places(&self) -> Vec<usize> {
        self.0.integrals.clone()
    }

    /// Returns the coefficients along orbits, and the condition number of the equations for them.
    /// `orbits` has the shape (orbits, points, variables). Undetermined coefficients are NaN.
    fn solve<'py>(
        &self,
        orbits: &Bound<'py, PyAny>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyArray1<f64>>)> {
        let py = orbits.py();
        let orbits = doubles(orbits, "x")?;
        let &[count, points, variables] = orbits.shape() else {
            return Err(PyValueError::new_err("x: orbits have the shape (orbits, points, variables)"));
        };
        let (numbers, width) = (orbits.as_slice()?, self.0.monomials.len());
        let mut values = Vec::with_capacity(count * width);
        let mut conditions = Vec::with_capacity(count);
        let solved = run_watched(py, Some(1), &Listener(None), |caller| {
            let orbits = numbers.chunks_exact((points * variables).max(1));
            for orbit in orbits.take_while(|_| !caller.wants_no_more()) {
                let orbit: Vec<Vec<f64>> =
                    orbit.chunks_exact(variables.max(1)).map(<[f64]>::to_vec).collect();
                match self.0.evaluate(&orbit) {
                    Ok(found) => {
                        values.extend(found.coefficients);
                        conditions.push(found.condition);
                    }
                    Err(BasisError::NotFinite | BasisError::Undetermined) => {
                        values.extend(std::iter::repeat_n(f64::NAN, width));
                        conditions.push(f64::INFINITY);
                    }
                    Err(error) => return Err(error),
                }
            }
            Ok(())
        })?;
        solved.map_err(|error| refused(&error))?;
        let values = PyArray1::from_vec(py, values).reshape([conditions.len(), width])?;
        Ok((values.into_any(), PyArray1::from_vec(py, conditions)))
    }

    /// Returns the exact coefficients along the orbit with these points. All numbers are text.
    fn solve_exactly(&self, orbit: Vec<Vec<String>>) -> PyResult<Vec<String>> {
        let point = |point: &Vec<String>| point.iter().map(|value| number(value)).collect();
        let orbit: Result<Vec<Vec<Rational>>, _> = orbit.iter().map(point).collect();
        let orbit = orbit.map_err(|why| PyValueError::new_err(format!("x: {why}")))?;
        let found = self.0.evaluate_exact(&orbit).map_err(|error| refused(&error))?;
        Ok(found.iter().map(Rational::to_string).collect())
    }
}

fn refused(error: &BasisError) -> PyErr {
    PyValueError::new_err(format!("x: {error}"))
}

#[pymethods]
impl Field {
    /// Answers the question `discover` as `ask` does, and also returns the bases that were found.
    #[pyo3(name = "_discovered", signature = (asked, *, listener = None))]
    fn discovered(
        &self,
        py: Python<'_>,
        asked: &str,
        listener: Option<Bound<'_, PyAny>>,
    ) -> PyResult<(String, Vec<Relation>)> {
        let (asked, study) = (question(asked)?, self.study().clone());
        let found = run_detached(py, None, &Listener(listener), move |caller| study.ask(&asked, caller))?;
        let Answer::Discover(found) = found.map_err(|error| of_study(py, &error))? else {
            return Err(PyValueError::new_err("this question discovers nothing"));
        };
        let json = serde_json::to_string(&found).expect("answers are JSON");
        Ok((json, found.report.bases.into_iter().map(Relation).collect()))
    }
}
