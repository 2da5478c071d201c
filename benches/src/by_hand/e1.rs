//! E1: with k = 1 + 2X and t = 1 − X the map is x̃ = x − 2Xx/k, ỹ = y − 2Xy/k, z̃ = z + 2ε(2y² + xz(1+X))/(kt).

use crate::contender::{Contender, Role};

/// All of them.
pub(crate) fn contenders(start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, one reciprocal", Role::ByHand, start, one_reciprocal(eps)),
        Contender::new("by hand, two reciprocals", Role::ByHand, start, two_reciprocals(eps)),
        Contender::new("by hand, three divisions", Role::ByHand, start, three_divisions(eps)),
    ]
}

/// One reciprocal, 1/(kt).
pub(crate) fn one_reciprocal(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, dx) = (eps * x, two_eps * x);
        let t = 1.0 - ex;
        let i = 1.0 / ((1.0 + dx) * t);
        let g = dx * t;
        let n = two_eps * y * (y + y) + z * (dx * (1.0 + ex));
        [x - (x * g) * i, y - (y * g) * i, z + n * i]
    }
}

/// 1/k first: x and y need no more than that, and only x closes the chain; z is divided by t at the end.
pub(crate) fn two_reciprocals(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, dx) = (eps * x, two_eps * x);
        let i = 1.0 / (1.0 + dx);
        let n = two_eps * y * (y + y) + z * (dx * (1.0 + ex));
        [x - (x * dx) * i, y - (y * dx) * i, z + (n * i) / (1.0 - ex)]
    }
}

/// A division a component: no multiplication after the division.
pub(crate) fn three_divisions(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, dx) = (eps * x, two_eps * x);
        let k = 1.0 + dx;
        let n = two_eps * y * (y + y) + z * (dx * (1.0 + ex));
        [x - (x * dx) / k, y - (y * dx) / k, z + n / (k * (1.0 - ex))]
    }
}
