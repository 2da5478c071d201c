use kahan_core::prelude::*;

kahan! {
    /// The system E3 of Hone and Petrera.
    pub struct E3;

    xdot = -x*z;
    ydot = -y*z;
    zdot = x^2 + y^2;
}
