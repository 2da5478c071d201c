//! The step of a map whose ε and parameters are known: what the macro writes, and what orbits, prepared maps and
//! ensembles run.
//!
//! In: constants computed once. Out: for each state the increment x̃ − x, as numerators and the reciprocals of their
//! denominators, so that whoever finishes the step decides how to round it (fused, compensated, in lanes).

pub(crate) mod error;

use core::array::from_fn;

use nalgebra::SVector;

use crate::Scalar;
use crate::field::linear::vector;

pub use error::SingularStep;

/// x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ, or numeratorᵢ where there is no reciprocal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quotients<T, const N: usize> {
    /// The numerators.
    pub numerators: [T; N],
    /// The reciprocals of the denominators, where the last thing to do is a multiplication; the factor 2ε is in the products,
    /// wherever it costs least.
    pub reciprocals: [Option<T>; N],
}

/// What a step costs, counted in the plan that it runs: the deterministic measure by which settings are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// Additions, subtractions, multiplications and divisions; a multiply-add counts as two.
    pub operations: u32,
    /// The divisions among them.
    pub divisions: u32,
    /// Cycles from one state to the next in an orbit, where each step waits for the one before, on a core of today:
    /// additions take 3, multiplications 4, divisions 14.
    pub chain: u32,
}

impl StepCost {
    /// What elimination in n variables costs, a multiplication and an addition an entry of each row below a pivot; A(x,ε) and f(x)
    /// are taken as dense.
    pub const fn of_elimination(n: usize) -> Self {
        let n = n as u32;
        let (matrix, field) = (2 * n * n * n, n * n * (n + 1));
        let elimination = (2 * n * n * n + 9 * n * n) / 3;
        StepCost { operations: matrix + field + elimination + 3 * n, divisions: n, chain: 12 + n * 36 }
    }
}

/// A prepared constant, away from its neighbours.
///
/// Scalars side by side in memory are loaded in pairs by compilers that pack scalar code into vectors; in the dependent chain
/// of one step every such pair costs the cycles that shuffle it apart again, up to a quarter of the step.
///
/// Compilers load a single-precision constant with the twelve bytes after it, too, and compute on with all four numbers. Zeros
/// stand there: what else might lie there can be subnormal, and made a step in six variables take eight times as long.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct Apart<T>(
    /// The constant.
    pub T,
    [u32; 3],
);

impl<T> Apart<T> {
    /// The constant, away from others.
    #[inline(always)]
    pub const fn new(constant: T) -> Self {
        Self(constant, [0; 3])
    }
}

/// A step that knows its ε and its parameters.
///
/// Nothing in it allocates beyond what the scalar does, and the evaluation order is fixed.
pub trait PreparedStep<T: Scalar, const N: usize>: Clone {
    /// What one step costs; here, elimination in N variables.
    const COST: StepCost = StepCost::of_elimination(N);

    /// Whether compilers may pack the components of x̃ into vectors, as they like to.
    ///
    /// Where a step has two divisions, what closes the cycle of an orbit is a single component with a short chain: the shuffles
    /// of packing it with its neighbour would take a sixth of the step.
    const PACKS: bool = true;

    /// Whether the step has a form divided by ε besides a general one, for an ε that floats allow to divide by.
    #[doc(hidden)]
    const HAS_INVERSE_STEP: bool = false;

    /// The increment at `x` before its last multiplication, or `None` at a pole of a scalar that has no reciprocal
    /// of zero. The kernel of everything: implementations are `#[inline(always)]`, because lanes must be compiled
    /// into the function that enables their instructions.
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>>;

    /// x̃ − x.
    #[inline]
    fn increment(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        Some(self.quotients(x)?.increment())
    }

    /// x̃, the last multiplication and addition fused where the scalar can.
    #[inline(always)]
    fn next(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        let quotients = self.quotients(x)?;
        Some(quotients.finished(x, Self::component))
    }

    /// x̃ and what it lacks, from x and what x lacks: the step of a compensated orbit.
    ///
    /// What x lacks is added while the step waits for its division: with b = x + c and what is left of c, t = b + n·r is the next
    /// point, and what that lacks is n·r − (t − b) and the rest of c. The chain from state to state is that of a plain step.
    ///
    /// Where |n·r| ≤ |b| (Dekker 1971), nothing is lost but the rounding of n·r itself. Where a component is smaller than its
    /// increment, t − b is rounded, and what t lacks is wrong by at most u·|t − b|: no more than that rounding. So there is no
    /// branch.
    #[inline(always)]
    fn next_with_carry(&self, x: &SVector<T, N>, carry: &SVector<T, N>) -> Option<[SVector<T, N>; 2]> {
        let quotients = self.quotients(x)?;
        let base: SVector<T, N> = vector(from_fn(|i| x[i].clone() + carry[i].clone()));
        let rest: [T; N] = from_fn(|i| carry[i].clone() - (base[i].clone() - x[i].clone()));
        let next = quotients.clone().finished(&base, Self::component);
        let carry = vector(from_fn(|i| {
            let lacks = quotients.less(i, next[i].clone() - base[i].clone());
            Self::component(rest[i].clone() + lacks)
        }));
        Some([next, carry])
    }

    /// A component of x̃ as it is handed on: where nothing is to be packed, in a register of its own.
    #[doc(hidden)]
    #[inline(always)]
    fn component(value: T) -> T {
        if Self::PACKS && T::PACKS { value } else { value.alone() }
    }
}

/// A prepared step whose constants can be spread over the lanes of a vector register.
pub trait WideStep<T: Scalar, const N: usize>: PreparedStep<T, N> {
    /// Whether the step is straight-line code; elimination, which chooses its pivots by comparing, has no lanes.
    const HAS_LANES: bool;

    /// The same step over another scalar.
    type Wide<L: Scalar>: PreparedStep<L, N>;

    /// Each constant spread over the lanes of `L`.
    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> Self::Wide<L>;
}

impl<T: Scalar, const N: usize> Quotients<T, N> {
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
        self.finished(x, |component| component)
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

    #[inline(always)]
    pub(crate) fn finished(self, x: &SVector<T, N>, finish: impl Fn(T) -> T) -> SVector<T, N> {
        let Quotients { numerators, reciprocals } = self;
        vector(from_fn(|i| {
            let (numerator, x) = (numerators[i].clone(), x[i].clone());
            finish(match &reciprocals[i] {
                Some(reciprocal) => numerator.multiply_add(reciprocal.clone(), x),
                None => x + numerator,
            })
        }))
    }
}

#[cfg(test)]
mod tests {
    use core::mem::{align_of, offset_of, size_of};

    use super::Apart;

    #[test]
    fn zeros_fill_the_register_behind_a_single_precision_constant() {
        assert_eq!((offset_of!(Apart<f32>, 0), offset_of!(Apart<f32>, 1)), (0, 4));
        assert_eq!((size_of::<Apart<f32>>(), align_of::<Apart<f32>>()), (32, 32));
        assert_eq!(Apart::new(1.5_f32).1, [0; 3]);
    }
}
