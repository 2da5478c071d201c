//! Orbits that are more than steps of floats: exact ones, and those through poles.

mod exact;
mod projective;

pub use exact::ExactOrbit;
pub use projective::{ProjectiveOrbit, ProjectiveScalar};
