//! The largest Lyapunov exponent.

use super::TangentMap;
use super::carried::{Carried, Indicator, IndicatorObserver};
use super::growth::Size;

/// An observer of the largest Lyapunov exponent, the growth rate of tangent vectors.
///
/// A tangent vector grows like exp(λt) with the time t, where λ is the exponent. For quasi-periodic
/// motion the estimate of λ tends to 0 like log(n)/n after n steps.
///
/// `Lyapunov::new(&map)` takes a [`TangentMap`]. The tangent vector costs about as much as the
/// step.
pub type Lyapunov<M> = IndicatorObserver<Growth, M, 1>;

/// The squared lengths of a tangent vector at the first point and at steps that are powers of two.
#[derive(Clone, Debug)]
pub struct Growth {
    first: Size,
    doublings: Doublings,
}

/// A Lyapunov exponent per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Exponent {
    /// The mean growth rate, NaN without a step.
    pub value: f64,
    /// An estimate of the error of `value`, not a bound: its distance from the mean rate over the
    /// first k of n steps. Here k is the power of two with n/8 < k ≤ n/4. NaN for n < 4.
    pub error: f64,
}

impl Indicator<1> for Growth {
    type Report = Exponent;

    const LOOKS_AT_EACH: bool = false;

    fn new([first]: [Size; 1]) -> Self {
        Self { first, doublings: Doublings::default() }
    }

    #[inline(always)]
    fn read_lengths(&mut self, step: u64, [size]: [Size; 1]) {
        if step.is_power_of_two() {
            self.doublings.pass(step, size);
        }
    }

    fn report<M: TangentMap>(self, mut carried: Carried<M, 1>) -> Exponent {
        let [size] = carried.scale();
        self.doublings.exponent(self.first, (carried.steps(), size), carried.time_step())
    }
}

/// The squared lengths at the last three steps that are powers of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doublings([(u64, Size); 3]);

impl Default for Doublings {
    fn default() -> Self {
        Self([(0, Size::of(f64::NAN)); 3])
    }
}

impl Doublings {
    #[inline(always)]
    pub(super) fn pass(&mut self, step: u64, square: Size) {
        let [_, before, last] = self.0;
        self.0 = [before, last, (step, square)];
    }

    /// Returns the exponent for the squared lengths `first` and `last`, and the time step `time`.
    pub(super) fn exponent(&self, first: Size, last: (u64, Size), time: f64) -> Exponent {
        let rate = |(steps, square): (u64, Size)| 0.5 * (square.ln() - first.ln()) / (steps as f64 * time);
        let value = rate(last);
        Exponent { value, error: (value - rate(self.0[0])).abs() }
    }
}
