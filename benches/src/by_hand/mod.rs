//! Steps that were carefully written by hand, one file for each system, as references for generated
//! code.
//!
//! For given ε and parameters, a function makes a function from state to state. The increment form
//! x + n/D rounds once per component and preserves integrals in long runs. Where rounding would
//! make an integral drift, only ε, εα, 1/(2ε) and their doubles are rounded constants. Each file
//! has the forms with the fewest operations and with the shortest chain of dependent operations. On
//! current x86-64 additions take 2–3 cycles, multiplications 4, divisions 14; only the path to the
//! denominator counts. Capital letters are variables times ε.

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
