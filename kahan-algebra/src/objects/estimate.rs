//! How many bytes of machine code an object becomes, and how long rustc works on it: a calibrated model, no measurement.
//!
//! The model is a function of the operations alone (a multiply-add counts twice, as in the builds that it was calibrated
//! on) and the number of results. Bytes were fitted to LV, the Euler top, E1, E3, E6, E9, Lorenz's system, a dense field of
//! three variables and Clebsch's of six (78 functions), milliseconds to E1, E6 and the dense field, object by object, in
//! `f64`, by rustc 1.95 for x86-64 without further flags, `opt-level = 3`:
//!
//! | style | bytes | predicted over measured | milliseconds | predicted over measured |
//! |---|---|---|---|---|
//! | plain | 6.5·operations + 7·results | 0.63 … 1.36, once 0.29; rms 0.17 | 2.5 + 0.17·operations | 0.6 … 2, above the noise of 3 ms |
//! | two points | 125 + 8·operations | 0.78 … 1.12 | as plain | as plain |
//! | dual | 1.4·operations^(4/3) | 0.90 … 1.15 | 31 + 0.26·operations | 0.97 … 1.03 |
//!
//! All objects together, for those three systems and LV, Lorenz's and Clebsch's: 0.75 … 1.1 of the milliseconds measured.
//! They are processor time on a shared machine of two cores; another may be twice as fast, and the ratios between objects
//! are what stays.
//!
//! (Dual numbers spill registers, so their code grows faster than their operations; a function of two points is one that
//! the compiler likes to pack into vectors, for which it shuffles.)
//!
//! To repeat it: a library with one module a system, in it the block of `kahan!` without claims, and for each object a
//! `#[inline(never)] #[unsafe(no_mangle)]` function over `f64` that calls it (the step through its prepared map).
//! Bytes are the sizes that `nm --print-size` shows in a release build. Milliseconds are the processor time of
//! `cargo rustc --release` with twelve such modules, less the same without the functions, over twelve; to that the
//! time of parsing and checking the generated code, 1 ms a function, is added, which is spent for what is not called,
//! too. The macro's own time is not in it.

use crate::plan::Plan;

use super::Style;

/// What an object costs once compiled: bytes within a factor of 1.5 as a rule, milliseconds within 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Bytes of machine code of the function over `f64`, x86-64 without further flags, optimised.
    pub bytes: u64,
    /// Milliseconds of rustc's processor time for the function over `f64`, optimised.
    pub compile_ms: f64,
}

impl Estimate {
    /// The estimate for a plan; nothing for one that computes nothing.
    pub(super) fn of(plan: &Plan, style: Style) -> Self {
        let operations = plan.cost().operations();
        if operations == 0 && plan.outputs.is_empty() {
            return Estimate { bytes: 0, compile_ms: 0.0 };
        }
        let (operations, results) = (operations as f64, plan.outputs.len() as f64);
        let (bytes, compile_ms) = match style {
            Style::Plain => (6.5 * operations + 7.0 * results, 2.5 + 0.17 * operations),
            Style::TwoPoints => (125.0 + 8.0 * operations, 2.5 + 0.17 * operations),
            Style::Dual => (1.4 * operations.powf(4.0 / 3.0), 31.0 + 0.26 * operations),
        };
        Estimate { bytes: bytes.round() as u64, compile_ms }
    }
}
