//! The numbers with which a Kahan map computes.
//!
//! A [`Scalar`] has + − × ÷, and represents every rational exactly or rounded. One code then runs
//! over floats, exact rationals, dual numbers and SIMD lanes. The methods share no name with
//! num-traits; therefore both traits can be in scope.

pub(crate) mod bounded;
mod constant;
mod dd;
mod directional_dual;
mod dual;
pub(crate) mod embed;
mod epsilon;
#[cfg(feature = "exact")]
mod exact;
mod float;
mod float_scalar;
#[cfg(all(feature = "std", feature = "exact"))]
mod laurent;
mod operators;
pub(crate) mod tuning;
mod wide;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

pub use constant::Constant;
pub use dd::Dd;
pub(crate) use directional_dual::DirectionalDual;
pub use dual::Dual;
pub use embed::EmbedScalar;
pub use epsilon::nearest_short_eps;
pub use float_scalar::FloatScalar;
#[cfg(all(feature = "std", feature = "exact"))]
pub(crate) use laurent::Laurent;
#[cfg(all(feature = "std", any(target_arch = "x86_64", target_arch = "aarch64")))]
pub(crate) use operators::assignments;
pub(crate) use operators::operators;
#[cfg(feature = "std")]
pub(crate) use wide::{Capacity, LongNumber, equilibrate_row};
pub(crate) use wide::{Size, Wide};

/// A number with which a Kahan map computes.
///
/// Implementors write the operators and [`constant`](Scalar::constant). The other methods have
/// defaults that suit exact arithmetic.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scalar that a Kahan map can compute with",
    label = "not a `Scalar`; for a number, write `1.0`, not `1`",
    note = "`f32` and `f64` are scalars, with the feature `exact` also `BigRational`, and every type that implements \
            `kahan_core::Scalar`"
)]
pub trait Scalar:
    Clone
    + PartialEq
    + Debug
    + 'static
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// Returns the scalar nearest to an exact rational.
    fn constant(c: &Constant<'_>) -> Self;

    /// Returns 1/self, or `None` if the reciprocal does not exist and division would panic.
    ///
    /// Floats always return a number, because 1/0 is infinite.
    fn reciprocal(&self) -> Option<Self> {
        if self.is_zero() { None } else { Some(Self::one() / self.clone()) }
    }

    /// Returns self/divisor, or `None` if the divisor has no [`reciprocal`](Self::reciprocal).
    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        // The compiler removes this line for types whose numbers all have reciprocals.
        divisor.reciprocal()?;
        Some(self / divisor)
    }

    /// Returns whether `self` is the better pivot. The default prefers a nonzero number to zero.
    fn is_better_pivot(&self, than: &Self) -> bool {
        than.is_zero() && !self.is_zero()
    }

    /// Returns self·factor + addend, rounded once if the target fuses both operations.
    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// Returns self·factor − subtrahend, rounded as in [`multiply_add`](Self::multiply_add).
    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    /// Returns self − a·b, rounded as in [`multiply_add`](Self::multiply_add).
    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    /// Returns the number without its derivatives, for ε and parameters, which do not depend on the
    /// state.
    #[inline(always)]
    fn prepared(&self) -> Self {
        self.clone()
    }

    /// Returns a nearby `f64` for reports, or NaN by default.
    fn approximate(&self) -> f64 {
        f64::NAN
    }
}
