//! What a file that writes or runs a Kahan map wants in scope: `use kahan_core::prelude::*;`.

pub use crate::{Dd, Integrals, KahanMap, Named, Pivot, QuadraticField, Scalar, kahan, vector};

pub use nalgebra::{SMatrix, SVector};

#[cfg(feature = "exact")]
pub use num_rational::BigRational;
