//! The imports for a file that writes or runs a Kahan map: `use kahan_core::prelude::*;`.

#[cfg(feature = "std")]
pub use crate::{Axis, Ensemble, LatticeMap};
pub use crate::{
    Composition, Dd, Integrals, KahanAt, KahanMap, Named, Pivot, QuadraticField, Scalar, SingularStep,
    ThroughF64, eps_from_dt, include_kahan, kahan, vector,
};

pub use nalgebra::{SMatrix, SVector};

// If these traits are in scope, rustc's errors explain which declaration a `kahan!` block lacks.
#[doc(hidden)]
pub use crate::undeclared::{IntegerParameters as _, WithoutDensity as _, WithoutIntegrals as _};

#[cfg(feature = "exact")]
pub use num_rational::BigRational;

#[cfg(not(feature = "exact"))]
#[doc(hidden)]
pub use crate::without_exact::BigRational;
