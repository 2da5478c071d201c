//! Measures the cost of expanding blocks with an unoptimised macro, which is cargo's default.
//! `KAHAN_TIMING=1 cargo build --package expansion_cost` in this workspace prints the cost.

use kahan_core::prelude::*;

kahan! {
    /// E6 of Hone and Petrera, with the integrals of Table 2, row 6 of their paper.
    pub struct E6;

    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);

    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
    density rho = -2/((x*z + y^2)*(x^2 + y^2 + z^2));
    bracket P {
        {x,y} = x*(1 + 3*eps^2*y^2);
        {y,z} = z*(1 + 3*eps^2*y^2);
        {z,x} = 2*y*(1 - 3*eps^2*x*z);
    }
    bracket Q {
        {x,y} = -(z + 3/2*eps^2*x*(x^2 + y^2 - z^2));
        {y,z} = -(x + 3/2*eps^2*z*(z^2 + y^2 - x^2));
        {z,x} = -y*(1 - 3*eps^2*x*z);
    }
}

kahan! {
    /// A dense quadratic field with six states, three parameters and one linear integral.
    pub struct Dense { a, b, c }
    xdot = 1/6*b*x*x + 7/1*c*x*y - 1/6*x*z - 2/1*b*x*u + 4/2*c*x*v + 7/1*a*x*w - 5/6*a*y*y + 3/3*a*y*z +
        3/2*y*u - 2/5*c*y*v - 2/2*y*w - 5/2*a*z*z - 2/2*b*z*u + 2/2*a*z*v - 2/6*a*z*w + 3/3*u*u + 2/4*a*u*v
        - 2/3*u*w + 2/3*v*v + 2/1*b*v*w + 2/3*c*w*w + 6/2*b*x + 8/6*a*y + 1/3*a*z + 6/4*a*u + 9/4*b*v +
        7/5*a*w + b/7;
    ydot = -5/6*a*x*x - 1/1*a*x*y + 4/3*b*x*z + 7/3*c*x*u - 3/5*b*x*v + 1/1*c*x*w - 3/2*b*y*y + 7/5*b*y*z -
        2/3*b*y*u + 7/1*b*y*v + 2/3*a*y*w - 3/6*a*z*z + 1/4*a*z*u - 5/1*c*z*v - 5/2*b*z*w + 1/4*c*u*u -
        2/1*u*v + 4/3*a*u*w - 2/6*a*v*v + 3/1*a*v*w + 3/3*a*w*w + 1/4*b*x + 3/4*c*y + 3/5*b*z + 8/6*c*u +
        6/4*b*v + 5/4*b*w + a/7;
    zdot = -3/4*a*x*x + 4/3*a*x*y - 3/4*b*x*z + 7/5*b*x*u - 3/3*x*v + 1/3*b*x*w + 4/3*b*y*y + 2/6*a*y*z -
        5/4*b*y*u + 2/6*b*y*v + 4/3*b*y*w + 2/3*b*z*z + 3/3*a*z*u + 4/3*b*z*v + 7/2*a*z*w - 1/3*c*u*u +
        1/6*u*v + 3/2*c*u*w + 1/5*b*v*v - 5/2*a*v*w + 4/5*a*w*w + 4/6*a*x + 1/4*a*y + 3/1*a*z + 2/3*a*u +
        8/2*c*v + 1/4*b*w + b/7;
    udot = 3/6*x*x - 1/2*b*x*y - 5/3*c*x*z + 1/4*x*u + 7/3*x*v + 7/5*b*x*w - 3/3*b*y*y + 1/3*a*y*z +
        3/4*b*y*u + 4/2*a*y*v + 3/5*c*y*w - 1/2*z*z + 2/6*z*u + 3/1*b*z*v + 7/2*b*z*w + 3/4*c*u*u -
        1/4*b*u*v + 4/6*c*u*w + 3/2*b*v*v + 1/4*b*v*w + 3/1*b*w*w + 5/4*b*x + 3/4*a*y + 2/6*c*z + 8/2*b*u +
        1/2*b*v + 1/4*c*w + c/7;
    vdot = 1/2*c*x*x - 5/2*c*x*y + 1/2*b*x*z + 1/4*c*x*u + 7/6*x*v - 5/2*b*x*w + 1/5*b*y*y + 1/6*y*z +
        4/3*b*y*u - 2/1*y*v + 1/5*c*y*w - 3/6*a*z*z - 5/4*c*z*u + 4/4*c*z*v + 3/6*a*z*w + 1/4*u*u +
        1/1*c*u*v + 1/6*c*u*w + 1/2*a*v*v + 4/6*c*v*w + 2/5*a*w*w + 7/5*c*x + 1/1*c*y + 4/3*a*z + 2/6*a*u +
        6/6*b*v + 2/4*c*w + b/7;
    wdot = -(1/6*b*x*x + 7/1*c*x*y - 1/6*x*z - 2/1*b*x*u + 4/2*c*x*v + 7/1*a*x*w - 5/6*a*y*y + 3/3*a*y*z +
        3/2*y*u - 2/5*c*y*v - 2/2*y*w - 5/2*a*z*z - 2/2*b*z*u + 2/2*a*z*v - 2/6*a*z*w + 3/3*u*u + 2/4*a*u*v
        - 2/3*u*w + 2/3*v*v + 2/1*b*v*w + 2/3*c*w*w + 6/2*b*x + 8/6*a*y + 1/3*a*z + 6/4*a*u + 9/4*b*v +
        7/5*a*w + b/7) - (-5/6*a*x*x - 1/1*a*x*y + 4/3*b*x*z + 7/3*c*x*u - 3/5*b*x*v + 1/1*c*x*w -
        3/2*b*y*y + 7/5*b*y*z - 2/3*b*y*u + 7/1*b*y*v + 2/3*a*y*w - 3/6*a*z*z + 1/4*a*z*u - 5/1*c*z*v -
        5/2*b*z*w + 1/4*c*u*u - 2/1*u*v + 4/3*a*u*w - 2/6*a*v*v + 3/1*a*v*w + 3/3*a*w*w + 1/4*b*x + 3/4*c*y
        + 3/5*b*z + 8/6*c*u + 6/4*b*v + 5/4*b*w + a/7) - (-3/4*a*x*x + 4/3*a*x*y - 3/4*b*x*z + 7/5*b*x*u -
        3/3*x*v + 1/3*b*x*w + 4/3*b*y*y + 2/6*a*y*z - 5/4*b*y*u + 2/6*b*y*v + 4/3*b*y*w + 2/3*b*z*z +
        3/3*a*z*u + 4/3*b*z*v + 7/2*a*z*w - 1/3*c*u*u + 1/6*u*v + 3/2*c*u*w + 1/5*b*v*v - 5/2*a*v*w +
        4/5*a*w*w + 4/6*a*x + 1/4*a*y + 3/1*a*z + 2/3*a*u + 8/2*c*v + 1/4*b*w + b/7) - (3/6*x*x - 1/2*b*x*y
        - 5/3*c*x*z + 1/4*x*u + 7/3*x*v + 7/5*b*x*w - 3/3*b*y*y + 1/3*a*y*z + 3/4*b*y*u + 4/2*a*y*v +
        3/5*c*y*w - 1/2*z*z + 2/6*z*u + 3/1*b*z*v + 7/2*b*z*w + 3/4*c*u*u - 1/4*b*u*v + 4/6*c*u*w +
        3/2*b*v*v + 1/4*b*v*w + 3/1*b*w*w + 5/4*b*x + 3/4*a*y + 2/6*c*z + 8/2*b*u + 1/2*b*v + 1/4*c*w +
        c/7) - (1/2*c*x*x - 5/2*c*x*y + 1/2*b*x*z + 1/4*c*x*u + 7/6*x*v - 5/2*b*x*w + 1/5*b*y*y + 1/6*y*z +
        4/3*b*y*u - 2/1*y*v + 1/5*c*y*w - 3/6*a*z*z - 5/4*c*z*u + 4/4*c*z*v + 3/6*a*z*w + 1/4*u*u +
        1/1*c*u*v + 1/6*c*u*w + 1/2*a*v*v + 4/6*c*v*w + 2/5*a*w*w + 7/5*c*x + 1/1*c*y + 4/3*a*z + 2/6*a*u +
        6/6*b*v + 2/4*c*w + b/7);
    integral s = x + y + z + u + v + w;
}

kahan! {
    /// A lift with the two new variables sin x and cos x.
    lift pub struct Pendulum { g }
    xdot = v;
    vdot = -g*sin(x);
}

kahan! {
    /// A lift whose new variables are found by a search.
    lift pub struct Kepler { mu }
    xdot = p;
    ydot = q;
    pdot = -mu*x/(x^2 + y^2)^(3/2);
    qdot = -mu*y/(x^2 + y^2)^(3/2);
}
