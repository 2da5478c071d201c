//! Double-double operations, each with its error bound; u = 2⁻⁵³.
//!
//! Operands and results are normalised. Everything is inlined, so that a kernel becomes one
//! straight-line program. Operands that may overflow or lose bits go to `extremes`, on a branch
//! that ordinary computations never take and that adds no latency.

use crate::scalar::bounded::power_of_two;

use super::error_free::{fast_two_sum, multiply_add, two_product, two_sum};
use super::{Dd, extremes, moderate};

/// The bound on leading sums and products below which all later additions stay finite.
const ROOM: f64 = power_of_two(1022);

/// Quotients of operands between these bounds lose no bits: they are between 2⁻⁹⁰⁰ and 2⁹⁰⁰.
const SMALL: f64 = power_of_two(-450);
const LARGE: f64 = power_of_two(450);

#[inline(always)]
fn has_room(x: f64) -> bool {
    x.abs() < ROOM
}

#[inline(always)]
pub(super) fn is_moderate(x: f64) -> bool {
    let size = x.abs();
    size > SMALL && size < LARGE
}

/// Returns x + y with an error of at most (3u² + 13u³)·|x + y| (AccurateDWPlusDW).
#[inline(always)]
pub(super) fn sum(x: Dd, y: Dd) -> Dd {
    let leading = two_sum(x.high, y.high);
    if has_room(leading.0) { moderate::with_lower(leading, x.low, y.low) } else { extremes::sum(x, y) }
}

#[inline(always)]
pub(super) fn difference(x: Dd, y: Dd) -> Dd {
    sum(x, -y)
}

/// Returns xy with an error of at most 5u²·|xy| (DWTimesDW2, or DWTimesDW1 without fusing).
#[inline(always)]
pub(super) fn product(x: Dd, y: Dd) -> Dd {
    let leading = two_product(x.high, y.high);
    if has_room(leading.0) { moderate::product(leading, x, y) } else { extremes::product(x, y) }
}

/// Returns xy + z with an error of at most 16u²·|xy| + 5u²·|xy + z|.
///
/// The product is not normalised, and the lower parts are added as floats. This takes 15 operations
/// and half the latency of a product and a sum, which take 28. It is as accurate, because the error
/// of the product is a multiple of |xy| even if the sum cancels. In units of u², with p = |xy|, r =
/// |xy + z| and |z| ≤ p + r, the additions of the lower parts round by p + |z|, 2p + |z|, 3p + |z|
/// and 3p + |z| + r, and the omitted x.low·y.low is p. Without fused multiply-adds two products
/// round by p each. If the leading parts cancel below the lower sum, they leave a multiple of its
/// last place, so the last sum is exact.
#[inline(always)]
pub(super) fn product_plus(x: Dd, y: Dd, z: Dd) -> Dd {
    let (leading, product_error) = two_product(x.high, y.high);
    let (sum_of_leading, sum_error) = two_sum(leading, z.high);
    if has_room(sum_of_leading) {
        let lower = multiply_add(x.low, y.high, multiply_add(x.high, y.low, z.low));
        let (high, low) = fast_two_sum(sum_of_leading, sum_error + (product_error + lower));
        Dd { high, low }
    } else {
        sum(product(x, y), z)
    }
}

/// Returns x/y with an error of at most 14u²·|x/y|.
///
/// The remainder r = x − qy of the leading quotient q is known up to its last bits, because x.high
/// − q·y.high is a float. The correction is r times the float nearest to 1/y.high, computed in
/// parallel with q. With x.high, y.high and q scaled into [1,2), the errors in u² of x/y are: 3
/// from the products and sums in r, which is at most 3u·x.high; 3 each from its last addition, from
/// omitting y.low and from the last product; 1.5 from the reciprocal. Unless y = q = 1, they add up
/// to less.
#[inline(always)]
pub(super) fn quotient(x: Dd, y: Dd) -> Dd {
    if is_moderate(x.high) && is_moderate(y.high) {
        moderate::quotient(x, y)
    } else {
        extremes::quotient(x, y)
    }
}

/// Returns √x with an error of at most 25/8 u²·√x (SQRTDWtoDW).
#[inline]
pub(super) fn square_root(x: Dd) -> Dd {
    if x.high > SMALL && x.high < LARGE { moderate::square_root(x) } else { extremes::square_root(x) }
}
