//! Polynomial pieces of a flow.

use super::series::{Series, SeriesScalar};
use kahan_core::Dd;

/// A polynomial that is valid from its start to the start of the next piece.
#[derive(Clone, Debug)]
pub(super) struct TaylorPiece<T> {
    pub(super) start: Dd,
    /// The piece is a polynomial in rate·(t − start), where rate is a power of 2.
    rate: f64,
    pub(super) coefficients: Vec<T>,
}

impl<T: SeriesScalar> TaylorPiece<T> {
    pub(super) fn of<const N: usize>(series: &Series<T, N>, start: Dd) -> Self {
        let coefficients = series.coefficients.iter().flat_map(|x| x.iter().copied()).collect();
        Self { start, rate: series.rate, coefficients }
    }

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
