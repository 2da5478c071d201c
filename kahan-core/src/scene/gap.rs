//! Two orbits of one method, compared: so many steps against twice as many.
//!
//! In: a map, a first point, a composition, a time. Out: how far apart they come, until when they are near, and whether what they follow
//! is a solution without a pole.

use nalgebra::SVector;

use crate::{Composition, Lift};

/// Two orbits of one method, compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    /// The largest distance, relative to the scale; infinite where a point is not finite.
    pub(super) error: f64,
    /// The same over the first half of the time.
    pub(super) half: f64,
    /// The part of the time before the distance reached a tenth of the point, or the fine orbit passed a pole.
    pub(super) agreed: f64,
    /// Whether the fine orbit passed no pole.
    pub(super) is_resolved: bool,
}

/// A solution that is infinite at t* is there like c/(t − t*), so f like −x/(t − t*). Kahan's map steps over such a pole as if
/// nothing were, but one of its points is at most ε from it, and is the largest so far: there ε‖f‖ is at least ‖x‖. This part of that
/// leaves room for the terms beside.
const POLE: f64 = 0.75;
/// ‖x‖∞; infinite where a coordinate is not a number.
pub(super) fn norm<const N: usize>(x: &SVector<f64, N>) -> f64 {
    x.iter().fold(0.0, |largest, entry| if entry.is_nan() { f64::INFINITY } else { largest.max(entry.abs()) })
}

/// The orbit of so many steps against that of twice as many.
pub(super) fn gap<M, const N: usize>(
    map: &M,
    x0: &SVector<f64, N>,
    composition: Composition,
    time: f64,
    steps: u64,
) -> Gap
where
    M: Lift<f64, N>,
{
    let eps = 0.5 * time / steps as f64;
    let coarse = map.orbit(*x0, eps).composed(composition);
    let mut fine = map.orbit(*x0, 0.5 * eps).composed(composition);
    fine.next();
    let (mut distance, mut half, mut scale, mut agreed) = (0.0_f64, 0.0, norm(x0), None);
    let mut is_resolved = true;
    for (n, x) in (1..=steps).zip(coarse.skip(1)) {
        let (Some(between), Some(other)) = (fine.next(), fine.next()) else { break };
        for x in [between, other] {
            scale = scale.max(norm(&x));
            is_resolved &= 0.5 * eps * norm(&map.field(&x)) < POLE * scale || scale == 0.0;
        }
        let apart = norm(&(x - other));
        distance = distance.max(apart);
        let is_near = apart <= 0.1 * norm(&other);
        if !(is_resolved && is_near) {
            agreed.get_or_insert((n - 1) as f64 / steps as f64);
        }
        if n <= steps.div_ceil(2) {
            half = distance;
        }
    }
    let relative = |distance: f64| if distance > 0.0 { distance / scale } else { 0.0 };
    let error = relative(distance);
    let error = if error.is_nan() { f64::INFINITY } else { error };
    Gap { error, half: relative(half), agreed: agreed.unwrap_or(1.0), is_resolved }
}
