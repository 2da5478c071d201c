//! A file that is not there.

use kahan_core::prelude::*;

include_kahan!("nowhere.kahan");

fn main() {}
