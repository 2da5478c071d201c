//! Steps as machine code: the programs of a field's steps, compiled when they are first asked for.
//!
//! In: the plan of a step, and how it is to be stepped. Out: code, kept for everyone who steps the
//! same field so. What numbers mean is known here, what instructions there are is `kahan-jit`'s.

mod codes;
mod double_double;
mod recorder;
mod step;

pub(crate) use codes::{Codes, Coded, Form, Stepping};
pub(crate) use step::StepKind;
