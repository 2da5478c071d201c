//! Steps on `f32` states that are computed in `f64`, each rounded at its end.

use core::array::from_fn;
#[cfg(feature = "std")]
use std::vec::Vec;

use nalgebra::{SMatrix, SVector};

use crate::field::linear::vector;
use crate::step::NoLanes;
use crate::step::error::Reason;
use crate::{
    ExtendScalars, KahanMap, PreparedStep, QuadraticField, Quotients, Scalar, SingularStep, StepCost,
};
#[cfg(feature = "std")]
use crate::{Step, Stopped, Workspace};

/// A map over `f32` whose every step is computed in `f64` and rounded once.
///
/// Away from poles x̃ is the `f32` nearest to the exact x̃, except for about one component in 10⁷.
/// Near a pole exceptions are more frequent. A step takes longer than a step in `f64`, because it
/// waits for conversions (see `benches/results`). An [`Ensemble`](crate::Ensemble) runs this map
/// one trajectory at a time. A plain orbit rounds each point to `f32`, and its integrals drift as
/// in `f32`.
///
/// ```
/// use kahan_core::ThroughF64;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// let (x, eps) = (vector![1.5_f32, 1.25], 0.03125);
/// let next = ThroughF64(LotkaVolterra).step(&x, eps);
/// let exact = LotkaVolterra.step(&x.map(f64::from), f64::from(eps));
/// assert_eq!(next, exact.map(|entry| entry as f32));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThroughF64<M>(
    /// The map over `f32`.
    pub M,
);

/// A step over `f64` on `f32` states; see [`ThroughF64::of_step`].
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepThroughF64<S> {
    step: S,
    eps: f32,
}

#[cfg(feature = "std")]
impl ThroughF64<()> {
    /// Runs any step over `f64` on `f32` states, for example a chain or a map read at run time. ε
    /// and the parameters stay `f64`; [`eps`](Step::eps) returns the rounded ε. Each call of
    /// [`advance`](Step::advance) or [`part`](Step::part) allocates one `f64` state.
    pub fn of_step<S: Step<Scalar = f64>>(step: S) -> StepThroughF64<S> {
        let eps = *step.eps() as f32;
        StepThroughF64 { step, eps }
    }
}

#[cfg(feature = "std")]
impl<S: Step<Scalar = f64>> Step for StepThroughF64<S> {
    type Scalar = f32;
    type State = Vec<f32>;

    fn dimension(&self) -> usize {
        self.step.dimension()
    }

    fn eps(&self) -> &f32 {
        &self.eps
    }

    fn advance(&self, x: &mut [f32], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        let mut wide: Vec<f64> = x.iter().copied().map(f64::from).collect();
        for steps in 0..steps {
            self.step.advance(&mut wide, 1, workspace).map_err(|stopped| Stopped { steps, ..stopped })?;
            for (x, wide) in x.iter_mut().zip(&mut wide) {
                *x = *wide as f32;
                *wide = f64::from(*x);
            }
        }
        Ok(())
    }

    fn part(&self, eps: &f32, x: &mut [f32], workspace: &mut Workspace) -> Result<(), Stopped> {
        let mut wide: Vec<f64> = x.iter().copied().map(f64::from).collect();
        self.step.part(&f64::from(*eps), &mut wide, workspace)?;
        x.iter_mut().zip(wide).for_each(|(x, wide)| *x = wide as f32);
        Ok(())
    }
}

/// The prepared step of [`ThroughF64`]: a step in `f64` from an `f32` state, rounded once.
#[derive(Clone, Copy, Debug)]
pub struct ThroughF64Step<P>(P);

fn widened<const N: usize>(x: &SVector<f32, N>) -> SVector<f64, N> {
    vector(from_fn(|i| f64::from(x[i])))
}

#[inline(always)]
fn rounded<const N: usize>(x: &SVector<f64, N>) -> SVector<f32, N> {
    vector(from_fn(|i| x[i] as f32))
}

impl<P: PreparedStep<f64, N>, const N: usize> PreparedStep<f32, N> for ThroughF64Step<P> {
    const COST: StepCost = P::COST;

    type Wide<L: Scalar> = NoLanes;

    #[inline(always)]
    fn quotients(&self, x: &SVector<f32, N>) -> Option<Quotients<f32, N>> {
        let increment = self.increment(x)?;
        Some(Quotients::whole(from_fn(|i| increment[i])))
    }

    #[inline(always)]
    fn increment(&self, x: &SVector<f32, N>) -> Option<SVector<f32, N>> {
        Some(rounded(&self.0.increment(&widened(x))?))
    }

    /// Adds x, the carry and the increment at x in `f64`. Splits the sum into a point and a carry.
    #[inline(always)]
    fn next_with_carry(&self, x: &SVector<f32, N>, carry: &SVector<f32, N>) -> Option<[SVector<f32, N>; 2]> {
        let (x, carry) = (widened(x), widened(carry));
        let base = vector(from_fn(|i| x[i] + carry[i]));
        let next = self.0.quotients(&x)?.added_to(&base);
        let point = rounded(&next);
        let carry = vector(from_fn(|i| (next[i] - f64::from(point[i])) as f32));
        Some([point, carry])
    }

    #[inline(always)]
    fn next(&self, x: &SVector<f32, N>) -> Option<SVector<f32, N>> {
        Some(rounded(&self.0.next(&widened(x))?))
    }
}

impl<M: QuadraticField<f32, N>, const N: usize> QuadraticField<f32, N> for ThroughF64<M> {
    fn field(&self, x: &SVector<f32, N>) -> SVector<f32, N> {
        self.0.field(x)
    }

    fn field_jacobian(&self, x: &SVector<f32, N>) -> SMatrix<f32, N, N> {
        self.0.field_jacobian(x)
    }

    fn bilinear(&self, x: &SVector<f32, N>, y: &SVector<f32, N>) -> SVector<f32, N> {
        self.0.bilinear(x, y)
    }

    fn polarized(&self, x: &SVector<f32, N>, y: &SVector<f32, N>) -> SVector<f32, N> {
        self.0.polarized(x, y)
    }
}

impl<M> ThroughF64<M> {
    fn wide<const N: usize>(&self) -> M::Extended<f64>
    where
        M: ExtendScalars<f32, N>,
    {
        self.0.extend_scalars(|parameter| f64::from(*parameter))
    }
}

/// Computes steps, Jacobians and determinants in `f64` and rounds once. All else is computed in
/// `f32`.
impl<M: ExtendScalars<f32, N>, const N: usize> KahanMap<f32, N> for ThroughF64<M> {
    type Prepared = ThroughF64Step<<M::Extended<f64> as KahanMap<f64, N>>::Prepared>;

    #[inline]
    fn prepare(&self, eps: &f32) -> Self::Prepared {
        ThroughF64Step(self.wide().prepare(&f64::from(*eps)))
    }

    /// Rounds the step computed in `f64`. A result beyond the range of `f32` is an error.
    fn try_prepared(
        &self,
        prepared: &Self::Prepared,
        x: &SVector<f32, N>,
        eps: &f32,
    ) -> Result<SVector<f32, N>, SingularStep> {
        let (wide, x, eps) = (self.wide(), widened(x), f64::from(*eps));
        let next = rounded(&wide.try_prepared(&prepared.0, &x, &eps)?);
        if next.iter().all(|entry| entry.is_finite()) {
            Ok(next)
        } else {
            Err(SingularStep::because(Reason::BeyondRange, wide.det_matrix(&x, eps), f64::INFINITY, eps))
        }
    }

    fn has_coefficients_of_eps(&self) -> bool {
        self.0.has_coefficients_of_eps()
    }

    fn field_at(&self, x: &SVector<f32, N>, eps: &f32) -> SVector<f32, N> {
        self.0.field_at(x, eps)
    }

    fn field_jacobian_at(&self, x: &SVector<f32, N>, eps: &f32) -> SMatrix<f32, N, N> {
        self.0.field_jacobian_at(x, eps)
    }

    fn polarized_at(&self, x: &SVector<f32, N>, y: &SVector<f32, N>, eps: &f32) -> SVector<f32, N> {
        self.0.polarized_at(x, y, eps)
    }

    fn jacobian(&self, x: &SVector<f32, N>, eps: f32) -> SMatrix<f32, N, N> {
        self.wide().jacobian(&widened(x), f64::from(eps)).map(|entry| entry as f32)
    }

    fn det_matrix(&self, x: &SVector<f32, N>, eps: f32) -> f32 {
        self.wide().det_matrix(&widened(x), f64::from(eps)) as f32
    }

    fn det_jacobian(&self, x: &SVector<f32, N>, eps: f32) -> f32 {
        self.wide().det_jacobian(&widened(x), f64::from(eps)) as f32
    }
}
