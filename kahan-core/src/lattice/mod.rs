//! Chains of any number of sites: one equation per site, couplings to a few neighbours.
//!
//! In: the equations of one site, from a family `for i in periodic { … }`. Out: steps of the whole
//! chain. A(x,ε) is a band, with corners if periodic; its linear system is solved without
//! allocations.
//!
//! A step goes from [`LatticeAt::advance`] to `Memory::advance`, and for a long chain to
//! `InParts::step`, whose two passes (`parts/first.rs`, `parts/second.rs`) are divided among
//! threads (`divide`). `Kernels` names the kernel for the family's sizes, `InLanes` its registers.
//! A short chain is one elimination (`folded.rs`).

mod at;

mod error;
mod family;
mod far;
mod folded;
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
pub use parts::{Gathered, Menu, SiteLine};
pub use scalar::LatticeScalar;
