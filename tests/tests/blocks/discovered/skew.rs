//! A Lotka–Volterra field of four variables with a skew matrix of ones: three integrals.

use kahan_core::prelude::*;

kahan! {
    pub struct Skew;
    xdot = x*(y + z + w);
    ydot = y*(z + w - x);
    zdot = z*(w - x - y);
    wdot = -w*(x + y + z);
    integral H1 = x + y + z + w;
    integral H2 = w*(x + y)/z;
    integral H3 = x*w/(y + z);
    density rho = 1/(y*z*(y + z));
    bracket P1 { {x, y} = x*y*z*(y + z + w)/(y + z); {x, z} = -x*y*z*(y + z + w)/(y + z); {y, z} = y*z*(x - w); {y, w} = y*z*w*(x + y + z)/(y + z); {z, w} = -y*z*w*(x + y + z)/(y + z); };
    bracket P2 { {x, y} = y*(x + y)*(y + z)*(z + w)/z; {x, z} = -y*(y + z)*(x + y - w); {x, w} = -y*w*(y + z)*(x + y + z)/z; {y, z} = y*(y + z)*(x + y - w); {y, w} = y*w*(y + z)*(x + y + z)/z; };
    bracket P3 { {x, y} = x*y^2*w*(x + y)/(z*(y + z)); {x, z} = x*y*w*(x + 2*y + z)/(y + z); {x, w} = x*y*w^2*(x + y + z)/(z*(y + z)); {y, z} = y^2*w; {y, w} = y^2*w^2*(x + y + z)/(z*(y + z)); {z, w} = y*w^2*(x + y + z)/(y + z); };
}
