//! Which scalars chains are made of, and how each is solved for.

use crate::ensemble::lanes::InLanes;
use crate::scalar::Wide;
use crate::scalar::bounded::{Bounded, Number, power_of_two};
use crate::{Dd, Pivot, Scalar};

use super::LatticeMap;
use super::parts::InParts;
use super::sites::Site;

/// A scalar of a chain: `f32`, `f64`, [`Dd`], with the feature `exact` also `BigRational`.
#[diagnostic::on_unimplemented(
    message = "a chain of `{Self}` cannot be stepped",
    label = "not a `LatticeScalar`; for a number, write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are, with the feature `exact` also `BigRational`"
)]
#[expect(private_bounds, reason = "what judges a step is no scalar that others could give")]
pub trait LatticeScalar: Pivot + Judged + Send + Sync {
    /// |self|
    fn absolute(&self) -> Self;

    /// How many parts of a chain are eliminated side by side; none for scalars without lanes.
    #[doc(hidden)]
    const PARTS: Option<usize> = None;

    /// One step in parts, if they can vouch for it; otherwise the state stays as it is.
    #[doc(hidden)]
    fn step_in_parts<M: LatticeMap<Self>>(
        _parts: &mut InParts<Self>,
        _map: &M,
        _constants: &[Self],
        _twice: &Self,
        _site: &mut Site<Self>,
        _state: &mut [Self],
    ) -> bool {
        false
    }
}

/// A scalar whose steps can be judged.
pub(super) trait Judged: Sized {
    /// Wider numbers, with bounds on their errors, that tell how good a step is.
    type Judge: Scalar;

    /// u, the relative error of an operation; 0 of an exact scalar.
    const UNIT: f64;

    /// The same number.
    fn judged(&self) -> Self::Judge;

    /// The nearest number, and what is known of the value.
    fn known(value: &Self::Judge) -> (Self, Known);
}

/// What is known of a value of a formula: a number, and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) size: f64,
    pub(super) error: f64,
    /// No input may be larger, or underflow was not allowed for.
    pub(super) largest_input: f64,
}

impl Known {
    /// What the size is at least: a little less, which pays for the roundings of sums of sizes too;
    /// nothing where the error is no small part of it.
    pub(super) fn at_least(self) -> f64 {
        if 64.0 * self.error <= self.size { 62.0 / 64.0 * self.size } else { 0.0 }
    }
}

/// The promise of a float, judged in a wider one.
macro_rules! judged_in {
    ($float:ty, $wider:ty: |$number:ident| $widen:expr, |$value:ident| $round:expr) => {
        impl Judged for $float {
            type Judge = Bounded<$wider>;

            const UNIT: f64 = <Self as Number>::UNIT;

            fn judged(&self) -> Self::Judge {
                let $number = *self;
                Bounded::given($widen)
            }

            fn known(value: &Self::Judge) -> (Self, Known) {
                let $value = value.value();
                let largest_input = power_of_two(value.largest_input().min(1000) as i32);
                let (size, error) = ($value.size().into(), value.error().into());
                ($round, Known { size, error, largest_input })
            }
        }
    };
}

macro_rules! implement_for_float {
    ($float:ty) => {
        impl LatticeScalar for $float {
            fn absolute(&self) -> Self {
                self.abs()
            }

            #[doc(hidden)]
            const PARTS: Option<usize> = Some(<$float as InLanes>::MOST);

            #[doc(hidden)]
            fn step_in_parts<M: LatticeMap<Self>>(
                parts: &mut InParts<Self>,
                map: &M,
                constants: &[Self],
                twice: &Self,
                site: &mut Site<Self>,
                state: &mut [Self],
            ) -> bool {
                parts.step(map, constants, twice, site, state)
            }
        }
    };
}

implement_for_float!(f32);
implement_for_float!(f64);

judged_in!(f32, f64: |number| number.into(), |value| value as f32);
judged_in!(f64, Dd: |number| number.into(), |value| value.into());
judged_in!(Dd, Wide: |number| Wide::from_double_double(number.high(), number.low()), |value| {
    let (high, low) = value.to_double_double();
    Dd::new(high, low)
});

impl LatticeScalar for Dd {
    fn absolute(&self) -> Self {
        self.abs()
    }
}

#[cfg(feature = "exact")]
impl LatticeScalar for num_rational::BigRational {
    fn absolute(&self) -> Self {
        num_traits::Signed::abs(self)
    }
}

#[cfg(feature = "exact")]
impl Judged for num_rational::BigRational {
    type Judge = Self;

    const UNIT: f64 = 0.0;

    fn judged(&self) -> Self {
        self.clone()
    }

    fn known(value: &Self) -> (Self, Known) {
        (value.clone(), Known { size: value.approximate().abs(), error: 0.0, largest_input: f64::INFINITY })
    }
}
