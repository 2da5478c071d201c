//! Kahan's map of a quadratic field and the objects derived from it.
//!
//! In: a state x and ε, half the time step. Out: x̃, the linear system A·x̃ = b, Jacobians,
//! determinants, orbits. Every step runs through a prepared step: generated code, or elimination.
//! Other methods have defaults for any field, and the macro overrides some of them.

mod at;
mod checked;
mod coupled;
mod elimination;
mod error_estimate;
mod extension;
mod orbit;
mod pivot;
mod stable;
mod tangent;
mod through_f64;

use nalgebra::{SMatrix, SVector};

use crate::field::linear::{determinant, determinant_and_adjugate_product, solve};
use crate::step::error::pole;
use crate::{Constant, PreparedStep, QuadraticField, Scalar, SingularStep};

use checked::checked_step;

pub use at::KahanAt;
pub use coupled::{CoupledField, CoupledStep, Postfix, slopes_matrix};
pub use elimination::Elimination;
pub use error_estimate::{ErrorEstimates, Estimated};
pub use extension::ExtendScalars;
pub use orbit::{Compensated, Increments, Orbit, Scaled};
#[cfg(feature = "std")]
pub use orbit::{Projective, ProjectivePoint, ThroughPoles};
pub use pivot::Pivot;
pub use stable::stable_step;
#[cfg(feature = "std")]
pub(crate) use stable::{LongElimination, PromiseScalar, eliminated_at_any_capacity};
pub(crate) use tangent::{push_forward, push_forward_to};
#[cfg(feature = "std")]
pub use through_f64::StepThroughF64;
pub use through_f64::ThroughF64;

/// Returns ε = dt/2.
#[inline]
pub fn eps_from_dt<T: Scalar>(dt: T) -> T {
    T::constant(&Constant::ratio(1, 2)) * dt
}

/// Kahan's map x ↦ x̃ of a quadratic field f, defined by (x̃ − x)/(2ε) = Q(x,x̃) + ½B(x + x̃) + c.
///
/// `eps` is ε, **half the time step**, in every method. The inverse of the map is the map with −ε.
///
/// # Poles
/// The map is the *reduced* rational map: numerators and denominators have no common factor. At its
/// poles a float result is infinite or NaN, an exact scalar panics, [`try_step`](Self::try_step)
/// returns an error, and an exact [`Orbit`] ends. If det A(x,ε) = 0 but the reduced map has a
/// value, steps and Jacobian use that value. A field too large for reduction at compile time, such
/// as every field of more than eight variables, has a pole wherever det A vanishes.
///
/// # Range
/// If a denominator overflows, a float step may be wrong without notice, except in `try_step`.
///
/// ```
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// let x = vector![1.5_f64, 1.0];
/// let eps = kahan_core::eps_from_dt(0.1);
/// let next = LotkaVolterra.step(&x, eps);
///
/// // The defining equation.
/// let increment = LotkaVolterra.polarized(&x, &next) * (2.0 * eps);
/// assert!((next - x - increment).norm() < 1e-15);
/// ```
pub trait KahanMap<T: Scalar, const N: usize>: QuadraticField<T, N> + Clone {
    /// The step at a fixed ε, with everything computed that depends only on ε and the parameters.
    ///
    /// The macro generates this type. A handwritten map can use
    /// [`Elimination`](crate::Elimination), which suits every field, or its own [`PreparedStep`].
    type Prepared: PreparedStep<T, N>;

    /// Prepares the step at ε; an orbit and [`at`](Self::at) call this once.
    ///
    /// # Panics
    /// For exact scalars, if the field divides by zero at these parameters.
    fn prepare(&self, eps: &T) -> Self::Prepared;

    /// Returns whether coefficients of the field depend on ε. If so, the map must override
    /// [`field_at`](Self::field_at), [`field_jacobian_at`](Self::field_jacobian_at) and
    /// [`polarized_at`](Self::polarized_at), which ignore ε by default.
    #[inline(always)]
    fn has_coefficients_of_eps(&self) -> bool {
        false
    }

    /// Returns f(x) with the coefficients at ε; the increment of a step is 2ε·A(x,ε)⁻¹f(x).
    #[inline(always)]
    fn field_at(&self, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.field(x)
    }

    /// Returns f′(x) with the coefficients at ε.
    #[inline(always)]
    fn field_jacobian_at(&self, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        let _ = eps;
        self.field_jacobian(x)
    }

    /// Returns Q(x,y) + ½B(x+y) + c with the coefficients at ε; for y = x̃ this is (x̃ − x)/(2ε).
    #[inline(always)]
    fn polarized_at(&self, x: &SVector<T, N>, y: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.polarized(x, y)
    }

    /// Returns A(x,ε) = I − εf′(x), with the coefficients of f at ε.
    fn matrix(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let slopes = self.field_jacobian_at(x, &eps);
        SMatrix::from_fn(|i, j| {
            let entry = -(eps.clone() * slopes[(i, j)].clone());
            if i == j { T::one() + entry } else { entry }
        })
    }

    /// Returns the right-hand side b(x,ε) = x + εBx + 2εc.
    fn rhs(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        let origin = SVector::from_fn(|_, _| T::zero());
        // ½Bx + c
        let affine = self.polarized_at(x, &origin, &eps);
        let dt = eps.clone() + eps;
        SVector::from_fn(|i, _| x[i].clone() + dt.clone() * affine[i].clone())
    }

    /// Returns x̃, the state after one time step 2ε.
    ///
    /// Fields of ordinary size use the reduced closed form with one or two divisions. Away from
    /// poles its error is of the order of the rounding unit while ‖εf′(x)‖ is not much above 1. For
    /// longer steps it is about that of elimination with pivoting, up to ‖εf′(x)‖∞ = 1000 or the
    /// limit that the documentation of the generated type states.
    ///
    /// Over floats a closed form runs the same operations at every point, without branches or
    /// allocation. Some fields have a faster form that divides by ε, used for |ε| from 2⁻⁶⁴ to 2⁶⁴
    /// (`f32`: 2⁻¹⁶ to 2¹⁶). A map too large for a closed form uses sparse elimination in an order
    /// found at compile time. If a pivot is more than 16 times smaller than an entry of its row and
    /// an entry of its column, that step uses partial pivoting on the whole matrix.
    ///
    /// At a fixed ε use [`at`](Self::at) or [`orbit`](Self::orbit): prepared once, with equal bits.
    ///
    /// # Panics
    /// For exact scalars, at a pole; floats become infinite or NaN.
    #[inline]
    fn step(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        match self.prepare(&eps).next(x) {
            Some(next) => next,
            None => pole(&eps),
        }
    }

    /// Returns x̃ with a bound on its error, or the reason for failure.
    ///
    /// For maps generated by [`kahan!`](crate::kahan), `Ok` holds finite numbers with
    ///
    ///   ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞
    ///
    /// for x, ε and the parameters as given; u = 2⁻⁵³ for `f64`, 2⁻²⁴ for `f32` and 2⁻¹⁰² for
    /// [`Dd`](crate::Dd). Every call proves the bound by a running error analysis: first in the
    /// scalar itself, if necessary in a wider scalar, then in floating-point numbers of 17 × 64
    /// bits without overflow. If terms differ by a thousand powers of ten, elimination with up to
    /// 256 × 64 bits follows, which takes milliseconds, allocates, and needs `std`. Ordinary points
    /// get the bits of [`step`](Self::step) at little more than its cost; `benches/results` has the
    /// times. In unoptimised builds wide numbers need stack space that grows with the number of
    /// variables.
    ///
    /// In more than eight variables `Ok` instead guarantees a small componentwise backward error,
    /// proved likewise. With at most k entries in a row of A,
    ///
    ///   |A·x̃ − b|ᵢ ≤ (k + 8) u (|A|·|x̃| + |b|)ᵢ   for every i.
    ///
    /// Exact scalars give the exact step. Handwritten maps and foreign scalars get the finite
    /// result of `step`, or of elimination with partial pivoting, without a bound.
    ///
    /// # Errors
    /// [`SingularStep`] at a pole, at a point that is not finite, if x̃ is beyond the scalar's
    /// range, or if the widest numbers do not settle the bound. The error tells these cases apart.
    #[inline(always)]
    fn try_step(&self, x: &SVector<T, N>, eps: T) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.try_prepared(&self.prepare(&eps), x, &eps)
    }

    /// Runs a prepared step for [`try_step`](Self::try_step). This default serves handwritten maps;
    /// the macro overrides it by `stable_step`.
    #[doc(hidden)]
    fn try_prepared(
        &self,
        prepared: &Self::Prepared,
        x: &SVector<T, N>,
        eps: &T,
    ) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        checked_step(self, prepared, x, eps)
    }

    /// Returns the state one time step 2ε earlier, by the map with −ε.
    ///
    /// # Panics
    /// For exact scalars, at a pole of the inverse map.
    #[inline]
    fn step_back(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        self.step(x, -eps)
    }

    /// Returns ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε), with ∂x̃ᵢ/∂xⱼ in row i, column j.
    ///
    /// # Panics
    /// For exact scalars, at a pole; float entries become infinite or NaN.
    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let next = self.step(x, eps.clone());
        let back = self.matrix(&next, -eps.clone());
        solve(self.matrix(x, eps.clone()), back).unwrap_or_else(|| pole(&eps))
    }

    /// Returns D(x,ε) = det A(x,ε), which is 0 at every pole and where reduction removed one.
    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.matrix(x, eps))
    }

    /// Returns det ∂x̃/∂x, which is det A(x̃,−ε)/det A(x,ε) if det A ≠ 0.
    ///
    /// # Panics
    /// For exact scalars, at a pole; floats become infinite or NaN.
    fn det_jacobian(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.jacobian(x, eps))
    }

    /// Returns (N, D) = (adj A·b, det A) without division, defined everywhere; x̃ = N/D if D ≠ 0.
    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        determinant_and_adjugate_product(&self.matrix(x, eps.clone()), &self.rhs(x, eps))
    }

    /// Returns the reduced numerators and denominator without division, or
    /// [`rational_map`](Self::rational_map) if both differ only by a constant factor.
    #[doc(hidden)]
    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        self.rational_map(x, eps)
    }

    /// Prepares the map at one ε for many steps. The result owns a copy of this map.
    #[inline]
    fn at(&self, eps: T) -> KahanAt<Self, T, N> {
        KahanAt::new(self.clone(), eps)
    }

    /// Prepares the map of the time step Δt = 2ε; see [`at`](Self::at).
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! { pub struct Decay; xdot = -x^2; }
    ///
    /// assert_eq!(Decay.at_dt(0.2).step(&vector![1.5]), Decay.at(0.1).step(&vector![1.5]));
    /// ```
    #[inline]
    fn at_dt(&self, dt: T) -> KahanAt<Self, T, N> {
        self.at(eps_from_dt(dt))
    }

    /// Returns the orbit x₀ = `x`, x₁, …, which owns all its data.
    #[inline]
    fn orbit(&self, x: SVector<T, N>, eps: T) -> Orbit<KahanAt<Self, T, N>> {
        Orbit::new(self.at(eps), x)
    }
}
