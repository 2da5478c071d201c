//! A Lotka–Volterra field of four variables with three integrals and a bracket of full rank.

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
    density rho = 1/(x*y*z*w);
    bracket P1 { {x, y} = x*y; {x, z} = x*z; {x, w} = x*w; {y, z} = y*z; {y, w} = y*w; {z, w} = z*w; };
    bracket P2 { {y, z} = z^2; {y, w} = -z^2; {z, w} = z^2; };
    bracket P3 { {x, y} = x*y*w*(x + y)*(z + w)/z; {x, z} = -x*y*w*(x + y - w); {x, w} = -x*y*w^2*(x + y + z)/z; {y, z} = x*y*w*(x + y - w); {y, w} = x*y*w^2*(x + y + z)/z; };
    bracket P4 { {x, y} = x^2*y*z*w*(y + z + w)/(y + z)^2; {x, z} = -x^2*y*z*w*(y + z + w)/(y + z)^2; {y, z} = x*y*z*w*(x - w)/(y + z); {y, w} = x*y*z*w^2*(x + y + z)/(y + z)^2; {z, w} = -x*y*z*w^2*(x + y + z)/(y + z)^2; };
    bracket P5 { {x, y} = x^2*y^2*w^2*(x + y)/(z*(y + z)^2); {x, z} = x^2*y*w^2*(x + 2*y + z)/(y + z)^2; {x, w} = x^2*y*w^3*(x + y + z)/(z*(y + z)^2); {y, z} = x*y^2*w^2/(y + z); {y, w} = x*y^2*w^3*(x + y + z)/(z*(y + z)^2); {z, w} = x*y*w^3*(x + y + z)/(y + z)^2; };
}
