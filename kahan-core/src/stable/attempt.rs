//! One run of a step over bounded values.

use core::array::from_fn;

use nalgebra::SVector;

use num_traits::{One, Zero};

use crate::linear::vector;
use crate::{KahanMap, Pivot, PreparedStep, Quotients, Scalar};

use super::bounded::{Bounded, Working};

/// A next state, and for each component what its error is at most, its own last rounding apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt<V: Working, const N: usize> {
    pub(super) next: [V; N],
    errors: [V::Magnitude; N],
    /// The binary exponent that no input may exceed, see [`Bounded::largest_input`].
    largest_input: u32,
}

impl<V: Working, const N: usize> Attempt<V, N> {
    /// By the increment form, with the operations and the bits of the fast step; `None` where a denominator may be zero.
    #[inline(always)]
    pub(super) fn by_increments<M>(map: &M, x: &SVector<Bounded<V>, N>, eps: Bounded<V>) -> Option<Self>
    where
        M: KahanMap<Bounded<V>, N>,
    {
        let Quotients { numerators, reciprocals } = map.prepare(&eps).quotients(x)?;
        let roundings = numerators.iter().map(Bounded::roundings).fold(0, u32::max);
        Some(Self {
            next: from_fn(|i| numerators[i].value().multiply_add(reciprocals[i].value(), x[i].value())),
            errors: from_fn(|i| numerators[i].error_of_product(reciprocals[i], roundings)),
            largest_input: numerators
                .iter()
                .chain(&reciprocals)
                .map(Bounded::largest_input)
                .fold(1000, u32::min),
        })
    }

    /// As N/D, both expanded and without common factors: no increment that could cancel against the state.
    pub(super) fn by_quotients<M>(map: &M, x: &SVector<Bounded<V>, N>, eps: Bounded<V>) -> Option<Self>
    where
        M: KahanMap<Bounded<V>, N>,
    {
        let (numerators, denominator) = map.reduced_map(x, eps);
        let reciprocal = Bounded::one().quotient(denominator)?;
        let quotients: [Bounded<V>; N] = from_fn(|i| numerators[i] * reciprocal);
        Some(Self {
            next: quotients.map(|quotient| quotient.value()),
            errors: quotients.map(|quotient| quotient.error()),
            largest_input: quotients.iter().map(Bounded::largest_input).fold(1000, u32::min),
        })
    }

    /// The size that no input may have, so that errors of underflow are allowed for.
    #[inline(always)]
    pub(super) fn largest_input(&self) -> V::Magnitude {
        V::magnitude(f64::from_bits((1023 + u64::from(self.largest_input)) << 52))
    }

    /// Whether every error, with a rounding to `unit` besides, is less than `limit` times the largest component.
    #[inline(always)]
    pub(super) fn is_within(&self, limit: f64) -> bool {
        let largest = self.largest();
        let allowed = V::magnitude(limit - V::UNIT) * largest;
        // A state of zeros without an error is one, too. What is not a number is never less; what is infinite has a finite error
        // where only the last addition overflows.
        (largest.is_finite_number() && self.errors.iter().all(|error| V::exceeds(allowed, *error)))
            || (largest.is_zero() && self.errors.iter().all(V::Magnitude::is_zero))
    }

    /// The next state in another scalar, if it is still within `limit` times its largest component there.
    pub(super) fn rounded<T: Copy>(
        mut self,
        limit: f64,
        round: impl Fn(V) -> T,
        exactly: impl Fn(&T) -> V,
    ) -> Option<SVector<T, N>> {
        let rounded = self.next.map(round);
        for ((error, value), rounded) in self.errors.iter_mut().zip(&self.next).zip(&rounded) {
            *error += (exactly(rounded) - *value).size();
        }
        self.is_within(limit).then(|| vector(rounded))
    }

    /// What the error is at most, as a multiple of the largest component; infinite where nothing is known.
    pub(super) fn bound(&self) -> f64 {
        let worst = |worst: f64, ratio: f64| if ratio <= worst { worst } else { ratio };
        let ratio = |error: &V::Magnitude| (*error / self.largest()).approximate();
        let bound = self.errors.iter().map(ratio).fold(0.0, worst);
        if bound.is_nan() { f64::INFINITY } else { bound }
    }

    #[inline(always)]
    fn largest(&self) -> V::Magnitude {
        self.next.iter().fold(V::magnitude(0.0), |largest, value| {
            let size = value.size();
            if V::exceeds(size, largest) { size } else { largest }
        })
    }
}
