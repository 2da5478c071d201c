//! Which scalars chains are made of, and how each is solved for.

#[cfg(feature = "exact")]
use num_traits::Zero;

use crate::map::{Eliminated, Promised};
#[cfg(feature = "exact")]
use crate::scalar::bounded::Limit;
use crate::scalar::bounded::{Bounded, Known, Number};
use crate::scalar::{Capacity, Long, Size, Wide};
use crate::{Dd, Pivot, Scalar};

use super::LatticeMap;
use super::far::eliminated;
use super::parts::{InParts, NoParts, Parted};

/// A scalar of a chain: `f32`, `f64`, [`Dd`], with the feature `exact` also `BigRational`.
#[diagnostic::on_unimplemented(
    message = "a chain of `{Self}` cannot be stepped",
    label = "not a `LatticeScalar`; for a number, write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are, with the feature `exact` also `BigRational`"
)]
#[expect(private_bounds, reason = "what judges a step is no scalar that others could give")]
pub trait LatticeScalar: Pivot + Solved + Send + Sync {
    /// |self|
    fn absolute(&self) -> Self;
}

/// How chains of a scalar are solved, and their steps judged.
pub(super) trait Solved: Sized {
    /// Wider numbers that tell how good a step is.
    type Near: Judge<Self>;

    /// What steps a long chain in parts, side by side in lanes.
    type Parts: Parted<Self>;

    /// Still wider ones, for what the others leave open: in these nothing underflows.
    type Far: Judge<Self>;

    /// u, the relative error of an operation; 0 of an exact scalar.
    const UNIT: f64;

    /// x̃ by elimination over numbers of many digits; none of an exact scalar, whose steps are
    /// exact, and of very long chains.
    fn eliminated<M: LatticeMap<Self>>(
        _map: &M,
        _eps: &Self,
        _x: &[Self],
        _capacity: Capacity,
    ) -> Option<Eliminated<Self>>
    where
        Self: LatticeScalar,
    {
        None
    }
}

/// Numbers with bounds on their errors, in which a formula over T is judged.
pub(super) trait Judge<T>: Scalar {
    /// The same number.
    fn given(number: &T) -> Self;

    /// The nearest number of T, and what is known of the value.
    fn known(&self) -> (T, Known<Size>);
}

/// How numbers of a float become wider ones, and back.
macro_rules! judged_in {
    ($float:ty, $wider:ty: |$number:ident| $widen:expr, |$value:ident| $round:expr) => {
        impl Judge<$float> for Bounded<$wider> {
            fn given($number: &$float) -> Self {
                Bounded::given($widen)
            }

            fn known(&self) -> ($float, Known<Size>) {
                let $value = self.value();
                let Known { size, error, largest_input } = Bounded::known(self);
                ($round, Known { size: size.into(), error: error.into(), largest_input })
            }
        }
    };
}

judged_in!(f32, f64: |number| (*number).into(), |value| value as f32);
judged_in!(f32, Wide: |number| number.widen(), |value| f32::narrow(value));
judged_in!(f64, Dd: |number| (*number).into(), |value| value.into());
judged_in!(f64, Wide: |number| number.widen(), |value| f64::narrow(value));
judged_in!(Dd, Wide: |number| number.widen(), |value| Dd::narrow(value));

/// A float, judged in a wider one, and what steps its chains in parts.
macro_rules! implement_for_float {
    ($float:ty, $near:ty, $parts:ty) => {
        impl LatticeScalar for $float {
            fn absolute(&self) -> Self {
                self.abs()
            }
        }

        impl Solved for $float {
            type Parts = $parts;
            type Near = Bounded<$near>;
            type Far = Bounded<Wide>;

            const UNIT: f64 = <Self as Number>::UNIT;

            fn eliminated<M: LatticeMap<Self>>(
                map: &M,
                eps: &Self,
                x: &[Self],
                capacity: Capacity,
            ) -> Option<Eliminated<Self>> {
                let exact = eliminated(map, eps, x, |number| Long::new(number.widen(), capacity))?;
                Some(Eliminated::of(&exact))
            }
        }
    };
}

implement_for_float!(f32, f64, InParts<f32>);
implement_for_float!(f64, Dd, InParts<f64>);
implement_for_float!(Dd, Wide, NoParts);

#[cfg(feature = "exact")]
impl LatticeScalar for num_rational::BigRational {
    fn absolute(&self) -> Self {
        num_traits::Signed::abs(self)
    }
}

#[cfg(feature = "exact")]
impl Solved for num_rational::BigRational {
    type Parts = NoParts;
    type Near = Self;
    type Far = Self;

    const UNIT: f64 = 0.0;
}

/// Nothing is left open.
#[cfg(feature = "exact")]
impl Judge<Self> for num_rational::BigRational {
    fn given(number: &Self) -> Self {
        number.clone()
    }

    fn known(&self) -> (Self, Known<Size>) {
        let size = Size::from(self.approximate().abs());
        (self.clone(), Known { size, error: Size::zero(), largest_input: Limit::ANY })
    }
}
