//! The steps that are judged, of systems whose type is not known where they are called.

use kahan_core::Lift;
use kahan_core::nalgebra::SVector;

use super::float::Float;

use crate::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra, VolterraLattice};

/// The steps of one map at given parameters.
pub(crate) trait Steps<T>: Send + Sync {
    /// x̃ by `step`, whatever it is.
    fn step(&self, parameters: &[T], x: &[T], eps: T) -> Vec<T>;

    /// x̃ by the step through a wider format; `None` where the scalar has none.
    fn wider_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>>;

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

    fn try_step(&self, parameters: &[T], x: &[T], eps: T) -> Option<Vec<T>> {
        let next = self.0(parameters).try_step(&SVector::from_fn(|i, _| x[i]), eps).ok()?;
        Some(next.iter().copied().collect())
    }
}

/// The generated steps of a system of the catalog, or of the lattice, by its command name.
pub(crate) fn generated<T: Float>(command: &str) -> Option<Box<dyn Steps<T>>> {
    Some(match command {
        "euler" => Box::new(Generated::<_, 3>(|p: &[T]| EulerTop { a1: p[0], a2: p[1], a3: p[2] })),
        "lv" => Box::new(Generated::<_, 2>(|_: &[T]| LotkaVolterra)),
        "e1" => Box::new(Generated::<_, 3>(|_: &[T]| E1)),
        "e2" => Box::new(Generated::<_, 3>(|_: &[T]| E2)),
        "e3" => Box::new(Generated::<_, 3>(|_: &[T]| E3)),
        "e4" => Box::new(Generated::<_, 3>(|_: &[T]| E4)),
        "e5" => Box::new(Generated::<_, 3>(|_: &[T]| E5)),
        "e6" => Box::new(Generated::<_, 3>(|_: &[T]| E6)),
        "e7" => Box::new(Generated::<_, 3>(|p: &[T]| E7 { xi: p[0] })),
        "e8" => Box::new(Generated::<_, 3>(|_: &[T]| E8)),
        "e9" => Box::new(Generated::<_, 3>(|p: &[T]| E9 { xi: p[0] })),
        "volterra" => Box::new(Generated::<_, 3>(|_: &[T]| VolterraLattice)),
        _ => return None,
    })
}
