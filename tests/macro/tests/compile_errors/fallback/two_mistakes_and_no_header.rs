//! Each mistake gives one error, even if the block has no correct equation.

use kahan_core::prelude::*;

fn main() {
    let _ = kahan! { 2*x; 3*y; };
}
