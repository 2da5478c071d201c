//! Compiles straight-line floating-point programs to machine code.
//!
//! In: a [`Program`] over two arrays. Out: code in `f64` or `f32`, scalar or in SIMD lanes. It runs
//! the program once ([`Function`]), repeatedly on one state ([`Orbit`], [`ComposedOrbit`]), or over
//! columns of trajectories ([`Sweep`]). Bits equal those of generated Rust, with or without fused
//! multiply-adds. Without the feature `pages` every program is refused.
//!
//! Pipeline: `program`, `lowering`, `allocation`, `assembler`, `routine`, `pages`, `call`. `unsafe`
//! is confined to `call.rs`, the three files of `routine` and `pages/cache.rs`, plus a test helper.

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
