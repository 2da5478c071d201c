use kahan_core::prelude::*;

kahan! {
    /// The system E6 of Hone and Petrera.
    pub struct E6;

    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}
