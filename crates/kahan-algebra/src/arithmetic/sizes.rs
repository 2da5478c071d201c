//! Bounds degrees and coefficients of fractions. From these bounds, the prover computes how many
//! random points a proof needs.
//!
//! Plans form fractions N/M of integer polynomials without cancellation. A [`FractionSize`] bounds
//! the degrees of N and M and the logarithms of their 1-norms. Additions of bounds saturate.

use kahan_syntax::rational::Rational;

use super::Arithmetic;

/// Bounds on the degree and the coefficients of an integer polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct PolynomialSize {
    /// The total degree.
    pub degree: u64,
    /// The logarithm log₂ of the sum of the absolute values of the coefficients, rounded up.
    pub bits: u64,
}

/// Bounds on a fraction N/M of integer polynomials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct FractionSize {
    /// The numerator N.
    pub above: PolynomialSize,
    /// The denominator M.
    pub below: PolynomialSize,
}

impl PolynomialSize {
    fn times(self, other: Self) -> Self {
        let degree = self.degree.saturating_add(other.degree);
        PolynomialSize { degree, bits: self.bits.saturating_add(other.bits) }
    }

    /// Returns a bound that holds for both polynomials.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        PolynomialSize { degree: self.degree.max(other.degree), bits: self.bits.max(other.bits) }
    }

    fn summed(self, bits: u64) -> Self {
        self.times(PolynomialSize { degree: 0, bits })
    }
}

impl FractionSize {
    /// Returns the size of a variable.
    #[must_use]
    pub fn variable() -> Self {
        FractionSize { above: PolynomialSize { degree: 1, bits: 0 }, ..FractionSize::default() }
    }

    /// Returns the size of an exact constant p/q.
    #[must_use]
    pub fn constant(value: &Rational) -> Self {
        let length = PolynomialSize { degree: 0, bits: value.bits() };
        FractionSize { above: length, below: length }
    }
}

/// The arithmetic that computes with sizes instead of values.
#[derive(Clone, Copy, Debug)]
pub struct SizeArithmetic;

impl SizeArithmetic {
    /// Bounds the determinant of every matrix that consists of n columns of `rows`.
    ///
    /// The matrix `rows` has n rows with at least n entries. The bound's denominator is the product
    /// of all denominators in `rows`. Each of the n! terms has one numerator per row.
    #[must_use]
    pub fn determinant(self, rows: &[Vec<FractionSize>]) -> FractionSize {
        let product = |lengths: &mut dyn Iterator<Item = PolynomialSize>| {
            lengths.fold(PolynomialSize::default(), PolynomialSize::times)
        };
        let below = product(&mut rows.iter().flatten().map(|size| size.below));
        let largest = |row: &Vec<FractionSize>| {
            row.iter().map(|size| size.above).fold(PolynomialSize::default(), PolynomialSize::max)
        };
        let order = rows.len() as u64;
        let permutations = order.saturating_mul(u64::from(u64::BITS - order.leading_zeros()));
        FractionSize {
            above: product(&mut rows.iter().map(largest)).times(below).summed(permutations),
            below,
        }
    }
}

impl Arithmetic for SizeArithmetic {
    type Value = FractionSize;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<FractionSize> {
        Some(FractionSize::constant(value))
    }

    fn add(&self, a: &FractionSize, b: &FractionSize) -> FractionSize {
        let above = a.above.times(b.below).max(b.above.times(a.below)).summed(1);
        FractionSize { above, below: a.below.times(b.below) }
    }

    fn subtract(&self, a: &FractionSize, b: &FractionSize) -> FractionSize {
        self.add(a, b)
    }

    fn multiply(&self, a: &FractionSize, b: &FractionSize) -> FractionSize {
        FractionSize { above: a.above.times(b.above), below: a.below.times(b.below) }
    }

    fn negate(&self, a: &FractionSize) -> FractionSize {
        *a
    }

    fn divide(&self, a: &FractionSize, b: &FractionSize) -> Option<FractionSize> {
        Some(self.multiply(a, &FractionSize { above: b.below, below: b.above }))
    }

    fn is_zero(&self, _: &FractionSize) -> bool {
        false
    }
}
