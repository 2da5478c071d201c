//! What a file that writes or runs a Kahan map wants in scope: `use kahan_core::prelude::*;`.

#[cfg(feature = "std")]
pub use crate::{Axis, Ensemble, Scene};
pub use crate::{
    Composition, Dd, Integrals, KahanAt, KahanMap, Named, Pivot, QuadraticField, Scalar, ThroughF64, kahan,
    vector,
};

pub use nalgebra::{SMatrix, SVector};

#[cfg(feature = "exact")]
pub use num_rational::BigRational;
