//! Tests `try_step` near the limits of float formats on samples, and steps that another program
//! makes.

mod as_compiled;
pub(crate) mod compiled;
mod drawn;
mod kept_promises;
pub(crate) mod residual;
