//! The step of a field whose map is too large to be reduced, by elimination along its couplings.
//!
//! In: the entries of f′ and f as the macro writes them, and tables of where they stand. Out:
//! increments x̃ − x = 2ε·A(x,ε)⁻¹f(x), Jacobians, and a step with a small backward error. Where a
//! pivot is too small, partial pivoting on the whole matrix takes over: no leading minor may hurt.

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
use super::stable::Promised;

use backward::promised;
pub use formulas::Postfix;

/// The formulas of a field in N variables with P parameters: M entries of f′, and S places in which
/// A is eliminated.
pub trait CoupledField<const N: usize, const P: usize, const M: usize, const S: usize>: 'static {
    /// Where A has entries.
    const COUPLINGS: Couplings<'static>;
    /// f as a table.
    const FIELD: &'static [Postfix<'static>];
    /// The entries of f′ as a table, in the order of their places.
    const SLOPES: &'static [Postfix<'static>];
    /// What one step costs.
    const COST: StepCost;

    /// f(x)
    fn field<T: Scalar>(parameters: &[T; P], x: &[T; N]) -> [T; N];

    /// The entries of f′(x), in the order of their places.
    fn slopes<T: Scalar>(parameters: &[T; P], x: &[T; N]) -> [T; M];

    /// A(x,ε)⁻¹f(x), or `None` where a pivot is too small: by the tables, or in a straight line of
    /// the same operations.
    fn velocity<T: Scalar>(parameters: &[T; P], x: &[T; N], eps: &T) -> Option<[T; N]> {
        let factors = Factors::<T, S>::of::<N, M>(&Self::COUPLINGS, &Self::slopes(parameters, x), eps)?;
        let mut velocity = Self::field(parameters, x);
        factors.solve(&Self::COUPLINGS, &mut velocity);
        Some(velocity)
    }
}

/// A(x,ε) = L·U, in S places.
struct Factors<T, const S: usize>([T; S]);

impl<T: Scalar, const S: usize> Factors<T, S> {
    /// `None` where a pivot is too small.
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

    /// Replaces b by A⁻¹b, in the order of the variables.
    fn solve<const N: usize>(&self, couplings: &Couplings<'_>, b: &mut [T; N]) {
        let mut ordered: [T; N] = from_fn(|k| b[couplings.order[k] as usize].clone());
        couplings.solve(&self.0, &mut ordered);
        for (turn, value) in couplings.order.iter().zip(ordered) {
            b[*turn as usize] = value;
        }
    }
}

/// The prepared step of a [`CoupledField`]: its parameters and ε.
pub struct CoupledStep<K, T, const N: usize, const P: usize, const M: usize, const S: usize> {
    parameters: [T; P],
    eps: T,
    field: PhantomData<fn() -> K>,
}

impl<K, T: Clone, const N: usize, const P: usize, const M: usize, const S: usize>
    CoupledStep<K, T, N, P, M, S>
{
    /// The step at these parameters and ε, half the time step.
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

/// f′(x) from its entries.
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

/// A matrix is made where it stays and worked on in its place: a copy of two hundred rows is a good
/// part of a thread's stack.
#[inline(never)]
fn zeros<T: Scalar, const N: usize>() -> SMatrix<T, N, N> {
    SMatrix::from_array_storage(ArrayStorage(from_fn(|_| from_fn(|_| T::zero()))))
}

impl<K: CoupledField<N, P, M, S>, T: Scalar, const N: usize, const P: usize, const M: usize, const S: usize>
    CoupledStep<K, T, N, P, M, S>
{
    /// Writes A(x,ε) over zeros.
    #[inline(never)]
    fn write_matrix(&self, x: &[T; N], eps: &T, matrix: &mut SMatrix<T, N, N>) {
        for ((i, j), slope) in K::COUPLINGS.pairs().zip(K::slopes(&self.parameters, x)) {
            matrix[(i, j)] = -(eps.clone() * slope);
        }
        for i in 0..N {
            matrix[(i, i)] = T::one() + matrix[(i, i)].clone();
        }
    }

    /// Replaces B by A(x,ε)⁻¹B, by partial pivoting.
    #[cold]
    #[inline(never)]
    fn solve_by_pivoting<const C: usize>(&self, x: &[T; N], b: &mut SMatrix<T, N, C>) -> Option<()> {
        let mut matrix = zeros();
        self.write_matrix(x, &self.eps, &mut matrix);
        solve_in_place(&mut matrix, b)
    }

    /// The increment by partial pivoting, where elimination in the order of the couplings does not
    /// do.
    #[cold]
    #[inline(never)]
    fn pivoted(&self, x: &[T; N]) -> Option<SVector<T, N>> {
        let mut velocity = vector(K::field(&self.parameters, x));
        self.solve_by_pivoting(x, &mut velocity)?;
        let time_step = self.eps.clone() + self.eps.clone();
        Some(velocity.map(|entry| time_step.clone() * entry))
    }

    /// The step with a promise of its backward error; for a scalar that gives none, a finite step.
    ///
    /// # Errors
    /// As [`KahanMap::try_step`](crate::KahanMap::try_step).
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

    /// The promised step over F, which T is.
    fn promised_in<F: Promised>(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep> {
        let step = CoupledStep::new(*same::<[T; P], [F; P]>(&self.parameters), *same(&self.eps));
        let next = promised::<K, F, N, P, M, S>(&step, same(x))?;
        Ok(same::<SVector<F, N>, SVector<T, N>>(&next).clone())
    }

    /// ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε).
    ///
    /// # Panics
    /// At a pole of an exact scalar.
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

    /// `None` where det A(x,ε) = 0, for a scalar that has no reciprocal of zero.
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
