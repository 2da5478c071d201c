//! Chains of any number of sites. Each site has one equation and is coupled to a few neighbours.
//!
//! In: the equations of one site, from a family `for i in periodic { … }`. Out: steps of the whole
//! chain. A(x,ε) is banded, with corners if periodic; solving allocates nothing. `StepWorkspace`
//! eliminates a short chain at once (`folded.rs`). It divides a long chain into parts, whose two
//! passes (`parts/first_pass.rs`, `parts/second_pass.rs`) run in SIMD lanes and on threads.
//! `Kernels` selects the code for the family's sizes.

mod at;

mod error;
mod family;
mod folded;
mod long_elimination;
mod map;
mod parts;
mod promise;
mod scalar;
mod sites;
mod sums;
#[cfg(test)]
mod tests;

pub use at::LatticeAt;
pub use error::LatticeError;
pub use family::{Boundary, Sizes, Stencil};
pub use map::LatticeMap;
pub use parts::{Gathered, SiteLine, StencilMenu};
pub use scalar::LatticeScalar;
