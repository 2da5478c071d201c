//! The Lotka–Volterra equations at ε = 1, where the map has an additional integral.

use kahan_core::prelude::*;

kahan! {
    pub struct LotkaVolterra;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
    integral H1 = (4*x^2 - 8*x*y + 4*y^2 - 4*x^3 + 4*x^2*y + 4*x*y^2 - 4*y^3 + x^4 + y^4)/(x^2*y^2) when eps = 1;
    density rho = 1/(x*y) when eps = 1;
    bracket P1 { {x, y} = x*y; } when eps = 1;
}
