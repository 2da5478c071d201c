//! What a map does, answered in the loop, without storing the orbit.
//!
//! In: the points of an orbit, or of every trajectory of an ensemble, one after another. Out: one
//! report an observer. An observer keeps what its report needs and nothing else: no step allocates,
//! and a question that is not asked costs nothing.
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
//! | what is asked | observer |
//! |---|---|
//! | between which values a quantity stays | [`Extrema`] |
//! | how well integrals are kept | [`Drift`] |
//! | the largest exponent, all in descending order, their sum | [`Lyapunov`], `Spectrum`, [`MeanLogDet`] |
//! | regular or chaotic, soon | [`Fli`], [`Megno`], [`Sali`] |
//! | how fast it turns | [`Rotation`] |
//! | where it crosses a section, and when first | [`Section`], [`first_crossing`] |
//! | when it escapes, when it comes back | [`Escape`], [`Period`] |
//! | the same, and no further than that | [`Ending`] |
//! | how long it stays where | [`Residence`] |
//! | the points themselves | [`Visit`] |
//!
//! Times are in steps; exponents are per unit of time, of which a step takes 2ε. Logarithms,
//! exponentials and arctangents are those of the `libm` crate, and growth is kept as a number and a
//! power of two, so that a report has the same bits on every machine that computes the same points.
//!
//! The observers of derivatives take the prepared map, which carries tangent vectors along
//! ([`TangentMap`]), by value or by reference.

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
/// Observers that a loop gives their vectors back, and the steps between two looks.
#[doc(hidden)]
pub use carried::{PAUSE, Resumed};
/// What observes groups of trajectories of maps that are read at run time.
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
pub use residence::{Residence, Stays};
pub use rotation::{Rotation, Turns};
pub use sali::Sali;
#[cfg(feature = "std")]
pub use section::{AtMost, Kept};
pub use section::{Crossing, Direction, Section, Sectioned, Sink, first_crossing};
#[cfg(feature = "std")]
pub use spectrum::Spectrum;
pub use tangent::{Tangent, TangentMap};
pub use visit::Visit;

/// A question about an orbit whose numbers are of the type T.
///
/// It sees points alone; where states are `Vec`s, as those of a `&dyn Step` are, it sees all of a
/// state.
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
/// Tuples of up to eight observers, arrays and, with `std`, vectors of them are observers, whose
/// reports come together; `()` asks nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not observe orbits of numbers of the type `{T}`",
    label = "not an observer of such orbits",
    note = "a closure is asked by an observer: `Extrema::of(|x: &[f64]| x[0])`, `Escape::when(…)`, `Visit::by(|step, x: &[f64]| …)`, or one of your own, which implements `Observer`"
)]
pub trait Observer<T> {
    /// The answer.
    type Report;

    /// Whether it may be done before a run is.
    #[doc(hidden)]
    const MAY_END: bool = true;

    /// Looks at the point after `step` steps: x₀ is that of step 0, and the others follow one by
    /// one.
    fn observe(&mut self, step: u64, x: &[T]);

    /// Whether it has seen all that it wants to, asked after each point. An orbit that is observed
    /// ends there; a trajectory of an ensemble goes on unseen. A tuple, an array or a vector is
    /// done as soon as one of its observers is.
    #[inline(always)]
    fn is_done(&self) -> bool {
        false
    }

    /// The answer for the points seen.
    fn report(self) -> Self::Report;

    /// Returns this as an observer that need not see each point; `None` where it has to.
    #[doc(hidden)]
    #[inline]
    fn resumed(&mut self) -> Option<&mut dyn Resumed<T>> {
        None
    }

    /// Looks at some points of a group of trajectories, each with an observer of its own: here, at
    /// one trajectory after the other.
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

/// Shows the points of a group to its observers, one trajectory after the other, each until it is
/// done.
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
