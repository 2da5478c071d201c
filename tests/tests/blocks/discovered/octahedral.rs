//! The reduced Nahm equations with octahedral symmetry (Hitchin, Manton, Murray 1995).

use kahan_core::prelude::*;

kahan! {
    pub struct Octahedral;
    xdot = 2*x^2 - 12*y^2;
    ydot = -6*x*y - 4*y^2;
    integral H1 = y*(2*x + 3*y)*(x - y)^2/((1 - 4*eps^2*(3*x + 2*y)^2)*(1 - 4*eps^2*(x - 6*y)^2));
    density rho = 1/(y*(2*x + 3*y)*(x - y));
    bracket P1 { {x, y} = y*(2*x + 3*y)*(x - y); };
}
