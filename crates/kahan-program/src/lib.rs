//! Straight-line programs: lists of operations without branches. Operations read only inputs,
//! constants and results of earlier operations.
//!
//! A [`Builder`] adds each operation once and yields a [`Program`]. A program runs in any
//! [`Arithmetic`] with its constants and functions, can be printed as text, and is the input of
//! compilers. The types of inputs, constants and functions are type parameters.

#![no_std]

extern crate alloc;

mod arithmetic;
mod builder;
pub mod cost;
mod numbered;
mod operation;
mod program;
mod run;
mod text;

pub use arithmetic::{Arithmetic, Calls};
pub use builder::{Builder, ExactConstant};
pub use cost::Cost;
pub use numbered::Numbered;
pub use operation::{Float, Function, Node, Operation};
pub use program::Program;

#[cfg(test)]
mod tests;
