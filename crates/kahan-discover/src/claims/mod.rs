//! Findings as proved claims in the language of `kahan!`, and conclusions as English sentences.

pub mod proved;
pub(crate) mod verdicts;
pub(crate) mod writing;
