//! Laurent polynomials in numbered coordinates, with coefficients in ℚ(parameters).

use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

/// A product of powers of coordinates with integer exponents. Trailing zeros are removed.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Monomial(Vec<i16>);

impl Monomial {
    pub(crate) fn one() -> Self {
        Self::default()
    }

    pub(crate) fn power(coordinate: usize, exponent: i16) -> Self {
        let mut exponents = vec![0; coordinate + 1];
        exponents[coordinate] = exponent;
        Self::from_exponents(exponents)
    }

    pub(crate) fn from_exponents(mut exponents: Vec<i16>) -> Self {
        while exponents.last() == Some(&0) {
            exponents.pop();
        }
        Monomial(exponents)
    }

    pub(crate) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn exponent(&self, coordinate: usize) -> i16 {
        self.0.get(coordinate).copied().unwrap_or(0)
    }

    pub(crate) fn powers(&self) -> impl Iterator<Item = (usize, i16)> + '_ {
        self.0.iter().copied().enumerate().filter(|&(_, exponent)| exponent != 0)
    }

    /// Returns the sum of the absolute values of the exponents.
    pub(crate) fn size(&self) -> u32 {
        self.0.iter().map(|exponent| u32::from(exponent.unsigned_abs())).sum()
    }

    fn zip(&self, other: &Self, combine: impl Fn(i16, i16) -> i16) -> Self {
        let length = self.0.len().max(other.0.len());
        Self::from_exponents((0..length).map(|i| combine(self.exponent(i), other.exponent(i))).collect())
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        self.zip(other, i16::saturating_add)
    }

    pub(crate) fn over(&self, other: &Self) -> Self {
        self.zip(other, i16::saturating_sub)
    }

    pub(crate) fn pow(&self, exponent: i16) -> Self {
        Monomial::from_exponents(self.0.iter().map(|own| own.saturating_mul(exponent)).collect())
    }

    pub(crate) fn square_root(&self) -> Option<Self> {
        let is_square = self.0.iter().all(|exponent| exponent % 2 == 0);
        is_square.then(|| Monomial(self.0.iter().map(|exponent| exponent / 2).collect()))
    }

    /// Returns whether the monomial is a product of states. The states are the first coordinates.
    pub(crate) fn is_in(&self, states: usize) -> bool {
        self.powers().all(|(coordinate, exponent)| coordinate < states && exponent > 0)
    }

    /// Returns whether each exponent of `divisor` lies between 0 and the exponent of this monomial.
    pub(crate) fn is_multiple_of(&self, divisor: &Self) -> bool {
        divisor.powers().all(|(coordinate, exponent)| match self.exponent(coordinate) {
            own if exponent < 0 => own <= exponent,
            own => own >= exponent,
        })
    }
}

#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Laurent(BTreeMap<Monomial, RationalFunction>);

impl Laurent {
    pub(crate) fn zero() -> Self {
        Self::default()
    }

    pub(crate) fn term(monomial: Monomial, coefficient: RationalFunction) -> Self {
        let mut polynomial = Self::zero();
        polynomial.add_term(monomial, &coefficient);
        polynomial
    }

    pub(crate) fn constant(value: RationalFunction) -> Self {
        Self::term(Monomial::one(), value)
    }

    pub(crate) fn number(value: Rational) -> Self {
        Self::constant(RationalFunction::constant(value))
    }

    pub(crate) fn coordinate(index: usize) -> Self {
        Self::from(Monomial::power(index, 1))
    }

    pub(crate) fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &RationalFunction)> {
        self.0.iter()
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn contains(&self, monomial: &Monomial) -> bool {
        self.0.contains_key(monomial)
    }

    pub(crate) fn coefficient(&self, monomial: &Monomial) -> RationalFunction {
        self.0.get(monomial).cloned().unwrap_or_else(RationalFunction::zero)
    }

    pub(crate) fn as_constant(&self) -> Option<RationalFunction> {
        self.terms().all(|(monomial, _)| monomial.is_one()).then(|| self.coefficient(&Monomial::one()))
    }

    pub(crate) fn as_number(&self) -> Option<Rational> {
        self.as_constant()?.as_polynomial()?.as_constant()
    }

    /// Returns the monomial of a polynomial with one term and coefficient 1.
    pub(crate) fn as_monomial(&self) -> Option<&Monomial> {
        let (monomial, coefficient) = self.0.first_key_value().filter(|_| self.len() == 1)?;
        (*coefficient == RationalFunction::one()).then_some(monomial)
    }

    /// Returns the term whose monomial has the largest size; among equal sizes, the last in order.
    pub(crate) fn leading_term(&self) -> Option<(&Monomial, &RationalFunction)> {
        self.terms().max_by_key(|&(monomial, _)| (monomial.size(), monomial))
    }

    pub(crate) fn add_term(&mut self, monomial: Monomial, coefficient: &RationalFunction) {
        let sum = &self.coefficient(&monomial) + coefficient;
        if sum.is_zero() {
            self.0.remove(&monomial);
        } else {
            self.0.insert(monomial, sum);
        }
    }

    pub(crate) fn add_scaled(&mut self, other: &Self, factor: &RationalFunction) {
        for (monomial, coefficient) in other.terms() {
            self.add_term(monomial.clone(), &(coefficient * factor));
        }
    }

    pub(crate) fn scale(&self, factor: &RationalFunction) -> Self {
        let mut scaled = Self::zero();
        scaled.add_scaled(self, factor);
        scaled
    }

    pub(crate) fn shifted(&self, by: &Monomial) -> Self {
        Laurent(self.0.iter().map(|(monomial, value)| (monomial.times(by), value.clone())).collect())
    }

    pub(crate) fn filtered(&self, keep: impl Fn(&Monomial) -> bool) -> Self {
        let kept = self.0.iter().filter(|(monomial, _)| keep(monomial));
        Laurent(kept.map(|(monomial, value)| (monomial.clone(), value.clone())).collect())
    }

    /// Returns the partial derivative with respect to a coordinate, on which no other may depend.
    pub(crate) fn partial(&self, coordinate: usize) -> Self {
        let one = Monomial::power(coordinate, 1);
        let mut derivative = Self::zero();
        for (monomial, value) in self.terms() {
            let exponent = Rational::from(i64::from(monomial.exponent(coordinate)));
            derivative.add_term(monomial.over(&one), &(value * &RationalFunction::constant(exponent)));
        }
        derivative
    }

    /// Returns the greatest monomial that divides all terms.
    pub(crate) fn monomial_content(&self) -> Monomial {
        let least = |content: Monomial, next: &Monomial| content.zip(next, i16::min);
        let first = self.0.keys().next().cloned().unwrap_or_default();
        self.0.keys().skip(1).fold(first, least)
    }

    /// Returns a rational ρ and a polynomial p with `self` = ρ·p. The numerators in p have integer
    /// coefficients without a common factor, and the first leading coefficient is positive.
    pub(crate) fn primitive(&self) -> (Rational, Self) {
        let contents = self.0.values().map(|value| value.numerator().content().abs());
        let content = contents.reduce(|a, b| a.gcd(&b)).unwrap_or_else(Rational::one);
        let first = self.0.values().next().and_then(|value| value.numerator().leading_term());
        let negative = first.is_some_and(|(_, number)| number.is_negative());
        let factor = if negative { -&content } else { content };
        let inverse = factor.recip().expect("contents of nonzero numbers");
        (factor, self.scale(&RationalFunction::constant(inverse)))
    }
}

impl From<Monomial> for Laurent {
    fn from(monomial: Monomial) -> Self {
        Self::term(monomial, RationalFunction::one())
    }
}
