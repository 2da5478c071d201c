//! The step of a field that is too large for a closed form, by sparse elimination.
//!
//! The macro supplies the entries of f and f′, and their positions in the matrix A(x,ε) = I −
//! εf′(x). If a pivot is too small, partial pivoting on the whole matrix replaces sparse
//! elimination.

mod backward;
mod formulas;

use core::array::from_fn;
use core::marker::PhantomData;

use nalgebra::{ArrayStorage, SMatrix, SVector};

use crate::field::couplings::Couplings;
use crate::field::linear::{components, solve_in_place, vector};
use crate::scalar::tuning::{is, same};
use crate::step::NoLanes;
use crate::step::error::pole;
use crate::{Dd, KahanMap, Pivot, PreparedStep, Quotients, Scalar, SingularStep, StepCost};

use super::checked::checked_step;
use super::stable::PromiseScalar;

use backward::promised;
pub use formulas::Postfix;

/// The formulas of a field f with N variables, P parameters and M nonzero entries of f′. The matrix
/// A = I − εf′ has S entries, including the entries that elimination fills in.
pub trait CoupledField<const N: usize, const P: usize, const M: usize, const S: usize>: 'static {
    /// The positions of the entries of A, the matrix of the step.
    const COUPLINGS: Couplings<'static>;
    /// The components of f as a postfix table.
    const FIELD: &'static [Postfix<'static>];
    /// The entries of the derivative f′ as a postfix table, in the order of `COUPLINGS`.
    const SLOPES: &'static [Postfix<'static>];
    /// The cost of one step.
    const COST: StepCost;

    /// Returns f(x), the value of the field.
    fn field<T: Scalar>(parameters: &[T; P], x: &[T; N]) -> [T; N];

    /// Returns the entries of the derivative f′(x) in the order of `COUPLINGS`.
    fn slopes<T: Scalar>(parameters: &[T; P], x: &[T; N]) -> [T; M];

    /// Returns A(x,ε)⁻¹f(x), or `None` if a pivot is too small. The macro may override this by
    /// straight-line code with equal operations.
    fn velocity<T: Scalar>(parameters: &[T; P], x: &[T; N], eps: &T) -> Option<[T; N]> {
        let factors = Factors::<T, S>::of::<N, M>(&Self::COUPLINGS, &Self::slopes(parameters, x), eps)?;
        let mut velocity = Self::field(parameters, x);
        factors.solve(&Self::COUPLINGS, &mut velocity);
        Some(velocity)
    }
}

struct Factors<T, const S: usize>([T; S]);

impl<T: Scalar, const S: usize> Factors<T, S> {
    fn of<const N: usize, const M: usize>(
        couplings: &Couplings<'_>,
        slopes: &[T; M],
        eps: &T,
    ) -> Option<Self> {
        let mut values = from_fn(|_| T::zero());
        couplings.fill(slopes, eps, &mut values);
        let mut row: [T; N] = from_fn(|_| T::zero());
        couplings.factor(&mut values, &mut row).then_some(Self(values))
    }

    /// Replaces b by A⁻¹b. The entries of b are in the order of the variables.
    fn solve<const N: usize>(&self, couplings: &Couplings<'_>, b: &mut [T; N]) {
        let mut ordered: [T; N] = from_fn(|k| b[couplings.order[k] as usize].clone());
        couplings.solve(&self.0, &mut ordered);
        for (turn, value) in couplings.order.iter().zip(ordered) {
            b[*turn as usize] = value;
        }
    }
}

/// The prepared step of a [`CoupledField`].
pub struct CoupledStep<K, T, const N: usize, const P: usize, const M: usize, const S: usize> {
    parameters: [T; P],
    eps: T,
    field: PhantomData<fn() -> K>,
}

impl<K, T: Clone, const N: usize, const P: usize, const M: usize, const S: usize>
    CoupledStep<K, T, N, P, M, S>
{
    /// Prepares the step with these parameters, at `eps`, half the time step.
    pub fn new(parameters: [T; P], eps: T) -> Self {
        Self { parameters, eps, field: PhantomData }
    }
}

impl<K, T: Clone, const N: usize, const P: usize, const M: usize, const S: usize> Clone
    for CoupledStep<K, T, N, P, M, S>
{
    fn clone(&self) -> Self {
        Self::new(self.parameters.clone(), self.eps.clone())
    }
}

impl<K, T: Copy, const N: usize, const P: usize, const M: usize, const S: usize> Copy
    for CoupledStep<K, T, N, P, M, S>
{
}

/// Returns the derivative f′(x) as a dense matrix, built from its nonzero entries.
pub fn slopes_matrix<K, T, const N: usize, const P: usize, const M: usize, const S: usize>(
    slopes: [T; M],
) -> SMatrix<T, N, N>
where
    K: CoupledField<N, P, M, S>,
    T: Scalar,
{
    let mut matrix = zeros();
    for ((i, j), slope) in K::COUPLINGS.pairs().zip(slopes) {
        matrix[(i, j)] = slope;
    }
    matrix
}

/// Returns a zero matrix. Callers fill it in place, so that only one copy lies on the stack.
#[inline(never)]
fn zeros<T: Scalar, const N: usize>() -> SMatrix<T, N, N> {
    SMatrix::from_array_storage(ArrayStorage(from_fn(|_| from_fn(|_| T::zero()))))
}

impl<K: CoupledField<N, P, M, S>, T: Scalar, const N: usize, const P: usize, const M: usize, const S: usize>
    CoupledStep<K, T, N, P, M, S>
{
    #[inline(never)]
    fn write_matrix(&self, x: &[T; N], eps: &T, matrix: &mut SMatrix<T, N, N>) {
        for ((i, j), slope) in K::COUPLINGS.pairs().zip(K::slopes(&self.parameters, x)) {
            matrix[(i, j)] = -(eps.clone() * slope);
        }
        for i in 0..N {
            matrix[(i, i)] = T::one() + matrix[(i, i)].clone();
        }
    }

    #[cold]
    #[inline(never)]
    fn solve_by_pivoting<const C: usize>(&self, x: &[T; N], b: &mut SMatrix<T, N, C>) -> Option<()> {
        let mut matrix = zeros();
        self.write_matrix(x, &self.eps, &mut matrix);
        solve_in_place(&mut matrix, b)
    }

    #[cold]
    #[inline(never)]
    fn pivoted(&self, x: &[T; N]) -> Option<SVector<T, N>> {
        let mut velocity = vector(K::field(&self.parameters, x));
        self.solve_by_pivoting(x, &mut velocity)?;
        let time_step = self.eps.clone() + self.eps.clone();
        Some(velocity.map(|entry| time_step.clone() * entry))
    }

    /// Returns x̃ with a proved backward error for `f32`, `f64` and `Dd`. Other scalars get the
    /// checked step.
    ///
    /// # Errors
    /// Returns the errors of [`KahanMap::try_step`](crate::KahanMap::try_step).
    pub fn promised<F>(&self, map: &F, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep>
    where
        F: KahanMap<T, N, Prepared = Self>,
        T: Pivot,
    {
        if is::<T, f64>() {
            self.promised_in::<f64>(x)
        } else if is::<T, f32>() {
            self.promised_in::<f32>(x)
        } else if is::<T, Dd>() {
            self.promised_in::<Dd>(x)
        } else {
            checked_step(map, self, x, &self.eps)
        }
    }

    fn promised_in<F: PromiseScalar>(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep> {
        let step = CoupledStep::new(*same::<[T; P], [F; P]>(&self.parameters), *same(&self.eps));
        let next = promised::<K, F, N, P, M, S>(&step, same(x))?;
        Ok(same::<SVector<F, N>, SVector<T, N>>(&next).clone())
    }

    /// Returns the Jacobian ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε), with A(x,ε) = I − εf′(x).
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole.
    pub fn jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        let Some(next) = self.next(x) else { pole(&self.eps) };
        let mut back = zeros();
        self.write_matrix(components(&next), &-self.eps.clone(), &mut back);
        let slopes = K::slopes(&self.parameters, components(x));
        match Factors::<T, S>::of::<N, M>(&K::COUPLINGS, &slopes, &self.eps) {
            Some(factors) => back.data.0.iter_mut().for_each(|column| factors.solve(&K::COUPLINGS, column)),
            None => {
                if self.solve_by_pivoting(components(x), &mut back).is_none() {
                    pole(&self.eps)
                }
            }
        }
        back
    }
}

impl<K, T, const N: usize, const P: usize, const M: usize, const S: usize> PreparedStep<T, N>
    for CoupledStep<K, T, N, P, M, S>
where
    K: CoupledField<N, P, M, S>,
    T: Scalar,
{
    const COST: StepCost = K::COST;

    type Wide<L: Scalar> = NoLanes;

    #[inline]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        let x = components(x);
        let [increments] = match K::velocity(&self.parameters, x, &self.eps) {
            Some(velocity) => {
                let time_step = self.eps.clone() + self.eps.clone();
                [velocity.map(|entry| time_step.clone() * entry)]
            }
            None => self.pivoted(x)?.data.0,
        };
        Some(Quotients::whole(increments))
    }
}
