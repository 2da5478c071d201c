//! x̃ as quotients over one denominator: x̃ᵢ = Nᵢ/d.
//!
//! The error of a result y is |yᵢd − Nᵢ|/|d|, and it is compared with max |Nᵢ|/|d| without a
//! division.

use std::cmp::Ordering;

use num_bigint::BigInt;

use super::Verdict;
use crate::extremes::dyadic::Dyadic;
use crate::extremes::elimination::largest;
use crate::extremes::float::Float;

/// The promise of the stable tier: ‖error‖∞ ≤ 64 u ‖exact‖∞.
pub(super) const PROMISE: i64 = 64;

/// Nᵢ and d, which is not 0.
pub(in crate::extremes) struct Fraction {
    pub(super) numerators: Vec<Dyadic>,
    pub(super) denominator: Dyadic,
    /// max |Nᵢ|.
    pub(super) size: Dyadic,
}

impl Fraction {
    pub(super) fn of(numerators: Vec<Dyadic>, denominator: Dyadic) -> Self {
        let size = largest(numerators.iter().cloned().map(Dyadic::abs));
        Self { numerators, denominator, size }
    }

    pub(super) fn judge<T: Float>(&self, result: &[Dyadic]) -> Verdict {
        let errors = result.iter().zip(&self.numerators).map(|(y, n)| (&(y * &self.denominator) - n).abs());
        let error = largest(errors);
        let within = |bound: &Dyadic| error.compare(bound) != Ordering::Greater;
        Verdict {
            error_u: if error.is_zero() { 0.0 } else { error.clone().scaled(T::PRECISION).ratio(&self.size) },
            keeps_promise: within(&(&self.size * &Dyadic::new(PROMISE, -T::PRECISION))),
            // error·1000 ≤ size
            is_rough: (&error * &Dyadic::new(1000, 0)).compare(&self.size) != Ordering::Greater,
        }
    }

    /// Whether the format holds every component with all of its bits: none beyond its range, none
    /// but 0 below its normal numbers.
    pub(super) fn fits<T: Float>(&self) -> bool {
        let d = self.denominator.clone().abs();
        let (least, greatest) = (d.clone().scaled(T::LEAST_BINADE), &d * &greatest::<T>());
        self.numerators.iter().all(|n| {
            let n = n.clone().abs();
            n.is_zero() || (n.compare(&least) != Ordering::Less && n.compare(&greatest) != Ordering::Greater)
        })
    }
}

/// The largest number of a format, (2 − 2^(1−p))·2^greatest.
pub(super) fn greatest<T: Float>() -> Dyadic {
    Dyadic::new((BigInt::from(1) << T::PRECISION) - 1, T::GREATEST_BINADE + 1 - T::PRECISION)
}
