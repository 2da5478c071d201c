//! The symmetries x → −x, y → −y and (x, y, z) → (y, x, −z) of E4 and its map. Their compositions
//! bring every point to a quarter of space where the elliptic functions of the solution are real.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::special::Real;

/// A point as s = x + y, d = x − y, z and |xy|, after a [`Symmetry`] has been applied.
pub(super) struct NormalForm<T> {
    pub(super) sum: T,
    pub(super) difference: T,
    pub(super) height: T,
    pub(super) product: T,
}

/// A symmetry of E4's field and map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// Whether x changes its sign.
    pub flip_x: bool,
    /// Whether y changes its sign.
    pub flip_y: bool,
    /// Whether (x, y, z) becomes (y, x, −z) before the signs change.
    pub swap: bool,
}

impl Symmetry {
    /// Returns the image of the point with x + y = `sum`, x − y = `difference` and z = `height`.
    pub(super) fn point<T: Real>(&self, sum: T, difference: T, height: T) -> SVector<T, 3> {
        let x = (sum + difference) * T::half();
        let y = (sum - difference) * T::half();
        let (x, y, z) = if self.swap { (y, x, -height) } else { (x, y, height) };
        vector![if self.flip_x { -x } else { x }, if self.flip_y { -y } else { y }, z]
    }
}

impl<T: Real> NormalForm<T> {
    /// Maps a point to one with x, y ≥ 0.
    pub(super) fn same_signs(point: &SVector<T, 3>) -> (Self, Symmetry) {
        Self::with_signs(point, |_| (false, false))
    }

    /// Maps a point to one where x has the sign of εz and y has the opposite sign.
    pub(super) fn opposite_signs(point: &SVector<T, 3>, eps: &T) -> (Self, Symmetry) {
        Self::with_signs(point, |height| {
            let negative = height.is_negative() != eps.is_negative();
            (negative, !negative)
        })
    }

    /// Maps a point to one whose signs are `wanted(z)`: the first flag says whether x is negative,
    /// the second whether y is. If x = 0, x and y are exchanged first, so that x ≠ 0.
    fn with_signs(point: &SVector<T, 3>, wanted: impl Fn(&T) -> (bool, bool)) -> (Self, Symmetry) {
        let [x, y, z] = (*point).into();
        let swap = x.is_zero();
        let (first, second, height) = if swap { (y, x, -z) } else { (x, y, z) };
        let (first_negative, second_negative) = wanted(&height);
        let (flip_first, flip_second) =
            (first.is_negative() != first_negative, second.is_negative() != second_negative);
        let first = if flip_first { -first } else { first };
        let second = if flip_second { -second } else { second };
        let form =
            Self { sum: first + second, difference: first - second, height, product: (first * second).abs() };
        // `Symmetry` maps the normal form back: it exchanges x and y, and then changes signs.
        let (flip_x, flip_y) = if swap { (flip_second, flip_first) } else { (flip_first, flip_second) };
        (form, Symmetry { flip_x, flip_y, swap })
    }
}
