//! The scalars that commands compute with, and how their values are written.

mod double_double;
mod scalar;

pub(crate) use double_double::DoubleDouble;
pub(crate) use scalar::{Printable, ScalarKind};
