//! A missing file.

use kahan_core::prelude::*;

include_kahan!("nowhere.kahan");

fn main() {}
