//! The accessors of a claim exist although the claim could not be read.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y**2;
    density rho = ;
    bracket P { {x,w} = 1; }
}

fn main() {
    let rotation = Rotation { k: 2.0 };
    let x = vector![1.0_f64, 2.0];
    let _: SVector<f64, 1> = rotation.integrals(&x, 0.1);
    let _: f64 = rotation.density(&x, 0.1);
    let _: SMatrix<f64, 2, 2> = rotation.bracket_P(&x, 0.1);
}
