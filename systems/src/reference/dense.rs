//! A trajectory as pieces of polynomials in t: it has a value at every time, whatever grid asks.

use kahan_core::Dd;

/// The most pieces of a trajectory.
pub(super) const MOST_PIECES: usize = 50_000;

/// One polynomial, valid from its start to the start of the next.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) start: Dd,
    /// The coefficients are those of powers of rate·(t − start); a power of 2.
    pub(super) rate: Dd,
    pub(super) dimension: usize,
    /// x₀, x₁, …, each a vector.
    pub(super) coefficients: Vec<Dd>,
}

impl Piece {
    /// The value at time t, by Horner's rule.
    pub(super) fn value(&self, t: Dd) -> Vec<Dd> {
        let s = (t - self.start) * self.rate;
        let mut sum = vec![Dd::from(0.0); self.dimension];
        for coefficient in self.coefficients.chunks(self.dimension).rev() {
            for (entry, term) in sum.iter_mut().zip(coefficient) {
                *entry = *entry * s + *term;
            }
        }
        sum
    }
}

/// The piece to which time t belongs: the last that begins before it.
pub(super) fn piece_at(pieces: &[Piece], t: Dd) -> &Piece {
    let later = pieces.partition_point(|piece| piece.start <= t);
    &pieces[later.saturating_sub(1)]
}
