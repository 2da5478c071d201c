//! What a number must do to run through a Kahan map.
//!
//! In: any type with the four operations and the rationals inside it. Out: the same code over
//! floats, exact rationals, dual numbers, or lanes of floats. [`Scalar`] asks for no ordering, no
//! square root and no conversion. No method shares its name with one of num-traits, so both can be
//! in scope.

mod along;
pub(crate) mod bounded;
mod constant;
mod dd;
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

pub(crate) use along::Along;
pub use constant::Constant;
pub use dd::Dd;
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
pub(crate) use wide::{Capacity, Long, level_row};
pub(crate) use wide::{Size, Wide};

/// A number that a Kahan map computes with.
///
/// To make a type one, implement the operators and [`constant`](Scalar::constant); the other
/// methods have defaults that suit an exact field.
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
    /// The scalar nearest to an exact rational.
    fn constant(c: &Constant<'_>) -> Self;

    /// 1/self, or `None` where the scalar has no such value and dividing would panic.
    ///
    /// Floats always answer (1/0 is infinite), so that their steps never branch.
    fn reciprocal(&self) -> Option<Self> {
        if self.is_zero() { None } else { Some(Self::one() / self.clone()) }
    }

    /// self/divisor, or `None` where [`reciprocal`](Self::reciprocal) has no value for the divisor.
    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        // Where reciprocals always have a value, this one is not computed.
        divisor.reciprocal()?;
        Some(self / divisor)
    }

    /// Whether elimination should divide by `self` rather than by `than`: here, a nonzero number
    /// rather than zero.
    fn is_better_pivot(&self, than: &Self) -> bool {
        than.is_zero() && !self.is_zero()
    }

    /// self·factor + addend, rounded once where the target has an instruction for that, else as
    /// written.
    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// self·factor − subtrahend, rounded as [`multiply_add`](Self::multiply_add).
    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    /// self − a·b, rounded as [`multiply_add`](Self::multiply_add).
    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    /// The number as a constant of a step, which ε and the parameters fix: a number with a
    /// derivative along the state has none as such.
    #[inline(always)]
    fn prepared(&self) -> Self {
        self.clone()
    }

    /// A nearby `f64` for reports, not for computing; not a number where there is none, as here.
    fn approximate(&self) -> f64 {
        f64::NAN
    }
}
