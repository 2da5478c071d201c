//! The first return of an orbit.

use crate::Scalar;

use super::Observer;

/// An observer of the first return to a ball around the initial point.
///
/// With radius 0, the observer finds periods of exact orbits.
///
/// ```
/// use kahan_core::observe::Period;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// // With ε = 1 the map turns by a right angle.
/// let start = vector![1.0, 0.0];
/// let back = Turn.orbit(start, 1.0).observe(10, Period::within(1e-9, [0.0; 2]));
/// assert_eq!(back.unwrap().step, 4);
/// ```
#[derive(Clone, Debug)]
pub struct Period<T, V> {
    squared: T,
    start: V,
    was_away: bool,
    back: Option<Return<T>>,
}

/// The report of [`Period`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Return<T> {
    /// The step at which the orbit returned.
    pub step: u64,
    /// The squared distance of the returned point from the first point.
    pub squared_distance: T,
}

impl<T: Scalar, V: AsMut<[T]>> Period<T, V> {
    /// Creates an observer of the first return to the ball of this radius around the first point.
    /// `place` is memory for this point, an array or vector with one number per variable.
    pub fn within(radius: T, place: V) -> Self {
        Self { squared: radius.clone() * radius, start: place, was_away: false, back: None }
    }
}

impl<T: Scalar + PartialOrd, V: AsRef<[T]> + AsMut<[T]>> Observer<T> for Period<T, V> {
    /// The return, `None` if the orbit did not return.
    type Report = Option<Return<T>>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if step == 0 {
            self.start.as_mut().clone_from_slice(x);
        } else if self.back.is_none() {
            let entries = self.start.as_ref().iter().zip(x);
            let squared_distance = entries.fold(T::zero(), |sum, (start, x)| {
                let apart = x.clone() - start.clone();
                sum + apart.clone() * apart
            });
            if squared_distance > self.squared {
                self.was_away = true;
            } else if self.was_away && squared_distance <= self.squared {
                self.back = Some(Return { step, squared_distance });
            }
        }
    }

    fn report(self) -> Option<Return<T>> {
        self.back
    }
}
