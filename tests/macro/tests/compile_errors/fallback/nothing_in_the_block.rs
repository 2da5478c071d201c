//! A block without a word, at the level of a module and as a value.

use kahan_core::prelude::*;

kahan! {}

fn main() {
    kahan! {}
}
