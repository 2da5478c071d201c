//! Which scalars chains are made of, and how each is solved for.

use crate::{Dd, Pivot};

/// A scalar of a chain: `f32`, `f64`, [`Dd`], with the feature `exact` also `BigRational`.
#[diagnostic::on_unimplemented(
    message = "a chain of `{Self}` cannot be stepped",
    label = "not a `LatticeScalar`; for a number, write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are, with the feature `exact` also `BigRational`"
)]
pub trait LatticeScalar: Pivot {
    /// |self|
    fn absolute(&self) -> Self;
}

impl LatticeScalar for f32 {
    fn absolute(&self) -> Self {
        self.abs()
    }
}

impl LatticeScalar for f64 {
    fn absolute(&self) -> Self {
        self.abs()
    }
}

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
