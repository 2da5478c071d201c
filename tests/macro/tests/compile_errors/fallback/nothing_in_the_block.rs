//! An empty block, at module level and as a value.

use kahan_core::prelude::*;

kahan! {}

fn main() {
    kahan! {}
}
