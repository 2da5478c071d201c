//! The heights of a point, and the reasons why an orbit ends.

/// The logarithmic heights of one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// The number n of steps from the initial point.
    pub step: usize,
    /// h(xᵢ) = log max(|p|, |q|) of each component p/q in lowest terms, to 15 digits; h(0) = 0.
    pub logarithms: Vec<f64>,
    /// The number of decimal digits of max(|p|, |q|) of each component.
    pub digits: Vec<u64>,
}

impl Heights {
    /// Returns the number of decimal digits of the component that has the most digits.
    #[must_use]
    pub fn longest(&self) -> u64 {
        self.digits.iter().copied().max().unwrap_or(0)
    }
}

/// The reason why an orbit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The map has a pole at the last point, so the next point would have W = 0.
    Pole,
    /// The next point exceeds the bound of [`within_digits`](super::HeightsOrbit::within_digits),
    /// or is expected to exceed twice this bound.
    Digits,
    /// The time limit does not allow another step, or the callback ended the orbit.
    Seconds,
}
