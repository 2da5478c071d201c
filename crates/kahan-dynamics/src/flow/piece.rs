//! A stretch of a flow.

use super::series::{Digits, Series};
use kahan_core::Dd;

/// One polynomial, valid from its start to the start of the next.
#[derive(Clone, Debug)]
pub(super) struct Piece<T> {
    pub(super) start: Dd,
    /// The coefficients are those of powers of rate·(t − start); a power of 2.
    rate: f64,
    /// x₀, x₁, …, each a vector.
    pub(super) coefficients: Vec<T>,
}

impl<T: Digits> Piece<T> {
    pub(super) fn of<const N: usize>(series: &Series<T, N>, start: Dd) -> Self {
        let coefficients = series.coefficients.iter().flat_map(|x| x.iter().copied()).collect();
        Self { start, rate: series.rate, coefficients }
    }

    /// The value at time t, by Horner's rule.
    #[inline(always)]
    pub(super) fn value(&self, t: Dd, value: &mut [T]) {
        let s = T::from(t - self.start) * T::from(self.rate);
        value.fill(T::zero());
        for coefficient in self.coefficients.chunks_exact(value.len()).rev() {
            for (entry, term) in value.iter_mut().zip(coefficient) {
                *entry = *entry * s + *term;
            }
        }
    }
}
