use kahan_core::prelude::*;

kahan! {
    /// The system E5 of Hone and Petrera.
    pub struct E5;

    xdot = x*y;
    ydot = -x^2;
    zdot = y*(2*x - z);
}
