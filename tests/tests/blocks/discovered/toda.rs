//! The open Toda lattice of two particles in Flaschka's variables.

use kahan_core::prelude::*;

kahan! {
    pub struct Toda;
    adot = a*(c - b);
    bdot = 2*a^2;
    cdot = -2*a^2;
    integral H1 = b + c;
    integral H2 = (a^2 - b*c - eps^2*a^2*(b + c)^2)/(1 + 4*eps^2*a^2);
    density rho = 1/(a*(1 + 4*eps^2*a^2));
    bracket P1 { {a, b} = a*(1 + 4*eps^2*a^2); {a, c} = -a*(1 + 4*eps^2*a^2); };
    bracket P2 { {a, b} = a*(b + 2*eps^2*a^2*(b + c)); {a, c} = -a*(c + 2*eps^2*a^2*(b + c)); {b, c} = -2*a^2*(1 - eps^2*(b - c)^2)/(1 + 4*eps^2*a^2); };
}
