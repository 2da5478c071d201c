//! Observers, which answer questions about an orbit while it runs, without storing it.
//!
//! Observers store only what their reports need. On states of fixed size they allocate nothing
//! while they observe a point; only closures may.
//!
//! ```
//! use kahan_core::observe::{Drift, Extrema, Lyapunov};
//! use kahan_core::prelude::*;
//!
//! kahan! {
//!     /// Predator and prey.
//!     pub struct LotkaVolterra;
//!     xdot = x*(1 - y);
//!     ydot = y*(x - 1);
//! }
//!
//! let map = LotkaVolterra.at(0.05);
//! let observers = (Extrema::of(|x: &[f64]| x[0]), Lyapunov::new(&map));
//! let (prey, exponent) = map.orbit(vector![1.5, 1.0]).observe(10_000, observers);
//! assert!(prey.unwrap().least < 0.7 && prey.unwrap().greatest > 1.4);
//! assert!(exponent.value.abs() < exponent.error);
//! ```
//!
//! | question | observer |
//! |---|---|
//! | the range of an observable | [`Extrema`] |
//! | how well integrals are conserved | [`Drift`] |
//! | Lyapunov exponents: the largest, all, their sum | [`Lyapunov`], `Spectrum`, [`MeanLogDet`] |
//! | regular or chaotic motion, after few steps | [`Fli`], [`Megno`], [`Sali`] |
//! | the rotation number | [`Rotation`] |
//! | crossings of a section, the first crossing | [`Section`], [`first_crossing`] |
//! | the times of escape and of return | [`Escape`], [`Period`] |
//! | a run that ends at its escape or crossing | [`Ending`] |
//! | a histogram of an observable | [`Residence`] |
//! | the points themselves | [`Visit`] |
//!
//! Times are in steps, but crossings also have the time in units of t. Exponents are per unit of
//! time, where a step takes Δt = 2ε. Elementary functions come from the `libm` crate, so that equal
//! points give equal bits on every machine. Observers of derivatives take the prepared map
//! ([`TangentMap`]), by value or reference.

#[cfg(feature = "std")]
mod burst;
mod carried;
mod drift;
mod ending;
#[cfg(feature = "std")]
mod ensemble;
mod escape;
mod extrema;
mod fli;
mod growth;
#[cfg(feature = "std")]
mod lanes;
mod log_det;
mod lyapunov;
mod megno;
mod orbit;
mod period;
#[cfg(feature = "std")]
mod projective;
mod residence;
mod rotation;
mod sali;
mod section;
#[cfg(feature = "std")]
mod spectrum;
mod tangent;
mod tuples;
mod visit;
mod zero;

#[cfg(feature = "std")]
use crate::EnsembleScalar;
#[cfg(feature = "std")]
pub use burst::{Burst, Grouped, Observers, SideBySide};
#[doc(hidden)]
pub use carried::{PAUSE, SparseObserver};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use {
    crate::ensemble::columns::{GROUP, Group},
    ensemble::observe_group,
    growth::are_moderate,
};

pub use drift::{Drift, Drifted};
pub use ending::Ending;
pub use escape::Escape;
pub use extrema::{Extrema, Extremes};
pub use fli::Fli;
pub use log_det::MeanLogDet;
pub use lyapunov::{Exponent, Lyapunov};
pub use megno::{Megno, Megnos};
pub use period::{Period, Return};
pub use residence::{Residence, ResidenceCounts};
pub use rotation::{Rotation, RotationNumber};
pub use sali::Sali;
pub use section::{Crossing, CrossingReceiver, Direction, Section, SectionReport, first_crossing};
#[cfg(feature = "std")]
pub use section::{FirstCrossings, StoredCrossings};
#[cfg(feature = "std")]
pub use spectrum::Spectrum;
pub use tangent::{Tangent, TangentMap};
pub use visit::Visit;

/// An observer of orbits over the scalar `T`.
///
/// The observer gets the variables of a state, or all numbers if the state is a `Vec`.
///
/// ```
/// use kahan_core::observe::Observer;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Growth without limits.
///     pub struct Growth;
///     xdot = x;
/// }
///
/// /// Ends the run where x is beyond a bound, and tells the step.
/// struct Beyond(f64, Option<u64>);
///
/// impl Observer<f64> for Beyond {
///     type Report = Option<u64>;
///
///     fn observe(&mut self, step: u64, x: &[f64]) {
///         self.1 = (x[0] > self.0).then_some(step);
///     }
///
///     fn is_done(&self) -> bool {
///         self.1.is_some()
///     }
///
///     fn report(self) -> Option<u64> {
///         self.1
///     }
/// }
///
/// assert_eq!(Growth.orbit(vector![1.0], 0.05).observe(100, Beyond(2.0, None)), Some(7));
/// ```
///
/// Tuples of up to eight observers, arrays and (with `std`) vectors of observers are observers,
/// too. Their report consists of the reports of all members. The observer `()` observes nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not observe orbits of numbers of the type `{T}`",
    label = "not an observer of such orbits",
    note = "a closure is asked by an observer: `Extrema::of(|x: &[f64]| x[0])`, `Escape::when(…)`, `Visit::by(|step, x: &[f64]| …)`, or one of your own, which implements `Observer`"
)]
pub trait Observer<T> {
    /// The type of the report.
    type Report;

    #[doc(hidden)]
    const MAY_END: bool = true;

    /// Processes the point after `step` steps. Step 0 is x₀, and steps come in order.
    fn observe(&mut self, step: u64, x: &[T]);

    /// Returns whether the observer needs no further points.
    ///
    /// A finished observer ends the run of an orbit. In an ensemble its trajectory continues
    /// unobserved. Tuples, arrays and vectors finish as soon as one of their members finishes.
    #[inline(always)]
    fn is_done(&self) -> bool {
        false
    }

    /// Returns the report on the observed points.
    fn report(self) -> Self::Report;

    /// Returns this observer if it may skip points, and `None` if it needs every point.
    #[doc(hidden)]
    #[inline]
    fn resumed(&mut self) -> Option<&mut dyn SparseObserver<T>> {
        None
    }

    /// Shows each observer of a group the points of its own trajectory in one burst.
    #[cfg(feature = "std")]
    #[doc(hidden)]
    #[inline]
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>)
    where
        Self: Sized,
        T: EnsembleScalar,
    {
        show_in_turn(group, burst);
    }
}

#[cfg(feature = "std")]
#[inline]
fn show_in_turn<T, O, P>(group: &mut Observers<'_, O>, burst: &Burst<'_, P>)
where
    T: EnsembleScalar,
    O: Observer<T>,
    P: Grouped<T>,
{
    for (lane, observer) in group.iter_mut().flatten().enumerate() {
        burst.show(lane, 0, |step, x| {
            if !observer.is_done() {
                observer.observe(step, x);
            }
        });
    }
}
