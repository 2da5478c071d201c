//! The steps that are judged: a system's plans, run one operation after the other.
//!
//! In: a system, and values of its parameters at which it is defined. Out: every step of its map
//! over each scalar that is judged, with the bits of the code that the macro writes for it (which tests show on the
//! whole catalog), so that a verdict on these is a verdict on that.

use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, Elimination, KahanMap, PreparedStep, QuadraticField};

use super::float::Float;

use kahan_runtime::interpreted::Interpreted;

/// The steps of one map. A step has as many components as x.
pub(crate) trait Steps<T>: core::fmt::Debug + Send + Sync {
    /// x̃ by `step`, whatever it is.
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T>;

    /// x̃ by the step through a wider format; `None` where the scalar has none.
    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    /// x̃ by elimination with partial pivoting; `None` where det A is zero and the scalar has no
    /// reciprocal of that.
    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

    /// The entries of f′(x), row by row.
    fn slopes(&self, parameters: &[T], x: &[T]) -> Vec<T>;

    /// x̃ by `try_step`; `None` where it is flagged.
    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;
}

impl<T: Float, const N: usize> Steps<T> for Interpreted<T, N> {
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T> {
        own(&KahanMap::step(&self.with_parameters(parameters), &padded(x), eps), x)
    }

    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&T::wider_step(self.with_parameters(parameters), &padded(x), eps)?, x))
    }

    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&Elimination::new(self.with_parameters(parameters), eps).next(&padded(x))?, x))
    }

    fn slopes(&self, parameters: &[T], x: &[T]) -> Vec<T> {
        let jacobian = self.with_parameters(parameters).field_jacobian(&padded(x));
        (0..x.len()).flat_map(|i| (0..x.len()).map(move |j| jacobian[(i, j)])).collect()
    }

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        Some(own(&KahanMap::try_step(&self.with_parameters(parameters), &padded(x), eps).ok()?, x))
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

/// The steps of a system over each scalar that is judged, planned once.
#[derive(Debug)]
pub(crate) struct StepsOfSystem {
    pub(crate) single: Box<dyn Steps<f32>>,
    pub(crate) double: Box<dyn Steps<f64>>,
    pub(crate) double_double: Box<dyn Steps<Dd>>,
}
