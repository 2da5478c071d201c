//! The first time that something happens.

use super::Observer;

/// The first step after which a condition holds: leaving a region, or reaching one.
///
/// After that step it is not asked again.
#[derive(Clone, Debug)]
pub struct Escape<F> {
    condition: F,
    at: Option<u64>,
}

impl<F> Escape<F> {
    /// The first step after which `condition` holds of the point.
    pub fn when<T>(condition: F) -> Self
    where
        F: Fn(&[T]) -> bool,
    {
        Self { condition, at: None }
    }

    /// Whether it has held.
    pub(super) fn has_happened(&self) -> bool {
        self.at.is_some()
    }
}

impl<T, F: Fn(&[T]) -> bool> Observer<T> for Escape<F> {
    /// The step, 0 where it holds from the beginning; `None` where it never held.
    type Report = Option<u64>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if self.at.is_none() && (self.condition)(x) {
            self.at = Some(step);
        }
    }

    fn report(self) -> Option<u64> {
        self.at
    }
}
