//! All unknown names of one equation, each once.

use kahan_core::prelude::*;

kahan! {
    pub struct Names;
    xdot = a*x + b*y + a;
    ydot = x + a;
}

fn main() {}
