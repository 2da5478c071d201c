//! Findings as claims in the language of `kahan!`, proved, and verdicts in words.

pub mod proved;
pub(crate) mod verdicts;
pub(crate) mod writing;
