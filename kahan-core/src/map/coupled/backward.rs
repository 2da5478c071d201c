//! The step with a small backward error, for more than eight variables.
//!
//! In every row i of the linear system A·x̃ = b, the result x̃ satisfies |A·x̃ − b|ᵢ ≤ (k +
//! 8)·u·(|A|·|x̃| + |b|)ᵢ. A row of A has at most k entries, and u is the rounding unit. Residuals
//! with error bounds prove the result, or error bounds of an elimination with many digits. A
//! residual b − A·x̃ is computed as 2εf − A·(x̃ − x), because these terms are small if ε is small.

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use crate::SingularStep;
use crate::field::linear::{components, eliminated_determinant, solve_in_place, vector};
use crate::map::stable::PromiseScalar;
#[cfg(feature = "std")]
use crate::map::stable::{LongElimination, eliminated_at_any_capacity};
use crate::scalar::bounded::{Bounded, Number, backward_error};
#[cfg(feature = "std")]
use crate::scalar::{Capacity, LongNumber, equilibrate_row};
use crate::step::error::Reason;

use super::formulas::PostfixEvaluator;
use super::{CoupledField, CoupledStep, Factors, zeros};

const REFINEMENTS: usize = 2;

/// The residual b − A·x̃ of a solution x̃, with a bound of the backward error.
struct Residual<T, const N: usize> {
    residual: [T; N],
    /// An upper bound of the componentwise backward error, infinite if unknown.
    bound: f64,
}

#[inline(never)]
pub(super) fn promised<K, T, const N: usize, const P: usize, const M: usize, const S: usize>(
    step: &CoupledStep<K, T, N, P, M, S>,
    x: &SVector<T, N>,
) -> Result<SVector<T, N>, SingularStep>
where
    K: CoupledField<N, P, M, S>,
    T: PromiseScalar,
{
    let backward = BackwardStep { step, x: components(x) };
    if const { T::IS_WIDEST } {
        backward.promised(|next| backward.rest_in_wide(next))
    } else {
        backward.promised(|next| backward.residual(next, T::embed, T::round))
    }
}

struct BackwardStep<'a, K, T, const N: usize, const P: usize, const M: usize, const S: usize> {
    step: &'a CoupledStep<K, T, N, P, M, S>,
    x: &'a [T; N],
}

impl<K, T, const N: usize, const P: usize, const M: usize, const S: usize> BackwardStep<'_, K, T, N, P, M, S>
where
    K: CoupledField<N, P, M, S>,
    T: PromiseScalar,
{
    fn promise() -> f64 {
        (K::COUPLINGS.widest_row() as f64 + 8.0) * T::UNIT
    }

    /// Tries sparse elimination, then partial pivoting. The function `rest` computes the residual
    /// of x̃. If the residual is too inaccurate, wide numbers compute it again.
    fn promised(&self, rest: impl Fn(&[T; N]) -> Residual<T, N>) -> Result<SVector<T, N>, SingularStep> {
        let given = self.x.iter().chain(&self.step.parameters).chain([&self.step.eps]);
        if !given.clone().all(T::is_finite_number) {
            return Err(SingularStep::because(
                Reason::NotFinite,
                f64::NAN,
                f64::INFINITY,
                self.step.eps.approximate(),
            ));
        }
        let slopes = K::slopes(&self.step.parameters, self.x);
        let mut least = f64::INFINITY;
        let factors = Factors::<T, S>::of::<N, M>(&K::COUPLINGS, &slopes, &self.step.eps);
        if let Some(factors) = factors {
            let solution = |mut b: [T; N]| {
                factors.solve(&K::COUPLINGS, &mut b);
                b
            };
            if let Some(next) = self.refined(solution, &rest, &mut least) {
                return Ok(next);
            }
        }
        self.promised_by_pivoting(&rest, &mut least)
    }

    #[cold]
    #[inline(never)]
    fn promised_by_pivoting(
        &self,
        rest: &impl Fn(&[T; N]) -> Residual<T, N>,
        least: &mut f64,
    ) -> Result<SVector<T, N>, SingularStep> {
        let solution = |b: [T; N]| {
            let mut solution = vector(b);
            match self.solve_scaled(&mut solution) {
                Some(()) => *components(&solution),
                None => from_fn(|_| T::zero() / T::zero()),
            }
        };
        if let Some(next) = self.refined(solution, rest, least) {
            return Ok(next);
        }
        #[cfg(feature = "std")]
        if let Some(next) = eliminated_at_any_capacity(
            |capacity| self.eliminated(capacity).map(|exact| LongElimination::of(&exact)),
            |next| {
                let Residual { bound, .. } = self.rest_in_wide(&from_fn(|i| next[i]));
                *least = bound.min(*least);
                bound <= Self::promise()
            },
        ) {
            return Ok(vector(from_fn(|i| next[i])));
        }
        let [determinant, scaled] = self.determinants();
        let reason = if scaled.is_zero() { Reason::Pole } else { Reason::Refined };
        Err(SingularStep::because(reason, determinant.approximate(), *least, self.step.eps.approximate()))
    }

    #[cfg(feature = "std")]
    #[inline(never)]
    fn eliminated(&self, capacity: Capacity) -> Option<[LongNumber; N]> {
        let long = |number: &T| LongNumber::new(number.widen(), capacity);
        let (eps, parameters) =
            (long(&self.step.eps), from_fn::<_, P, _>(|k| long(&self.step.parameters[k])));
        let x: [LongNumber; N] = from_fn(|i| long(&self.x[i]));
        let mut velocity = vector(from_fn::<_, N, _>(|_| LongNumber::zero()));
        for (entry, component) in velocity.iter_mut().zip(PostfixEvaluator::of(K::FIELD, &parameters, &x)) {
            *entry = component;
        }
        let mut matrix: SMatrix<LongNumber, N, N> = zeros();
        for ((i, j), slope) in K::COUPLINGS.pairs().zip(PostfixEvaluator::of(K::SLOPES, &parameters, &x)) {
            matrix[(i, j)] = -(eps.clone() * slope);
        }
        for i in 0..N {
            matrix[(i, i)] += LongNumber::one();
            equilibrate_row(matrix.row_mut(i).iter_mut(), &mut velocity[i]);
        }
        solve_in_place(&mut matrix, &mut velocity)?;
        let time_step = eps.clone() + eps;
        Some(from_fn(|i| x[i].clone() + time_step.clone() * velocity[i].clone()))
    }

    /// Writes A(x,ε) with each row divided by its largest entry, and returns the reciprocals of
    /// these entries.
    fn scale(&self, matrix: &mut SMatrix<T, N, N>) -> [T; N] {
        self.step.write_matrix(self.x, &self.step.eps, matrix);
        let scales: [T; N] = from_fn(|i| {
            let row = matrix.row(i);
            let larger = |one: T, other: &T| if other.magnitude_exceeds(&one) { *other } else { one };
            T::one() / row.iter().fold(T::zero(), larger)
        });
        for (i, scale) in scales.iter().enumerate() {
            matrix.row_mut(i).iter_mut().for_each(|entry| *entry *= *scale);
        }
        scales
    }

    #[inline(never)]
    fn solve_scaled(&self, b: &mut SVector<T, N>) -> Option<()> {
        let mut matrix = zeros();
        let scales = self.scale(&mut matrix);
        b.iter_mut().zip(scales).for_each(|(entry, scale)| *entry *= scale);
        solve_in_place(&mut matrix, b)
    }

    #[inline(never)]
    fn determinants(&self) -> [T; 2] {
        let mut matrix = zeros();
        self.step.write_matrix(self.x, &self.step.eps, &mut matrix);
        let own = eliminated_determinant(&mut matrix);
        matrix.iter_mut().for_each(|entry| *entry = T::zero());
        self.scale(&mut matrix);
        [own, eliminated_determinant(&mut matrix)]
    }

    /// Refines x̃ iteratively, and returns it if its backward error is small enough. Lowers `least`
    /// to the smallest error bound found on the way.
    fn refined(
        &self,
        solution: impl Fn([T; N]) -> [T; N],
        rest: impl Fn(&[T; N]) -> Residual<T, N>,
        least: &mut f64,
    ) -> Option<SVector<T, N>> {
        let promise = Self::promise();
        let time_step = self.step.eps + self.step.eps;
        let velocity = solution(K::field(&self.step.parameters, self.x));
        let first: [T; N] = from_fn(|i| self.x[i] + time_step * velocity[i]);
        let mut attempt = |rest: &dyn Fn(&[T; N]) -> Residual<T, N>| {
            let mut next = first;
            for turn in 0..=REFINEMENTS {
                if !next.iter().all(T::is_finite_number) {
                    return None;
                }
                let Residual { residual, bound } = rest(&next);
                *least = bound.min(*least);
                if bound <= promise {
                    return Some(vector(next));
                }
                if turn < REFINEMENTS {
                    let correction = solution(residual);
                    let better: [T; N] = from_fn(|i| next[i] + correction[i]);
                    if better == next {
                        return None;
                    }
                    next = better;
                }
            }
            None
        };
        attempt(&rest).or_else(|| attempt(&|next| self.rest_in_wide(next)))
    }

    #[cold]
    #[inline(never)]
    fn rest_in_wide(&self, next: &[T; N]) -> Residual<T, N> {
        self.residual(next, T::widen, T::narrow)
    }

    fn residual<V: Number>(
        &self,
        next: &[T; N],
        embed: impl Fn(&T) -> V,
        round: impl Fn(V) -> T,
    ) -> Residual<T, N> {
        let mut sum = V::Magnitude::zero();
        let mut given = |number: &T| {
            let value = embed(number);
            sum = sum + value.size();
            Bounded::<V>::from_input(value)
        };
        let eps = given(&self.step.eps);
        let parameters: [Bounded<V>; P] = from_fn(|k| given(&self.step.parameters[k]));
        let x: [Bounded<V>; N] = from_fn(|i| given(&self.x[i]));
        let next: [Bounded<V>; N] = from_fn(|i| given(&next[i]));
        // Let left = 2f(x) + f′(x)(x̃ − x) and right = 2f(x) − f′(x)x. Then the residual is ε·left
        // − (x̃ − x), and the right-hand side is b = x + ε·right.
        let mut left = [Bounded::<V>::zero(); N];
        for (left, component) in left.iter_mut().zip(PostfixEvaluator::of(K::FIELD, &parameters, &x)) {
            *left = component + component;
        }
        let mut right = left;
        let mut diagonal = [Bounded::<V>::one(); N];
        let mut sizes = [V::Magnitude::zero(); N];
        for ((i, j), slope) in K::COUPLINGS.pairs().zip(PostfixEvaluator::of(K::SLOPES, &parameters, &x)) {
            left[i] += slope * (next[j] - x[j]);
            right[i] -= slope * x[j];
            let entry = eps * slope;
            if i == j {
                diagonal[i] -= entry;
            } else {
                sizes[i] = sizes[i] + entry.known().at_least() * next[j].value().size();
            }
        }
        let mut bound = 0.0_f64;
        let residual = from_fn(|i| {
            let residual = eps * left[i] - (next[i] - x[i]);
            let own = diagonal[i].known().at_least() * next[i].value().size();
            let right = (x[i] + eps * right[i]).known();
            bound = bound.max(backward_error(residual.known(), sizes[i] + own, right, sum));
            round(residual.value())
        });
        Residual { residual, bound }
    }
}
