//! The increment of a step before its last multiplication, so that whoever finishes the step
//! decides how to round it.

use core::array::from_fn;

use nalgebra::SVector;

use crate::Scalar;
use crate::field::linear::vector;
use crate::scalar::tuning::component;

/// The increment x̃ − x: x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ, or numeratorᵢ where there is no
/// reciprocal.
///
/// A reciprocal is that of a denominator; the factor 2ε is in the products, wherever it costs
/// least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quotients<T, const N: usize> {
    /// The numerators.
    pub numerators: [T; N],
    /// The reciprocals, where the last thing to do is a multiplication.
    pub reciprocals: [Option<T>; N],
    /// Whether reciprocals were computed one after the other.
    pub(crate) several: bool,
}

impl<T: Scalar, const N: usize> Quotients<T, N> {
    /// Increments numeratorᵢ · reciprocal.
    #[inline(always)]
    pub fn over(numerators: [T; N], reciprocal: T) -> Self {
        Self { numerators, reciprocals: from_fn(|_| Some(reciprocal.clone())), several: false }
    }

    /// Increments numeratorᵢ · reciprocalᵢ, or numeratorᵢ.
    #[inline(always)]
    pub fn over_each(numerators: [T; N], reciprocals: [Option<T>; N]) -> Self {
        Self { numerators, reciprocals, several: false }
    }

    /// The same for reciprocals one after the other, where the last may be waited for by some
    /// components only.
    #[inline(always)]
    pub fn over_several(numerators: [T; N], reciprocals: [Option<T>; N]) -> Self {
        Self { numerators, reciprocals, several: true }
    }

    /// Increments that are known as they are.
    #[inline(always)]
    pub fn whole(increments: [T; N]) -> Self {
        Self { numerators: increments, reciprocals: from_fn(|_| None), several: false }
    }

    /// x̃ − x: at most one multiplication a component.
    #[inline(always)]
    pub fn increment(&self) -> SVector<T, N> {
        vector(from_fn(|i| match &self.reciprocals[i] {
            Some(reciprocal) => self.numerators[i].clone() * reciprocal.clone(),
            None => self.numerators[i].clone(),
        }))
    }

    /// x̃ from x: one multiply-add or addition a component.
    #[inline(always)]
    pub fn added_to(self, x: &SVector<T, N>) -> SVector<T, N> {
        vector(from_fn(|i| component(self.sum(i, x[i].clone()), self.several)))
    }

    /// x̃ᵢ from xᵢ.
    #[inline(always)]
    pub(crate) fn sum(&self, i: usize, x: T) -> T {
        let numerator = self.numerators[i].clone();
        match &self.reciprocals[i] {
            Some(reciprocal) => numerator.multiply_add(reciprocal.clone(), x),
            None => x + numerator,
        }
    }

    /// x̃ and what it lacks, from x and what x lacks: the step of a compensated orbit.
    ///
    /// What x lacks is added while the step waits for its division: with b = x + c and what is left
    /// of c, t = b + n·r is the next point, and what that lacks is n·r − (t − b) and the rest of c.
    /// The critical path from state to state is that of a plain step.
    ///
    /// Where |n·r| ≤ |b| (Dekker 1971), nothing is lost but the rounding of n·r itself. Where a
    /// component is smaller than its increment, t − b is rounded, and what t lacks is wrong by at
    /// most u·|t − b|: no more than that rounding. So there is no branch.
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

    /// x̃ᵢ − xᵢ − d: one multiply-subtract or subtraction.
    #[inline(always)]
    fn less(&self, i: usize, d: T) -> T {
        let numerator = self.numerators[i].clone();
        match &self.reciprocals[i] {
            Some(reciprocal) => numerator.multiply_subtract(reciprocal.clone(), d),
            None => numerator - d,
        }
    }
}
