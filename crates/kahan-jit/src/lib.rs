//! Compiles straight-line floating-point programs to machine code.
//!
//! A [`Program`] reads arrays of states and of constants. A [`Function`] runs it once, an [`Orbit`]
//! or [`ComposedOrbit`] iterates it on one state, and a [`Sweep`] on many. The code computes in
//! `f64` or `f32`, with scalars or SIMD vectors. Results equal those of generated Rust code bit for
//! bit, except for NaN. Without the feature `pages` every program is refused.
//!
//! All `unsafe` code is in the modules `call`, `routine` and `pages`, and in a helper of the tests.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod allocation;
mod assembler;
mod call;
mod compile_error;
mod instructions;
mod lowering;
mod pages;
mod program;
mod routine;
#[cfg(test)]
mod tests;

pub use compile_error::CompileError;
pub use instructions::{Float, InstructionSet, LaneCount, Shape};
pub use program::{CalledFunction, Input, Instruction, Program};
pub use routine::{ComposedOrbit, Constants, Function, Orbit, Sweep};
