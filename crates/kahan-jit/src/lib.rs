//! Straight-line programs of floats as machine code.
//!
//! In: a [`Program`] over two arrays. Out: code that runs it once ([`Function`]), many times on one
//! state ([`Orbit`], [`ComposedOrbit`]), or over columns of trajectories ([`Sweep`]), in `f64` or
//! `f32`, on one number or on a register of numbers at a time. The code has the operations of the
//! program in their order, and the bits of generated Rust with or without fused multiply-adds. The
//! crate must not know the meaning of the numbers. Without the feature `pages` every program is
//! refused.
//!
//! Modules in reading order: `program`, `lowering` (fewer kinds of operations), `allocation`
//! (registers), `assembler` (bytes for x86-64 and 64-bit Arm), `routine`, `pages`, `call`. All
//! `unsafe` code is in five files: `call.rs` enters machine code; `function.rs`, `orbit.rs` and
//! `sweep.rs` of `routine` state why their code is sound; `cache.rs` of `pages` synchronises the
//! caches of 64-bit Arm. Tests add one file, which puts inaccessible pages around slices.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod allocation;
mod assembler;
mod call;
mod instructions;
mod lowering;
mod pages;
mod program;
mod refusal;
mod routine;
#[cfg(test)]
mod tests;

pub use instructions::{Float, InstructionSet, LaneCount, Shape};
pub use program::{Called, Input, Instruction, Program};
pub use refusal::Refusal;
pub use routine::{ComposedOrbit, Constants, Function, Orbit, Sweep};
