//! The periodic Volterra lattice of three sites.

use kahan_core::prelude::*;

kahan! {
    pub struct Volterra;
    xdot = x*(y - z);
    ydot = y*(z - x);
    zdot = z*(x - y);
    integral H1 = x + y + z;
    integral H2 = x*y*z/(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2));
    density rho = 1/(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2));
    bracket P1 { {x, y} = 1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2); {x, z} = -(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2)); {y, z} = 1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2); };
    bracket P2 { {x, y} = -x*y*(1 - eps^2*(x - y + z)*(x - y - z))/(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2)); {x, z} = x*z*(1 - eps^2*(x + y - z)*(x - y - z))/(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2)); {y, z} = -y*z*(1 + eps^2*(x + y - z)*(x - y + z))/(1 - eps^2*(x^2 - 2*x*y - 2*x*z + y^2 - 2*y*z + z^2)); };
}
