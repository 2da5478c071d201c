//! Methods that a user could choose instead of generated code.

pub(crate) mod diffsol;
pub(crate) mod dop853;
pub(crate) mod lu;
pub(crate) mod midpoint;
pub(crate) mod runge_kutta;
