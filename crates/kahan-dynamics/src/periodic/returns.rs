//! Close returns of an orbit, from which the search for cycles starts.

/// A close return of an orbit to an earlier point.
#[derive(Clone, Debug, PartialEq)]
pub struct CloseReturn {
    /// The index of the earlier point.
    pub at: usize,
    /// The number of steps until the return.
    pub steps: usize,
    /// The distance of the later point from the curve of the orbit near the earlier point. Each
    /// coordinate is divided by its range on the orbit.
    pub distance: f64,
}

/// Finds returns of an orbit to earlier points after `least` to `most` steps. They are sorted by
/// the product of distance and steps. Each coordinate is divided by its range on the orbit.
///
/// Two rounds of a cycle are not reported, because a later return to the same point must be ten
/// times closer. About 2000 points are compared with `most` successors each.
///
/// # Panics
/// If the points differ in their number of coordinates.
#[must_use]
pub fn close_returns(orbit: &[Vec<f64>], [least, most]: [usize; 2]) -> Vec<CloseReturn> {
    /// At least this many points of a long orbit, and at most twice as many, are tested.
    const START_POINTS: usize = 1000;
    const RETURNS: usize = 24;
    /// An orbit must first leave a point by more than this, in scaled coordinates, to return to it.
    const NEIGHBOURHOOD_RADIUS: f64 = 0.1;
    /// Distances below this are raised to it, because the interpolation is not more accurate.
    const EQUAL_RETURN_DISTANCE: f64 = 1e-4;

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
    let across = |i: usize, j: usize| {
        distance_from_parabola([i - 1, i, i + 1].map(scaled).each_ref().map(|x| &x[..]), &scaled(j))
    };
    let most = most.min(orbit.len().saturating_sub(2));
    let starts = orbit.len().saturating_sub(most + 1);
    let mut returns = Vec::new();
    for at in (1..starts).step_by((starts / START_POINTS).max(1)) {
        let (mut farthest, mut closest) = (0.0_f64, f64::INFINITY);
        let mut distances = [f64::INFINITY, 0.0];
        for steps in 1..=most {
            let next = square(&orbit[at + steps], &orbit[at]);
            let [before, here] = distances;
            let is_least =
                here <= before && here < next && here < NEIGHBOURHOOD_RADIUS * NEIGHBOURHOOD_RADIUS;
            if is_least && farthest > NEIGHBOURHOOD_RADIUS && steps > least.max(1) {
                let distance = across(at, at + steps - 1);
                if distance < 0.1 * closest && closest > EQUAL_RETURN_DISTANCE {
                    closest = distance;
                    returns.push(CloseReturn { at, steps: steps - 1, distance });
                }
            }
            farthest = farthest.max(next.sqrt());
            distances = [here, next];
        }
    }
    let rank = |one: &CloseReturn| one.distance.max(EQUAL_RETURN_DISTANCE) * one.steps as f64;
    returns.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
    returns.truncate(RETURNS);
    returns
}

/// Returns the distance of a point `there` near `x` from the parabola through the given points.
pub(super) fn distance_from_parabola([before, x, behind]: [&[f64]; 3], there: &[f64]) -> f64 {
    let slope = |k: usize| 0.5 * (behind[k] - before[k]);
    let off = |k: usize, at: f64| {
        let bend = behind[k] - 2.0 * x[k] + before[k];
        there[k] - x[k] - 0.5 * at * at * bend
    };
    let length: f64 = (0..x.len()).map(|k| slope(k) * slope(k)).sum();
    let along = |at: f64| (0..x.len()).map(|k| off(k, at) * slope(k)).sum::<f64>() / length;
    let at = if length > 0.0 { along(along(along(0.0))) } else { 0.0 };
    (0..x.len()).map(|k| (off(k, at) - at * slope(k)).powi(2)).sum::<f64>().sqrt()
}
