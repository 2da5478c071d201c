//! Steps and objects as machine code: their programs, compiled when they are first asked for.
//!
//! In: the plans of a field, and how it is to be stepped. Out: code, kept for everyone who steps
//! the same field so. What numbers mean is known here; what instructions there are is
//! `kahan-jit`'s. Without the feature `jit` there is never any code, and everything is interpreted.

#[cfg(not(feature = "jit"))]
mod absent;
#[cfg(feature = "jit")]
mod codes;
#[cfg(feature = "jit")]
mod double_double;
mod kind;
#[cfg(feature = "jit")]
mod programs;
#[cfg(feature = "jit")]
mod traced;

#[cfg(not(feature = "jit"))]
pub(crate) use absent::*;
#[cfg(feature = "jit")]
pub(crate) use codes::{Coded, Codes, ColumnsCode, OrbitCode};
#[cfg(feature = "jit")]
pub(crate) use kahan_jit::{InstructionSet, Sweep};
pub(crate) use kind::{SideBySide, StepKind};
