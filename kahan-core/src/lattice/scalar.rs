//! Which scalars chains are made of, and how each is solved for.

use crate::ensemble::lanes::InLanes;
use crate::{Dd, Pivot};

use super::LatticeMap;
use super::parts::InParts;
use super::sites::Site;

/// A scalar of a chain: `f32`, `f64`, [`Dd`], with the feature `exact` also `BigRational`.
#[diagnostic::on_unimplemented(
    message = "a chain of `{Self}` cannot be stepped",
    label = "not a `LatticeScalar`; for a number, write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are, with the feature `exact` also `BigRational`"
)]
pub trait LatticeScalar: Pivot + Send + Sync {
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
