//! The first step at which a condition holds.

use super::Observer;

/// An observer of the first step at which a condition holds.
#[derive(Clone, Debug)]
pub struct Escape<F> {
    condition: F,
    at: Option<u64>,
}

impl<F> Escape<F> {
    /// Creates an observer of the first point that satisfies `condition`.
    pub fn when<T>(condition: F) -> Self
    where
        F: Fn(&[T]) -> bool,
    {
        Self { condition, at: None }
    }

    pub(super) fn has_happened(&self) -> bool {
        self.at.is_some()
    }
}

impl<T, F: Fn(&[T]) -> bool> Observer<T> for Escape<F> {
    /// The step at which the condition first held, or `None`.
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
