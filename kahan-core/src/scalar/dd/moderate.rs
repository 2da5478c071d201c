//! The operations on numbers for which no intermediate result overflows. Only products may
//! underflow.

use super::Dd;
use super::error_free::{fast_two_sum, multiply_add, remainder, root, two_sum};

/// Returns sum + error + a + b, where the last three are small beside the rounded `sum`.
#[inline(always)]
pub(super) fn with_lower((sum, error): (f64, f64), a: f64, b: f64) -> Dd {
    let (lower, rest) = two_sum(a, b);
    let (sum, error) = fast_two_sum(sum, error + lower);
    let (high, low) = fast_two_sum(sum, rest + error);
    Dd { high, low }
}

/// Returns xy rounded; `leading` + `error` is the exact product of the high parts of x and y.
#[inline(always)]
pub(super) fn product((leading, error): (f64, f64), x: Dd, y: Dd) -> Dd {
    let lower = multiply_add(x.low, y.high, x.high * y.low);
    let (high, low) = fast_two_sum(leading, error + lower);
    Dd { high, low }
}

#[inline(always)]
pub(super) fn quotient(x: Dd, y: Dd) -> Dd {
    let leading = x.high / y.high;
    let reciprocal = 1.0 / y.high;
    let remainder = remainder(x.high, leading, y.high) + multiply_add(-leading, y.low, x.low);
    let (high, low) = fast_two_sum(leading, remainder * reciprocal);
    Dd { high, low }
}

#[inline]
pub(super) fn square_root(x: Dd) -> Dd {
    let leading = root(x.high);
    let remainder = remainder(x.high, leading, leading) + x.low;
    let (high, low) = fast_two_sum(leading, remainder / (leading + leading));
    Dd { high, low }
}
