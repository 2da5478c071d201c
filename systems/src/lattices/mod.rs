//! Families are systems with any number of sites, which is chosen at run time. Each file of a
//! family has a `kahan!` block, which claims the linear integrals and the Hamiltonian, if there are
//! any. `kahan discover --sites N` searches for further integrals of N sites.

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
    /// The command-line name, such as `kdv`.
    pub command: &'static str,
    /// A description in one line.
    pub title: &'static str,
    /// The contents of the source file, which contains a single block.
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

/// Returns the family with this command name.
pub fn find(command: &str) -> Option<&'static Entry> {
    ALL.iter().find(|entry| entry.command == command)
}
