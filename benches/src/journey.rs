//! Integrations over a fixed time, which compare integrators of different kinds.

use kahan_core::prelude::*;
use nalgebra::{Const, DimMin};

use crate::rivals::{diffsol, dop853, midpoint, runge_kutta};

pub(crate) const SPAN: f64 = 8.0;

/// The time step 2ε of methods with fixed steps.
pub(crate) const STEP: f64 = 1.0 / 64.0;

/// The absolute and relative tolerance of adaptive methods.
pub(crate) const TOLERANCE: f64 = 1e-8;

pub(crate) struct Journey {
    pub(crate) name: &'static str,
    go: Box<dyn Fn() -> Vec<f64>>,
}

impl Journey {
    fn new<const N: usize>(
        name: &'static str,
        start: [f64; N],
        go: impl Fn([f64; N]) -> [f64; N] + 'static,
    ) -> Self {
        Self { name, go: Box::new(move || go(std::hint::black_box(start)).to_vec()) }
    }

    pub(crate) fn end(&self) -> Vec<f64> {
        (self.go)()
    }
}

pub(crate) fn journeys<M, const N: usize>(map: M, start: [f64; N]) -> Vec<Journey>
where
    M: KahanMap<f64, N> + Copy + 'static,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let eps = 0.5 * STEP;
    let steps = (SPAN / STEP) as usize;
    let (midpoint, runge_kutta) = (midpoint::step(map, eps), runge_kutta::step(map, eps));
    let (dop853, diffsol) = (dop853::end(map, TOLERANCE), diffsol::end(map, TOLERANCE));
    vec![
        Journey::new("Kahan, orbit", start, move |x| {
            map.orbit(SVector::from(x), eps).nth(steps).expect("an orbit over floats goes on").into()
        }),
        Journey::new(midpoint::NAME, start, move |x| (0..steps).fold(x, |x, _| midpoint(x))),
        Journey::new("Runge-Kutta 4", start, move |x| (0..steps).fold(x, |x, _| runge_kutta(x))),
        Journey::new("ode_solvers DOP853", start, move |x| dop853(x, SPAN)),
        Journey::new("diffsol tsit45", start, move |x| diffsol(x, SPAN)),
        Journey::new(REFERENCE, start, {
            let reference = dop853::end(map, 1e-14);
            move |x| reference(x, SPAN)
        }),
    ]
}

/// The name of the reference for errors, which is not timed.
pub(crate) const REFERENCE: &str = "reference";
