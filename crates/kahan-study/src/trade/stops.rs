//! The points of an orbit that are looked at.

use crate::reference::Reference;

/// Steps at equal distances along an orbit, or all where they are fewer.
const EVENLY: u64 = 512;
/// Steps on each stretch of the trajectory that one polynomial describes: there are many where it
/// moves fast, however short that is.
const ON_A_PIECE: u32 = 3;
/// The most such stretches: of more than these, each is as good as the next.
const MOST_PIECES: usize = 2048;

/// Numbers of steps after which an orbit of so many steps, at least one, with ε = `eps`, is looked
/// at, each larger than the one before; the last step is among them.
pub(super) fn stops(reference: Option<&Reference>, eps: f64, steps: u64) -> Vec<u64> {
    let stride = steps.div_ceil(EVENLY);
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
