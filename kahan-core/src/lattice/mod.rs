//! Chains of any number of sites. The equations of a site contain the states of a few neighbours.
//!
//! A family `for i in … { … }` gives the equations of one site. A(x,ε) is banded, with corners if
//! the chain is periodic. A long chain of `f32` or `f64` is divided into parts, which are
//! eliminated in SIMD lanes, and with `parallel` on threads (`parts`). Other chains are eliminated
//! as a whole (`folded`), and so are chains with too small pivots or without a kernel. `Kernels`
//! selects the code for the family's sizes.

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
