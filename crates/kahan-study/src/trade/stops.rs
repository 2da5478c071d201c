//! The steps of an orbit at which its points are compared with the reference, or its integrals
//! evaluated.

use crate::reference::Reference;

/// The number of evenly spaced stops; if the orbit has fewer steps, each step is a stop.
const EVEN_STOPS: u64 = 512;
/// The number of stops on each polynomial piece of the trajectory.
const ON_A_PIECE: u32 = 3;
/// The largest number of pieces that get stops.
const MOST_PIECES: usize = 2048;

/// Returns the steps after which an orbit of `steps` ≥ 1 steps is compared with the reference.
pub(super) fn inspected_steps(reference: Option<&Reference>, eps: f64, steps: u64) -> Vec<u64> {
    let stride = steps.div_ceil(EVEN_STOPS);
    let mut stops: Vec<u64> = (1..=steps / stride).map(|k| k * stride).collect();
    if let Some(flow) = reference.map(Reference::flow).filter(|_| stride > 1) {
        let apart = flow.breaks().len().div_ceil(MOST_PIECES);
        let begins: Vec<f64> = flow.breaks().step_by(apart).collect();
        let ends = begins.iter().skip(1).copied().chain([flow.end()]);
        for (begin, end) in begins.iter().zip(ends) {
            let times =
                (1..=ON_A_PIECE).map(|k| begin + (end - begin) * f64::from(k) / f64::from(ON_A_PIECE));
            stops.extend(times.map(|t| ((t / (2.0 * eps)).round() as u64).clamp(1, steps)));
        }
    }
    stops.push(steps);
    stops.sort_unstable();
    stops.dedup();
    stops
}
