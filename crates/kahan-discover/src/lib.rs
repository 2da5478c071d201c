//! Discovers the structures that Kahan's map of a quadratic field preserves.
//!
//! The input is a checked system. The output is a [`Report`] on growth of degrees, integrals,
//! densities, Poisson brackets, drifts and Hamiltonian structure. The search computes modulo primes
//! and interpolates along orbits. Claims in a report are proved, and other results may only be
//! observed. A Hirota–Kimura [`Basis`] represents integrals with long formulas. Callers lay out the
//! formulas and sentences of a report.
//!
//! Modules in reading order: [`watch`], [`deadline`], [`modular`] (arithmetic), [`maps`],
//! [`orbits`], [`integrals`], [`densities`], [`poisson`], [`drift`], [`claims`] (proof and text),
//! `stages` (the search) and [`report`]. The module [`mod@scan`] searches special parameter values
//! on a grid, and [`mod@poles`] continues singular curves of the map through poles.
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
pub use orbits::integral_bound::IntegralBound;
pub use poles::{Poles, poles};
pub use report::{DiscoverError, Options, Report};
pub use scan::{Scan, ScannedQuantity, scan};
pub use stages::discover;
pub use watch::{Finding, Progress, Unwatched, Watch};
