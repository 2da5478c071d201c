//! The map of a field at values of its parameters.

use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_core::{Scalar, Scheme};

use crate::dimension::Argument;
use crate::interpreted::{Interpreted, round};
use crate::orbit::SchemeOrbit;
use crate::{DimensionError, Field, MachineFloat, MapAt};

/// Kahan's map of a [`Field`] at values of its parameters; made by [`Field::with`].
///
/// Copies share the field and the values.
#[derive(Clone, Debug)]
pub struct Map {
    field: Field,
    parameters: Arc<[Rational]>,
}

impl Map {
    pub(crate) fn new(field: Field, parameters: Vec<Rational>) -> Self {
        Map { field, parameters: parameters.into() }
    }

    /// The field.
    #[must_use]
    pub fn field(&self) -> &Field {
        &self.field
    }

    /// The values of the parameters, in the order of the field.
    #[must_use]
    pub fn parameters(&self) -> &[Rational] {
        &self.parameters
    }

    /// The map at ε, half the time step, over the float that ε is. What depends on ε and the
    /// parameters alone is computed here.
    ///
    /// Cost: the first call for a field plans its step, which takes some milliseconds to some tens
    /// of them; further ones some microseconds.
    #[must_use]
    pub fn at<T: MachineFloat>(&self, eps: T) -> MapAt<T> {
        MapAt::new(self.clone(), self.parameters.iter().map(round).chain([eps]).collect())
    }

    /// The map as a [`KahanMap`](kahan_core::KahanMap) over any scalar, in at least as many
    /// variables as the field has: those beyond its own stand still.
    ///
    /// So everything that is generic over maps takes fields that were read: orbits over
    /// `BigRational`, the step with a promise, ensembles of points.
    ///
    /// # Errors
    /// [`DimensionError`] if N is smaller than the number of variables.
    pub fn as_kahan_map<T: Scalar, const N: usize>(&self) -> Result<Interpreted<T, N>, DimensionError> {
        DimensionError::check_type(N, self.field.variables().len())?;
        Ok(Interpreted::of(&self.field.engine, self.parameters.iter().map(round).collect()))
    }

    /// The orbit in a scheme, with ε, half the time step, from a first point; each number is
    /// rounded once.
    ///
    /// Cost: the first orbit of a field plans its step, which takes some milliseconds to some tens
    /// of them, and the first of its kind compiles it, in some tenths of one.
    ///
    /// # Errors
    /// [`DimensionError`] if the point has not an entry a variable.
    pub fn orbit(
        &self,
        scheme: Scheme,
        eps: &Rational,
        start: &[Rational],
    ) -> Result<SchemeOrbit, DimensionError> {
        DimensionError::check(Argument::State, start.len(), self.field.variables().len())?;
        Ok(SchemeOrbit::begin(self, scheme, eps, start))
    }
}
