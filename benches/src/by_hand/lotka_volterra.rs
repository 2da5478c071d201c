//! Steps of the Lotka–Volterra system. With u = 1 − y, v = x − 1, p = u − εv, q = v + εu the map is
//! x̃ = x + 2εxp/D, ỹ = y + 2εyq/D, where D = 1 − ε(u+v) + ε²(x+y−1).

use crate::contender::{Contender, Role};

pub(crate) fn contenders(start: [f64; 2], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(eps)),
        Contender::new("by hand, two divisions", Role::ByHand, start, two_divisions(eps)),
        Contender::new("by hand, over the time step", Role::ByHand, start, over_time_step(eps)),
    ]
}

/// Computes 1 − y and x − 1 once, and uses each of these differences twice.
pub(crate) fn fewest_operations(eps: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    let two_eps = 2.0 * eps;
    move |[x, y]| {
        let (u, v) = (1.0 - y, x - 1.0);
        let (p, q) = (u - eps * v, v + eps * u);
        let i = two_eps / (1.0 - eps * (p + q - eps));
        [x + x * p * i, y + y * q * i]
    }
}

/// Reduces the critical path to six operations.
pub(crate) fn short_chain(eps: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    let two_eps = 2.0 * eps;
    move |[x, y]| {
        let (ex, ey) = (eps * x, eps * y);
        let i = 1.0 / ((1.0 + (ey - ex)) + eps * ((ex + ey) - eps));
        let n = two_eps * x * ((1.0 - y) - (ex - eps));
        let m = two_eps * y * ((x - 1.0) + (eps - ey));
        [x + n * i, y + m * i]
    }
}

pub(crate) fn two_divisions(eps: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    let two_eps = 2.0 * eps;
    move |[x, y]| {
        let (ex, ey) = (eps * x, eps * y);
        let d = (1.0 + (ey - ex)) + eps * ((ex + ey) - eps);
        let n = two_eps * x * ((1.0 - y) - (ex - eps));
        let m = two_eps * y * ((x - 1.0) + (eps - ey));
        [x + n / d, y + m / d]
    }
}

/// Divides the denominator by 2ε, with coefficients computed in advance.
pub(crate) fn over_time_step(eps: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    let (h, more, less) = (0.5 / eps, 1.0 + eps, 1.0 - eps);
    let (half_more, half_less, half_eps) = (0.5 * more, 0.5 * less, 0.5 * eps);
    move |[x, y]| {
        let d = (h - half_less * x) + (half_more * y - half_eps);
        [x + x * ((more - y) - eps * x) / d, y + y * ((x - less) - eps * y) / d]
    }
}
