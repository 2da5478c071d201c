//! An observer that passes every point to a closure.

use super::Observer;

/// An observer that calls a closure with every step and point, and reports nothing.
///
/// ```
/// use kahan_core::observe::Visit;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Growth without limits.
///     pub struct Growth;
///     xdot = x;
/// }
///
/// let mut points = Vec::new();
/// Growth.orbit(vector![1.0], 0.5).observe(2, Visit::by(|step, x: &[f64]| points.push((step, x[0]))));
/// assert_eq!(points, [(0, 1.0), (1, 3.0), (2, 9.0)]);
/// ```
#[derive(Clone, Debug)]
pub struct Visit<F>(F);

impl<F> Visit<F> {
    /// Creates an observer that calls `visit` with every step and point.
    pub fn by<T>(visit: F) -> Self
    where
        F: FnMut(u64, &[T]),
    {
        Self(visit)
    }
}

impl<T, F: FnMut(u64, &[T])> Observer<T> for Visit<F> {
    type Report = ();

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        (self.0)(step, x);
    }

    fn report(self) {}
}
