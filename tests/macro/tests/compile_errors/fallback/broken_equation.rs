//! The type, its constants and its methods exist although one equation is wrong.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^3 - z^2;
    zdot = y*(z - 2*x);
    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
    density rho = 1/(x*z + y^2);
    bracket P { {x,y} = x; {y,z} = z; {z,x} = 2*y; }
}

fn main() {
    let x = vector![1.0_f64, 2.0, 3.0];
    let next: SVector<f64, 3> = E6.step(&x, 0.1);
    let _: SVector<f64, 1> = E6.integrals(&next, 0.1);
    let _: f64 = E6.density(&next, 0.1) * E6.det_jacobian(&x, 0.1);
    let _: SMatrix<f64, 3, 3> = E6.bracket_P(&next, 0.1);
    assert_eq!(E6::VARIABLES, ["x", "y", "z"]);
    assert_eq!(E6::INTEGRALS, ["H"]);
    let _ = E6.orbit(x, 0.1).nth(10);
}
