//! Searches for a sign change of a function, which may be a zero or a jump.
//!
//! The function may have poles, jumps and NaNs. The search then ends normally, and [`is_zero`]
//! tells zeros from jumps.

use crate::{Constant, FloatScalar};

#[derive(Clone, Copy, Debug)]
pub(super) struct ZeroBracket<T> {
    pub part: T,
    pub height: T,
}

/// Returns u^⅓ for the unit roundoff u: 2⁻¹⁷ for `f64`, and 2⁻⁸ for `f32`.
///
/// A sign change of a function counts as a zero if the function is small on both sides of it. Small
/// means at most u^⅓ times the larger magnitude at the ends of the step. A zero may be missed if
/// the step moves the point by less than u^⅔ of its size.
pub(super) fn small<T: FloatScalar>() -> f64 {
    libm::exp2(-f64::from(T::SHORT_BITS))
}

const fn digits<T: FloatScalar>() -> u32 {
    3 * T::SHORT_BITS
}

/// Returns whether both |values| are at most [`small`] times the larger finite |value| of `ends`.
pub(super) fn is_zero<T: FloatScalar>(places: [ZeroBracket<T>; 2], ends: [T; 2]) -> bool {
    let sizes = ends.map(|height| height.approximate().abs()).into_iter().filter(|size| size.is_finite());
    let most = small::<T>() * sizes.fold(0.0, f64::max);
    places.iter().all(|place| place.height.approximate().abs() <= most)
}

/// Returns two arguments with the sign change between them, or a zero and an argument beside it.
///
/// The search uses the Illinois method: each new argument is the zero of a secant, and the value at
/// a retained end is halved in the next secant. Each new argument keeps a least distance from both
/// ends. If secants do not halve the interval, bisection replaces the secant.
pub(super) fn narrow<T: FloatScalar>(
    [start, end]: [T; 2],
    mut level: impl FnMut(T) -> T,
) -> [ZeroBracket<T>; 2] {
    let half = T::constant(&Constant::ratio(1, 2));
    let least = (0..digits::<T>()).fold(T::one(), |least, _| least * half);
    let mut last = ZeroBracket { part: T::one(), height: end };
    let mut other = ZeroBracket { part: T::zero(), height: start };
    let (mut weighted, mut slow) = (start, 0);
    // Three evaluations, two secants and a bisection, halve the interval.
    for _ in 0..3 * digits::<T>() {
        let gap = other.part - last.part;
        let share = if gap.approximate() < 0.0 { -least / gap } else { least / gap };
        let closest = share.approximate();
        if closest >= 1.0 {
            break;
        }
        if last.height.is_zero() {
            other.part = last.part + share * gap;
            other.height = level(other.part);
            break;
        }
        let secant = last.height / (last.height - weighted);
        let ratio = match secant.approximate() {
            _ if slow == 2 || closest > 0.5 => half,
            at if at > 0.0 && at < closest => share,
            at if at > 1.0 - closest && at <= 1.0 => T::one() - share,
            at if at > 0.0 && at < 1.0 => secant,
            _ => half,
        };
        // If the function is NaN at one argument, other arguments are tried.
        let ratios = [ratio, half, half * half, half + half * half];
        let mut places = ratios.into_iter().map(|ratio| {
            let part = last.part + ratio * gap;
            ZeroBracket { part, height: level(part) }
        });
        let Some(found) = places.find(|place| !place.height.approximate().is_nan()) else { break };
        let [new, old, beyond] = [found, last, other].map(|place| place.height.approximate());
        if (new < 0.0) == (old < 0.0) {
            weighted *= half;
        } else {
            (other, weighted) = (last, last.height);
        }
        let is_halved = (other.part - found.part).approximate().abs() <= 0.5 * gap.approximate().abs();
        slow = match (new.abs() >= old.abs().max(beyond.abs()), is_halved) {
            (true, _) => 2,
            (false, true) => 0,
            (false, false) => (slow + 1) % 3,
        };
        last = found;
    }
    [last, other]
}
