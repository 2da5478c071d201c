//! The bodies of the fuzz targets, which make inputs from bytes and check every result.

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

// Source files of `kahan-jit` are included in this crate, and refer to these names as `crate::…`.
use kahan_jit::{
    CalledFunction, CompileError, ComposedOrbit, Constants, Float, Function, Input, Instruction,
    InstructionSet, LaneCount, Orbit, Program, Shape, Sweep,
};

pub use expansion::expand;
pub use plan::read_plan;
pub use reading::{read_csv, read_npy};
pub use texts::read_text;

/// Runs a random program as machine code, on arrays next to inaccessible memory.
pub fn run_program(bytes: &[u8]) {
    hostile::Case::of(bytes).has_run();
}
