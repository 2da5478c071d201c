//! Sums and products of two floats with their rounding errors, which are floats themselves.
//!
//! In: two floats. Out: the rounded result and what it leaves; the two together are the exact
//! result unless something overflows, or, for products, falls below 2⁻⁹⁶⁹. The multiply-add is
//! fused where floats fuse theirs; a library call it never is.

/// a + b and its error (Knuth).
#[inline(always)]
pub(super) const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_a = sum - b;
    let from_b = sum - from_a;
    (sum, (a - from_a) + (b - from_b))
}

/// a + b and its error, where |a| ≥ |b| or a is a multiple of the last place of b (Dekker).
#[inline(always)]
pub(super) const fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// √a, rounded once.
#[inline(always)]
pub(super) fn root(a: f64) -> f64 {
    #[cfg(feature = "std")]
    return a.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(a);
}

pub(super) use product::{multiply_add, remainder, two_product};

/// Where the target fuses.
#[cfg(all(feature = "std", target_feature = "fma"))]
mod product {
    /// ab and its error.
    #[inline(always)]
    pub(in super::super) fn two_product(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        (product, a.mul_add(b, -product))
    }

    /// whole − ab, where it is a float: a the rounded quotient whole/b, or the rounded root with b
    /// = a.
    #[inline(always)]
    pub(in super::super) fn remainder(whole: f64, a: f64, b: f64) -> f64 {
        (-a).mul_add(b, whole)
    }

    /// ab + c, rounded once.
    #[inline(always)]
    pub(in super::super) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

/// Where it does not.
#[cfg(not(all(feature = "std", target_feature = "fma")))]
mod product {
    /// Beyond this [`split`] would overflow.
    const LARGE: f64 = f64::from_bits((1023 + 995) << 52);

    /// ab and its error, by halves (Dekker).
    #[inline(always)]
    pub(in super::super) fn two_product(a: f64, b: f64) -> (f64, f64) {
        if a.abs() < LARGE && b.abs() < LARGE { halves(a, b) } else { large(a, b) }
    }

    #[inline(always)]
    fn halves(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
        let left = ((a_high * b_high - product) + a_high * b_low) + a_low * b_high;
        (product, left + a_low * b_low)
    }

    /// Two floats of 26 bits and one sign with the sum a (Veltkamp).
    #[inline(always)]
    fn split(a: f64) -> (f64, f64) {
        const FACTOR: f64 = ((1_u32 << 27) + 1) as f64;
        let spread = FACTOR * a;
        let high = spread - (spread - a);
        (high, a - high)
    }

    /// With the large factor made smaller. The other one is brought up, so that no half of it
    /// underflows.
    #[cold]
    #[inline(never)]
    fn large(a: f64, b: f64) -> (f64, f64) {
        const DOWN: f64 = f64::from_bits((1023 - 100) << 52);
        const UP: f64 = f64::from_bits((1023 + 100) << 52);
        let product = a * b;
        let (a, b) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
        if b.abs() < LARGE * DOWN {
            (product, halves(a * DOWN, b * UP).1)
        } else {
            // The product is not finite, and it has no error.
            (product, f64::NAN)
        }
    }

    /// whole − ab, where it is a float: a the rounded quotient whole/b, or the rounded root with b
    /// = a.
    #[inline(always)]
    pub(in super::super) fn remainder(whole: f64, a: f64, b: f64) -> f64 {
        let (product, error) = two_product(a, b);
        (whole - product) - error
    }

    /// ab + c.
    #[inline(always)]
    pub(in super::super) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }
}
