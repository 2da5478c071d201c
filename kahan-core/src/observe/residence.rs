//! Histograms of functions of the point.

use core::marker::PhantomData;
use core::ops::Range;

use crate::Scalar;

use super::Observer;

/// A histogram of an observable, which counts the points in equal subintervals of a range.
///
/// ```
/// use kahan_core::observe::Residence;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let halves = Residence::of(|x: &[f64]| x[0], 0.0..2.0, [0; 2]);
/// let stays = Turn.orbit(vector![1.0, 0.0], 1.0).observe(7, halves);
/// assert_eq!((stays.within, stays.outside), ([2 + 2, 2], 2));
/// ```
#[derive(Clone, Debug)]
pub struct Residence<F, T, V> {
    quantity: F,
    start: f64,
    /// The reciprocal of the width of a subinterval.
    parts_to_unit: f64,
    stays: ResidenceCounts<V>,
    scalar: PhantomData<T>,
}

/// The report of [`Residence`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ResidenceCounts<V> {
    /// The number of points in each subinterval. A subinterval includes its lower end.
    pub within: V,
    /// The number of points outside the range. A NaN is outside.
    pub outside: u64,
}

impl<F, T, V> Residence<F, T, V>
where
    F: Fn(&[T]) -> T,
    V: AsMut<[u64]>,
{
    /// Counts the values of `quantity` in equal parts of `range`, one part per entry of `counts`.
    /// All counts start at zero.
    pub fn of(quantity: F, range: Range<f64>, mut counts: V) -> Self {
        let parts_to_unit = counts.as_mut().len() as f64 / (range.end - range.start);
        let stays = ResidenceCounts { within: counts, outside: 0 };
        Self { quantity, start: range.start, parts_to_unit, stays, scalar: PhantomData }
    }
}

impl<F, T, V> Observer<T> for Residence<F, T, V>
where
    F: Fn(&[T]) -> T,
    T: Scalar,
    V: AsMut<[u64]>,
{
    type Report = ResidenceCounts<V>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, _step: u64, x: &[T]) {
        let part = ((self.quantity)(x).approximate() - self.start) * self.parts_to_unit;
        // Without this test, a negative number would be counted in subinterval 0.
        let count = if part >= 0.0 { self.stays.within.as_mut().get_mut(part as usize) } else { None };
        *count.unwrap_or(&mut self.stays.outside) += 1;
    }

    fn report(self) -> ResidenceCounts<V> {
        self.stays
    }
}
