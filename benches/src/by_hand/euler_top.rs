//! Steps of the Euler top. With p, q, r = εα₁, εα₂, εα₃ and a = x + pyz, b = y + qzx, c = z + rxy
//! the map is x̃ = x + 2p·bc/D, ỹ = y + 2q·ca/D, z̃ = z + 2r·ab/D, where D = 1 − qrx² − pry² − pqz²
//! − 2pqr·xyz.

use kahan_bench_fields::EulerTop;

use crate::contender::{Contender, Role};

pub(crate) fn contenders(top: EulerTop<f64>, start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(top, eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(top, eps)),
    ]
}

/// Computes most products once, and uses them in the denominator and in the numerators.
pub(crate) fn fewest_operations(top: EulerTop<f64>, eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (p, q, r) = (eps * top.a1, eps * top.a2, eps * top.a3);
    move |[x, y, z]| {
        let (qx, rx, pz) = (q * x, r * x, p * z);
        let (a, b, c) = (x + pz * y, y + qx * z, z + rx * y);
        let (pb, qc, rb) = (p * b, q * c, r * b);
        let i = 2.0 / (1.0 - qx * rx - (p * y) * rb - pz * qc);
        let ai = a * i;
        [x + pb * c * i, y + qc * ai, z + rb * ai]
    }
}

/// Sums the terms of the denominator in pairs.
pub(crate) fn short_chain(top: EulerTop<f64>, eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (p, q, r) = (eps * top.a1, eps * top.a2, eps * top.a3);
    let (two_p, two_q, two_r) = (2.0 * p, 2.0 * q, 2.0 * r);
    move |[x, y, z]| {
        let (qx, ry, pz) = (q * x, r * y, p * z);
        let squares = qx * (r * x) + ry * (p * y);
        let i = 1.0 / (((1.0 - pz * (q * z)) - squares) - (qx * ry) * (pz + pz));
        let (a, b, c) = (x + pz * y, y + qx * z, z + ry * x);
        [x + two_p * b * c * i, y + two_q * c * a * i, z + two_r * a * b * i]
    }
}
