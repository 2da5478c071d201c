//! What the targets run: inputs from bytes, and what must hold of whatever becomes of them. Parts
//! of our crates that are private there are compiled once more.

#[path = "../../kahan-jit/src/tests/draw.rs"]
#[expect(dead_code, reason = "the crate has tests that draw programs in another way")]
mod draw;
mod expansion;
#[path = "../../kahan-jit/src/tests/hostile/mod.rs"]
mod hostile;
mod plan;
mod reading;
#[path = "../../kahan-jit/src/tests/run.rs"]
#[expect(dead_code, reason = "the crate has tests whose numbers are in slices")]
mod run;
mod texts;
mod words;

// The files of `kahan-jit` name what they use by `crate`.
use kahan_jit::{
    Called, ComposedOrbit, Constants, Float, Function, Input, Instruction, InstructionSet, LaneCount, Orbit,
    Program, Refusal, Shape, Sweep,
};

pub use expansion::expand;
pub use plan::read_plan;
pub use reading::{read_csv, read_npy};
pub use texts::read_text;

/// Runs a program for machine code on slices at the edge of forbidden memory, in the way that the
/// bytes say.
pub fn run_program(bytes: &[u8]) {
    hostile::Case::of(bytes).has_run();
}
