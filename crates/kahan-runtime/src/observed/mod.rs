//! What can be observed of an orbit, and the loops that observe it.
//!
//! In: maps, first points, and what is asked of each orbit. Out: what was seen, in that order. The
//! loops are compiled here, for the floats of the machine, because the steps and the group of
//! orbits that they look at are: in another unit of compilation they take up to twice the time.

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

/// What is asked of orbits.
#[derive(Clone, Copy, Debug)]
pub struct Observing<'a> {
    /// What is observed, each once.
    pub of: &'a [Observable],
    /// The most steps of each orbit.
    pub steps: u64,
    /// Steps between two times that tangent vectors are made orthogonal, at least 1.
    pub renormalize: u64,
    /// The number of exponents in the spectrum, at least 1 and at most the number of variables: the
    /// largest ones.
    pub exponents: usize,
    /// The size of a variable beyond which an orbit has escaped, and ends; `None` for no bound.
    pub escape: Option<f64>,
    /// The relations of a lifted field, whose tangent vectors are those of its original variables.
    pub relations: Option<&'a dyn Relations>,
}

impl Observing<'_> {
    /// The size beyond which [`Observable::Escape`] looks where there is no bound.
    pub const USUAL_SIZE: f64 = 1e6;

    /// The size of a variable beyond which orbits end.
    fn bound(&self) -> f64 {
        self.escape.unwrap_or(f64::MAX)
    }
}

/// A float of the machine whose orbits are observed.
pub trait ObservedFloat: MachineFloat + EmbedScalar + PartialOrd {
    /// Observes the orbit of `start`, which ends where its points are not finite or are beyond the
    /// bound. `step` makes the orbit, or the map where that is `None`; observers always ask the
    /// map. `tell` hears of steps, and may stop the orbit.
    ///
    /// # Errors
    /// [`DimensionError`] if the start has not an entry a variable.
    fn alone(
        step: Option<&dyn Step<Scalar = Self>>,
        at: &MapAt<Self>,
        start: &[Self],
        asked: &Observing<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Followed<Vec<Seen>>, DimensionError>;

    /// The same of many orbits, side by side where there is code for that: a map an orbit, and
    /// column c has variable c of all first points. An orbit has the same numbers alone. What was
    /// seen when `tell` stopped the work is of no use.
    ///
    /// # Errors
    /// [`DimensionError`] for columns that do not fit the maps, or each other.
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
