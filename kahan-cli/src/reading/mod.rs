//! What the commands read: systems, fields in text and in Rust files, exact numbers.
//!
//! In: arguments and files. Out: checked systems and numbers; what is wrong with them becomes a
//! [`Refusal`](crate::printing::Refusal).

mod file;
mod input;
mod rust_file;
mod values;

pub(crate) use input::{Block, Source, Start};
pub(crate) use values::{coordinates, number, seconds, whole};
