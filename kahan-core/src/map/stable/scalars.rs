//! Which scalars rungs work in, and which steps are promised in.

use crate::scalar::Wide;
use crate::scalar::bounded::{Both, PackedDouble, PackedSingle, Pair, Working};
use crate::{Dd, Pivot};

/// A scalar that steps can be promised in, and begin in.
pub(crate) trait Promised: Working + Pivot {
    /// A value and its magnitude, side by side in a register if there is such a one.
    type Packed: Pair<Self>;

    /// The same number.
    fn widen(&self) -> Wide;
    /// The nearest one.
    fn narrow(value: Wide) -> Self;
}

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

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f32()
    }
}

impl Promised for f64 {
    type Packed = PackedDouble;

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
