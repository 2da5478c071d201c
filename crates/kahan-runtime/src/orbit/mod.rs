//! Exact orbits, and orbits through poles.

mod exact;
mod projective;

pub use exact::ExactOrbit;
pub use projective::{ProjectiveOrbit, ProjectiveScalar};
