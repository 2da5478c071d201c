//! Kahan's map of a quadratic field and the objects derived from it.
//!
//! A step runs a prepared step, which is generated code, an elimination, or handwritten. Over
//! floats `try_step` of generated code prepares its own steps. All other methods except `prepare`
//! have defaults for any field, and the macro overrides some of these.

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

/// Returns ε = dt/2, half the time step.
#[inline]
pub fn eps_from_dt<T: Scalar>(dt: T) -> T {
    T::constant(&Constant::ratio(1, 2)) * dt
}

/// Kahan's map x ↦ x̃ of a quadratic field f(x) = Q(x,x) + Bx + c, with (x̃ − x)/(2ε) = Q(x,x̃) +
/// ½B(x + x̃) + c.
///
/// In every method `eps` is ε, **half the time step**. The inverse of the map is the map with −ε.
///
/// # Poles
/// The map is the *reduced* rational map, whose numerators and denominators have no common factor.
/// At a pole of this map, a float result is infinite or NaN, an exact scalar panics,
/// [`try_step`](Self::try_step) returns an error, and an exact [`Orbit`] ends. The reduced map can
/// be defined where det A(x,ε) = 0; steps and Jacobian are then defined, too. Some fields are too
/// large for reduction, for example all fields of more than eight variables. Their maps have a pole
/// wherever det A vanishes.
///
/// # Range
/// If a denominator overflows, a float step may be wrong without notice. Only `try_step` detects
/// this.
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
    /// The step at a fixed ε. Everything that depends only on ε and the parameters is already
    /// computed.
    ///
    /// A handwritten map can use [`Elimination`](crate::Elimination), which suits every field, or
    /// its own [`PreparedStep`].
    type Prepared: PreparedStep<T, N>;

    /// Prepares the step at ε.
    ///
    /// # Panics
    /// If the scalar is exact and the field divides by zero at these parameters.
    fn prepare(&self, eps: &T) -> Self::Prepared;

    /// Returns whether coefficients of the field depend on ε. If so, the map must override
    /// [`field_at`](Self::field_at), [`field_jacobian_at`](Self::field_jacobian_at) and
    /// [`polarized_at`](Self::polarized_at), whose defaults ignore ε.
    #[inline(always)]
    fn has_coefficients_of_eps(&self) -> bool {
        false
    }

    /// Returns f(x) with the coefficients at ε.
    #[inline(always)]
    fn field_at(&self, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.field(x)
    }

    /// Returns the derivative f′(x) with the coefficients at ε.
    #[inline(always)]
    fn field_jacobian_at(&self, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        let _ = eps;
        self.field_jacobian(x)
    }

    /// Returns Q(x,y) + ½B(x + y) + c for f(x) = Q(x,x) + Bx + c, whose coefficients may depend on
    /// ε. For y equal to x̃ the result is (x̃ − x)/(2ε).
    #[inline(always)]
    fn polarized_at(&self, x: &SVector<T, N>, y: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.polarized(x, y)
    }

    /// Returns the matrix A(x,ε) = I − εf′(x), with the coefficients of f at ε.
    fn matrix(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let slopes = self.field_jacobian_at(x, &eps);
        SMatrix::from_fn(|i, j| {
            let entry = -(eps.clone() * slopes[(i, j)].clone());
            if i == j { T::one() + entry } else { entry }
        })
    }

    /// Returns the right-hand side b(x,ε) = x + εBx + 2εc of A·x̃ = b, for f(x) = Q(x,x) + Bx + c.
    fn rhs(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        let origin = SVector::from_fn(|_, _| T::zero());
        // The vector `affine` is ½Bx + c.
        let affine = self.polarized_at(x, &origin, &eps);
        let dt = eps.clone() + eps;
        SVector::from_fn(|i, _| x[i].clone() + dt.clone() * affine[i].clone())
    }

    /// Returns x̃, the state after one time step 2ε.
    ///
    /// Most fields of up to eight variables use a closed form: x̃ as a reduced fraction, with few
    /// divisions. Over floats this form has no branches and never allocates. Away from
    /// poles, the error is of the order of the rounding unit if ‖εf′(x)‖ is not much above 1. Up to
    /// ‖εf′(x)‖∞ = 1000, the error is about as large as after elimination with pivoting. The
    /// documentation of a generated type may state another limit.
    ///
    /// Some fields have a faster form that divides by ε. This form is used for |ε| from 2⁻⁸⁴ to
    /// 2⁶⁴, in `f32` from 2⁻¹⁶ to 2¹⁶. A map that is too large for a closed form uses sparse
    /// elimination. If a pivot is too small, the step uses partial pivoting on the whole matrix.
    ///
    /// For many steps at a fixed ε use [`at`](Self::at) or [`orbit`](Self::orbit), which prepare
    /// the step once and give equal bits.
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole. Floats become infinite or NaN instead.
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
    /// where `exact` is the step for x, ε and the parameters as given. The rounding unit u is 2⁻⁵³
    /// for `f64`, 2⁻²⁴ for `f32` and 2⁻¹⁰² for [`Dd`](crate::Dd). Every call proves the bound by a
    /// running error analysis, in the scalar itself or in wider numbers. Ordinary points get the
    /// bits of [`step`](Self::step) at little more than the cost of a step; `benches/results` has
    /// the times. If terms of the step differ by factors like 10¹⁰⁰⁰, elimination uses up to 256 ×
    /// 64 bits. This elimination takes milliseconds, allocates, and needs `std`. In unoptimised
    /// builds wide numbers need stack space that grows with the number of variables.
    ///
    /// In more than eight variables every call instead proves a small componentwise backward error.
    /// With at most k entries in a row of A,
    ///
    ///   |A·x̃ − b|ᵢ ≤ (k + 8) u (|A|·|x̃| + |b|)ᵢ   for every i.
    ///
    /// Exact scalars give the exact step. Handwritten maps and foreign scalars get a finite result
    /// without a bound, either from `step` or from elimination with partial pivoting.
    ///
    /// # Errors
    /// Returns a [`SingularStep`] at a pole, at a point that is not finite, if x̃ is beyond the
    /// scalar's range, or if the widest numbers do not prove the bound. The error tells these cases
    /// apart.
    #[inline(always)]
    fn try_step(&self, x: &SVector<T, N>, eps: T) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.try_prepared(&self.prepare(&eps), x, &eps)
    }

    /// Runs a prepared step for [`try_step`](Self::try_step). This default serves handwritten maps.
    /// For other maps, the macro generates a step with an error bound instead.
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
    /// If the scalar is exact and `x` is a pole of the inverse map.
    #[inline]
    fn step_back(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        self.step(x, -eps)
    }

    /// Returns the Jacobian ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε). The entry in row i, column j is ∂x̃ᵢ/∂xⱼ.
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole. Float entries become infinite or NaN instead.
    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let next = self.step(x, eps.clone());
        let back = self.matrix(&next, -eps.clone());
        solve(self.matrix(x, eps.clone()), back).unwrap_or_else(|| pole(&eps))
    }

    /// Returns the determinant D(x,ε) = det A(x,ε), which is 0 at every pole. If a factor of D
    /// cancels in x̃, D is also 0 at points where the map is defined.
    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.matrix(x, eps))
    }

    /// Returns the Jacobian determinant det ∂x̃/∂x, which is det A(x̃,−ε)/det A(x,ε) if det A ≠ 0.
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole. Floats become infinite or NaN instead.
    fn det_jacobian(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.jacobian(x, eps))
    }

    /// Returns the numerators N = adj A·b and the denominator D = det A, which are defined
    /// everywhere. If D ≠ 0, x̃ = N/D.
    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        determinant_and_adjugate_product(&self.matrix(x, eps.clone()), &self.rhs(x, eps))
    }

    /// Returns the numerators and the denominator of x̃. Generated code cancels all common factors
    /// of these polynomials except constants.
    #[doc(hidden)]
    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        self.rational_map(x, eps)
    }

    /// Prepares the map at one ε for many steps.
    #[inline]
    fn at(&self, eps: T) -> KahanAt<Self, T, N> {
        KahanAt::new(self.clone(), eps)
    }

    /// Prepares the map for the time step Δt = 2ε; see [`at`](Self::at).
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

    /// Returns the orbit with the points x₀ = `x`, x₁, …. The orbit owns all its data.
    #[inline]
    fn orbit(&self, x: SVector<T, N>, eps: T) -> Orbit<KahanAt<Self, T, N>> {
        Orbit::new(self.at(eps), x)
    }
}
