//! What the Kahan map of a quadratic field preserves, found from its equations alone.
//!
//! In: a checked system. Out: a [`Report`] of what its map keeps, with formulas that are proved. It
//! must not know how a report is printed.
//!
//! [`discover`] answers what can be asked of a new field: how fast the degrees of the map's
//! iterates grow, how many independent algebraic integrals its orbits show, their formulas, an
//! invariant density, Poisson brackets, the Hamiltonian structure of the field, and which integrals
//! survive composition. Everything is found modulo primes, from orbits, by linear algebra and
//! interpolation; a formula is returned only once the prover of `kahan-algebra` has proved its
//! text. An integral whose formula would fill pages is given by a Hirota–Kimura [`Basis`], which
//! evaluates it.
//!
//! Modules in reading order: [`watch`] and [`deadline`]; [`modular`], the arithmetic; [`maps`],
//! what is looked at; [`orbits`], what orbits show; [`integrals`], [`densities`], [`poisson`] and
//! [`drift`], what is found; [`claims`], its proof and its text; `stages`, the whole search, and
//! [`report`], its answer. [`mod@scan`] looks for special values on a grid, [`mod@poles`] follows
//! curves through poles.
//!
//! ```
//! use kahan_algebra::{lexer, read};
//! use kahan_discover::{Options, Unwatched, discover};
//!
//! let field = "xdot = -x*z; ydot = y*z; zdot = x^2 - y^2;";
//! let system = read(&lexer::lex(field).tokens).system().expect("a system");
//! let report = discover(&system, &Options::default(), &Unwatched).unwrap();
//! assert_eq!(report.independent_integrals(), 2);
//! assert_eq!(report.integrals.len(), 2); // each `text` is a line for `kahan!`
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod claims;
pub mod deadline;
pub mod densities;
pub mod drift;
pub mod integrals;
pub mod maps;
pub mod modular;
pub mod orbits;
pub mod poisson;
pub mod poles;
pub mod report;
pub mod scan;
mod stages;
#[cfg(test)]
mod tests;
pub mod watch;

pub use deadline::Deadline;
pub use orbits::basis::Basis;
pub use orbits::ceiling::Ceiling;
pub use poles::{Poles, poles};
pub use report::{DiscoverError, Options, Report};
pub use scan::{Scan, Scanned, scan};
pub use stages::discover;
pub use watch::{Finding, Progress, Unwatched, Watch};
