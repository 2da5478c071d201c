//! Tests `try_step` near the limits of float formats, here and in a program with generated code.

mod as_compiled;
pub(crate) mod compiled;
mod drawn;
mod kept_promises;
pub(crate) mod residual;
