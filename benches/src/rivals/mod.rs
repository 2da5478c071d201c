//! What a user would have taken instead: one file each.

pub(crate) mod diffsol;
pub(crate) mod dop853;
pub(crate) mod lu;
pub(crate) mod midpoint;
pub(crate) mod runge_kutta;
