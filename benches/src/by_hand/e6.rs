//! Steps of E6, the Euler top with the coefficients −3, 1, 1 in the variables x + z, x − z and y.
//!
//! - Let s = x + z, d = x − z, X = εx, Y = εy, Z = εz, T = 3Y, u = 1 + T and v = 1 − T.
//! - Let a = y + εsd, b = d + Ys, c = s − Td, g = 2z − xu and h = zv − 2x.
//! - Let D = 1 + TY + 2ε²(zh − xg) = 1 + 3Y² − 8XZ + 2X²u + 2Z²v.
//! - The step is x̃ = x + 2εag/D, ỹ = y + 2εbc/D, z̃ = z + 2εah/D.
//!
//! The constant 3ε is not computed in advance, since its rounding would make the integrals drift.

use crate::contender::{Contender, Role};

pub(crate) fn contenders(start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(eps)),
        Contender::new("by hand, shortest chain", Role::ByHand, start, shortest_chain(eps)),
    ]
}

/// Computes the denominator from the numerators of x and z.
pub(crate) fn fewest_operations(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let ey = eps * y;
        let t = 3.0 * ey;
        let (g, h) = ((z + z) - (x + t * x), (z - t * z) - (x + x));
        let (s, d) = (x + z, x - z);
        let i = two_eps / (1.0 + t * ey + eps * (two_eps * (z * h - x * g)));
        let ai = (y + eps * d * s) * i;
        [x + ai * g, y + (d + ey * s) * (s - t * d) * i, z + ai * h]
    }
}

/// Computes the denominator in parallel with the numerators.
pub(crate) fn short_chain(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, ey, ez) = (eps * x, eps * y, eps * z);
        let (dx, dz) = (two_eps * x, two_eps * z);
        let t = 3.0 * ey;
        let (u, v) = (1.0 + t, 1.0 - t);
        let i = 1.0 / (((1.0 + t * ey) - 4.0 * ex * dz) + ((ex * dx) * u + (ez * dz) * v));
        let (s, d) = (x + z, x - z);
        let a = two_eps * (y + (ex + ez) * d);
        let (b, c) = (d + ey * s, s - t * d);
        [x + (a * ((z + z) - x * u)) * i, y + (two_eps * b * c) * i, z + (a * (z * v - (x + x))) * i]
    }
}

/// Computes the denominator as `short_chain` does, but with the constant 8ε, which is not rounded.
pub(crate) fn shortest_chain(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (two_eps, eight_eps) = (2.0 * eps, 8.0 * eps);
    move |[x, y, z]| {
        let (ex, ey, ez) = (eps * x, eps * y, eps * z);
        let (dx, dz) = (two_eps * x, two_eps * z);
        let dy = ey + ey;
        let (t, u, v) = (ey + dy, (1.0 + ey) + dy, (1.0 - ey) - dy);
        let i = 1.0 / (((1.0 - ex * (eight_eps * z)) + t * ey) + ((ex * dx) * u + (ez * dz) * v));
        let (s, d) = (x + z, x - z);
        let a = two_eps * (y + (ex + ez) * d);
        let (b, c) = (d + ey * s, s - t * d);
        [x + (a * ((z + z) - x * u)) * i, y + (two_eps * b * c) * i, z + (a * (z * v - (x + x))) * i]
    }
}
