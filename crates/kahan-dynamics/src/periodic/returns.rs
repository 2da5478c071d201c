//! Places where an orbit comes back close to itself, from which cycles are looked for.

/// A return of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct CloseReturn {
    /// The place on the orbit that the orbit comes back to.
    pub at: usize,
    /// The steps until it is back.
    pub steps: usize,
    /// The distance at which it passes its earlier point, across its direction, in units of the
    /// orbit's extent.
    pub distance: f64,
}

/// Finds the returns of an orbit that pass closest, after at least `least` and at most `most`
/// steps, the closest and shortest first. Coordinates are measured by their ranges on the orbit.
///
/// A return after more steps counts besides one after fewer only where it is ten times as close: of
/// an orbit that is near a cycle it is not told that two rounds lead back, too.
///
/// Cost: about a thousand starts on the orbit are compared with `most` points each.
///
/// # Panics
/// If the points have not all as many coordinates.
#[must_use]
pub fn close_returns(orbit: &[Vec<f64>], [least, most]: [usize; 2]) -> Vec<CloseReturn> {
    /// The most starts, and the most returns.
    const STARTS: usize = 1000;
    const RETURNS: usize = 24;
    /// A return comes nearer than this, in units of the extent, after it was further away than
    /// this.
    const NEAR: f64 = 0.1;
    /// Returns that pass closer are equally close: steps are straight, and the orbit is not.
    const ALIKE: f64 = 1e-4;

    let Some(first) = orbit.first() else { return Vec::new() };
    let sizes: Vec<f64> = (0..first.len())
        .map(|k| {
            let column = orbit.iter().map(|x| x[k]);
            column.clone().fold(f64::MIN, f64::max) - column.fold(f64::MAX, f64::min)
        })
        .map(|size| if size > 0.0 { 1.0 / size } else { 0.0 })
        .collect();
    let square = |a: &[f64], b: &[f64]| -> f64 {
        a.iter().zip(b).zip(&sizes).map(|((a, b), size)| ((a - b) * size).powi(2)).sum()
    };
    let scaled = |i: usize| orbit[i].iter().zip(&sizes).map(|(x, size)| x * size).collect::<Vec<_>>();
    let across =
        |i: usize, j: usize| across([i - 1, i, i + 1].map(scaled).each_ref().map(|x| &x[..]), &scaled(j));
    let most = most.min(orbit.len().saturating_sub(2));
    let starts = orbit.len().saturating_sub(most + 1);
    let mut returns = Vec::new();
    for at in (1..starts).step_by((starts / STARTS).max(1)) {
        let (mut farthest, mut closest) = (0.0_f64, f64::INFINITY);
        let mut distances = [f64::INFINITY, 0.0];
        for steps in 1..=most {
            let next = square(&orbit[at + steps], &orbit[at]);
            let [before, here] = distances;
            let is_least = here <= before && here < next && here < NEAR * NEAR;
            if is_least && farthest > NEAR && steps > least.max(1) {
                let distance = across(at, at + steps - 1);
                if distance < 0.1 * closest && closest > ALIKE {
                    closest = distance;
                    returns.push(CloseReturn { at, steps: steps - 1, distance });
                }
            }
            farthest = farthest.max(next.sqrt());
            distances = [here, next];
        }
    }
    let rank = |one: &CloseReturn| one.distance.max(ALIKE) * one.steps as f64;
    returns.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
    returns.truncate(RETURNS);
    returns
}

/// The distance of a point from the parabola through three points of an orbit, near the middle one.
pub(super) fn across([before, x, behind]: [&[f64]; 3], there: &[f64]) -> f64 {
    let slope = |k: usize| 0.5 * (behind[k] - before[k]);
    // Off the tangent at a place of the parabola.
    let off = |k: usize, at: f64| {
        let bend = behind[k] - 2.0 * x[k] + before[k];
        there[k] - x[k] - 0.5 * at * at * bend
    };
    let length: f64 = (0..x.len()).map(|k| slope(k) * slope(k)).sum();
    let along = |at: f64| (0..x.len()).map(|k| off(k, at) * slope(k)).sum::<f64>() / length;
    let at = if length > 0.0 { along(along(along(0.0))) } else { 0.0 };
    (0..x.len()).map(|k| (off(k, at) - at * slope(k)).powi(2)).sum::<f64>().sqrt()
}
