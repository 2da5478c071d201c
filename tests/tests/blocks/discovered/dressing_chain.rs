//! The dressing chain of period three with two parameters.

use kahan_core::prelude::*;

kahan! {
    pub struct DressingChain { a, b }
    xdot = y^2 - z^2 + a;
    ydot = z^2 - x^2 + b;
    zdot = x^2 - y^2 - a - b;
    integral H1 = x + y + z;
    integral H2 = (a*x - b*x + 4*a*y + 2*b*y + a*z + 2*b*z + x^3 + y^3 + z^3 - 4*eps^2*(a^2*x + b^2*y - 3*a*x^2*z - b*x^2*z - 6*a*x*y*z - 3*b*x*y*z - 3*a*x*z^2 - 2*b*x*z^2 - 2*a*y^2*z - a*y*z^2 - x^3*y*z - 2*x^2*y^2*z - 2*x^2*y*z^2 - x*y^3*z - 2*x*y^2*z^2 - x*y*z^3 + (a + b)*(a*z + b*z - x^2*y - 2*x*y^2)))/(1 + 4*eps^2*(x*y + x*z + y*z));
    density rho = 1/(1 + 4*eps^2*(x*y + x*z + y*z));
    bracket P1 { {x, y} = 1 + 4*eps^2*(x*y + x*z + y*z); {x, z} = -(1 + 4*eps^2*(x*y + x*z + y*z)); {y, z} = 1 + 4*eps^2*(x*y + x*z + y*z); };
    bracket P2 { {x, y} = (a + 2*b + 3*z^2 - 4*eps^2*((a + b)*(a + b - 2*x^2 + 2*y^2) - 2*a*x*y - 4*b*x*y - 6*a*x*z - 4*b*x*z - 2*a*y*z + x^4 - 2*x^2*y^2 - 4*x^2*y*z - 4*x*y^2*z - 6*x*y*z^2 - 2*x*z^3 + y^4 - 2*y*z^3) + 16*eps^4*(a^2*x^2 - 2*a*b*x*y + b^2*y^2 + 2*a*x^3*y + 3*a*x^2*y^2 - 2*b*x*y^3 + 2*a*x*y^2*z + 4*a*x*y*z^2 + 2*b*x*y*z^2 + a*y^2*z^2 + x^4*y^2 + 2*x^3*y^3 + 4*x^3*y^2*z + 2*x^3*y*z^2 + x^2*y^4 + 4*x^2*y^3*z + 7*x^2*y^2*z^2 + 2*x^2*y*z^3 + 2*x*y^3*z^2 + 2*x*y^2*z^3 + x^2*z*(2*y + z)*(3*a + 2*b)))/(1 + 4*eps^2*(x*y + x*z + y*z)); {x, z} = -(4*a + 2*b + 3*y^2 - 4*eps^2*(b^2 - 2*b*x^2 - 4*a*x*y - 4*b*x*y - 8*a*x*z - 4*b*x*z - 4*a*y*z + 2*b*z^2 + x^4 - 4*x^2*y*z - 2*x^2*z^2 - 2*x*y^3 - 6*x*y^2*z - 4*x*y*z^2 - 2*y^3*z + z^4) + 16*eps^4*(a^2*x^2 - 2*a*x^3*z + 4*a*x*y^2*z + 2*b*x*y^2*z + 4*a*x*y*z^2 + 2*a*y^2*z^2 + x^4*z^2 + 2*x^3*y^2*z + 4*x^3*y*z^2 + 2*x^3*z^3 + 2*x^2*y^3*z + 7*x^2*y^2*z^2 + 4*x^2*y*z^3 + x^2*z^4 + 2*x*y^3*z^2 + 2*x*y^2*z^3 + (a + b)*(2*a*x*z + a*z^2 + b*z^2 + 2*x^2*y^2 + 4*x^2*y*z - 2*x*z^3)))/(1 + 4*eps^2*(x*y + x*z + y*z)); {y, z} = (a - b + 3*x^2 - 4*eps^2*(a^2 - 2*a*x*y - 2*b*x*y - 6*a*x*z - 2*b*x*z + 2*a*y^2 - 2*a*y*z + 2*b*y*z - 2*a*z^2 - 2*x^3*y - 2*x^3*z - 6*x^2*y*z - 4*x*y^2*z - 4*x*y*z^2 + y^4 - 2*y^2*z^2 + z^4) + 16*eps^4*(y*(b^2*y + 4*a*x^2*z + 2*b*x^2*z + 2*b*y^2*z + 2*x^3*y*z + 2*x^3*z^2 + 2*x^2*y^2*z + 7*x^2*y*z^2 + 2*x^2*z^3 + 4*x*y^2*z^2 + 4*x*y*z^3 + y^3*z^2 + 2*y^2*z^3 + y*z^4) + x*z^2*(x + 2*y)*(3*a + b) + (a + b)*(2*b*y*z + a*z^2 + b*z^2 + x^2*y^2 + 2*x*y^2*z + 3*y^2*z^2 + 2*y*z^3)))/(1 + 4*eps^2*(x*y + x*z + y*z)); };
}
