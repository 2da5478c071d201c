//! Steps and derived functions of a field as machine code, compiled at first use.
//!
//! In: the plans of a field, and the kind of step. Out: code, shared by all maps of the field. The
//! interpreter makes the steps without the feature `jit`, and on processors other than x86-64 and
//! AArch64. It also makes steps whose plans are too long, and steps that the code rejects.

mod codes;
mod double_double;
mod kind;
#[cfg(test)]
mod measured;
mod programs;
mod traced;

pub(crate) use codes::{Codes, ColumnsCode, FloatCodes, OrbitCode};
pub(crate) use kahan_jit::{InstructionSet, Sweep};
pub(crate) use kind::{GroupKind, StepKind, TangentKind};
