//! The parameters exist although one of them has a type.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k: f64, l }
    xdot = k*y;
    ydot = -l*x;
}

fn main() {
    let rotation = Rotation { k: 2.0_f64, l: 3.0 };
    let _: SVector<f64, 2> = rotation.step(&vector![1.0, 2.0], 0.1);
    assert_eq!(Rotation::<f64>::PARAMETERS, ["k", "l"]);
}
