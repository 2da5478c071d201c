//! The map of a field at values of its parameters.

use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::{KahanMap, Pivot, Scalar, SingularStep, eps_from_dt};
use kahan_dynamics::Precision;

use crate::dimension::Argument;
use crate::interpreted::{Interpreted, round};
use crate::{DimensionError, Field, MapAt, RuntimeFloat};

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
    pub fn at<T: RuntimeFloat>(&self, eps: T) -> MapAt<T> {
        MapAt::new(self.clone(), self.constants(eps).collect(), T::PRECISION)
    }

    /// The map of the time step Δt = 2ε; see [`at`](Self::at).
    #[must_use]
    pub fn at_dt<T: RuntimeFloat>(&self, dt: T) -> MapAt<T> {
        self.at(eps_from_dt(dt))
    }

    /// The map of [`ThroughF64`](kahan_core::ThroughF64): states, ε and parameters are numbers of
    /// `f32` that are held in `f64`, and each step is computed in `f64` and rounded once.
    #[must_use]
    pub fn through_f64(&self, eps: f32) -> MapAt<f64> {
        let constants = self.constants(eps).map(f64::from).collect();
        MapAt::new(self.clone(), constants, Precision::SingleThroughDouble)
    }

    /// The parameters, and ε behind them.
    fn constants<T: RuntimeFloat>(&self, eps: T) -> impl Iterator<Item = T> {
        self.parameters.iter().map(round).chain([eps])
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
        let n = self.field.variables().len();
        DimensionError::check(Argument::Type, N.min(n), n)?;
        Ok(Interpreted::of(&self.field.engine, self.parameters.iter().map(round).collect()))
    }

    /// Writes x̃ to `next`, with the promise of [`KahanMap::try_step`] and its bits: of a float, an
    /// error of at most 64 u of the largest component, or else why there is no such x̃.
    ///
    /// Cost: some ten interpreted steps where the point is an ordinary one, and many more near
    /// poles.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` or `next` has not an entry a variable, and for a field of more
    /// than 16 variables: the widest numbers of a larger one do not fit on the stack.
    pub fn try_step<T: Pivot + Copy>(
        &self,
        x: &[T],
        eps: T,
        next: &mut [T],
    ) -> Result<Result<(), SingularStep>, DimensionError> {
        // A type of more variables takes the same steps, except that `f32` tries its own precision
        // first in at most four.
        match self.field.variables().len() {
            0..=4 => self.try_step_among::<T, 4>(x, eps, next),
            5..=8 => self.try_step_among::<T, 8>(x, eps, next),
            _ => self.try_step_among::<T, 16>(x, eps, next),
        }
    }

    fn try_step_among<T: Pivot + Copy, const N: usize>(
        &self,
        x: &[T],
        eps: T,
        next: &mut [T],
    ) -> Result<Result<(), SingularStep>, DimensionError> {
        let n = self.field.variables().len();
        DimensionError::check(Argument::Promise, n.min(N), n)?;
        let map = self.as_kahan_map::<T, N>()?;
        DimensionError::check(Argument::State, x.len(), n)?;
        DimensionError::check(Argument::Out, next.len(), n)?;
        let point = SVector::from_fn(|i, _| x.get(i).copied().unwrap_or_else(T::zero));
        Ok(map.try_step(&point, eps).map(|found| next.copy_from_slice(&found.as_slice()[..n])))
    }
}
