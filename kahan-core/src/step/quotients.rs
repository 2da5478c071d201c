//! The increment of a step, before a last multiplication that can be fused with an addition.

use core::array::from_fn;

use nalgebra::SVector;

use crate::Scalar;
use crate::field::linear::vector;
use crate::scalar::tuning::component;

/// The increment x̃ − x in unevaluated form:
///
/// x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ, or numeratorᵢ without a reciprocal.
///
/// The numerators or the reciprocals contain the factor 2ε.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quotients<T, const N: usize> {
    /// The numerators of the increments.
    pub numerators: [T; N],
    /// The reciprocals of the denominators, `None` if the numerator is already the increment.
    pub reciprocals: [Option<T>; N],
    /// Whether later reciprocals are computed from earlier reciprocals.
    pub(crate) several: bool,
}

impl<T: Scalar, const N: usize> Quotients<T, N> {
    /// Creates the increments numeratorᵢ · reciprocal.
    #[inline(always)]
    pub fn over(numerators: [T; N], reciprocal: T) -> Self {
        Self { numerators, reciprocals: from_fn(|_| Some(reciprocal.clone())), several: false }
    }

    /// Creates the increments numeratorᵢ · reciprocalᵢ, or numeratorᵢ if there is no reciprocal.
    #[inline(always)]
    pub fn over_each(numerators: [T; N], reciprocals: [Option<T>; N]) -> Self {
        Self { numerators, reciprocals, several: false }
    }

    /// Creates increments as [`over_each`](Self::over_each) does, for reciprocals that are computed
    /// one after another. At least one component needs a reciprocal.
    #[inline(always)]
    pub fn over_several(numerators: [T; N], reciprocals: [Option<T>; N]) -> Self {
        Self { numerators, reciprocals, several: true }
    }

    /// Creates increments without reciprocals.
    #[inline(always)]
    pub fn whole(increments: [T; N]) -> Self {
        Self { numerators: increments, reciprocals: from_fn(|_| None), several: false }
    }

    /// Returns the increment x̃ − x, with at most one multiplication per component.
    #[inline(always)]
    pub fn increment(&self) -> SVector<T, N> {
        vector(from_fn(|i| match &self.reciprocals[i] {
            Some(reciprocal) => self.numerators[i].clone() * reciprocal.clone(),
            None => self.numerators[i].clone(),
        }))
    }

    /// Returns the next state x̃, with one multiply-add or one addition per component.
    #[inline(always)]
    pub fn added_to(self, x: &SVector<T, N>) -> SVector<T, N> {
        vector(from_fn(|i| component(self.sum(i, x[i].clone()), self.several)))
    }

    #[inline(always)]
    pub(crate) fn sum(&self, i: usize, x: T) -> T {
        let numerator = self.numerators[i].clone();
        match &self.reciprocals[i] {
            Some(reciprocal) => numerator.multiply_add(reciprocal.clone(), x),
            None => x + numerator,
        }
    }

    /// Returns the next state x̃ and its carry, from x and its carry c. A carry is the rounding
    /// error of a state on a compensated orbit.
    ///
    /// Let b be the rounded sum x + c, and rest = c − (b − x) its rounding error. With the
    /// increment n·r,
    ///
    /// x̃ = t = b + n·r, carry = (n·r − (t − b)) + rest.
    ///
    /// If |n·r| ≤ |b|, t − b is exact (Dekker 1971), and only the rounding error of n·r is lost.
    /// Otherwise t − b is rounded, and this error is lost, too. The latency is that of a plain
    /// step, because the carry is added while the step waits for its division.
    #[inline(always)]
    pub fn added_with_carry(self, x: &SVector<T, N>, carry: &SVector<T, N>) -> [SVector<T, N>; 2] {
        let base: SVector<T, N> = vector(from_fn(|i| x[i].clone() + carry[i].clone()));
        let rest: [T; N] = from_fn(|i| carry[i].clone() - (base[i].clone() - x[i].clone()));
        let next = self.clone().added_to(&base);
        let carry = vector(from_fn(|i| {
            let lacks = self.less(i, next[i].clone() - base[i].clone());
            component(rest[i].clone() + lacks, self.several)
        }));
        [next, carry]
    }

    #[inline(always)]
    fn less(&self, i: usize, d: T) -> T {
        let numerator = self.numerators[i].clone();
        match &self.reciprocals[i] {
            Some(reciprocal) => numerator.multiply_subtract(reciprocal.clone(), d),
            None => numerator - d,
        }
    }
}
