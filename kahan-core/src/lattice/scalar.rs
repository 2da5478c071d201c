//! The scalars of chains, with the number types that solve a step and bound the error.

#[cfg(feature = "exact")]
use num_traits::Zero;

use crate::map::{LongElimination, PromiseScalar};
#[cfg(feature = "exact")]
use crate::scalar::bounded::InputLimit;
use crate::scalar::bounded::{Bounded, KnownBounds, Number};
use crate::scalar::{Capacity, LongNumber, Size, Wide};
use crate::{Dd, Pivot, Scalar};

use super::LatticeMap;
use super::long_elimination::eliminated;
use super::parts::{NoPartSolver, PartSolver, PartWorkspace};

/// A scalar of a chain: `f32`, `f64`, [`Dd`], or with the feature `exact` `BigRational`.
#[diagnostic::on_unimplemented(
    message = "a chain of `{Self}` cannot be stepped",
    label = "not a `LatticeScalar`; for a number, write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are, with the feature `exact` also `BigRational`"
)]
#[expect(private_bounds, reason = "what judges a step is no scalar that others could give")]
pub trait LatticeScalar: Pivot + ChainArithmetic + Send + Sync {
    /// Returns |self|.
    fn absolute(&self) -> Self;
}

/// For each scalar of chains, the number types that solve a step and bound its error.
pub(super) trait ChainArithmetic: Sized {
    /// The numbers that first compute a residual and its error bound, faster than `BoundedWide`.
    type BoundedWorking: BoundedScalar<Self>;

    type Parts: PartSolver<Self>;

    /// The numbers used if the bounds of `BoundedWorking` are too large. They never underflow.
    type BoundedWide: BoundedScalar<Self>;

    const UNIT: f64;

    /// Computes x̃ by elimination over long numbers, or returns `None` for exact scalars and very
    /// long chains.
    fn eliminated<M: LatticeMap<Self>>(
        _map: &M,
        _eps: &Self,
        _x: &[Self],
        _capacity: Capacity,
    ) -> Option<LongElimination<Self>>
    where
        Self: LatticeScalar,
    {
        None
    }
}

/// Numbers with error bounds, in which formulas over T are evaluated.
pub(super) trait BoundedScalar<T>: Scalar {
    fn from_input(number: &T) -> Self;

    /// Returns this value rounded to T, with bounds of its magnitude and of its error.
    fn known(&self) -> (T, KnownBounds<Size>);
}

macro_rules! judged_in {
    ($float:ty, $wider:ty: |$number:ident| $widen:expr, |$value:ident| $round:expr) => {
        impl BoundedScalar<$float> for Bounded<$wider> {
            fn from_input($number: &$float) -> Self {
                Bounded::from_input($widen)
            }

            fn known(&self) -> ($float, KnownBounds<Size>) {
                let $value = self.value();
                let KnownBounds { size, error, largest_input } = Bounded::known(self);
                ($round, KnownBounds { size: size.into(), error: error.into(), largest_input })
            }
        }
    };
}

judged_in!(f32, f64: |number| (*number).into(), |value| value as f32);
judged_in!(f32, Wide: |number| number.widen(), |value| f32::narrow(value));
judged_in!(f64, Dd: |number| (*number).into(), |value| value.into());
judged_in!(f64, Wide: |number| number.widen(), |value| f64::narrow(value));
judged_in!(Dd, Wide: |number| number.widen(), |value| Dd::narrow(value));

macro_rules! implement_for_float {
    ($float:ty, $near:ty, $parts:ty) => {
        impl LatticeScalar for $float {
            fn absolute(&self) -> Self {
                self.abs()
            }
        }

        impl ChainArithmetic for $float {
            type Parts = $parts;
            type BoundedWorking = Bounded<$near>;
            type BoundedWide = Bounded<Wide>;

            const UNIT: f64 = <Self as Number>::UNIT;

            fn eliminated<M: LatticeMap<Self>>(
                map: &M,
                eps: &Self,
                x: &[Self],
                capacity: Capacity,
            ) -> Option<LongElimination<Self>> {
                let exact = eliminated(map, eps, x, |number| LongNumber::new(number.widen(), capacity))?;
                Some(LongElimination::of(&exact))
            }
        }
    };
}

implement_for_float!(f32, f64, PartWorkspace<f32>);
implement_for_float!(f64, Dd, PartWorkspace<f64>);
implement_for_float!(Dd, Wide, NoPartSolver);

#[cfg(feature = "exact")]
impl LatticeScalar for num_rational::BigRational {
    fn absolute(&self) -> Self {
        num_traits::Signed::abs(self)
    }
}

#[cfg(feature = "exact")]
impl ChainArithmetic for num_rational::BigRational {
    type Parts = NoPartSolver;
    type BoundedWorking = Self;
    type BoundedWide = Self;

    const UNIT: f64 = 0.0;
}

#[cfg(feature = "exact")]
impl BoundedScalar<Self> for num_rational::BigRational {
    fn from_input(number: &Self) -> Self {
        number.clone()
    }

    fn known(&self) -> (Self, KnownBounds<Size>) {
        let size = Size::from(self.approximate().abs());
        (self.clone(), KnownBounds { size, error: Size::zero(), largest_input: InputLimit::ANY })
    }
}
