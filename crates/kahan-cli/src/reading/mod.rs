//! What the commands read: systems, fields in text and in Rust files, exact numbers.
//!
//! In: arguments and files. Out: checked systems and numbers; what is wrong with them becomes a
//! [`Refusal`](crate::printing::Refusal).

mod block;
mod chain;
mod npz;
mod points;
mod results;
mod rust_file;
mod source;
mod study;
mod values;

pub(crate) use block::Block;
pub(crate) use points::{is_number_file, point, points};
pub(crate) use results::{columns, not_started, sweeper};
pub(crate) use source::{ONE_WORD, Source, Start, StepLength, Stepping, Transient};
pub(crate) use study::option;
pub(crate) use values::{axis, named, number, observable, one_of, order, over, scalar, seconds, whole};

/// The most steps of an orbit that is observed: doubles count them.
pub(crate) const MOST_OBSERVED: u64 = 1 << 53;
