//! Double-double operations, each with its error bound in terms of u = 2⁻⁵³.
//!
//! In operands and results, the high part is the rounded sum of both parts. The module `extremes`
//! computes results that may overflow, and quotients and roots that may lose bits. Products below
//! 2⁻⁹⁶⁹ lose bits.

use crate::scalar::bounded::power_of_two;

use super::error_free::{fast_two_sum, multiply_add, two_product, two_sum};
use super::{Dd, extremes, moderate};

/// If a sum or product of high parts is below this bound, adding the low parts does not overflow.
const SUM_LIMIT: f64 = power_of_two(1022);

/// Quotients of operands between `SMALL` and `LARGE` lose no bits.
const SMALL: f64 = power_of_two(-450);
const LARGE: f64 = power_of_two(450);

#[inline(always)]
fn has_room(x: f64) -> bool {
    x.abs() < SUM_LIMIT
}

#[inline(always)]
pub(super) fn is_moderate(x: f64) -> bool {
    let size = x.abs();
    size > SMALL && size < LARGE
}

/// Returns x + y with an error of at most (3u² + 13u³)·|x + y|, by the algorithm AccurateDWPlusDW.
#[inline(always)]
pub(super) fn sum(x: Dd, y: Dd) -> Dd {
    let leading = two_sum(x.high, y.high);
    if has_room(leading.0) { moderate::with_lower(leading, x.low, y.low) } else { extremes::sum(x, y) }
}

#[inline(always)]
pub(super) fn difference(x: Dd, y: Dd) -> Dd {
    sum(x, -y)
}

/// Returns xy with an error of at most 5u²·|xy|, by the algorithm DWTimesDW2 or, without fused
/// operations, DWTimesDW1.
#[inline(always)]
pub(super) fn product(x: Dd, y: Dd) -> Dd {
    let leading = two_product(x.high, y.high);
    if has_room(leading.0) { moderate::product(leading, x, y) } else { extremes::product(x, y) }
}

/// Returns xy + z with an error of at most 16u²·|xy| + 5u²·|xy + z|.
///
/// The lower parts are added as floats, in half the time of a product and a sum.
///
/// Let p = |xy| and r = |xy + z|. Then |z| ≤ p + r. In units of u², the four nested additions of
/// lower parts, from the innermost on, round by at most p + |z|, 2p + |z|, 3p + |z| and 3p + |z| +
/// r. The omitted product x.low·y.low is at most p. Without fused multiply-adds, two products round
/// by at most p each: 16p + 5r in all. If the leading parts cancel to less than the sum of the
/// lower parts, the last sum is exact.
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
/// The leading quotient q has the remainder r = x − qy. The correction of q is r times the float
/// nearest to 1/y.high, which is computed in parallel with q.
///
/// Scale x.high, y.high and q into [1,2). The errors of x/y are, in units of u²·|x/y|, as follows.
/// Products and sums in r contribute 3, because r is at most 3u·x.high. The last addition in r
/// contributes 3, the omission of y.low contributes 3, and the last product contributes 3. The
/// reciprocal contributes 1.5. If y = q = 1, most of these are 0; else their sum is below 14.
#[inline(always)]
pub(super) fn quotient(x: Dd, y: Dd) -> Dd {
    if is_moderate(x.high) && is_moderate(y.high) {
        moderate::quotient(x, y)
    } else {
        extremes::quotient(x, y)
    }
}

/// Returns √x with an error of at most 25/8 u²·√x, by the algorithm SQRTDWtoDW.
#[inline]
pub(super) fn square_root(x: Dd) -> Dd {
    if x.high > SMALL && x.high < LARGE { moderate::square_root(x) } else { extremes::square_root(x) }
}
