//! The block in the included file has two mistakes.

use kahan_core::prelude::*;

include_kahan!("mistakes.kahan");

fn main() {
    let _ = Broken.step(&vector![1.0, 2.0], 0.1);
}
