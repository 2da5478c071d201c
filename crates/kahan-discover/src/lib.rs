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
//! Modules in reading order: [`modulus`], [`matrix`], [`monomials`], [`deadline`],
//! [`watch`] (the tools);
//! [`stepping`], [`family`], [`map`], [`search_field`] (the maps looked at); [`thiele`],
//! [`degrees`], [`growth`], [`plane`]; [`relations`], [`hilbert`], [`ceiling`], [`basis`];
//! [`reconstruct`], [`weights`], [`grading`], [`space`] (back to ℚ); [`parity`], [`pencil`],
//! [`search`], [`leaf`], [`chart`], [`constrained`], [`independent`], `reduction`, `members`,
//! `collector`, [`integrals`]; [`darboux`], `brackets`, [`drift`]; [`structure`], [`determinant`],
//! [`hamiltonian`], `modified`; [`composition`]; `writing`, [`claims`], [`report`]; [`mod@scan`]
//! looks for special values on a grid, [`mod@poles`] follows what the map sends to infinity or
//! blows down.
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

pub mod basis;
mod brackets;
pub mod ceiling;
pub mod chart;
pub mod claims;
mod collector;
pub mod composition;
pub mod constrained;
pub mod darboux;
pub mod deadline;
pub mod degrees;
mod densities;
pub mod determinant;
pub mod drift;
mod entries;
pub mod family;
pub mod grading;
pub mod growth;
pub mod hamiltonian;
pub mod hilbert;
pub mod independent;
pub mod integrals;
pub mod leaf;
mod limit;
pub mod map;
pub mod matrix;
mod members;
mod modified;
pub mod modulus;
pub mod monomials;
pub mod parity;
pub mod pencil;
pub mod plane;
pub mod poles;
mod products;
pub mod reconstruct;
mod reduction;
pub mod relations;
pub mod report;
pub mod scan;
pub mod search;
pub mod search_field;
mod shape;
pub mod space;
mod stages;
pub mod stepping;
pub mod structure;
#[cfg(test)]
mod tests;
pub mod thiele;
pub mod watch;
pub mod weights;
mod words;
mod writing;

pub use basis::Basis;
pub use ceiling::Ceiling;
pub use deadline::Deadline;
pub use poles::{Poles, poles};
pub use report::{DiscoverError, Options, Report};
pub use scan::{Scan, Scanned, scan};
pub use stages::discover;
pub use watch::{Finding, Progress, Unwatched, Watch};
