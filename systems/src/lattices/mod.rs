//! Families: systems of any number of sites, for which a chain is made when the program runs.
//!
//! In: a family of equations a file, as a `kahan!` block with the sums that it keeps. Out: the
//! types that the macro makes of them, and in [`ALL`] the blocks as text. Their integrals beyond
//! sums are found at a given number of sites by `kahan discover --sites N`.

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

/// A family of the catalog.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name on the command line: `kdv`.
    pub command: &'static str,
    /// What it is, in one line.
    pub title: &'static str,
    /// The source file that holds its block and no other.
    pub text: &'static str,
}

/// The families of the catalog.
pub const ALL: [Entry; 5] = [
    entry("volterra-ring", "Volterra's chain closed to a ring", include_str!("volterra_ring.rs")),
    entry("volterra-chain", "Volterra's chain with two ends", include_str!("volterra_chain.rs")),
    entry("toda", "Toda's chain in Flaschka's variables", include_str!("toda.rs")),
    entry("species", "species along a shore that compete with their neighbours", include_str!("species.rs")),
    entry("kdv", "the Korteweg-de Vries equation by central differences", include_str!("kdv.rs")),
];

const fn entry(command: &'static str, title: &'static str, text: &'static str) -> Entry {
    Entry { command, title, text }
}

/// The family of this command name.
pub fn find(command: &str) -> Option<&'static Entry> {
    ALL.iter().find(|entry| entry.command == command)
}
