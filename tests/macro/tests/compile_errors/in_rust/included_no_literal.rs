//! The file is given by a name instead of a literal.

use kahan_core::prelude::*;

include_kahan!(toda);

fn main() {}
