//! Error-free sums and products of two floats.
//!
//! The functions for sums and products return the rounded result and its error. The sum of both is
//! exact unless the result overflows or is a product below 2⁻⁹⁶⁹.

/// Returns the rounded sum and its error (Knuth).
#[inline(always)]
pub(super) const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_a = sum - b;
    let from_b = sum - from_a;
    (sum, (a - from_a) + (b - from_b))
}

/// Returns the rounded sum and its error (Dekker). Requires that |a| ≥ |b|, or that a is a multiple
/// of the unit in the last place of b.
#[inline(always)]
pub(super) const fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

#[inline(always)]
pub(super) fn root(a: f64) -> f64 {
    #[cfg(feature = "std")]
    return a.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(a);
}

pub(super) use product::{multiply_add, remainder, two_product};

#[cfg(all(feature = "std", target_feature = "fma"))]
mod product {
    #[inline(always)]
    pub(in super::super) fn two_product(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        (product, a.mul_add(b, -product))
    }

    /// Returns the exact remainder whole − ab, where a is the rounded quotient whole/b, or a = b is
    /// the rounded square root of whole.
    #[inline(always)]
    pub(in super::super) fn remainder(whole: f64, a: f64, b: f64) -> f64 {
        (-a).mul_add(b, whole)
    }

    #[inline(always)]
    pub(in super::super) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

#[cfg(not(all(feature = "std", target_feature = "fma")))]
mod product {
    /// Above this number [`split`] may overflow.
    const SPLIT_LIMIT: f64 = f64::from_bits((1023 + 995) << 52);

    /// Returns the rounded product and its error, by splitting the factors (Dekker).
    #[inline(always)]
    pub(in super::super) fn two_product(a: f64, b: f64) -> (f64, f64) {
        if a.abs() < SPLIT_LIMIT && b.abs() < SPLIT_LIMIT { halves(a, b) } else { scaled_product(a, b) }
    }

    #[inline(always)]
    fn halves(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
        let left = ((a_high * b_high - product) + a_high * b_low) + a_low * b_high;
        (product, left + a_low * b_low)
    }

    /// Splits a into two floats of at most 26 bits whose sum is a (Veltkamp).
    #[inline(always)]
    fn split(a: f64) -> (f64, f64) {
        const SPLIT_FACTOR: f64 = ((1_u32 << 27) + 1) as f64;
        let spread = SPLIT_FACTOR * a;
        let high = spread - (spread - a);
        (high, a - high)
    }

    /// Returns the rounded product and its error for a large factor, which is scaled down. The
    /// other factor is scaled up to prevent underflow.
    #[cold]
    #[inline(never)]
    fn scaled_product(a: f64, b: f64) -> (f64, f64) {
        const SCALE_DOWN: f64 = f64::from_bits((1023 - 100) << 52);
        const SCALE_UP: f64 = f64::from_bits((1023 + 100) << 52);
        let product = a * b;
        let (a, b) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
        if b.abs() < SPLIT_LIMIT * SCALE_DOWN {
            (product, halves(a * SCALE_DOWN, b * SCALE_UP).1)
        } else {
            // The product is infinite or NaN.
            (product, f64::NAN)
        }
    }

    #[inline(always)]
    pub(in super::super) fn remainder(whole: f64, a: f64, b: f64) -> f64 {
        let (product, error) = two_product(a, b);
        (whole - product) - error
    }

    #[inline(always)]
    pub(in super::super) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }
}
