//! The dressing chain of period three with two parameters.

use kahan_core::prelude::*;

kahan! {
    pub struct DressingChain { a, b }
    xdot = y^2 - z^2 + a;
    ydot = z^2 - x^2 + b;
    zdot = x^2 - y^2 - a - b;
    integral H1 = x + y + z;
    integral H2 = (a*x - b*x + 4*a*y + 2*b*y + a*z + 2*b*z + x^3 + y^3 + z^3 - 4*eps^2*a^2*x - 4*eps^2*b^2*y - 4*eps^2*a^2*z - 8*eps^2*a*b*z - 4*eps^2*b^2*z + 4*eps^2*a*x^2*y + 4*eps^2*b*x^2*y + 12*eps^2*a*x^2*z + 4*eps^2*b*x^2*z + 8*eps^2*a*x*y^2 + 8*eps^2*b*x*y^2 + 24*eps^2*a*x*y*z + 12*eps^2*b*x*y*z + 12*eps^2*a*x*z^2 + 8*eps^2*b*x*z^2 + 8*eps^2*a*y^2*z + 4*eps^2*a*y*z^2 + 4*eps^2*x^3*y*z + 8*eps^2*x^2*y^2*z + 8*eps^2*x^2*y*z^2 + 4*eps^2*x*y^3*z + 8*eps^2*x*y^2*z^2 + 4*eps^2*x*y*z^3)/(1 + 4*eps^2*x*y + 4*eps^2*x*z + 4*eps^2*y*z);
    density rho = 1/(1 + 4*eps^2*x*y + 4*eps^2*x*z + 4*eps^2*y*z);
    bracket P1 { {x, y} = 1 + 4*eps^2*x*y + 4*eps^2*x*z + 4*eps^2*y*z; {x, z} = -(1 + 4*eps^2*x*y + 4*eps^2*x*z + 4*eps^2*y*z); {y, z} = 1 + 4*eps^2*x*y + 4*eps^2*x*z + 4*eps^2*y*z; };
}
