//! A field that can be integrated equation by equation.

use kahan_core::prelude::*;

kahan! {
    pub struct Triangular;
    xdot = 1;
    ydot = x^2;
    zdot = x*y;
    integral H1 = 3*y - x^3 + 4*eps^2*x;
    integral H2 = 10*z - 5*x^2*y + x^5 + 8*eps^2*(3*y - x^3) + 16*eps^4*x;
    density rho = 1;
    bracket P1 { {y, z} = 1; };
    bracket P2 { {x, z} = 3; {y, z} = 3*x^2 - 4*eps^2; };
    bracket P3 { {x, y} = 10; {x, z} = 5*x^2 - 24*eps^2; {y, z} = -(10*x*y - 5*x^4 + 24*eps^2*x^2 - 16*eps^4); };
}
