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
    /// The last point is a pole. In the reduced map W = 0; in a map that is not reduced, det A = 0.
    Pole,
    /// The next point exceeds the bound of [`within_digits`]. Or: it would have more than twice as
    /// many digits as the bound, if digits grew as in the last step.
    ///
    /// [`within_digits`]: super::HeightsOrbit::within_digits
    Digits,
    /// The next point would exceed the time limit of
    /// [`DiophantineTest::within`](super::DiophantineTest::within), or the callback ended the
    /// orbit.
    Seconds,
}
