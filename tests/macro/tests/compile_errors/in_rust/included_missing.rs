//! The included file is missing.

use kahan_core::prelude::*;

include_kahan!("nowhere.kahan");

fn main() {}
