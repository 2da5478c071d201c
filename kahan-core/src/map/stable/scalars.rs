//! Which scalars rungs work in, and which steps are promised in.

use nalgebra::SVector;

use crate::scalar::Wide;
use crate::scalar::bounded::{Both, PackedDouble, PackedSingle, Pair, Working};
use crate::{Dd, ExtendScalars, Pivot, SingularStep};

use super::rungs::{beyond, in_next_wider, in_own_precision, in_wide, or_higher};

/// A scalar that steps can be promised in, and begin in.
pub(crate) trait Promised: Working + Pivot {
    /// A value and its magnitude, side by side in a register if there is such a one.
    type Packed: Pair<Self>;

    /// The same number.
    fn widen(&self) -> Wide;
    /// The nearest one.
    fn narrow(value: Wide) -> Self;

    /// The step with its promise: by the first rung, or where that proves too little by the next.
    #[inline(always)]
    fn promised<M, const N: usize>(
        map: &M,
        x: &SVector<Self, N>,
        eps: &Self,
    ) -> Result<SVector<Self, N>, SingularStep>
    where
        M: ExtendScalars<Self, N>,
    {
        or_higher(in_own_precision(map, x, eps), in_wide, map, x, eps)
    }
}

/// The variables up to which `f32` works for itself. Steps in more variables multiply so many
/// factors that products of ordinary numbers leave its range, and nearly every step would be
/// computed in `f64` after all.
const MOST_OF_SINGLE: usize = 4;

/// One whose second rung is the next wider scalar.
pub(crate) trait Widened: Promised {
    /// That scalar.
    type Wider: Promised;

    /// The same number.
    fn embed(&self) -> Self::Wider;
    /// The nearest one.
    fn round(value: Self::Wider) -> Self;
}

impl Widened for f32 {
    type Wider = f64;

    #[inline(always)]
    fn embed(&self) -> f64 {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: f64) -> Self {
        value as f32
    }
}

impl Widened for f64 {
    type Wider = Dd;

    #[inline(always)]
    fn embed(&self) -> Dd {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: Dd) -> Self {
        value.into()
    }
}

impl Promised for f32 {
    type Packed = PackedSingle;

    #[inline(always)]
    fn promised<M, const N: usize>(
        map: &M,
        x: &SVector<Self, N>,
        eps: &Self,
    ) -> Result<SVector<Self, N>, SingularStep>
    where
        M: ExtendScalars<Self, N>,
    {
        if const { N > MOST_OF_SINGLE } {
            or_higher(in_next_wider(map, x, eps), in_wide, map, x, eps)
        } else {
            or_higher(in_own_precision(map, x, eps), beyond, map, x, eps)
        }
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

    #[inline(always)]
    fn promised<M, const N: usize>(
        map: &M,
        x: &SVector<Self, N>,
        eps: &Self,
    ) -> Result<SVector<Self, N>, SingularStep>
    where
        M: ExtendScalars<Self, N>,
    {
        or_higher(in_own_precision(map, x, eps), beyond, map, x, eps)
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

    fn widen(&self) -> Wide {
        Wide::from_double_double(self.high(), self.low())
    }

    fn narrow(value: Wide) -> Self {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }
}
