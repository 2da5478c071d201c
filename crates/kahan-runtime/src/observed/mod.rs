//! Observables of orbits, and the loops that observe orbits over `f32` and `f64`.
//!
//! In: maps, first points, and a list of observables for each orbit. Out: the values seen, in the
//! order of the list. The loops are instantiated here, beside the steps that they call: in another
//! unit of compilation they take up to twice the time.

mod carried;
mod observable;
mod running;
mod tangent;

use std::ops::ControlFlow;

use kahan_core::{EmbedScalar, Step};

use crate::{DimensionError, Followed, MachineFloat, MapAt};

pub use observable::Seen;
pub use running::Observable;
pub use tangent::Relations;

/// A request: observables of orbits, with their settings.
#[derive(Clone, Copy, Debug)]
pub struct Observing<'a> {
    /// The observables, each once.
    pub of: &'a [Observable],
    /// The largest number of steps of each orbit.
    pub steps: u64,
    /// Steps between two orthonormalizations of the tangent vectors, at least 1.
    pub renormalize: u64,
    /// The number of exponents in the spectrum, the largest ones, from 1 to that of the variables.
    pub exponents: usize,
    /// The bound on |xᵢ| beyond which an orbit has escaped, and ends; `None` for no bound.
    pub escape: Option<f64>,
    /// The relations of a lifted field; its tangent vectors are those of the original variables.
    pub relations: Option<&'a dyn Relations>,
}

impl Observing<'_> {
    /// The bound of [`Observable::Escape`] where [`escape`](Self::escape) is `None`.
    pub const USUAL_SIZE: f64 = 1e6;

    fn bound(&self) -> f64 {
        self.escape.unwrap_or(f64::MAX)
    }
}

/// A machine float whose orbits can be observed.
pub trait ObservedFloat: MachineFloat + EmbedScalar + PartialOrd {
    /// Observes the orbit of `start`, which ends where a point is not finite or beyond the bound.
    ///
    /// The orbit is made by `step`, or by `at` where `step` is `None`; observers always evaluate
    /// `at`. The callback `tell` receives numbers of steps, and may stop the orbit.
    ///
    /// # Errors
    /// [`DimensionError`] if `start` does not have one entry for each variable.
    fn alone(
        step: Option<&dyn Step<Scalar = Self>>,
        at: &MapAt<Self>,
        start: &[Self],
        asked: &Observing<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Followed<Vec<Seen>>, DimensionError>;

    /// Observes many orbits, side by side where compiled code can do so.
    ///
    /// Orbit k has the map `maps[k]`; column c of `starts` holds variable c of all first points.
    /// Numbers equal those of [`alone`](Self::alone), but are useless if `tell` stops the work.
    ///
    /// # Errors
    /// [`DimensionError`] for columns whose lengths do not fit the maps or each other.
    fn abreast(
        maps: &[&MapAt<Self>],
        starts: &[Vec<Self>],
        asked: &Observing<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Vec<Followed<Vec<Seen>>>, DimensionError>;
}

macro_rules! observed {
    ($($float:ty),*) => {
        $(impl ObservedFloat for $float {
            fn alone(
                step: Option<&dyn Step<Scalar = Self>>,
                at: &MapAt<Self>,
                start: &[Self],
                asked: &Observing<'_>,
                tell: &dyn Fn(u64) -> ControlFlow<()>,
            ) -> Result<Followed<Vec<Seen>>, DimensionError> {
                match step {
                    Some(step) => running::alone(&step, at, start, asked, tell),
                    None => running::alone(at, at, start, asked, tell),
                }
            }

            fn abreast(
                maps: &[&MapAt<Self>],
                starts: &[Vec<Self>],
                asked: &Observing<'_>,
                tell: &dyn Fn(u64) -> ControlFlow<()>,
            ) -> Result<Vec<Followed<Vec<Seen>>>, DimensionError> {
                running::abreast(maps, starts, asked, tell)
            }
        })*
    };
}

observed!(f32, f64);
