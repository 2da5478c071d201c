//! The periodic Volterra lattice of three sites: a linear integral, and the modified Hamiltonian.

use kahan_core::prelude::*;

kahan! {
    pub struct Volterra;
    xdot = x*(y - z);
    ydot = y*(z - x);
    zdot = z*(x - y);
    integral H1 = x + y + z;
    integral H2 = x*y*z/(1 - eps^2*x^2 + 2*eps^2*x*y + 2*eps^2*x*z - eps^2*y^2 + 2*eps^2*y*z - eps^2*z^2);
    density rho = 1/(1 - eps^2*x^2 + 2*eps^2*x*y + 2*eps^2*x*z - eps^2*y^2 + 2*eps^2*y*z - eps^2*z^2);
}
