//! A name where a literal is wanted.

use kahan_core::prelude::*;

include_kahan!(toda);

fn main() {}
