//! The scalars with a stable step, and for `f32` and `f64` a wider scalar for precision level 2.

#[cfg(feature = "std")]
use std::vec::Vec;

use crate::scalar::Wide;
use crate::scalar::bounded::{BoundedPair, Number, PackedDouble, PackedSingle, UnpackedPair};
#[cfg(feature = "std")]
use crate::scalar::{Capacity, LongNumber};
use crate::{Dd, Pivot};

pub(crate) trait PromiseScalar: Number + Pivot {
    type Packed: BoundedPair<Self>;

    /// The scalar of precision level 2, or `Self` for the widest scalar.
    type Wider: PromiseScalar;
    const IS_WIDEST: bool;

    /// The maximum number of variables for which precision level 1 uses this scalar.
    const MOST_VARIABLES: usize = usize::MAX;

    fn embed(&self) -> Self::Wider;
    fn round(value: Self::Wider) -> Self;

    fn widen(&self) -> Wide;
    fn narrow(value: Wide) -> Self;
}

impl PromiseScalar for f32 {
    type Packed = PackedSingle;
    type Wider = f64;
    const IS_WIDEST: bool = false;

    /// In more variables, products exceed the range of `f32`, and most steps would need `f64`.
    const MOST_VARIABLES: usize = 4;

    #[inline(always)]
    fn embed(&self) -> f64 {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: f64) -> Self {
        value as f32
    }

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f32()
    }
}

impl PromiseScalar for f64 {
    type Packed = PackedDouble;
    type Wider = Dd;
    const IS_WIDEST: bool = false;

    #[inline(always)]
    fn embed(&self) -> Dd {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: Dd) -> Self {
        value.into()
    }

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f64()
    }
}

impl PromiseScalar for Dd {
    type Packed = UnpackedPair<Dd>;
    type Wider = Self;
    const IS_WIDEST: bool = true;

    fn embed(&self) -> Self {
        *self
    }

    fn round(value: Self) -> Self {
        value
    }

    fn widen(&self) -> Wide {
        Wide::from_double_double(self.high(), self.low())
    }

    fn narrow(value: Wide) -> Self {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }
}

#[cfg(feature = "std")]
pub(crate) struct LongElimination<T> {
    next: Vec<T>,
    /// Whether the error of each component is proved to be at most 8 rounding units.
    is_promised: bool,
    /// Whether a larger capacity of the long numbers would give no more information.
    is_settled: bool,
}

#[cfg(feature = "std")]
impl<T: PromiseScalar> LongElimination<T> {
    pub(crate) fn of(exact: &[LongNumber]) -> Self {
        let next: Vec<T> = exact.iter().map(|number| T::narrow(number.leading())).collect();
        let is_near = |(exact, next): (&LongNumber, &T)| exact.is_within(8.0 * T::UNIT, next.widen());
        let is_promised = exact.iter().zip(&next).all(is_near);
        let is_settled = LongNumber::are_settled(exact.iter().zip(next.iter().map(T::is_finite_number)));
        Self { next, is_promised, is_settled }
    }
}

/// Eliminates with numbers of growing capacity. Stops if the error bound of x̃ is proved, or if the
/// caller's test `is_kept` accepts x̃. Returns `None` if no capacity suffices.
#[cfg(feature = "std")]
pub(crate) fn eliminated_at_any_capacity<T: Pivot>(
    eliminated: impl Fn(Capacity) -> Option<LongElimination<T>>,
    mut is_kept: impl FnMut(&[T]) -> bool,
) -> Option<Vec<T>> {
    for capacity in Capacity::ALL {
        let Some(LongElimination { next, is_promised, is_settled }) = eliminated(capacity) else { continue };
        if next.iter().all(T::is_finite_number) && (is_promised || is_kept(&next)) {
            return Some(next);
        }
        if is_settled {
            break;
        }
    }
    None
}
