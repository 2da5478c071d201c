//! The paper's formulas as claims, which are established by proof or by measurement.
//!
//! [`Paper`] lists all [`Claim`]s. Each is expanded over ℚ, or its sides are evaluated modulo
//! primes, in fractions, or in 256-bit arithmetic. Misprints are refuted. [`Verdicts`] are the
//! results as text.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod block;
mod claim;
mod erratum;
mod evaluate;
pub mod figures;
pub mod formula;
mod growth_constants;
mod id;
mod identity;
mod misprint;
mod model;
mod numeric;
mod registry;
mod report;
mod section;
mod sections;
mod verdict;

pub use block::{establish_block_claim, failing_mutation};
pub use claim::{Claim, Established, Outcome};
pub use erratum::Erratum;
pub use id::Id;
pub use registry::Paper;
pub use section::Section;
pub use sections::{OPEN, StructureRow, structure};
pub use verdict::{OpenQuestion, Verdict, Verdicts, in_one_line};
