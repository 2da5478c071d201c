//! The observables of orbits, and the loops that observe orbits over `f32` and `f64`.
//!
//! In: maps, first points, and a list of observables. Out: the observed values, in the order of the
//! list. The loops are instantiated in this crate, beside the steps that they call. In another
//! compilation unit, the loops would take up to twice the time.

mod carried;
mod observable;
mod running;
mod tangent;

use std::ops::ControlFlow;

use kahan_core::{EmbedScalar, Step};

use crate::{DimensionError, Followed, MachineFloat, MapAt};

pub use observable::ObservedValue;
pub use running::Observable;
pub use tangent::Relations;

/// A request for observables of orbits, with settings.
#[derive(Clone, Copy, Debug)]
pub struct ObservationRequest<'a> {
    /// The observables, each once.
    pub of: &'a [Observable],
    /// The largest number of steps of each orbit.
    pub steps: u64,
    /// The number of steps between two orthonormalizations of the tangent vectors, at least 1.
    pub renormalize: u64,
    /// The number of Lyapunov exponents in the spectrum, largest first; at least 1.
    pub exponents: usize,
    /// The bound on |xᵢ| beyond which an orbit has escaped and ends; `None` for no bound.
    pub escape: Option<f64>,
    /// The relations that define the added variables of a lifted field. If given, tangent vectors
    /// have entries for the original variables only.
    pub relations: Option<&'a dyn Relations>,
}

impl ObservationRequest<'_> {
    /// The bound on |xᵢ| for [`Observable::Escape`] if [`escape`](Self::escape) is `None`.
    pub const USUAL_SIZE: f64 = 1e6;

    fn escape_bound(&self) -> f64 {
        self.escape.unwrap_or(f64::MAX)
    }
}

/// A machine float whose orbits can be observed.
pub trait ObservedFloat: MachineFloat + EmbedScalar + PartialOrd {
    /// Observes the orbit of `start`, which ends at a nonfinite point or beyond the bound.
    ///
    /// `step`, or `at` if `step` is `None`, makes the steps; derivatives and integrals always come
    /// from `at`. The callback `tell` receives numbers of steps, and may stop the orbit.
    ///
    /// # Errors
    /// [`DimensionError`] if `start` does not have one entry for each variable.
    fn observe_one(
        step: Option<&dyn Step<Scalar = Self>>,
        at: &MapAt<Self>,
        start: &[Self],
        asked: &ObservationRequest<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Followed<Vec<ObservedValue>>, DimensionError>;

    /// Observes many orbits, in SIMD lanes if machine code exists.
    ///
    /// Orbit k has the map `maps[k]`; column c of `starts` holds variable c of all first points.
    /// The numbers equal those of [`observe_one`](Self::observe_one), unless `tell` stops the work.
    ///
    /// # Errors
    /// [`DimensionError`] for columns whose lengths do not fit the maps or each other.
    fn observe_many(
        maps: &[&MapAt<Self>],
        starts: &[Vec<Self>],
        asked: &ObservationRequest<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Vec<Followed<Vec<ObservedValue>>>, DimensionError>;
}

macro_rules! observed {
    ($($float:ty),*) => {
        $(impl ObservedFloat for $float {
            fn observe_one(
                step: Option<&dyn Step<Scalar = Self>>,
                at: &MapAt<Self>,
                start: &[Self],
                asked: &ObservationRequest<'_>,
                tell: &dyn Fn(u64) -> ControlFlow<()>,
            ) -> Result<Followed<Vec<ObservedValue>>, DimensionError> {
                match step {
                    Some(step) => running::observe_one(&step, at, start, asked, tell),
                    None => running::observe_one(at, at, start, asked, tell),
                }
            }

            fn observe_many(
                maps: &[&MapAt<Self>],
                starts: &[Vec<Self>],
                asked: &ObservationRequest<'_>,
                tell: &dyn Fn(u64) -> ControlFlow<()>,
            ) -> Result<Vec<Followed<Vec<ObservedValue>>>, DimensionError> {
                running::observe_many(maps, starts, asked, tell)
            }
        })*
    };
}

observed!(f32, f64);
