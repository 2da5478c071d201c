//! Input: turns arguments and files into checked systems and numbers.

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
pub(crate) use source::{ONE_WORD, Rounding, Source, Start, StepLength, Stepping, Transient};
pub(crate) use study::option;
pub(crate) use values::{axis, named, number, observable, one_of, order, over, scalar, seconds, whole};

/// The largest number of steps of an observed orbit, because an `f64` counts the steps.
pub(crate) const MOST_OBSERVED: u64 = 1 << 53;
