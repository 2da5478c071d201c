//! Steps of Lorenz's system with the parameters σ, ρ, β.
//!
//! - Constants: s = εσ, r = ερ, b = εβ, k = 1 + s, l = 1 + ε, c = 1 + b.
//! - Variables: X = εx, Y = εy, Z = εz, q = x + sy, R = r − Z, T = kl − sR, D = cT + X(kX + sY).
//! - x̃ = x + 2s(cy + x(c(r − l) − Z − X²))/D,
//! - ỹ = y + 2(q(cR − XY) − k(cY − bXz))/D,
//! - z̃ = z + 2(q(RX + Y) − sXY − bzT)/D.
//!
//! The system has no integral that could drift, so all constants are computed in advance.

use kahan_bench_fields::Lorenz;

use crate::contender::{Contender, Role};

pub(crate) fn contenders(map: Lorenz<f64>, start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(map, eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(map, eps)),
    ]
}

pub(crate) fn fewest_operations(map: Lorenz<f64>, eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (s, r, b) = (eps * map.sigma, eps * map.rho, eps * map.beta);
    let (k, l, c) = (1.0 + s, 1.0 + eps, 1.0 + b);
    let (t0, x0) = (k * l - s * r, c * (r - l));
    move |[x, y, z]| {
        let (ex, ey, ez) = (eps * x, eps * y, eps * z);
        let (w, t, q) = (r - ez, t0 + s * ez, x + s * y);
        let i = 2.0 / (c * t + ex * (k * ex + s * ey));
        let n = s * (c * y + x * ((x0 - ez) - ex * ex));
        let m = q * (c * w - ex * ey) - k * (c * ey - b * ex * z);
        let o = q * (w * ex + ey) - s * ex * ey - b * z * t;
        [x + n * i, y + m * i, z + o * i]
    }
}

/// Computes the denominator with coefficients that are computed in advance.
pub(crate) fn short_chain(map: Lorenz<f64>, eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (s, r, b) = (eps * map.sigma, eps * map.rho, eps * map.beta);
    let (k, l, c) = (1.0 + s, 1.0 + eps, 1.0 + b);
    let (t0, x0) = (k * l - s * r, c * (r - l));
    let (d0, dz, dxx, dxy) = (c * t0, c * s * eps, k * eps, s * eps);
    let (two_s, two_b, two_k, c_eps) = (2.0 * s, 2.0 * b, 2.0 * k, c * eps);
    move |[x, y, z]| {
        let (ex, ey, ez) = (eps * x, eps * y, eps * z);
        let i = 1.0 / (ex * (dxx * x + dxy * y) + (d0 + dz * z));
        let q = x + s * y;
        let (q, w, t) = (q + q, r - ez, t0 + s * ez);
        let n = two_s * (c * y + x * ((x0 - ez) - ex * ex));
        let m = q * (c * w - ex * ey) - two_k * (c_eps * y - b * (ex * z));
        let o = q * (w * ex + ey) - (two_s * ex * ey + two_b * z * t);
        [x + n * i, y + m * i, z + o * i]
    }
}
