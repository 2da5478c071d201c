//! A system that was read, in whatever number of variables.

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, Dual, QuadraticField, Scalar, StepCost};
use kahan_runtime::interpreted::{Padded, UnsupportedDimension, round};
use kahan_runtime::{Field, ParameterError, ParameterValue};

use crate::reference::{Limits, NoReference, Reference, Trajectory};

/// A system at values of its parameters, planned once.
#[derive(Debug)]
pub(crate) struct Map(Padded<BigRational>);

/// A system at these values of its parameters: its orbits, and what else is asked of it.
pub(crate) fn read(
    system: &System,
    parameters: &[impl ParameterValue],
) -> Result<(kahan_runtime::Map, Map), CannotRun> {
    let names = &system.field.symbols.parameters;
    let orbits = Field::of(system).with(names.iter().zip(parameters)).map_err(CannotRun::Parameters)?;
    let map = orbits.as_padded_kahan_map().map_err(CannotRun::Dimension)?;
    Ok((orbits, Map(map)))
}

/// Why a system cannot be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CannotRun {
    /// It has too many variables.
    Dimension(UnsupportedDimension),
    /// It is not defined at the parameters.
    Parameters(ParameterError),
}

impl core::fmt::Display for CannotRun {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Dimension(why) => why.fmt(f),
            Self::Parameters(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for CannotRun {}

impl Map {
    /// The map over a scalar, each parameter rounded once.
    pub(crate) fn over<T: Scalar>(&self) -> Padded<T> {
        self.0.rounded()
    }

    /// The trajectory to compare with.
    pub(crate) fn reference(
        &self,
        asked: &Trajectory<'_>,
        limits: &Limits<'_>,
    ) -> Result<Reference, NoReference> {
        Reference::of(&self.over::<Dd>(), asked, limits)
    }

    /// ‖f′(x₀)‖∞
    pub(crate) fn slope(&self, start: &[Rational]) -> f64 {
        let point = SVector::from_fn(|i, _| start.get(i).map_or(0.0, round));
        let slopes = self.over::<f64>().field_jacobian(&point);
        slopes.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
    }

    /// The declared integrals at this ε.
    pub(crate) fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd> {
        let values = self.over().integrals(&padded(x, |value| value), &Dd::from(eps));
        values.into_iter().map(number).collect()
    }

    /// Their Taylor coefficients at ε = 0: the values, and those of ε².
    pub(crate) fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]> {
        // ε = d + d′ with d² = d′² = 0: the coefficient of dd′ is the second derivative.
        let fixed = |value: Dd| Dual::<_, 1>::lift(Dual::<_, 1>::lift(value));
        let eps = Dual { value: Dual::coordinate(Dd::from(0.0), 0), gradient: [Dual::lift(Dd::from(1.0))] };
        let claims = self.over::<Dd>().over(|parameter| fixed(*parameter));
        let half = Dd::from(0.5);
        let coefficients = claims.integrals(&padded(x, fixed), &eps).into_iter().map(|value| match value {
            Some(value) => [value.value.value, value.gradient[0].gradient[0] * half],
            None => [number(None); 2],
        });
        coefficients.collect()
    }

    /// What a step of the generated code costs.
    pub(crate) fn cost(&self) -> StepCost {
        self.0.cost()
    }
}

/// A point in numbers made from its coordinates, with zeros for the variables that stand still.
fn padded<T: Scalar, const N: usize>(x: &[Dd], number: impl Fn(Dd) -> T) -> SVector<T, N> {
    SVector::from_fn(|i, _| number(x.get(i).copied().unwrap_or_default()))
}

fn number(value: Option<Dd>) -> Dd {
    value.unwrap_or(Dd::from(f64::NAN))
}
