//! Steps of E1. With X = εx, k = 1 + 2X and t = 1 − X the map is x̃ = x − 2Xx/k, ỹ = y − 2Xy/k, z̃
//! = z + 2ε(2y² + xz(1+X))/(kt).

use crate::contender::{Contender, Role};

pub(crate) fn contenders(start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, one reciprocal", Role::ByHand, start, one_reciprocal(eps)),
        Contender::new("by hand, two reciprocals", Role::ByHand, start, two_reciprocals(eps)),
        Contender::new("by hand, three divisions", Role::ByHand, start, three_divisions(eps)),
        Contender::new("by hand, over the time step", Role::ByHand, start, over_time_step(eps)),
    ]
}

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

/// Divides twice. The next x and y need only the first division.
pub(crate) fn two_reciprocals(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, dx) = (eps * x, two_eps * x);
        let i = 1.0 / (1.0 + dx);
        let n = two_eps * y * (y + y) + z * (dx * (1.0 + ex));
        [x - (x * dx) * i, y - (y * dx) * i, z + (n * i) / (1.0 - ex)]
    }
}

pub(crate) fn three_divisions(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, dx) = (eps * x, two_eps * x);
        let k = 1.0 + dx;
        let n = two_eps * y * (y + y) + z * (dx * (1.0 + ex));
        [x - (x * dx) / k, y - (y * dx) / k, z + n / (k * (1.0 - ex))]
    }
}

/// Divides the denominators by ε, so that only one addition precedes the division.
pub(crate) fn over_time_step(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (h, two_h, four_h) = (0.5 / eps, 1.0 / eps, 2.0 / eps);
    move |[x, y, z]| {
        let (k, t) = (h + x, two_h - x);
        let (i, j) = (1.0 / k, 1.0 / (k * t));
        let n = four_h * y * y + x * (two_h + x) * z;
        [x - (x * x) * i, y - (x * y) * i, z + n * j]
    }
}
