//! Without a single equation there is still one error a mistake.

use kahan_core::prelude::*;

fn main() {
    let _ = kahan! { 2*x; 3*y; };
}
