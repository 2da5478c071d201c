//! Rational functions over ℚ in normal form.
//!
//! Numerator and denominator are coprime, and the denominator is primitive with positive leading
//! coefficient. Equal functions are therefore equal as data. Henrici's algorithm keeps gcds small,
//! because operands are in lowest terms. Sums, products, quotients and derivatives exist with and
//! without a [`Budget`].

mod common;
#[cfg(test)]
mod tests;

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use kahan_syntax::rational::Rational;

pub(crate) use common::{Row, reduced, with_leading_one};

use crate::poly::{Budget, Polynomial, Variable, WithinBudget, gcd_within};

/// A quotient of two polynomials in lowest terms.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// Returns the function 0.
    pub fn zero() -> Self {
        Self::from(Polynomial::zero())
    }

    /// Returns the function 1.
    pub fn one() -> Self {
        Self::from(Polynomial::one())
    }

    /// Returns a constant function.
    pub fn constant(value: Rational) -> Self {
        Self::from(Polynomial::constant(value))
    }

    /// Returns the function of a single variable.
    pub fn variable(variable: Variable) -> Self {
        Self::from(Polynomial::variable(variable))
    }

    /// Returns the quotient in lowest terms. Returns `None` if the denominator is zero.
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Option<Self> {
        unlimited(|budget| Self::new_within(numerator, denominator, budget))
    }

    /// Computes [`new`](Self::new) within a budget.
    pub fn new_within(
        numerator: Polynomial,
        denominator: Polynomial,
        budget: &mut Budget,
    ) -> WithinBudget<Option<Self>> {
        if denominator.is_zero() {
            return Ok(None);
        }
        let (numerator, denominator) = cancel(&numerator, &denominator, budget)?;
        Ok(Some(Self::from_coprime(numerator, denominator)))
    }

    /// Returns the numerator, which includes the rational factor and the sign of the function.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// Returns the denominator, which is primitive with positive leading coefficient. Polynomials
    /// have the denominator 1.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Returns whether the function is 0.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns the function as a polynomial if possible.
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_one().then_some(&self.numerator)
    }

    /// Returns whether the function depends on `variable`.
    pub fn contains(&self, variable: Variable) -> bool {
        self.numerator.contains(variable) || self.denominator.contains(variable)
    }

    /// Applies `change` to numerator and denominator. Returns `None` if the new denominator is
    /// zero.
    pub fn map(&self, change: impl Fn(&Polynomial) -> Polynomial) -> Option<Self> {
        Self::new(change(&self.numerator), change(&self.denominator))
    }

    /// Returns the quotient. Returns `None` if `divisor` is zero.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        unlimited(|budget| self.div_within(divisor, budget))
    }

    /// Returns the reciprocal. Returns `None` if the function is 0.
    pub fn recip(&self) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        Some(Self::from_coprime(self.denominator.clone(), self.numerator.clone()))
    }

    /// Returns the partial derivative.
    pub fn derivative(&self, variable: Variable) -> Self {
        unlimited(|budget| self.derivative_within(variable, budget))
    }

    /// Returns the sum, or an error if it exceeds the budget.
    pub fn add_within(&self, other: &Self, budget: &mut Budget) -> WithinBudget<Self> {
        // For g = gcd(b, d), a/b + c/d = (a·d/g + c·b/g) / (b·d/g). Only divisors of g may cancel.
        let common = gcd_within(&self.denominator, &other.denominator, budget)?;
        let own_cofactor = divide(&self.denominator, &common, budget)?;
        let other_cofactor = divide(&other.denominator, &common, budget)?;
        let left = self.numerator.mul_within(&other_cofactor, budget)?;
        let right = other.numerator.mul_within(&own_cofactor, budget)?;
        let sum = left.add_within(&right, budget)?;
        if sum.is_zero() {
            return Ok(Self::zero());
        }
        let (sum, common) = cancel(&sum, &common, budget)?;
        let denominator = own_cofactor.mul_within(&other_cofactor, budget)?.mul_within(&common, budget)?;
        Ok(Self::from_coprime(sum, denominator))
    }

    /// Returns the difference, or an error if it exceeds the budget.
    pub fn sub_within(&self, other: &Self, budget: &mut Budget) -> WithinBudget<Self> {
        self.add_within(&-other, budget)
    }

    /// Returns the product, or an error if it exceeds the budget.
    pub fn mul_within(&self, other: &Self, budget: &mut Budget) -> WithinBudget<Self> {
        // Both fractions are reduced, so only a numerator and the other denominator can cancel.
        let (a, d) = cancel(&self.numerator, &other.denominator, budget)?;
        let (c, b) = cancel(&other.numerator, &self.denominator, budget)?;
        Ok(Self::from_coprime(a.mul_within(&c, budget)?, b.mul_within(&d, budget)?))
    }

    /// Returns the quotient, or an error if it exceeds the budget. The quotient by 0 is `None`.
    pub fn div_within(&self, divisor: &Self, budget: &mut Budget) -> WithinBudget<Option<Self>> {
        divisor.recip().map(|inverse| self.mul_within(&inverse, budget)).transpose()
    }

    /// Returns the partial derivative, or an error if it exceeds the budget.
    pub fn derivative_within(&self, variable: Variable, budget: &mut Budget) -> WithinBudget<Self> {
        // With g = gcd(d, d′), (n/d)′ = (n′·d/g − n·d′/g) / (d·d/g).
        let slope = self.denominator.derivative(variable);
        let common = gcd_within(&self.denominator, &slope, budget)?;
        let cofactor = divide(&self.denominator, &common, budget)?;
        let slope = divide(&slope, &common, budget)?;
        let rising = self.numerator.derivative(variable).mul_within(&cofactor, budget)?;
        let falling = self.numerator.mul_within(&slope, budget)?;
        let numerator = rising.add_within(&-&falling, budget)?;
        let denominator = self.denominator.mul_within(&cofactor, budget)?;
        let (numerator, denominator) = cancel(&numerator, &denominator, budget)?;
        Ok(Self::from_coprime(numerator, denominator))
    }

    /// Replaces `variable` by `value`. Returns `None` if the new denominator is zero.
    pub fn compose_within(
        &self,
        variable: Variable,
        value: &Self,
        budget: &mut Budget,
    ) -> WithinBudget<Option<Self>> {
        if !self.contains(variable) {
            return Ok(Some(self.clone()));
        }
        let degree = self.numerator.degree_in(variable).max(self.denominator.degree_in(variable));
        let at = (&value.numerator, &value.denominator);
        let above = self.numerator.homogenised_at(variable, at, degree, budget)?;
        let below = self.denominator.homogenised_at(variable, at, degree, budget)?;
        Self::new_within(above, below, budget)
    }

    /// Normalises a quotient of coprime polynomials with nonzero denominator.
    pub(crate) fn from_coprime(numerator: Polynomial, denominator: Polynomial) -> Self {
        if numerator.is_zero() {
            return Self::zero();
        }
        match denominator.content().recip() {
            Some(inverse) if !inverse.is_one() => {
                Self { numerator: numerator.scale(&inverse), denominator: denominator.scale(&inverse) }
            }
            _ => Self { numerator, denominator },
        }
    }
}

fn cancel(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> WithinBudget<(Polynomial, Polynomial)> {
    if a.is_one() || b.is_one() {
        return Ok((a.clone(), b.clone()));
    }
    let common = gcd_within(a, b, budget)?;
    Ok((divide(a, &common, budget)?, divide(b, &common, budget)?))
}

fn divide(multiple: &Polynomial, divisor: &Polynomial, budget: &mut Budget) -> WithinBudget<Polynomial> {
    if divisor.is_one() {
        return Ok(multiple.clone());
    }
    Ok(multiple.div_within(divisor, budget)?.expect("a common divisor divides"))
}

/// Runs a computation with a budget that limits only total degrees.
fn unlimited<T>(compute: impl FnOnce(&mut Budget) -> WithinBudget<T>) -> T {
    compute(&mut Budget::unlimited()).expect("total degrees stay below 2^24")
}

impl From<Polynomial> for RationalFunction {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

macro_rules! without_a_budget {
    ($($operator:ident $method:ident $within:ident),*) => {$(
        impl $operator for &RationalFunction {
            type Output = RationalFunction;

            fn $method(self, other: &RationalFunction) -> RationalFunction {
                unlimited(|budget| self.$within(other, budget))
            }
        }
    )*};
}
without_a_budget!(Add add add_within, Sub sub sub_within, Mul mul mul_within);

impl Neg for &RationalFunction {
    type Output = RationalFunction;

    fn neg(self) -> RationalFunction {
        RationalFunction { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }
}

impl fmt::Debug for RationalFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?})/({:?})", self.numerator, self.denominator)
    }
}
