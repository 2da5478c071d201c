//! Suslov's problem: degrees of iterates grow linearly, and the map preserves a deformed energy.

use kahan_core::prelude::*;

kahan! {
    pub struct Suslov { a, b }
    w1dot = -a*w1*w2 - b*w2^2;
    w2dot = a*w1^2 + b*w1*w2;
    integral H1 = (w1^2 + w2^2)/(1 + eps^2*w1*(a^2*w1 - b^2*w1 + 2*a*b*w2));
    density rho = 1/((w1^2 + w2^2)*(a*w1 + b*w2));
    bracket P1 { {w1, w2} = (w1^2 + w2^2)*(a*w1 + b*w2); };
}
