use kahan_core::prelude::*;

kahan! {
    /// The Lorenz system.
    pub struct Lorenz { sigma, rho, beta }

    xdot = sigma*(y - x);
    ydot = x*(rho - z) - y;
    zdot = x*y - beta*z;
}
