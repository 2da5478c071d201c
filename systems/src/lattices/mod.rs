//! Families: systems of any number of sites, for which a chain is made when the program runs.
//!
//! In: a family of equations a file, as a `kahan!` block with the sums that it keeps. Out: the types
//! that the macro makes of them, and in [`ALL`] the blocks as text. Their integrals beyond sums are
//! found at a given number of sites by `kahan discover --sites N`.

mod kdv;
mod species;
mod toda;
mod volterra_chain;
mod volterra_ring;

pub use kdv::Kdv;
pub use species::Species;
pub use toda::Toda;
pub use volterra_chain::VolterraChain;
pub use volterra_ring::VolterraRing;

/// The name of each family, and the file that holds its block and no other.
pub const ALL: [(&str, &str); 5] = [
    ("volterra-ring", include_str!("volterra_ring.rs")),
    ("volterra-chain", include_str!("volterra_chain.rs")),
    ("toda", include_str!("toda.rs")),
    ("species", include_str!("species.rs")),
    ("kdv", include_str!("kdv.rs")),
];
