//! What an orbit says of a point and of its end.

/// The logarithmic heights of one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// n, the number of steps from the initial point.
    pub step: usize,
    /// h(xᵢ) = log max(|p|, |q|) of each component p/q in lowest terms: natural logarithms, right
    /// to 15 digits; h(0) = 0.
    pub logarithms: Vec<f64>,
    /// The number of decimal digits of max(|p|, |q|) of each component.
    pub digits: Vec<u64>,
}

impl Heights {
    /// The number of decimal digits of the longest component.
    #[must_use]
    pub fn longest(&self) -> u64 {
        self.digits.iter().copied().max().unwrap_or(0)
    }
}

/// Why an orbit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The last point is a pole: the reduced map has no value there (W = 0), or det A = 0 where the
    /// map is not reduced.
    Pole,
    /// The next point has more digits than [`within_digits`] lets pass, or would have more than
    /// twice as many if it grew like the last.
    ///
    /// [`within_digits`]: super::HeightsOrbit::within_digits
    Digits,
    /// The next point would be later than [`Survey::within`](super::Survey::within) lets pass, or
    /// whoever saw the last one wants no more.
    Seconds,
}
