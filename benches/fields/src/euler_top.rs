use kahan_core::prelude::*;

kahan! {
    /// The Euler top with the coefficients `a1`, `a2`, `a3`.
    pub struct EulerTop { a1, a2, a3 }

    xdot = a1*y*z;
    ydot = a2*z*x;
    zdot = a3*x*y;
}
