//! The steps that are judged: a system's plans, run one operation after the other.
//!
//! In: a system at values of its parameters at which it is defined. Out: every step of its map over
//! a scalar, with the bits of the code that the macro writes for it (which tests show on the whole
//! catalog), so that a verdict on these is a verdict on that.

use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, KahanMap, PreparedStep, QuadraticField};
use kahan_runtime::interpreted::Padded;

use crate::map::Map;

use super::float::Float;

/// The steps of one map over one scalar. A step has as many components as x.
#[derive(Debug)]
pub(crate) struct Steps<T>(Padded<T>);

impl<T: Float> Steps<T> {
    /// Those of a map.
    pub(crate) fn of(map: &Map) -> Self {
        Steps(map.over())
    }

    /// x̃ by `step`, whatever it is.
    pub(crate) fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T> {
        own(&KahanMap::step(&self.0.with_parameters(parameters), &padded(x), eps), x)
    }

    /// x̃ by the step through a wider format; `None` where the scalar has none.
    pub(crate) fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&T::wider_step(self.0.with_parameters(parameters), &padded(x), eps)?, x))
    }

    /// x̃ by elimination with partial pivoting; `None` where det A is zero and the scalar has no
    /// reciprocal of that.
    pub(crate) fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&Elimination::new(self.0.with_parameters(parameters), eps).next(&padded(x))?, x))
    }

    /// The entries of f′(x), row by row.
    pub(crate) fn slopes(&self, parameters: &[T], x: &[T]) -> Vec<T> {
        let jacobian = self.0.with_parameters(parameters).field_jacobian(&padded(x));
        (0..x.len()).flat_map(|i| (0..x.len()).map(move |j| jacobian[(i, j)])).collect()
    }

    /// x̃ by `try_step`; `None` where it is flagged.
    pub(crate) fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&KahanMap::try_step(&self.0.with_parameters(parameters), &padded(x), eps).ok()?, x))
    }
}

/// The point with zeros for the variables that stand still.
fn padded<T: Float, const N: usize>(x: &[T]) -> SVector<T, N> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or_else(T::zero))
}

/// The components that belong to those of x.
fn own<T: Float, const N: usize>(next: &SVector<T, N>, x: &[T]) -> Vec<T> {
    next.iter().copied().take(x.len()).collect()
}
