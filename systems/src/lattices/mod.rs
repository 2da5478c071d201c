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
    Entry {
        command: "volterra-ring",
        title: "Volterra's chain closed to a ring",
        text: include_str!("volterra_ring.rs"),
    },
    Entry {
        command: "volterra-chain",
        title: "Volterra's chain with two ends",
        text: include_str!("volterra_chain.rs"),
    },
    Entry { command: "toda", title: "Toda's chain in Flaschka's variables", text: include_str!("toda.rs") },
    Entry {
        command: "species",
        title: "species along a shore that compete with their neighbours",
        text: include_str!("species.rs"),
    },
    Entry {
        command: "kdv",
        title: "the Korteweg-de Vries equation by central differences",
        text: include_str!("kdv.rs"),
    },
];

/// The family of this command name.
pub fn find(command: &str) -> Option<&'static Entry> {
    ALL.iter().find(|entry| entry.command == command)
}
