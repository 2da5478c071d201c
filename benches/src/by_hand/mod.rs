//! Steps that were written by hand, one file for each system, as references for generated code.
//!
//! Each function makes a step for given ε and parameters. A step adds an increment to the state, so
//! that integrals drift less in long runs. Each file has a step with the fewest
//! operations and a step with the shortest chain of dependent operations. Capital letters are
//! variables times ε.

pub(crate) mod clebsch;
pub(crate) mod e1;
pub(crate) mod e3;
pub(crate) mod e5;
pub(crate) mod e6;
pub(crate) mod euler_top;
pub(crate) mod lorenz;
pub(crate) mod lotka_volterra;

#[cfg(test)]
mod tests;
