//! The paper's formulas as claims. Takes claims as text, and the catalog. For each claim the crate
//! finds a proof by expansion over ℚ or modulo primes, agreement at exact points or in 256-bit
//! arithmetic, or a misprint; [`Verdicts`] are plain text. It knows no arguments, terminals or
//! clocks. [`Paper`] lists and establishes all [`Claim`]s, for the commands `kahan-verify` and
//! `kahan verify`, the tests and the atlas. Data flow: `sections` (claims) and `figures` (orbits) →
//! [`formula`] (text to expressions) → `evaluate` (values in any arithmetic) → `identity`
//! (evidence) → [`Paper`] → `verdict` → `report` (text).

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
pub use sections::{OPEN, Structure, structure};
pub use verdict::{Open, Verdict, Verdicts, in_one_line};
