//! Steps and objects of a field as machine code, compiled at first use.
//!
//! In: the plans of a field, and the kind of step. Out: code, shared by all maps of the field. This
//! module knows the meaning of numbers, `kahan-jit` only instructions. Without code (no feature
//! `jit`, or another processor) the interpreter does the work.

mod codes;
mod double_double;
mod kind;
mod programs;
mod traced;

pub(crate) use codes::{Codes, ColumnsCode, FloatCodes, OrbitCode};
pub(crate) use kahan_jit::{InstructionSet, Sweep};
pub(crate) use kind::{GroupKind, StepKind, TangentKind};
