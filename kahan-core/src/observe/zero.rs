//! Tells a zero from a jump where a function changes its sign.
//!
//! In: a function on 0 ≤ θ ≤ 1 whose values at the ends have opposite signs. Out: two places on
//! both sides of the sign change, as near to each other as the digits of θ allow, and whether the
//! function is small at both. It asks nothing of the function: at a pole, a jump or a value that is
//! not a number the search ends as it does at a zero, and the values at the two places tell.

use crate::{Constant, FloatScalar};

/// A place θ and the value of the function there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<T> {
    pub part: T,
    pub height: T,
}

/// The part of the larger value at the ends up to which a value next to the sign change is small:
/// u^⅓, with u the rounding of the scalar; 2⁻¹⁷ of `f64`, 2⁻⁸ of `f32`.
///
/// Two places that are next to each other differ by about u in θ. There a continuous function
/// differs from 0 by its rounding errors: by u·|x|/|x̃ − x| of its change from end to end where a
/// step moves the point from x to x̃. That is below u^⅓ in all steps that move a point by more than
/// u^⅔ of its size. A jump keeps its height, whatever their distance, and the values at a pole
/// exceed those at the ends.
pub(super) fn small<T: FloatScalar>() -> f64 {
    libm::exp2(-f64::from(T::SHORT_BITS))
}

/// The digits of the scalar, about.
const fn digits<T: FloatScalar>() -> u32 {
    3 * T::SHORT_BITS
}

/// Whether the function is as small at both places as at a zero, beside its values at the ends. An
/// end where it is infinite has no size.
pub(super) fn is_zero<T: FloatScalar>(places: [Place<T>; 2], ends: [T; 2]) -> bool {
    let sizes = ends.map(|height| height.approximate().abs()).into_iter().filter(|size| size.is_finite());
    let most = small::<T>() * sizes.fold(0.0, f64::max);
    places.iter().all(|place| place.height.approximate().abs() <= most)
}

/// Two places with the sign change between them, or a zero and a place beside it.
///
/// The next place is the zero of the secant through the place found last and the one on the other
/// side of the sign change, whose value counts half each time that it stays (the Illinois method).
/// It keeps the least distance from both, so that they come as near to each other as that. It is
/// the middle between them after two secants that did not halve their distance, and after a value
/// beyond those at both, as there is near a pole.
pub(super) fn narrow<T: FloatScalar>([start, end]: [T; 2], mut level: impl FnMut(T) -> T) -> [Place<T>; 2] {
    let half = T::constant(&Constant::ratio(1, 2));
    let least = (0..digits::<T>()).fold(T::one(), |least, _| least * half);
    let mut last = Place { part: T::one(), height: end };
    let mut other = Place { part: T::zero(), height: start };
    let (mut weighted, mut slow) = (start, 0);
    // Two secants and a middle halve the distance.
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
            // A value is infinite.
            _ => half,
        };
        // A function may have a limit where it has no value.
        let ratios = [ratio, half, half * half, half + half * half];
        let mut places = ratios.into_iter().map(|ratio| {
            let part = last.part + ratio * gap;
            Place { part, height: level(part) }
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
