//! Steps and objects as machine code: their programs, compiled when they are first asked for.
//!
//! In: the plans of a field, and how it is to be stepped. Out: code, kept for everyone who steps
//! the same field so. What numbers mean is known here; what instructions there are is
//! `kahan-jit`'s. Where it has no code, as without the feature `jit`, everything is interpreted.

mod codes;
mod double_double;
mod kind;
mod programs;
mod traced;

pub(crate) use codes::{Codes, CodesOf, ColumnsCode, OrbitCode};
pub(crate) use kahan_jit::{InstructionSet, Sweep};
pub(crate) use kind::{Carrying, SideBySide, StepKind};
