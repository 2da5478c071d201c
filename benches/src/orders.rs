//! Compares compositions of order 8 with DOP853. Each uses the largest tried step or tolerance at
//! which the error is at most [`ERROR`]. Errors are measured at equidistant times. The reference is
//! the composition in double-double with 1024 steps between two of these times.

use kahan_core::prelude::*;
use kahan_core::{Composition, ExtendScalars};

use crate::rivals::dop853;

pub(crate) const HORIZON: f64 = 64.0;

/// The largest permitted error along the trajectory, relative to the largest component.
pub(crate) const ERROR: f64 = 1e-8;

/// The number of equidistant times at which errors are measured.
const SAMPLES: usize = 32;

pub(crate) const COMPOSITION: Composition = Composition::KAHAN_LI_8;

pub(crate) struct Run {
    pub(crate) name: String,
    pub(crate) error: f64,
    pub(crate) go: Box<dyn Fn()>,
}

/// Returns the run of DOP853, and then the run of the composition, for a system.
pub(crate) fn runs<M, const N: usize>(map: M, start: [f64; N]) -> [Run; 2]
where
    M: ExtendScalars<f64, N> + Copy + 'static,
{
    let start = SVector::from(start);
    let mut steps = 4;
    let composed = |steps: usize| -> Vec<SVector<f64, N>> {
        let eps = 0.5 * HORIZON / (SAMPLES * steps) as f64;
        map.orbit(start, eps).composed(COMPOSITION).step_by(steps).take(SAMPLES + 1).collect()
    };
    let error_of = |points: &[SVector<f64, N>], reference: &[SVector<f64, N>]| {
        let size = reference.iter().map(SVector::amax).fold(0.0, f64::max);
        points.iter().zip(reference).map(|(x, y)| (x - y).amax()).fold(0.0, f64::max) / size
    };
    let reference = reference(map, start);
    while error_of(&composed(steps), &reference) > ERROR {
        steps += (steps / 16).max(1);
    }
    let ours = error_of(&composed(steps), &reference);
    let (mut tolerance, mut theirs) = (1e-5, f64::INFINITY);
    while theirs > ERROR {
        tolerance *= 0.8;
        let solver = dop853::end(map, tolerance);
        let quarters = [1, 2, 3, 4].map(|k| k * SAMPLES / 4);
        let points =
            quarters.map(|k| SVector::from(solver(start.into(), HORIZON * k as f64 / SAMPLES as f64)));
        theirs = error_of(&points, &quarters.map(|k| reference[k]));
    }
    let eps = 0.5 * HORIZON / (SAMPLES * steps) as f64;
    let solver = dop853::end(map, tolerance);
    [
        Run {
            name: format!("DOP853, tolerances {tolerance:.1e}"),
            error: theirs,
            go: Box::new(move || {
                std::hint::black_box(solver(std::hint::black_box(start).into(), HORIZON));
            }),
        },
        Run {
            name: format!("{}, {} stages, step {:.2e}", COMPOSITION.name(), COMPOSITION.stages(), 2.0 * eps),
            error: ours,
            go: Box::new(move || {
                let mut orbit = map.orbit(std::hint::black_box(start), eps).composed(COMPOSITION);
                std::hint::black_box(orbit.nth(SAMPLES * steps));
            }),
        },
    ]
}

fn reference<M, const N: usize>(map: M, start: SVector<f64, N>) -> Vec<SVector<f64, N>>
where
    M: ExtendScalars<f64, N>,
{
    let wide = map.extend_scalars(|parameter| Dd::from(*parameter));
    let steps = 1024;
    let eps = Dd::from(0.5 * HORIZON / (SAMPLES * steps) as f64);
    let orbit = wide.orbit(start.map(Dd::from), eps).composed(COMPOSITION);
    orbit.step_by(steps).take(SAMPLES + 1).map(|x| x.map(f64::from)).collect()
}
