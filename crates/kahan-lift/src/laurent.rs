//! Laurent polynomials in numbered coordinates, with coefficients in ℚ(parameters).

use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

/// A power product of coordinates with exponents of either sign, as a list of exponents by
/// coordinate that does not end in 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Monomial(Vec<i16>);

impl Monomial {
    /// The empty product.
    pub(crate) fn one() -> Self {
        Self::default()
    }

    /// A power of one coordinate.
    pub(crate) fn power(coordinate: usize, exponent: i16) -> Self {
        let mut exponents = vec![0; coordinate + 1];
        exponents[coordinate] = exponent;
        Self::from_exponents(exponents)
    }

    /// The monomial with these exponents, by coordinate.
    pub(crate) fn from_exponents(mut exponents: Vec<i16>) -> Self {
        while exponents.last() == Some(&0) {
            exponents.pop();
        }
        Monomial(exponents)
    }

    /// Whether this is the empty product.
    pub(crate) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    /// The exponent of a coordinate.
    pub(crate) fn exponent(&self, coordinate: usize) -> i16 {
        self.0.get(coordinate).copied().unwrap_or(0)
    }

    /// The coordinates that occur, with their exponents.
    pub(crate) fn powers(&self) -> impl Iterator<Item = (usize, i16)> + '_ {
        self.0.iter().copied().enumerate().filter(|&(_, exponent)| exponent != 0)
    }

    /// The sum of the sizes of the exponents.
    pub(crate) fn size(&self) -> u32 {
        self.0.iter().map(|exponent| u32::from(exponent.unsigned_abs())).sum()
    }

    fn zip(&self, other: &Self, combine: impl Fn(i16, i16) -> i16) -> Self {
        let length = self.0.len().max(other.0.len());
        Self::from_exponents((0..length).map(|i| combine(self.exponent(i), other.exponent(i))).collect())
    }

    /// The product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        self.zip(other, i16::saturating_add)
    }

    /// The quotient.
    pub(crate) fn over(&self, other: &Self) -> Self {
        self.zip(other, i16::saturating_sub)
    }

    /// The power with an integer exponent.
    pub(crate) fn pow(&self, exponent: i16) -> Self {
        Monomial::from_exponents(self.0.iter().map(|own| own.saturating_mul(exponent)).collect())
    }

    /// The monomial whose square this is.
    pub(crate) fn square_root(&self) -> Option<Self> {
        let is_square = self.0.iter().all(|exponent| exponent % 2 == 0);
        is_square.then(|| Monomial(self.0.iter().map(|exponent| exponent / 2).collect()))
    }

    /// Whether this is a product of the first coordinates, the states.
    pub(crate) fn is_in(&self, states: usize) -> bool {
        self.powers().all(|(coordinate, exponent)| coordinate < states && exponent > 0)
    }

    /// Whether each exponent is as far from 0 as that of `divisor`, on the same side.
    pub(crate) fn is_multiple_of(&self, divisor: &Self) -> bool {
        divisor.powers().all(|(coordinate, exponent)| match self.exponent(coordinate) {
            own if exponent < 0 => own <= exponent,
            own => own >= exponent,
        })
    }
}

/// A Laurent polynomial: its monomials with coefficients other than 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Laurent(BTreeMap<Monomial, RationalFunction>);

impl Laurent {
    /// The polynomial 0.
    pub(crate) fn zero() -> Self {
        Self::default()
    }

    /// One term.
    pub(crate) fn term(monomial: Monomial, coefficient: RationalFunction) -> Self {
        let mut polynomial = Self::zero();
        polynomial.add_term(monomial, &coefficient);
        polynomial
    }

    /// A constant.
    pub(crate) fn constant(value: RationalFunction) -> Self {
        Self::term(Monomial::one(), value)
    }

    /// A rational number.
    pub(crate) fn number(value: Rational) -> Self {
        Self::constant(RationalFunction::constant(value))
    }

    /// A coordinate.
    pub(crate) fn coordinate(index: usize) -> Self {
        Self::from(Monomial::power(index, 1))
    }

    /// The terms, the monomials ascending.
    pub(crate) fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &RationalFunction)> {
        self.0.iter()
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether this is 0.
    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a monomial occurs.
    pub(crate) fn contains(&self, monomial: &Monomial) -> bool {
        self.0.contains_key(monomial)
    }

    /// The coefficient of a monomial.
    pub(crate) fn coefficient(&self, monomial: &Monomial) -> RationalFunction {
        self.0.get(monomial).cloned().unwrap_or_else(RationalFunction::zero)
    }

    /// The value, where it depends on no coordinate.
    pub(crate) fn as_constant(&self) -> Option<RationalFunction> {
        self.terms().all(|(monomial, _)| monomial.is_one()).then(|| self.coefficient(&Monomial::one()))
    }

    /// The number, where this is one.
    pub(crate) fn as_number(&self) -> Option<Rational> {
        self.as_constant()?.as_polynomial()?.as_constant()
    }

    /// The monomial, where this is one with coefficient 1.
    pub(crate) fn as_monomial(&self) -> Option<&Monomial> {
        let (monomial, coefficient) = self.0.first_key_value().filter(|_| self.len() == 1)?;
        (*coefficient == RationalFunction::one()).then_some(monomial)
    }

    /// The greatest monomial by size, then by exponents, and its coefficient.
    pub(crate) fn leading_term(&self) -> Option<(&Monomial, &RationalFunction)> {
        self.terms().max_by_key(|&(monomial, _)| (monomial.size(), monomial))
    }

    /// Adds a term.
    pub(crate) fn add_term(&mut self, monomial: Monomial, coefficient: &RationalFunction) {
        let sum = &self.coefficient(&monomial) + coefficient;
        if sum.is_zero() {
            self.0.remove(&monomial);
        } else {
            self.0.insert(monomial, sum);
        }
    }

    /// Adds a multiple of another polynomial.
    pub(crate) fn add_scaled(&mut self, other: &Self, factor: &RationalFunction) {
        for (monomial, coefficient) in other.terms() {
            self.add_term(monomial.clone(), &(coefficient * factor));
        }
    }

    /// The multiple by a coefficient.
    pub(crate) fn scale(&self, factor: &RationalFunction) -> Self {
        let mut scaled = Self::zero();
        scaled.add_scaled(self, factor);
        scaled
    }

    /// The product with a monomial.
    pub(crate) fn shifted(&self, by: &Monomial) -> Self {
        Laurent(self.0.iter().map(|(monomial, value)| (monomial.times(by), value.clone())).collect())
    }

    /// The terms with these monomials.
    pub(crate) fn filtered(&self, keep: impl Fn(&Monomial) -> bool) -> Self {
        let kept = self.0.iter().filter(|(monomial, _)| keep(monomial));
        Laurent(kept.map(|(monomial, value)| (monomial.clone(), value.clone())).collect())
    }

    /// The partial derivative by a coordinate that occurs in no other coordinate.
    pub(crate) fn partial(&self, coordinate: usize) -> Self {
        let one = Monomial::power(coordinate, 1);
        let mut derivative = Self::zero();
        for (monomial, value) in self.terms() {
            let exponent = Rational::from(i64::from(monomial.exponent(coordinate)));
            derivative.add_term(monomial.over(&one), &(value * &RationalFunction::constant(exponent)));
        }
        derivative
    }

    /// The greatest monomial that divides every term.
    pub(crate) fn monomial_content(&self) -> Monomial {
        let least = |content: Monomial, next: &Monomial| content.zip(next, i16::min);
        let first = self.0.keys().next().cloned().unwrap_or_default();
        self.0.keys().skip(1).fold(first, least)
    }

    /// The number ρ and the polynomial p with this = ρ·p, where the integer contents of p have no
    /// common divisor and its first coefficient has a positive leading number.
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
