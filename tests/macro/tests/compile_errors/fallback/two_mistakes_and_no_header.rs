//! Without a single equation, every mistake still gives one error.

use kahan_core::prelude::*;

fn main() {
    let _ = kahan! { 2*x; 3*y; };
}
