//! Steps of E5. With X = εx, Y = εy, u = 1 + Y, v = 1 − Y, p = y − Xx and D = v + 2X² the map is x̃
//! = x + 2εxp/D, ỹ = y − 2εx²u/D, z̃ = z + 2εp(2x − zv)/(Du).

use crate::contender::{Contender, Role};

pub(crate) fn contenders(start: [f64; 3], eps: f64) -> Vec<Contender> {
    vec![
        Contender::new("by hand, fewest operations", Role::ByHand, start, fewest_operations(eps)),
        Contender::new("by hand, two reciprocals", Role::ByHand, start, two_reciprocals(eps)),
        Contender::new("by hand, mixed divisions", Role::ByHand, start, mixed_divisions(eps)),
        Contender::new("by hand, over the time step", Role::ByHand, start, over_time_step(eps)),
    ]
}

pub(crate) fn fewest_operations(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, ey) = (eps * x, eps * y);
        let (u, v) = (1.0 + ey, 1.0 - ey);
        let p = y - ex * x;
        let i = two_eps / ((v + ex * (ex + ex)) * u);
        let j = u * i;
        [x + x * p * j, y - x * x * u * j, z + p * (x + x - z * v) * i]
    }
}

pub(crate) fn two_reciprocals(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, ey, dx) = (eps * x, eps * y, two_eps * x);
        let (u, v) = (1.0 + ey, 1.0 - ey);
        let i = 1.0 / (v + ex * dx);
        let j = 1.0 / u;
        let p = two_eps * (y - ex * x);
        [x + (x * p) * i, y - (dx * (x * u)) * i, z + ((p * ((x + x) - z * v)) * j) * i]
    }
}

/// Makes two separate divisions, so that compilers do not combine them in one vector instruction.
pub(crate) fn mixed_divisions(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let two_eps = 2.0 * eps;
    move |[x, y, z]| {
        let (ex, ey, dx) = (eps * x, eps * y, two_eps * x);
        let (u, v) = (1.0 + ey, 1.0 - ey);
        let i = 1.0 / (v + ex * dx);
        let p = two_eps * (y - ex * x);
        [x + (x * p) * i, y - (dx * (x * u)) * i, z + ((p * ((x + x) - z * v)) * i) / u]
    }
}

/// Returns the step with the denominators D/(2ε²) and u/ε. The new x and y are used to compute z̃.
pub(crate) fn over_time_step(eps: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let (h, two_h) = (0.5 / eps, 1.0 / eps);
    move |[x, y, z]| {
        let (xx, u) = (x * x, two_h + y);
        let (i, j) = (1.0 / (h * (two_h - y) + xx), 1.0 / u);
        let (dx, dy) = ((x * (two_h * y - xx)) * i, (xx * u) * i);
        let next = y - dy;
        [x + dx, next, z + (((x + x) - z) * (y + next) + (y + y) * dx) * j]
    }
}
