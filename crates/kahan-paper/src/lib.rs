//! The paper as running mathematics: every formula a claim, every claim established.
//!
//! In: the claims, as text, and the catalog. Out: for each claim what came of it: proved by
//! expansion over ℚ or modulo primes, seen at exact points, compared in 256-bit arithmetic, or a
//! misprint; and [`Verdicts`] as plain text. It must not know arguments, terminals or clocks.
//!
//! A [`Claim`] says where a formula stands and what it says; [`Paper`] lists the claims and
//! establishes them. The commands `kahan-verify` and `kahan verify`, the tests and the atlas read
//! this one list. Data flows one way: `sections` (the claims) and `figures` (the orbits) →
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
