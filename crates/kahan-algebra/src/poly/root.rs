//! Computes square roots of polynomials.

use num_bigint::BigInt;

use kahan_syntax::rational::Rational;

use super::{Monomial, Polynomial};

impl Polynomial {
    /// Returns the square root with positive leading coefficient. Returns `None` if the polynomial
    /// is not a square. The cost is at most that of multiplying the root by the polynomial.
    ///
    /// The highest term of polynomial − r² determines the next term of the root r. Also returns
    /// `None` if r has more terms than its square. All known r of this kind have at least 13 terms.
    pub fn square_root(&self) -> Option<Self> {
        let Some((monomial, coefficient)) = self.leading_term() else { return Some(Self::zero()) };
        let (monomial, coefficient) = (half_exponents(monomial)?, rational_root(coefficient)?);
        let twice = &coefficient + &coefficient;
        let mut root = Self::term(monomial.clone(), coefficient);
        let mut rest = self - &(&root * &root);
        while let Some((highest, value)) = rest.leading_term() {
            let next = Self::term(highest.div(&monomial)?, value.checked_div(&twice)?);
            if root.len() > self.len() || next.leading_term()?.0 >= root.terms().next_back()?.0 {
                return None;
            }
            // For the next term t, polynomial − (r + t)² is rest − t(2r + t).
            rest = &rest - &(&next * &(&(&root + &root) + &next));
            root = &root + &next;
        }
        Some(root)
    }
}

fn half_exponents(monomial: &Monomial) -> Option<Monomial> {
    let mut half = Monomial::one();
    for &(variable, exponent) in monomial.powers() {
        if exponent % 2 == 1 {
            return None;
        }
        half = half.mul(&Monomial::power(variable, exponent / 2));
    }
    Some(half)
}

fn rational_root(value: &Rational) -> Option<Rational> {
    if value.is_negative() {
        return None;
    }
    let root = |square: BigInt| {
        let root = square.sqrt();
        (&root * &root == square).then_some(root)
    };
    let (numerator, denominator) = (root(value.numerator())?, root(value.denominator())?);
    Some(Rational::from(num_rational::BigRational::new(numerator, denominator)))
}
