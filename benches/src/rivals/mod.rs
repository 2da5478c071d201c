//! Other methods that a user could choose.

pub(crate) mod diffsol;
pub(crate) mod dop853;
pub(crate) mod lu;
pub(crate) mod midpoint;
pub(crate) mod runge_kutta;
