//! The system exists although its keyword is wrong.

use kahan_core::prelude::*;

kahan! {
    enum Decay { k }
    xdot = -k*x;
}

fn main() {
    let decay = Decay { k: 2.0_f64 };
    let _: SVector<f64, 1> = decay.step(&vector![1.0], 0.1);
}
