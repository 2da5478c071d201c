//! The minimum and the maximum of a function of the point.

/// An observer of the minimum and the maximum of a function of the point. NaNs are skipped.
///
/// ```
/// use kahan_core::observe::Extrema;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let both = [0, 1].map(|i| Extrema::of(move |x: &[f64]| x[i]));
/// let [x, y] = Turn.orbit(vector![1.0, 0.0], 0.01).observe(1000, both);
/// assert!((x.unwrap().least + 1.0).abs() < 1e-4 && (y.unwrap().greatest - 1.0).abs() < 1e-4);
/// ```
#[derive(Clone, Debug)]
pub struct Extrema<F, T> {
    quantity: F,
    seen: Option<Extremes<T>>,
}

/// The report of [`Extrema`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Extremes<T> {
    /// The least value of the function.
    pub least: T,
    /// The greatest value of the function.
    pub greatest: T,
}

impl<F: Fn(&[T]) -> T, T> Extrema<F, T> {
    /// Creates an observer of the extremes of the function `quantity`.
    pub fn of(quantity: F) -> Self {
        Self { quantity, seen: None }
    }
}

impl<F: Fn(&[T]) -> T, T: Clone + PartialOrd> super::Observer<T> for Extrema<F, T> {
    /// The extremes, `None` if no value was a number.
    type Report = Option<Extremes<T>>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, _step: u64, x: &[T]) {
        let value = (self.quantity)(x);
        match &mut self.seen {
            Some(seen) if value < seen.least => seen.least = value,
            Some(seen) if value > seen.greatest => seen.greatest = value,
            None if value.partial_cmp(&value).is_some() => {
                self.seen = Some(Extremes { least: value.clone(), greatest: value });
            }
            _ => {}
        }
    }

    fn report(self) -> Option<Extremes<T>> {
        self.seen
    }
}
