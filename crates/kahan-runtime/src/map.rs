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
#[derive(Clone, Debug)]
pub struct Map {
    field: Field,
    parameters: Arc<[Rational]>,
    /// Whether steps in floats fuse multiply-adds.
    pub(crate) fuses: bool,
}

impl Map {
    pub(crate) fn new(field: Field, parameters: Vec<Rational>, fuses: bool) -> Self {
        Map { field, parameters: parameters.into(), fuses }
    }

    /// Returns the field.
    #[must_use]
    pub fn field(&self) -> &Field {
        &self.field
    }

    /// Returns the values of the parameters, in the field's order.
    #[must_use]
    pub fn parameters(&self) -> &[Rational] {
        &self.parameters
    }

    /// Returns the map whose steps in floats fuse multiply-adds: each a·b + c is rounded once. Such
    /// steps take 3 to 14 % less time. Their last digits differ from those of other steps, but are
    /// equal on all processors with fused operations.
    ///
    /// The steps are machine code. Returns `None` if the processor has no fused operations, or if
    /// the step is not a straight-line program, as in large and dense fields;
    /// [`Field::has_fused_steps`] tells this in advance.
    #[must_use]
    pub fn fused(self) -> Option<Self> {
        self.field.has_fused_steps().then_some(Map { fuses: true, ..self })
    }

    /// Prepares the map at ε, half the time step. States then have the type of `eps`.
    ///
    /// The first call for a field takes milliseconds; later calls take microseconds.
    #[must_use]
    pub fn at<T: RuntimeFloat>(&self, eps: T) -> MapAt<T> {
        MapAt::new(self.clone(), self.constants(eps).collect(), T::PRECISION)
    }

    /// Prepares the map at the time step Δt = 2ε; see [`at`](Self::at).
    #[must_use]
    pub fn at_dt<T: RuntimeFloat>(&self, dt: T) -> MapAt<T> {
        self.at(eps_from_dt(dt))
    }

    /// Prepares the steps of [`ThroughF64`](kahan_core::ThroughF64) at ε, half the time step.
    /// States, ε and parameters are `f32` numbers stored as `f64`. Each step is computed in `f64`
    /// and rounded once to `f32`.
    #[must_use]
    pub fn through_f64(&self, eps: f32) -> MapAt<f64> {
        let constants = self.constants(eps).map(f64::from).collect();
        MapAt::new(self.clone(), constants, Precision::SingleThroughDouble)
    }

    fn constants<T: RuntimeFloat>(&self, eps: T) -> impl Iterator<Item = T> {
        self.parameters.iter().map(round).chain([eps])
    }

    /// Returns the map as a [`KahanMap`](kahan_core::KahanMap) over any scalar in N variables;
    /// variables that the field does not have stay constant.
    ///
    /// Code that is generic over maps then accepts run-time fields.
    ///
    /// # Errors
    /// [`DimensionError`] if N is smaller than the number of variables.
    pub fn as_kahan_map<T: Scalar, const N: usize>(&self) -> Result<Interpreted<T, N>, DimensionError> {
        let n = self.field.variables().len();
        DimensionError::check(Argument::Type, N.min(n), n)?;
        Ok(Interpreted::of(&self.field.engine, self.parameters.iter().map(round).collect()))
    }

    /// Writes x̃ to `next`, with the bits and the error bound of [`KahanMap::try_step`]. For floats
    /// with unit roundoff u, the error is at most 64 u relative to the largest component. If this
    /// bound cannot be guaranteed, returns `Ok(Err(_))`.
    ///
    /// Cost: some ten interpreted steps at an ordinary point, and many more near poles.
    ///
    /// # Errors
    /// [`DimensionError`] for an `x` or `next` of a wrong length, and for more than 16 variables.
    pub fn try_step<T: Pivot + Copy>(
        &self,
        x: &[T],
        eps: T,
        next: &mut [T],
    ) -> Result<Result<(), SingularStep>, DimensionError> {
        // `f32` steps with N ≤ 4 try single precision first. All larger N give equal results.
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
