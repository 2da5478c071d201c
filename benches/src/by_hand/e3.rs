//! Steps of E3. With r = x² + y² and Z = εz the map is x̃ = x − 2ε(z + εr)x/D, ỹ = y − 2ε(z +
//! εr)y/D, z̃ = z + 2εr(1 − Z)/D, where D = 1 + Z + 2ε²r.

use crate::contender::{Contender, Role};

pub(crate) fn contenders(start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(eps)),
        Contender::new("by hand, short chain", Role::ByHand, start, short_chain(eps)),
        Contender::new("by hand, one sum of squares", Role::ByHand, start, one_sum_of_squares(eps)),
        Contender::new("by hand, over the time step", Role::ByHand, start, over_time_step(eps)),
    ]
}

pub(crate) fn fewest_operations(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let r = x * x + y * y;
        let er = eps * r;
        let w = z + er;
        let i = two_eps / (1.0 + eps * (w + er));
        let g = w * i;
        [x - x * g, y - y * g, z + (r - er * z) * i]
    }
}

/// Computes the sum of squares for the numerators and for the denominator separately.
pub(crate) fn short_chain(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, ey, ez) = (eps * x, eps * y, eps * z);
        let (dx, dy) = (two_eps * x, two_eps * y);
        let s = ex * dx + ey * dy;
        let i = 1.0 / ((1.0 + ez) + s);
        let h = two_eps * z + s;
        let r = x * dx + y * dy;
        [x - (x * h) * i, y - (y * h) * i, z + (r * (1.0 - ez)) * i]
    }
}

/// Computes 2ε(x² + y²) once, and derives the other multiples of x² + y² from it.
pub(crate) fn one_sum_of_squares(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (dx, dy, ez) = (two_eps * x, two_eps * y, eps * z);
        let r = x * dx + y * dy;
        let s = eps * r;
        let i = 1.0 / ((1.0 + ez) + s);
        let h = (ez + ez) + s;
        [x - (x * h) * i, y - (y * h) * i, z + (r - r * ez) * i]
    }
}

/// Divides the denominator by 2ε², so that its term x² + y² needs no factor.
pub(crate) fn over_time_step(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (h, two_h) = (0.5 / eps, 1.0 / eps);
    move |[x, y, z]| {
        let r = x * x + y * y;
        let i = 1.0 / (h * (two_h + z) + r);
        let s = two_h * z + r;
        [x - (x * s) * i, y - (y * s) * i, z + (r * (two_h - z)) * i]
    }
}
