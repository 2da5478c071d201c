//! A name instead of a literal.

use kahan_core::prelude::*;

include_kahan!(toda);

fn main() {}
