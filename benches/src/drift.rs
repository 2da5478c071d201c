//! Measures how rounding changes an integral of E6 over very long orbits, with and without
//! compensation of rounding errors.

use kahan_core::prelude::*;

kahan! {
    /// E6 of Hone and Petrera, with the integral whose change is measured.
    struct Watched;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
}

/// Half the time step, ε, which is a power of two.
pub(crate) const EPS: f64 = 1.0 / 1024.0;

pub(crate) struct Line {
    pub(crate) steps: usize,
    pub(crate) plain: f64,
    pub(crate) compensated: f64,
}

pub(crate) fn lines(decades: u32) -> Vec<Line> {
    let start = vector![0.3, 0.8, 0.5];
    let value = |x: SVector<f64, 3>| Watched.integrals(&x.map(Dd::from), Dd::from(EPS))[0];
    let first = value(start);
    let change = |x: SVector<f64, 3>| f64::from((value(x) - first) / first);
    let (mut plain, mut compensated) = (Watched.orbit(start, EPS), Watched.orbit(start, EPS).compensated());
    let mut done = 0;
    let mut lines = Vec::new();
    for decade in 5..=decades {
        let steps = 10_usize.pow(decade);
        let more = if done == 0 { steps } else { steps - done - 1 };
        let at = |orbit: &mut dyn Iterator<Item = SVector<f64, 3>>| {
            change(orbit.nth(more).expect("an orbit over floats goes on"))
        };
        lines.push(Line { steps, plain: at(&mut plain), compensated: at(&mut compensated) });
        done = steps;
    }
    lines
}
