//! Observers, and receivers of crossings, that end the run as soon as their report is known.

#[cfg(feature = "std")]
use super::{CrossingReceiver, FirstCrossings, StoredCrossings};
use super::{Escape, Observer};

/// An observer that ends the run of an orbit; see [`Escape::ending`] and
/// [`FirstCrossings::ending`].
///
/// ```
/// use kahan_core::observe::{Drift, Escape};
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Growth without limits.
///     pub struct Growth;
///     xdot = x;
/// }
///
/// let mut orbit = Growth.orbit(vector![1.0], 0.05);
/// let (_, step) = orbit.observe(
///     1_000_000,
///     (Drift::of(|x: &[f64]| [x[0]]), Escape::when(|x: &[f64]| x[0] > 2.0).ending()),
/// );
/// assert_eq!(step, Some(7));
/// // The orbit stands there.
/// assert!(orbit.next().unwrap()[0] > 2.0 * 1.05);
/// ```
#[derive(Clone, Debug)]
pub struct Ending<O>(O);

impl<F> Escape<F> {
    /// Returns an observer that ends the run when the condition holds.
    pub fn ending(self) -> Ending<Self> {
        Ending(self)
    }
}

impl<T, F: Fn(&[T]) -> bool> Observer<T> for Ending<Escape<F>> {
    /// The step at which the run ended, `None` if the condition never held.
    type Report = Option<u64>;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        self.0.observe(step, x);
    }

    #[inline]
    fn is_done(&self) -> bool {
        self.0.has_happened()
    }

    fn report(self) -> Option<u64> {
        Observer::<T>::report(self.0)
    }
}

#[cfg(feature = "std")]
impl<C> FirstCrossings<C> {
    /// Returns a receiver that ends the run after `capacity` crossings.
    pub fn ending(self) -> Ending<Self> {
        Ending(self)
    }
}

#[cfg(feature = "std")]
impl<C> CrossingReceiver<C> for Ending<FirstCrossings<C>> {
    type Report = StoredCrossings<C>;

    fn take(&mut self, crossing: C) {
        self.0.take(crossing);
    }

    #[inline]
    fn is_full(&self) -> bool {
        self.0.has_all()
    }

    fn report(self) -> StoredCrossings<C> {
        self.0.report()
    }
}
