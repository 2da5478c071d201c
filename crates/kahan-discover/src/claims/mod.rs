//! Turns findings into proved claims of `kahan!`, and conclusions into English sentences.

pub mod proved;
pub(crate) mod verdicts;
pub(crate) mod writing;
