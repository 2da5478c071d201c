//! Chains with any number of sites. A state is an array with a row for each site.

use std::sync::{Mutex, PoisonError};

use kahan_runtime::{ChainAt, FieldText, Follow, Lattice};
use kahan_study::{Catalog, StudyError, Systems};
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Eps, Places, doubles, named, places};
use crate::background::{Listener, run_watched};
use crate::errors::{of_dimension, of_study};

/// Returns whether a text describes a family, which has chains of any number of sites.
#[pyfunction]
pub(crate) fn is_family(text: &str) -> bool {
    matches!(FieldText::new(text.to_owned(), "field".to_owned()).family(), Ok(Some(_)))
}

/// A chain at one eps. `kahan.Lattice` is derived from this class.
#[pyclass(subclass, frozen, module = "kahan._kahan")]
pub(crate) struct Chain {
    lattice: Lattice,
    sites: usize,
    /// The map, whose scratch memory allows one call at a time.
    at: Mutex<ChainAt>,
}

#[pymethods]
impl Chain {
    /// Reads a family from a text, or takes the family of the catalog with this name. Each
    /// parameter has one number, or one number for each site.
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        sites: usize,
        eps: Eps,
        values: Vec<(String, Bound<'_, PyAny>)>,
    ) -> PyResult<Self> {
        let text = match Systems.find(text) {
            Some(named) => FieldText::new(named.text.to_owned(), named.name.to_owned()),
            None => FieldText::new(text.to_owned(), "field".to_owned()),
        };
        let family = text.family().map_err(StudyError::Field);
        let family = family.and_then(|family| family.ok_or(StudyError::NoFamily));
        let lattice = Lattice::of(&family.map_err(|error| of_study(py, &error))?);
        let values = values.into_iter().map(|(name, given)| {
            let numbers = doubles(&given, &name)?.as_slice()?.to_vec();
            Ok((name, numbers))
        });
        let values = values.collect::<PyResult<Vec<_>>>()?;
        let at =
            lattice.at(eps.0, sites, values).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(Chain { lattice, sites, at: Mutex::new(at) })
    }

    /// The arrays of the family, in their order within a site.
    #[getter]
    fn arrays(&self) -> &[String] {
        self.lattice.arrays()
    }

    /// Finds the columns of the chain's arrays among these names.
    #[pyo3(name = "_matched")]
    fn columns(&self, names: Vec<String>, name: &str, varies: bool) -> PyResult<Places> {
        let arrays = self.lattice.arrays();
        places(&names, (arrays, arrays.len()), &[], varies, name)
    }

    /// The number of sites.
    #[getter]
    fn sites(&self) -> usize {
        self.sites
    }

    /// Returns the state after `steps` steps, in an array of the same shape as the given state.
    #[pyo3(signature = (state, steps = 1, *, listener = None))]
    fn advance<'py>(
        slf: &Bound<'py, Self>,
        state: &Bound<'py, PyAny>,
        steps: u64,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (py, own) = (state.py(), slf.get());
        let state = doubles(&named(state, slf, "state")?, "state")?;
        let mut x = own.state(&state)?;
        let followed = run_watched(py, Some(1), &Listener(listener), |caller| {
            let at = own.at.lock().unwrap_or_else(PoisonError::into_inner);
            at.follow(&mut x, steps, |made| caller.made(made, steps))
        })?;
        let followed = followed.map_err(|error| of_dimension(&error))?;
        if followed.end.steps(steps) < steps {
            // A state that left the range of floats becomes NaN.
            x.fill(f64::NAN);
        }
        x.into_pyarray(py).reshape(state.shape())
    }

    /// Returns the integrals, the Hamiltonian and the modified energy at a state, by name.
    #[pyo3(name = "_sums")]
    fn sums(slf: &Bound<'_, Self>, state: &Bound<'_, PyAny>) -> PyResult<Vec<(String, f64)>> {
        let own = slf.get();
        let state = doubles(&named(state, slf, "state")?, "state")?;
        let x = own.state(&state)?;
        let mut at = own.at.lock().unwrap_or_else(PoisonError::into_inner);
        let failed = |error| of_dimension(&error);
        let integrals = at.integrals(&x).map_err(failed)?;
        let mut sums: Vec<(String, f64)> =
            own.lattice.integrals().into_iter().map(str::to_owned).zip(integrals).collect();
        if let Some(name) = own.lattice.hamiltonian() {
            let energies = [at.hamiltonian(&x).map_err(failed)?, at.modified_energy(&x).map_err(failed)?];
            let names = [name.to_owned(), format!("{name}_modified")];
            sums.extend(names.into_iter().zip(energies).filter_map(|(name, energy)| Some((name, energy?))));
        }
        Ok(sums)
    }
}

impl Chain {
    /// Returns the numbers of a state, site by site, after checking its shape.
    fn state(&self, state: &numpy::PyReadonlyArrayDyn<'_, f64>) -> PyResult<Vec<f64>> {
        let arrays = self.lattice.arrays().len();
        let fits = match state.shape() {
            [sites] => arrays == 1 && *sites == self.sites,
            shape => shape == [self.sites, arrays],
        };
        if !fits {
            let alone = if arrays == 1 { format!(", or ({},)", self.sites) } else { String::new() };
            return Err(PyValueError::new_err(format!(
                "a state has the shape ({}, {arrays}){alone}, a row a site, and this is {:?}",
                self.sites,
                state.shape()
            )));
        }
        Ok(state.as_slice()?.to_vec())
    }
}
