//! Turns findings into proved claims in the language of `kahan!`, and conclusions into English
//! sentences.

pub mod proved;
pub(crate) mod verdicts;
pub(crate) mod writing;
