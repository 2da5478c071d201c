//! Sizes of formal fractions: degree and coefficient size, for the error bound of the prover.
//!
//! Every value of a plan is a fraction N/M of integer polynomials, formed by the rules of
//! arithmetic without any cancellation. A [`Size`] bounds the total degrees of N and M and the
//! logarithms of their 1-norms (the sums of the absolute values of their coefficients, which are
//! submultiplicative). Running a plan in [`Sizes`] so gives bounds for its results; they saturate
//! instead of overflowing.

use kahan_syntax::rational::Rational;

use super::Arithmetic;

/// Bounds on a fraction N/M of integer polynomials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Size {
    /// deg N
    pub degree: u64,
    /// deg M
    pub denominator_degree: u64,
    /// log₂ ‖N‖₁, rounded up
    pub bits: u64,
    /// log₂ ‖M‖₁, rounded up
    pub denominator_bits: u64,
}

impl Size {
    /// A variable: degree 1, norm 1.
    #[must_use]
    pub fn variable() -> Self {
        Size { degree: 1, ..Size::default() }
    }

    /// An exact constant p/q.
    #[must_use]
    pub fn constant(value: &Rational) -> Self {
        Size { bits: value.bits(), denominator_bits: value.bits(), ..Size::default() }
    }
}

/// The arithmetic of sizes.
#[derive(Clone, Copy, Debug)]
pub struct Sizes;

impl Sizes {
    /// A bound for the determinant of any n×n matrix with columns among those of `rows` (n rows, at
    /// least n columns): over the product of all denominators, each of the n! terms has one
    /// numerator a row and no more than all denominators.
    #[must_use]
    pub fn determinant(self, rows: &[Vec<Size>]) -> Size {
        let all = || rows.iter().flatten();
        let denominator_degree = all().fold(0u64, |sum, size| sum.saturating_add(size.denominator_degree));
        let denominator_bits = all().fold(0u64, |sum, size| sum.saturating_add(size.denominator_bits));
        let largest = |of: fn(&Size) -> u64| {
            rows.iter().map(|row| row.iter().map(of).max().unwrap_or(0)).fold(0u64, u64::saturating_add)
        };
        let order = rows.len() as u64;
        let permutations = order.saturating_mul(u64::from(u64::BITS - order.leading_zeros()));
        Size {
            degree: largest(|size| size.degree).saturating_add(denominator_degree),
            denominator_degree,
            bits: largest(|size| size.bits).saturating_add(denominator_bits).saturating_add(permutations),
            denominator_bits,
        }
    }
}

impl Arithmetic for Sizes {
    type Value = Size;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Size> {
        Some(Size::constant(value))
    }

    fn add(&self, a: &Size, b: &Size) -> Size {
        Size {
            degree: a
                .degree
                .saturating_add(b.denominator_degree)
                .max(b.degree.saturating_add(a.denominator_degree)),
            denominator_degree: a.denominator_degree.saturating_add(b.denominator_degree),
            bits: a
                .bits
                .saturating_add(b.denominator_bits)
                .max(b.bits.saturating_add(a.denominator_bits))
                .saturating_add(1),
            denominator_bits: a.denominator_bits.saturating_add(b.denominator_bits),
        }
    }

    fn subtract(&self, a: &Size, b: &Size) -> Size {
        self.add(a, b)
    }

    fn multiply(&self, a: &Size, b: &Size) -> Size {
        Size {
            degree: a.degree.saturating_add(b.degree),
            denominator_degree: a.denominator_degree.saturating_add(b.denominator_degree),
            bits: a.bits.saturating_add(b.bits),
            denominator_bits: a.denominator_bits.saturating_add(b.denominator_bits),
        }
    }

    fn negate(&self, a: &Size) -> Size {
        *a
    }

    fn divide(&self, a: &Size, b: &Size) -> Option<Size> {
        let inverse = Size {
            degree: b.denominator_degree,
            denominator_degree: b.degree,
            bits: b.denominator_bits,
            denominator_bits: b.bits,
        };
        Some(self.multiply(a, &inverse))
    }

    fn is_zero(&self, _: &Size) -> bool {
        false
    }
}
