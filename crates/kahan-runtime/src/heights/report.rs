//! What an orbit says of a point and of its end, and what it may cost.

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
    /// The next point is longer than [`Bounds::max_digits`], or would be more than twice as long if
    /// it grew like the last.
    Digits,
    /// The next point would be later than [`Bounds::seconds`].
    Seconds,
}

/// What an orbit may cost; the default is anything.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// The greatest number of decimal digits of a height's integer.
    pub max_digits: Option<u64>,
    /// The wall-clock time since the orbit was made. Before each step its time is estimated from
    /// the last one's, so that no step begins that is likely to end late.
    pub seconds: Option<f64>,
}
