//! The scalars that steps are promised in: each with the wider one of its second rung.
//!
//! In: a number of a scalar. Out: that number in wider ones, and the nearest number back.

#[cfg(feature = "std")]
use std::vec::Vec;

use crate::scalar::Wide;
use crate::scalar::bounded::{Both, Number, PackedDouble, PackedSingle, Pair};
#[cfg(feature = "std")]
use crate::scalar::{Capacity, Long};
use crate::{Dd, Pivot};

/// A scalar that steps can be promised in, and begin in.
pub(crate) trait Promised: Number + Pivot {
    /// A value and its magnitude, side by side in a register if there is such a one.
    type Packed: Pair<Self>;

    /// The scalar of the second rung; the widest scalar has none, and stands for itself.
    type Wider: Promised;
    /// Whether there is no wider scalar.
    const IS_WIDEST: bool;

    /// The most variables in which the first rung is this scalar itself.
    const MOST_VARIABLES: usize = usize::MAX;

    /// This number in the wider scalar.
    fn embed(&self) -> Self::Wider;
    /// The number nearest to one of the wider scalar.
    fn round(value: Self::Wider) -> Self;

    /// This number in digits that lie anywhere.
    fn widen(&self) -> Wide;
    /// The number nearest to one of such digits.
    fn narrow(value: Wide) -> Self;
}

impl Promised for f32 {
    type Packed = PackedSingle;
    type Wider = f64;
    const IS_WIDEST: bool = false;

    /// In more variables a step multiplies many factors. Products of ordinary numbers then leave the
    /// range of `f32`, and nearly every step would be computed in `f64` after all.
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

impl Promised for f64 {
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

impl Promised for Dd {
    type Packed = Both<Dd>;
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

/// x̃ by elimination over numbers of many digits.
#[cfg(feature = "std")]
pub(crate) struct Eliminated<T> {
    /// Rounded.
    next: Vec<T>,
    /// Whether each component is within 8u of the true one, which keeps the promise of a small
    /// backward error.
    is_promised: bool,
    /// Whether a larger capacity would tell nothing new.
    is_settled: bool,
}

#[cfg(feature = "std")]
impl<T: Promised> Eliminated<T> {
    /// Rounds x̃ and judges the result.
    pub(crate) fn of(exact: &[Long]) -> Self {
        let next: Vec<T> = exact.iter().map(|number| T::narrow(number.leading())).collect();
        let is_near = |(exact, next): (&Long, &T)| exact.is_within(8.0 * T::UNIT, next.widen());
        let is_promised = exact.iter().zip(&next).all(is_near);
        let is_settled = Long::are_settled(exact.iter().zip(next.iter().map(T::is_finite_number)));
        Self { next, is_promised, is_settled }
    }
}

/// Eliminates over more and more digits until x̃ is promised, by its digits or, as `is_kept` sees,
/// by its backward error; `None` where that is never so.
#[cfg(feature = "std")]
pub(crate) fn eliminated_at_any_capacity<T: Pivot>(
    eliminated: impl Fn(Capacity) -> Option<Eliminated<T>>,
    mut is_kept: impl FnMut(&[T]) -> bool,
) -> Option<Vec<T>> {
    for capacity in Capacity::ALL {
        let Some(Eliminated { next, is_promised, is_settled }) = eliminated(capacity) else { continue };
        if next.iter().all(T::is_finite_number) && (is_promised || is_kept(&next)) {
            return Some(next);
        }
        if is_settled {
            break;
        }
    }
    None
}
