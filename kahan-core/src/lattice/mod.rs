//! Chains of any number of sites: one equation a site, couplings to a few neighbours.
//!
//! In: what the macro makes of a family `for i in periodic { … }`, the straight line of one site.
//! Out: steps of the whole chain that cost what its couplings cost. A(x,ε) is a band, with corners
//! where the chain is periodic; the linear system is solved, never inverted, and nothing is
//! allocated a step. What a state means, and what is conserved, is not known here.
//!
//! A step goes from [`LatticeAt::advance`] to `Memory::advance`, which asks the parts of a long
//! chain (`InParts::step`). Each of their two passes is divided among threads (`divide`); `Kernels`
//! names the kernel of the family's sizes, `InLanes` its registers, and `parts/first.rs` and
//! `parts/second.rs` are the kernels. A short chain is one elimination (`folded.rs`).

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
