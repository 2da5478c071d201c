use kahan_core::prelude::*;

kahan! {
    /// Clebsch's case of a body in a fluid: ṁ = p × Wp and ṗ = p × m, where W = diag(w1, w2, w3),
    /// m = (k, l, m) and p = (p, q, r).
    ///
    /// Integrals of the flow are |p|², m·p and ½(|m|² + p·Wp).
    pub struct Clebsch { w1, w2, w3 }

    kdot = (w3 - w2)*q*r;
    ldot = (w1 - w3)*r*p;
    mdot = (w2 - w1)*p*q;
    pdot = q*m - r*l;
    qdot = r*k - p*m;
    rdot = p*l - q*k;
}
