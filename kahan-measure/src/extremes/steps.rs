//! The steps that are judged, of systems whose type is not known where they are called.

use std::marker::PhantomData;

use kahan_algebra::system::System;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Elimination, Lift, PreparedStep};

use super::float::Float;

use kahan_runtime::interpreted::{
    CannotInterpret, Interpreted, UnsupportedDimension, VisitDimension, visit_dimension,
};
use kahan_systems::with_catalog;

/// The steps of one map at given parameters.
pub(crate) trait Steps<T>: Send + Sync {
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

/// A map made from its parameters.
struct Generated<F, const N: usize>(F);

impl<T, M, F, const N: usize> Steps<T> for Generated<F, N>
where
    T: Float,
    M: Lift<T, N>,
    F: Fn(&[T]) -> M + Send + Sync,
{
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T> {
        self.0(parameters).step(&SVector::from_fn(|i, _| x[i]), eps).iter().copied().collect()
    }

    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        let next = T::wider_step(self.0(parameters), &SVector::from_fn(|i, _| x[i]), eps)?;
        Some(next.iter().copied().collect())
    }

    fn eliminated(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        let next = Elimination::new(self.0(parameters), eps).next(&SVector::from_fn(|i, _| x[i]))?;
        Some(next.iter().copied().collect())
    }

    fn slopes(&self, parameters: &[T], x: &[T]) -> Vec<T> {
        let jacobian = self.0(parameters).field_jacobian(&SVector::from_fn(|i, _| x[i]));
        jacobian.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<T>>()).collect()
    }

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        let next = self.0(parameters).try_step(&SVector::from_fn(|i, _| x[i]), eps).ok()?;
        Some(next.iter().copied().collect())
    }
}

macro_rules! generated_steps {
    (
        paper { $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)* }
        further { $($rest:tt)* }
    ) => {
        /// The generated steps of a system of the paper, by its command name.
        pub(crate) fn generated<T: Float>(command: &str) -> Option<Box<dyn Steps<T>>> {
            $(
                if command == kahan_systems::$module::ENTRY.command {
                    return Some(Box::new(Generated::<_, $n>(|values: &[T]| {
                        let [$($($parameter),*)?] = values else { unreachable!("its parameters") };
                        kahan_systems::$type { $($($parameter: *$parameter),*)? }
                    })));
                }
            )*
            None
        }
    };
}

with_catalog!(generated_steps);

/// The steps of any system, by its plans; they have the bits of generated ones. `values` are
/// parameters at which it is defined.
pub(crate) fn interpreted<T: Float>(
    system: &System,
    values: &[BigRational],
) -> Result<Box<dyn Steps<T>>, CannotRun> {
    let made = visit_dimension(system.field.dimension(), Reader { system, values, scalar: PhantomData });
    made.map_err(CannotRun::Dimension)?.map_err(CannotRun::System)
}

/// Why the steps of a system cannot be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CannotRun {
    /// It has too many variables.
    Dimension(UnsupportedDimension),
    /// It is not defined at the parameters.
    System(CannotInterpret),
}

impl core::fmt::Display for CannotRun {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Dimension(why) => why.fmt(f),
            Self::System(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for CannotRun {}

/// Reads a system in whatever dimension it has.
struct Reader<'a, T> {
    system: &'a System,
    values: &'a [BigRational],
    scalar: PhantomData<T>,
}

impl<T: Float> VisitDimension for Reader<'_, T> {
    type Output = Result<Box<dyn Steps<T>>, CannotInterpret>;

    fn visit<const N: usize>(self) -> Self::Output {
        let map = Interpreted::<BigRational, N>::new(self.system, self.values)?.rounded::<T>();
        Ok(Box::new(Generated::<_, N>(move |parameters: &[T]| map.with_parameters(parameters))))
    }
}
