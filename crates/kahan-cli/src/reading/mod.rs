//! What the commands read: systems, fields in text and in Rust files, exact numbers.
//!
//! In: arguments and files. Out: checked systems and numbers; what is wrong with them becomes a
//! [`Refusal`](crate::printing::Refusal).

mod block;
mod chain;
mod file;
mod formula;
mod number_file;
mod points;
mod range;
mod results;
mod rust_file;
mod source;
mod study;
mod values;

pub(crate) use block::Block;
pub(crate) use number_file::is_number_file;
pub(crate) use points::{point, points};
pub(crate) use range::{axis, over};
pub(crate) use results::{columns, not_started, sweeper};
pub(crate) use source::{ONE_WORD, Source, Start};
pub(crate) use values::{number, observable, one_of, order, scalar, seconds, whole};
