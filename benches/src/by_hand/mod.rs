//! Careful hand-written steps, one file for each system, as references for generated code.
//!
//! They map ε and parameters to functions from state to state in the increment form x + n/D, which
//! rounds once per component and preserves integrals in long runs. Where rounding would make an
//! integral drift, only ε, εα, 1/(2ε) and their doubles are rounded constants. Each file has the
//! forms with the fewest operations and with the shortest chain. On current x86-64 additions take
//! 2–3 cycles, multiplications 4, divisions 14; only the path to the denominator counts. Capital
//! letters are variables times ε.

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
