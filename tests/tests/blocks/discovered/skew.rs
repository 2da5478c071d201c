//! A Lotka–Volterra field of four variables with a skew matrix of ones: three integrals, and a
//! bracket of full rank.

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
}
