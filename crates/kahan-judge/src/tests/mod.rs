//! Promises at the extremes, on samples; steps that are made elsewhere.

mod as_compiled;
pub(crate) mod compiled;
mod drawn;
mod kept_promises;
pub(crate) mod residual;
