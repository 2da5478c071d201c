//! The paper as running mathematics: every formula a claim, every claim established.
//!
//! A [`Claim`] says where a formula stands and what it says, as text; [`Paper`] lists the claims and establishes them:
//! by expansion over ℚ, modulo primes, at exact points, or in 256-bit arithmetic. The `kahan verify` command, the tests
//! and the atlas read this one list. Data flows one way: `sections` (the claims) and `figures` (the orbits) →
//! [`formula`] (text to expressions) → `evaluate` (values in any arithmetic) → `identity` (evidence) → [`Paper`].

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
mod section;
mod sections;

pub use block::{establish_block_claim, failing_mutation};
pub use claim::{Claim, Established, Outcome};
pub use erratum::Erratum;
pub use id::Id;
pub use registry::Paper;
pub use section::Section;
pub use sections::{OPEN, Structure, structure};
