//! Seeded rationals and matrix products, for the exact tests.

use nalgebra::{SMatrix, SVector};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

pub(super) type Q = BigRational;

pub(super) fn q(p: i64, q: i64) -> Q {
    Q::new(BigInt::from(p), BigInt::from(q))
}

/// A fixed sequence of small rationals, from the 64-bit generator of Knuth's MMIX.
pub(super) struct Rationals(u64);

impl Rationals {
    pub(super) fn seeded(seed: u64) -> Self {
        Self(seed)
    }

    fn below(&mut self, bound: u64) -> i64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) % bound) as i64
    }

    pub(super) fn next(&mut self) -> Q {
        q(self.below(41) - 20, self.below(12) + 1)
    }

    pub(super) fn vector<const N: usize>(&mut self) -> SVector<Q, N> {
        SVector::from_fn(|_, _| self.next())
    }

    pub(super) fn matrix<const N: usize>(&mut self) -> SMatrix<Q, N, N> {
        SMatrix::from_fn(|_, _| self.next())
    }
}

pub(super) fn product<const N: usize, const M: usize>(
    a: &SMatrix<Q, N, N>,
    b: &SMatrix<Q, N, M>,
) -> SMatrix<Q, N, M> {
    SMatrix::from_fn(|i, j| (0..N).fold(Q::zero(), |sum, k| sum + &a[(i, k)] * &b[(k, j)]))
}

pub(super) fn scaled<const N: usize>(t: &Q, v: &SVector<Q, N>) -> SVector<Q, N> {
    v.map(|entry| entry * t)
}
