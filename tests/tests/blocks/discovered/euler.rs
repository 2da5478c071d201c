//! The Euler top with its three coefficients free.

use kahan_core::prelude::*;

kahan! {
    pub struct Euler { a1, a2, a3 }
    xdot = a1*y*z;
    ydot = a2*z*x;
    zdot = a3*x*y;
    integral H1 = (a3*x^2 - a1*z^2)/(1 - eps^2*a2*a3*x^2);
    integral H2 = (a2*x^2 - a1*y^2)/(1 - eps^2*a2*a3*x^2);
    density rho = 1/(1 - eps^2*a2*a3*x^2)^2;
    bracket P1 { {x, z} = a1*y*(1 - eps^2*a2*a3*x^2); {y, z} = a2*x*(1 - eps^2*a1*a3*y^2); };
    bracket P2 { {x, y} = a1*z*(1 - eps^2*a2*a3*x^2); {y, z} = -a3*x*(1 - eps^2*a1*a2*z^2); };
}
