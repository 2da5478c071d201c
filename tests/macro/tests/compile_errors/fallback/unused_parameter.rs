//! An unused parameter stays a field of the struct.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k, l }
    xdot = -k*x;
}

fn main() {
    let decay = Decay { k: 2.0_f64, l: 3.0 };
    let _: SVector<f64, 1> = decay.step(&vector![1.0], 0.1);
}
