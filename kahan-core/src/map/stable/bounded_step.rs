//! One attempt at a step over numbers with error bounds.

use core::array::from_fn;
use core::cell::Cell;

use nalgebra::SVector;

use num_traits::{One, Zero};

use crate::field::linear::vector;
use crate::scalar::bounded::{Bounded, BoundedPair, InputLimit, Magnitude, Number, underflow};
use crate::{ExtendScalars, KahanMap, Pivot, PreparedStep, Quotients};

/// A next state and its error bound. The bound excludes two roundings: those of the increment
/// numerator·reciprocal and of its addition to x.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundedStep<V: Number, const N: usize> {
    pub(super) next: [V; N],
    /// The error bound, as a multiple of the rounding unit of V.
    error: V::Magnitude,
    largest_input: InputLimit,
}

impl<V: Number, const N: usize> BoundedStep<V, N> {
    /// Computes the step over numbers with error bounds. The values equal the fast step bit for
    /// bit. Returns `None` if a denominator may be zero, or if an input is so large that the bound
    /// does not cover underflow.
    #[inline(always)]
    pub(super) fn of<T: Pivot, P: BoundedPair<V>, M: ExtendScalars<T, N>>(
        map: &M,
        x: &SVector<T, N>,
        eps: &T,
        embed: impl Fn(&T) -> V,
    ) -> Option<Self> {
        // The sum of all magnitudes bounds each input, and is NaN if an input is NaN.
        let sum = Cell::new(embed(eps).size());
        let given = |number: &T| {
            let value = embed(number);
            sum.set(sum.get() + value.size());
            Bounded::<V, P>::from_input(value)
        };
        let state = SVector::from_fn(|i, _| given(&x[i]));
        // Avoids `PreparedStep::finish`, because compilers would not inline its closure.
        let prepared = map.extend_scalars(given).prepare(&Bounded::<V, P>::from_input(embed(eps)));
        let attempt = Self::by_increments(&state, prepared.quotients(&state)?);
        attempt.largest_input.allows(sum.get()).then_some(attempt)
    }

    #[inline(always)]
    pub(super) fn by_increments<P: BoundedPair<V>>(
        x: &SVector<Bounded<V, P>, N>,
        quotients: Quotients<Bounded<V, P>, N>,
    ) -> Self {
        let Quotients { numerators, reciprocals, several } = quotients;
        let roundings = numerators.iter().map(Bounded::roundings).fold(0, u32::max);
        let values = Quotients {
            numerators: numerators.map(|numerator| numerator.value()),
            reciprocals: reciprocals.map(|reciprocal| reciprocal.map(|reciprocal| reciprocal.value())),
            several,
        };
        let [next] = values.added_to(&vector(from_fn(|i| x[i].value()))).data.0;
        let underflow = V::Magnitude::of(underflow::<V>(roundings));
        let magnitudes = numerators.map(|numerator| numerator.magnitude());
        // An increment without a reciprocal gets the weight of the reciprocal 1. Compilers would
        // not inline a closure here.
        let mut weights = [V::Magnitude::zero(); N];
        for (weight, reciprocal) in weights.iter_mut().zip(&reciprocals) {
            *weight = match reciprocal {
                Some(reciprocal) => reciprocal.weight(roundings),
                None => Bounded::<V, P>::one().weight(roundings),
            };
        }
        let mut largest_input = InputLimit::ANY;
        for (numerator, reciprocal) in numerators.iter().zip(&reciprocals) {
            largest_input = largest_input.and(numerator.largest_input());
            if let Some(reciprocal) = reciprocal {
                largest_input = largest_input.and(reciprocal.largest_input());
            }
        }
        Self {
            next,
            error: if several {
                largest::<V, N>(from_fn(|i| magnitudes[i] * weights[i]))
                    + underflow * largest::<V, N>(weights)
            } else {
                // This product bounds the errors of all components.
                (largest::<V, N>(magnitudes) + underflow) * largest::<V, N>(weights)
            },
            largest_input,
        }
    }

    /// Computes x̃ as a reduced fraction N/D of expanded polynomials. This avoids cancellation
    /// between the state and an increment.
    pub(super) fn by_reduced_map<M: KahanMap<Bounded<V>, N>>(
        map: &M,
        x: &SVector<Bounded<V>, N>,
        eps: Bounded<V>,
    ) -> Option<Self> {
        let (numerators, denominator) = map.reduced_map(x, eps);
        let reciprocal = Bounded::one().quotient(denominator)?;
        let quotients: [Bounded<V>; N] = from_fn(|i| numerators[i] * reciprocal);
        Some(Self {
            next: quotients.map(|quotient| quotient.value()),
            error: largest::<V, N>(quotients.map(|quotient| quotient.error())) / V::Magnitude::of(V::UNIT),
            largest_input: quotients
                .iter()
                .map(Bounded::largest_input)
                .fold(InputLimit::ANY, InputLimit::and),
        })
    }

    /// Returns whether the error is below `limit`·‖x̃‖∞, even after one more rounding.
    #[inline(always)]
    pub(super) fn is_within(&self, limit: f64) -> bool {
        let largest = self.largest();
        // If a component is NaN or overflows, the error is NaN or infinite, and this comparison is
        // false. The condition after `||` accepts an exact zero state.
        V::Magnitude::of((limit - V::UNIT) / V::UNIT) * largest > self.error
            || (largest.is_zero() && self.error.is_zero())
    }

    /// Rounds the state to another scalar. Returns `None` if the rounded state is not finite, or if
    /// its error exceeds `limit` times the maximum norm.
    pub(super) fn rounded<T: Pivot + Copy>(
        mut self,
        limit: f64,
        round: impl Fn(V) -> T,
        exactly: impl Fn(&T) -> V,
    ) -> Option<SVector<T, N>> {
        let rounded = self.next.map(round);
        let changes = largest::<V, N>(from_fn(|i| (exactly(&rounded[i]) - self.next[i]).size()));
        self.error = self.error + changes / V::Magnitude::of(V::UNIT);
        (rounded.iter().all(T::is_finite_number) && self.is_within(limit)).then(|| vector(rounded))
    }

    /// Returns the error bound relative to the largest component, infinite if no bound is known.
    pub(super) fn bound(&self) -> f64 {
        let units: f64 = (self.error / self.largest()).into();
        if units.is_nan() { f64::INFINITY } else { units * V::UNIT }
    }

    #[inline(always)]
    fn largest(&self) -> V::Magnitude {
        largest::<V, N>(self.next.map(|value| value.size()))
    }
}

#[inline(always)]
fn largest<V: Number, const N: usize>(sizes: [V::Magnitude; N]) -> V::Magnitude {
    let larger = |one, other| if other > one { other } else { one };
    sizes.into_iter().reduce(larger).unwrap_or_else(|| V::Magnitude::of(0.0))
}
