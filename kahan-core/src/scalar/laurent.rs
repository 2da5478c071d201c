//! Truncated Laurent series Σ cₖδᵏ + O(δᵉ), in which k may be negative.
//!
//! A formula at a point shifted by δ gives the formula's limit as δ → 0, even at a pole.
//! Coefficients over an exact scalar are exact. Cancellation shortens a series, possibly until no
//! term is known.

use core::ops::Neg;
use std::vec::Vec;

use num_traits::{One, Zero};

use super::{Constant, Scalar, operators};

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Laurent<T> {
    Number(T),
    /// The series Σ terms\[k\]·δ^(start + k) + O(δ^(start + number of terms)), terms\[0\] ≠ 0.
    Series {
        /// The power of the first term. Without terms, this is the exponent in O(δ^start).
        start: i64,
        terms: Vec<T>,
    },
}

use Laurent::{Number, Series};

impl<T: Scalar> Laurent<T> {
    /// Returns δ as a series of this many terms.
    pub(crate) fn delta(terms: usize) -> Self {
        let terms = (0..terms.max(1)).map(|k| if k == 0 { T::one() } else { T::zero() });
        Series { start: 1, terms: terms.collect() }
    }

    /// Returns the lowest power with a nonzero coefficient, or `None` if none is known.
    pub(crate) fn order(&self) -> Option<i64> {
        match self {
            Number(number) => (!number.is_zero()).then_some(0),
            Series { start, terms } => (!terms.is_empty()).then_some(*start),
        }
    }

    /// Returns the power of δ below which every coefficient is 0.
    pub(crate) fn start(&self) -> i64 {
        match self {
            Number(_) => 0,
            Series { start, .. } => *start,
        }
    }

    /// Returns the lowest power with an unknown coefficient, or `None` for an exact number.
    fn end(&self) -> Option<i64> {
        match self {
            Number(_) => None,
            Series { start, terms } => Some(start + terms.len() as i64),
        }
    }

    /// Returns the coefficient of a power of δ, or `None` if unknown.
    pub(crate) fn coefficient(&self, power: i64) -> Option<T> {
        match self {
            Number(number) => Some(if power == 0 { number.clone() } else { T::zero() }),
            Series { start, terms } if power >= *start => terms.get((power - start) as usize).cloned(),
            Series { .. } => Some(T::zero()),
        }
    }

    /// Creates a series from the power and the coefficients of its first terms.
    fn of(start: i64, mut terms: Vec<T>) -> Self {
        let zeros = terms.iter().take_while(|term| term.is_zero()).count();
        terms.drain(..zeros);
        Series { start: start + zeros as i64, terms }
    }

    fn written_out(number: T, terms: usize) -> Vec<T> {
        let mut number = Some(number);
        (0..terms).map(|_| number.take().unwrap_or_else(T::zero)).collect()
    }

    fn map(self, change: impl Fn(T) -> T) -> Self {
        match self {
            Number(number) => Number(change(number)),
            Series { start, terms } => Series { start, terms: terms.into_iter().map(change).collect() },
        }
    }
}

impl<T: Scalar> Neg for Laurent<T> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|term| -term)
    }
}

fn sum<T: Scalar>(a: Laurent<T>, b: Laurent<T>) -> Laurent<T> {
    if let (Number(a), Number(b)) = (&a, &b) {
        return Number(a.clone() + b.clone());
    }
    let end = a.end().into_iter().chain(b.end()).min().unwrap_or(0);
    let start = a.start().min(b.start()).min(end);
    let coefficient = |one: &Laurent<T>, power| one.coefficient(power).unwrap_or_else(T::zero);
    Laurent::of(start, (start..end).map(|k| coefficient(&a, k) + coefficient(&b, k)).collect())
}

/// Returns the product, which has as many terms as the shorter factor.
fn product<T: Scalar>(a: Laurent<T>, b: Laurent<T>) -> Laurent<T> {
    match (a, b) {
        (Number(number), _) | (_, Number(number)) if number.is_zero() => Number(number),
        (Number(number), series) | (series, Number(number)) => series.map(|term| term * number.clone()),
        (Series { start, terms: a }, Series { start: other_start, terms: b }) => {
            let term = |k: usize| (0..=k).fold(T::zero(), |sum, j| sum + a[j].clone() * b[k - j].clone());
            let terms = (0..a.len().min(b.len())).map(term).collect();
            Series { start: start + other_start, terms }
        }
    }
}

/// Returns the quotient, which has as many terms as the shorter operand. The divisor must have a
/// term.
fn quotient<T: Scalar>(a: Laurent<T>, b: Laurent<T>) -> Laurent<T> {
    match (a, b) {
        (series, Number(divisor)) => series.map(|term| term / divisor.clone()),
        (Number(number), _) if number.is_zero() => Number(number),
        (dividend, Series { start: below, terms: divisor }) => {
            let (start, dividend) = match dividend {
                Number(number) => (0, Laurent::written_out(number, divisor.len())),
                Series { start, terms } => (start, terms),
            };
            let mut terms: Vec<T> = Vec::new();
            for k in 0..dividend.len().min(divisor.len()) {
                let known = terms.iter().enumerate();
                let rest = known.fold(dividend[k].clone(), |rest, (j, term)| {
                    rest - term.clone() * divisor[k - j].clone()
                });
                terms.push(rest / divisor[0].clone());
            }
            Series { start: start - below, terms }
        }
    }
}

operators!([T: Scalar] Laurent<T>: sum, |a: Self, b: Self| sum(a, -b), product, quotient);

impl<T: Scalar> Zero for Laurent<T> {
    fn zero() -> Self {
        Number(T::zero())
    }

    fn is_zero(&self) -> bool {
        matches!(self, Number(number) if number.is_zero())
    }
}

impl<T: Scalar> One for Laurent<T> {
    fn one() -> Self {
        Number(T::one())
    }
}

impl<T: Scalar> Scalar for Laurent<T> {
    fn constant(c: &Constant<'_>) -> Self {
        Number(T::constant(c))
    }

    fn reciprocal(&self) -> Option<Self> {
        Self::one().quotient(self.clone())
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        divisor.order()?;
        Some(self / divisor)
    }

    /// Prefers the series of lower order, because a division by it loses fewer terms.
    fn is_better_pivot(&self, than: &Self) -> bool {
        match (self.order(), than.order()) {
            (Some(own), Some(other)) => own < other,
            (own, None) => own.is_some(),
            (None, Some(_)) => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use std::vec;

    use super::*;

    fn series(start: i64, terms: &[i64]) -> Laurent<BigRational> {
        Laurent::of(start, terms.iter().map(|term| BigRational::from_integer((*term).into())).collect())
    }

    #[test]
    fn products_and_quotients_know_as_many_terms_as_their_factors() {
        let (a, b) = (series(-2, &[1, 2, 3]), series(1, &[5, 0, 1, 7]));
        assert_eq!(a.clone() * b.clone(), series(-1, &[5, 10, 16]));
        assert_eq!(a.clone() * b.clone() / b.clone(), a);
        assert_eq!(
            series(0, &[1, 0, 0, 0]).quotient(b.clone()).map(|inverse| inverse * b),
            Some(series(0, &[1, 0, 0, 0]))
        );
    }

    #[test]
    fn sums_are_known_as_far_as_both_terms_and_lose_what_cancels() {
        let (a, b) = (series(-2, &[1, 2, 3]), series(-2, &[1, 2, 4, 5]));
        assert_eq!(b - a.clone(), series(0, &[1]));
        let number = Laurent::Number(BigRational::from_integer(4.into()));
        assert_eq!(a.clone() + number.clone(), series(-2, &[1, 2, 7]));
        // Adding a term at δ⁰ does not change this series, which is unknown from δ⁻¹ on.
        assert_eq!(series(-3, &[1, 2]) + number.clone(), series(-3, &[1, 2]));
        let nothing = a.clone() - a;
        assert_eq!(nothing, Series { start: 1, terms: vec![] });
        assert!(!nothing.is_zero() && nothing.reciprocal().is_none());
        assert_eq!(nothing.clone() * number, nothing);
    }

    #[test]
    fn the_lowest_order_is_the_best_pivot() {
        let (low, high, nothing) = (series(-1, &[1]), series(2, &[7, 1]), series(5, &[]));
        assert!(low.is_better_pivot(&high) && !high.is_better_pivot(&low));
        assert!(high.is_better_pivot(&nothing) && !nothing.is_better_pivot(&low));
    }
}
