//! The cheapest setting that preserves the map's own integrals.
//!
//! In exact arithmetic the map preserves its integrals at every ε. Rounding a state changes an
//! integral by about u·κ, with the unit roundoff u and the integral's condition number κ. These
//! changes add up to about √n·u·κ after n steps (random walk). Twice this bound must be within the
//! tolerance. Compensation lowers it.

use kahan_core::nalgebra::SVector;

use crate::flow::{norm, slope};
use kahan_core::{ExtendScalars, PreparedStep};

use super::search::{PLAIN_DOUBLE, PLAIN_DOUBLE_DOUBLE};
use super::{NoSetting, Scene, Setting};

/// The safety factor on rounding errors. In 19 of 20 random walks, the final sum is at most twice
/// its typical size.
const ROUNDING_SAFETY_FACTOR: f64 = 2.0;
/// The largest number of steps, which `f64` represents exactly.
const MOST_STEPS: f64 = 9e15;

const PILOT_STEPS: f64 = 4096.0;
/// The largest coordinate on an orbit, divided by the largest one with ε/4, may be at most this.
const MAX_SIZE_RATIO: f64 = 2.0;
const MAX_HALVINGS: i32 = 16;

pub(super) fn choose<M, const N: usize>(
    scene: &Scene,
    map: &M,
    x0: &SVector<f64, N>,
) -> Result<Setting, NoSetting>
where
    M: ExtendScalars<f64, N>,
{
    let rate = rate(map, x0);
    let first = (0.5 * scene.horizon * rate).ceil().max(1.0);
    let coarsest = (0..MAX_HALVINGS)
        .map(|k| first * libm::exp2(f64::from(k)))
        .find(|steps| stays_bounded(scene, map, x0, *steps));
    let Some(coarsest) = coarsest else { return Err(NoSetting::Lost { time: 0.0 }) };
    let cost = |setting: &Setting| {
        setting.steps as f64 * setting.scheme.cycles(<M::Prepared as PreparedStep<f64, N>>::COST)
    };
    let (mut best, mut least_error): (Option<Setting>, f64) = (None, f64::INFINITY);
    for scheme in [PLAIN_DOUBLE, PLAIN_DOUBLE.compensated(), PLAIN_DOUBLE_DOUBLE] {
        for k in 0..MAX_HALVINGS {
            let steps = coarsest * libm::exp2(f64::from(k));
            let mut setting = scene.setting(scheme, steps as u64);
            let (eps, steps) = (setting.eps, setting.steps as f64);
            if !(eps > 0.0 && steps < MOST_STEPS) {
                break;
            }
            // With compensation only the increment 2εf is rounded, of size 2ε·`rate` relative to x.
            let part = if scheme.compensated { (2.0 * eps * rate).min(1.0) } else { 1.0 };
            let error = ROUNDING_SAFETY_FACTOR
                * scene.condition
                * scheme.precision.unit()
                * (1.0 + part * steps.sqrt());
            least_error = least_error.min(error);
            if error > scene.tolerance {
                continue;
            }
            setting.error = error;
            let of = |known: &Setting| (cost(known), known.error);
            if best.as_ref().is_none_or(|known| of(&setting) < of(known)) {
                best = Some(setting);
            }
            break;
        }
    }
    best.ok_or(NoSetting::OutOfReach { best: least_error })
}

/// Returns whether the first points are finite, and not much larger than on the orbit with ε/4.
fn stays_bounded<M, const N: usize>(scene: &Scene, map: &M, x0: &SVector<f64, N>, steps: f64) -> bool
where
    M: ExtendScalars<f64, N>,
{
    let eps = scene.setting(PLAIN_DOUBLE, steps as u64).eps;
    let count = steps.min(PILOT_STEPS) as usize;
    let coarse = size(map.orbit(*x0, eps).take(count + 1));
    let fine = size(map.orbit(*x0, 0.25 * eps).take(4 * count + 1));
    fine.is_finite() && coarse <= MAX_SIZE_RATIO * fine
}

fn size<const N: usize>(orbit: impl Iterator<Item = SVector<f64, N>>) -> f64 {
    orbit.fold(0.0, |size, x| norm(&x).max(size))
}

/// Returns max(‖f′‖∞, ‖f‖∞/‖x‖∞) at a point.
fn rate<M, const N: usize>(map: &M, x: &SVector<f64, N>) -> f64
where
    M: ExtendScalars<f64, N>,
{
    let slope = slope(map, x);
    let (speed, size) = (norm(&map.field(x)), norm(x));
    let rate = if size > 0.0 { slope.max(speed / size) } else { slope };
    if rate.is_finite() { rate } else { 0.0 }
}
