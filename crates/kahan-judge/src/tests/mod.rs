//! Tests of the stable tier at the extremes, on samples, and of steps made by another program.

mod as_compiled;
pub(crate) mod compiled;
mod drawn;
mod kept_promises;
pub(crate) mod residual;
