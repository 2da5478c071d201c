//! Careful hand-written steps, one file a system: the yardstick for generated code.
//!
//! In: ε and the parameters. Out: functions from state to state that keep the increment form x +
//! n/D (it rounds once a component and keeps integrals in long runs) and take nothing but ε, εα,
//! 1/(2ε) and their doubles as rounded constants where an integral would notice. Each file has the
//! shape with the fewest operations and the one with the shortest dependent chain; which of them
//! wins which figure is for the measurement to say.
//!
//! Chains on current x86-64: addition 2–3 cycles, multiplication 4, division 14, and only what
//! leads to the denominator counts. Capital letters in the comments are variables times ε.

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
