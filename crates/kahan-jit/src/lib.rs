//! Straight-line programs of floats as machine code.
//!
//! In: a [`Program`] over two arrays. Out: code that runs it once ([`Function`]), many times on one
//! state ([`Orbit`], [`ComposedOrbit`]), or over columns of trajectories ([`Sweep`]), in `f64` or
//! `f32`, one number or a register of them at a time. The operations and their order are
//! the program's, so are the bits: those of generated Rust, without fused multiply-adds or with
//! them. It must not know what the numbers mean. Without the feature `pages` every program is
//! refused.
//!
//! A program is one of `kahan-program`, whose operations name values; lowering leaves fewer kinds
//! of them, and registers are allocated for these. Machine instructions name registers, and are
//! what the assembler has bytes for, one for x86-64 and one for 64-bit Arm.
//!
//! Modules in reading order: `program`, `lowering`, `allocation`, `assembler`, `routine`, `pages`,
//! `call`. All `unsafe` code is in five files: `call.rs` enters machine code, `function.rs`,
//! `orbit.rs` and `sweep.rs` of `routine` each state why the code that they write is sound, and
//! `cache.rs` of `pages` tells the caches of 64-bit Arm of it. Tests add one more, which puts
//! inaccessible pages around slices.

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
