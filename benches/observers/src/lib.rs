//! The fields that are observed, and the cells of a stability map.

use kahan_core::prelude::*;

kahan! {
    /// An integrable field in three variables.
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
}

kahan! {
    /// Two coupled oscillators.
    pub struct HenonHeiles;
    xdot = p;
    ydot = q;
    pdot = -x - 2*x*y;
    qdot = -y - x^2 + y^2;
}

/// Half the time step, ε, of the stability maps.
pub const MAP_EPS: f64 = 0.05;

/// Returns `side`² initial states (x, y, p, q) of Hénon and Heiles' system, with x = p = 0.1, and y
/// and q from −0.4 to 0.4.
pub fn cells(side: usize) -> Ensemble<f64, 4> {
    let axis = Axis { start: -0.4, end: 0.4, count: side };
    let fixed = Axis { start: 0.1, end: 0.1, count: 1 };
    Ensemble::grid([fixed, axis, fixed, axis])
}
