//! Kahan's map of a quadratic field, and everything that follows from it.
//!
//! In: a state x and ε, half the time step. Out: x̃, the matrix A and right-hand side b of the
//! linear system A·x̃ = b, Jacobians, determinants, orbits. Every step goes through a prepared one,
//! which knows ε and the parameters: that is what the macro writes, or what elimination does for
//! any field. All else has defaults, correct for every field; the macro overrides those for which
//! it knows a closed form. What a prepared map or an orbit holds between steps lives in modules of
//! their own.

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
pub(crate) use stable::{Eliminated, Promised, eliminated_at_any_capacity};
pub(crate) use tangent::{carry, carry_to};
#[cfg(feature = "std")]
pub use through_f64::StepThroughF64;
pub use through_f64::ThroughF64;

/// ε from the time step: ε = dt/2.
#[inline]
pub fn eps_from_dt<T: Scalar>(dt: T) -> T {
    T::constant(&Constant::ratio(1, 2)) * dt
}

/// Kahan's map x ↦ x̃ of a quadratic field f, defined by (x̃ − x)/(2ε) = Q(x,x̃) + ½B(x + x̃) + c.
///
/// In every method `eps` is ε, **half the time step**. The inverse of the map is the map with −ε.
///
/// # Poles
/// The map is the *reduced* rational map: numerators and denominators without common factors. A
/// pole is a point where that has no value; there a float result is not finite, and an exact scalar
/// panics, except in [`try_step`](Self::try_step), which says so, and in an [`Orbit`], which ends.
/// Where det A(x,ε) = 0 but the reduced map has a value, the steps and the Jacobian are that
/// value's. For fields too large to be reduced while compiling, all of more than eight variables
/// among them, every point with det A = 0 is a pole.
///
/// # Range
/// A float step whose denominator overflows may silently be wrong; `try_step` knows, the other
/// methods do not.
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
    /// The step of this map at a known ε, with all that depends on ε and the parameters alone
    /// computed.
    ///
    /// The macro writes a type of its own here. A map that is written by hand takes
    /// [`Elimination<Self, T>`](crate::Elimination), which suits every field, or a [`PreparedStep`]
    /// of its own.
    type Prepared: PreparedStep<T, N>;

    /// Prepares the step at ε: what an orbit or [`at`](Self::at) computes once.
    ///
    /// # Panics
    /// Where the field divides by zero at these parameters, for exact scalars.
    fn prepare(&self, eps: &T) -> Self::Prepared;

    /// Whether coefficients of the field depend on ε. A map for which they do implements
    /// [`field_at`](Self::field_at), [`field_jacobian_at`](Self::field_jacobian_at) and
    /// [`polarized_at`](Self::polarized_at); by default these are free of ε.
    #[inline(always)]
    fn has_coefficients_of_eps(&self) -> bool {
        false
    }

    /// f(x) with the coefficients that the map has at ε: the increment of a step is
    /// 2ε·A(x,ε)⁻¹f(x).
    #[inline(always)]
    fn field_at(&self, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.field(x)
    }

    /// f′(x) with the coefficients that the map has at ε.
    #[inline(always)]
    fn field_jacobian_at(&self, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        let _ = eps;
        self.field_jacobian(x)
    }

    /// Q(x,y) + ½B(x+y) + c with the coefficients that the map has at ε: at (x,x̃) the increment of
    /// a step over 2ε.
    #[inline(always)]
    fn polarized_at(&self, x: &SVector<T, N>, y: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        let _ = eps;
        self.polarized(x, y)
    }

    /// A(x,ε) = I − εf′(x), the matrix of the linear system A(x,ε)·x̃ = b(x,ε). Coefficients of f
    /// that depend on ε are those at this ε.
    fn matrix(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let slopes = self.field_jacobian_at(x, &eps);
        SMatrix::from_fn(|i, j| {
            let entry = -(eps.clone() * slopes[(i, j)].clone());
            if i == j { T::one() + entry } else { entry }
        })
    }

    /// b(x,ε) = x + εBx + 2εc, the right-hand side of A(x,ε)·x̃ = b(x,ε).
    fn rhs(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        let origin = SVector::from_fn(|_, _| T::zero());
        // ½Bx + c
        let affine = self.polarized_at(x, &origin, &eps);
        let dt = eps.clone() + eps;
        SVector::from_fn(|i, _| x[i].clone() + dt.clone() * affine[i].clone())
    }

    /// x̃, the state one time step of 2ε later.
    ///
    /// The fast tier: for the fields of ordinary size the reduced closed form with one division, or
    /// two, whose error is of the order of the scalar's rounding unit away from poles while ‖ε
    /// f′(x)‖ is not much above 1; in longer steps it is about that of elimination with pivoting up
    /// to ‖ε f′(x)‖∞ = 1000, or up to what the documentation of the generated type says.
    ///
    /// Over floats every point takes the same operations and the same time: nothing is tested, and
    /// nothing is allocated. Only ε chooses between two forms, where a field has a faster one that
    /// divides by ε: that is used for |ε| from 2⁻⁶⁴ to 2⁶⁴ (`f32`: 2⁻¹⁶ to 2¹⁶), the other beyond.
    /// Where the map is too large to be reduced a step eliminates along the couplings, in an order
    /// found while compiling. A pivot that is smaller than an entry of its row and one of its
    /// column by more than a factor of 16 sends that step to partial pivoting on the whole matrix.
    ///
    /// In a loop with one ε use [`at`](Self::at) or [`orbit`](Self::orbit): they compute what
    /// depends on ε and the parameters once, and give the same numbers bit for bit.
    ///
    /// # Panics
    /// At a pole, for exact scalars; floats give a result that is not finite.
    #[inline]
    fn step(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        match self.prepare(&eps).next(x) {
            Some(next) => next,
            None => pole(&eps),
        }
    }

    /// x̃ with a promise, or why there is none.
    ///
    /// The stable tier. For the maps that [`kahan!`](crate::kahan) writes, `Ok` holds finite
    /// numbers with
    ///
    ///   ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞
    ///
    /// for x, ε and the parameters as given, u = 2⁻⁵³ for `f64`, 2⁻²⁴ for `f32` and 2⁻¹⁰² for
    /// [`Dd`](crate::Dd). It is established for this very call: the step runs with an error bound
    /// beside each of its values, first in the scalar's own precision, and where that proves too
    /// little in the next (`f64` for an `f32`, [`Dd`](crate::Dd) for an `f64`), then in 17 digits
    /// of 64 bits, wherever these lie, where nothing overflows and sums of terms of any sizes are
    /// exact. What these leave open (terms a thousand powers of ten apart) elimination settles over
    /// 256 such digits: that takes milliseconds and allocates, and needs `std`. An ordinary point
    /// gets the bits of [`step`](Self::step) at little more than its price, and points near poles
    /// or far out at a multiple of it; `benches/results` has the times. Until the last rung nothing
    /// is allocated, but without optimisation the wide numbers need some of the stack: the more,
    /// the more variables a dense field has.
    ///
    /// In more than eight variables `Ok` holds finite numbers with a small componentwise backward
    /// error instead, established as strictly after at most two refinements, or after elimination
    /// over many digits where numbers leave the range: with A and b exact at x, ε and the
    /// parameters as given, and k the most entries in a row of A,
    ///
    ///   |A·x̃ − b|ᵢ ≤ (k + 8) u (|A|·|x̃| + |b|)ᵢ   for every i.
    ///
    /// Exact scalars give the exact step. A map written by hand, and a scalar of a user's own, get
    /// the result of `step`, or where that left the scalar's range, of elimination with partial
    /// pivoting: finite, without a bound.
    ///
    /// # Errors
    /// [`SingularStep`] at a pole, at a point that is not finite, where x̃ is beyond the scalar's
    /// range, and where not even the last digits settle the bound; it says which of these is the
    /// case.
    #[inline(always)]
    fn try_step(&self, x: &SVector<T, N>, eps: T) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.try_prepared(&self.prepare(&eps), x, &eps)
    }

    /// [`try_step`](Self::try_step) with the step prepared. [`KahanAt`] calls it. The macro writes
    /// another body for it: `stable_step`, whose result has a bound. This one is for maps written
    /// by hand.
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

    /// The inverse map, which is the map with −ε: the state one time step of 2ε earlier.
    ///
    /// # Panics
    /// At a pole of the inverse map, for exact scalars, as [`step`](Self::step).
    #[inline]
    fn step_back(&self, x: &SVector<T, N>, eps: T) -> SVector<T, N> {
        self.step(x, -eps)
    }

    /// ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε), with the entry ∂x̃ᵢ/∂xⱼ in row i, column j.
    ///
    /// # Panics
    /// At a pole, for exact scalars; floats give entries that are not finite.
    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        let next = self.step(x, eps.clone());
        let back = self.matrix(&next, -eps.clone());
        solve(self.matrix(x, eps.clone()), back).unwrap_or_else(|| pole(&eps))
    }

    /// D(x,ε) = det A(x,ε): 0 at every pole, and also at the poles that the reduced map has lost.
    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.matrix(x, eps))
    }

    /// det ∂x̃/∂x; where det A is not 0, it is det A(x̃,−ε)/det A(x,ε).
    ///
    /// # Panics
    /// At a pole, for exact scalars; a float is not finite there.
    fn det_jacobian(&self, x: &SVector<T, N>, eps: T) -> T {
        determinant(self.jacobian(x, eps))
    }

    /// (N, D) = (adj A·b, det A), unreduced, without a division: x̃ = N/D where D is not 0. Defined
    /// everywhere.
    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        determinant_and_adjugate_product(&self.matrix(x, eps.clone()), &self.rhs(x, eps))
    }

    /// The reduced numerators and denominator without a division, where they are other than those
    /// of [`rational_map`](Self::rational_map) up to a constant.
    #[doc(hidden)]
    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        self.rational_map(x, eps)
    }

    /// The map at one ε, prepared to be stepped many times; it owns a copy of this map.
    #[inline]
    fn at(&self, eps: T) -> KahanAt<Self, T, N> {
        KahanAt::new(self.clone(), eps)
    }

    /// The map of the time step Δt = 2ε; see [`at`](Self::at).
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

    /// The orbit x₀, x₁, …, beginning with x₀ = `x`; it owns all that it needs.
    #[inline]
    fn orbit(&self, x: SVector<T, N>, eps: T) -> Orbit<KahanAt<Self, T, N>> {
        Orbit::new(self.at(eps), x)
    }
}
