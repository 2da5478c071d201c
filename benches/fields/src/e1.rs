use kahan_core::prelude::*;

kahan! {
    /// The system E1 of Hone and Petrera.
    pub struct E1;

    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
}
