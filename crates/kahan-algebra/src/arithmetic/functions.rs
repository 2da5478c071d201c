//! Rational functions over ℚ with expanded numerators and factored denominators.
//!
//! A function is zero exactly if its numerator has no terms. No gcd of polynomials is computed. All
//! operations together have one [`Budget`], and an operation beyond it returns `None`.

use std::cell::RefCell;

use kahan_syntax::rational::Rational;

use crate::poly::{Budget, Polynomial};

use super::Arithmetic;

/// The rational function numerator / ∏ factor^exponent.
#[derive(Clone, Debug)]
pub struct Function {
    /// The expanded numerator.
    pub numerator: Polynomial,
    /// The factors and their exponents. Factors are distinct non-constant primitive polynomials.
    pub denominator: Vec<(Polynomial, u32)>,
}

impl From<Polynomial> for Function {
    fn from(numerator: Polynomial) -> Self {
        Function { numerator, denominator: Vec::new() }
    }
}

/// The field of rational functions. All operations are charged to one budget of work.
#[derive(Debug)]
pub struct Functions {
    budget: RefCell<Budget>,
}

impl Functions {
    /// Creates the field with this budget for all its operations.
    #[must_use]
    pub fn new(budget: Budget) -> Self {
        Functions { budget: RefCell::new(budget) }
    }

    fn product(&self, a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
        a.mul_within(b, &mut self.budget.borrow_mut()).ok()
    }

    fn power(&self, a: &Polynomial, exponent: u32) -> Option<Polynomial> {
        a.pow_within(exponent, &mut self.budget.borrow_mut()).ok()
    }

    /// Expands a fraction from the denominator `have` to its multiple `target`, and returns the new
    /// numerator.
    fn expand_to(
        &self,
        numerator: &Polynomial,
        have: &[(Polynomial, u32)],
        target: &[(Polynomial, u32)],
    ) -> Option<Polynomial> {
        let mut expanded = numerator.clone();
        for (factor, exponent) in target {
            let missing = exponent - exponent_of(have, factor);
            if missing > 0 {
                expanded = self.product(&expanded, &self.power(factor, missing)?)?;
            }
        }
        Some(expanded)
    }

    fn sum(&self, a: &Function, b: &Function, sign: i64) -> Option<Function> {
        let mut denominator = a.denominator.clone();
        for (factor, exponent) in &b.denominator {
            let known = exponent_in(&mut denominator, factor);
            *known = (*known).max(*exponent);
        }
        let a = self.expand_to(&a.numerator, &a.denominator, &denominator)?;
        let b = self.expand_to(&b.numerator, &b.denominator, &denominator)?.scale(&Rational::from(sign));
        let numerator = a.add_within(&b, &mut self.budget.borrow_mut()).ok()?;
        Some(Function { numerator, denominator })
    }

    fn times(&self, a: &Function, b: &Function) -> Option<Function> {
        let (mut above, mut other, mut denominator) = (a.numerator.clone(), b.numerator.clone(), Vec::new());
        self.cancel(&mut above, &b.denominator, &mut denominator)?;
        self.cancel(&mut other, &a.denominator, &mut denominator)?;
        Some(Function { numerator: self.product(&above, &other)?, denominator })
    }

    /// Cancels factors of `below` in `numerator`, and appends the other factors to `denominator`. A
    /// factor is tried only if it has exactly as many terms as `numerator`. Therefore common
    /// factors may remain.
    fn cancel(
        &self,
        numerator: &mut Polynomial,
        below: &[(Polynomial, u32)],
        denominator: &mut Vec<(Polynomial, u32)>,
    ) -> Option<()> {
        for (factor, exponent) in below {
            let mut exponent = *exponent;
            while exponent > 0 && numerator.len() == factor.len() {
                let quotient = numerator.div_within(factor, &mut self.budget.borrow_mut()).ok()?;
                let Some(quotient) = quotient else { break };
                *numerator = quotient;
                exponent -= 1;
            }
            if exponent > 0 {
                *exponent_in(denominator, factor) += exponent;
            }
        }
        Some(())
    }

    fn inverted(&self, numerator: &Polynomial, denominator: &[(Polynomial, u32)]) -> Option<Function> {
        let above = self.expand_to(&Polynomial::one(), &[], denominator)?;
        let primitive = numerator.primitive_part();
        let above = above.scale(&numerator.content().recip()?);
        let denominator = if primitive.as_constant().is_some() { Vec::new() } else { vec![(primitive, 1)] };
        Some(Function { numerator: above, denominator })
    }
}

fn exponent_in<'a>(denominator: &'a mut Vec<(Polynomial, u32)>, factor: &Polynomial) -> &'a mut u32 {
    let place = denominator.iter().position(|(known, _)| known == factor).unwrap_or_else(|| {
        denominator.push((factor.clone(), 0));
        denominator.len() - 1
    });
    &mut denominator[place].1
}

fn exponent_of(denominator: &[(Polynomial, u32)], factor: &Polynomial) -> u32 {
    denominator.iter().find(|(known, _)| known == factor).map_or(0, |(_, exponent)| *exponent)
}

impl Arithmetic for Functions {
    type Value = Option<Function>;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Option<Function>> {
        Some(Some(Polynomial::constant(value.clone()).into()))
    }

    fn add(&self, a: &Option<Function>, b: &Option<Function>) -> Option<Function> {
        self.sum(a.as_ref()?, b.as_ref()?, 1)
    }

    fn subtract(&self, a: &Option<Function>, b: &Option<Function>) -> Option<Function> {
        self.sum(a.as_ref()?, b.as_ref()?, -1)
    }

    fn multiply(&self, a: &Option<Function>, b: &Option<Function>) -> Option<Function> {
        self.times(a.as_ref()?, b.as_ref()?)
    }

    fn negate(&self, a: &Option<Function>) -> Option<Function> {
        self.times(a.as_ref()?, &Polynomial::constant(Rational::from(-1)).into())
    }

    fn divide(&self, a: &Option<Function>, b: &Option<Function>) -> Option<Option<Function>> {
        if self.is_zero(b) {
            return None;
        }
        let without = |own: &[(Polynomial, u32)], other: &[(Polynomial, u32)]| -> Vec<(Polynomial, u32)> {
            let left = own
                .iter()
                .map(|(factor, exponent)| (factor, exponent.saturating_sub(exponent_of(other, factor))));
            left.filter(|(_, exponent)| *exponent > 0).map(|(factor, e)| (factor.clone(), e)).collect()
        };
        let quotient = |a: &Function, b: &Function| {
            let denominator = without(&a.denominator, &b.denominator);
            let inverse = self.inverted(&b.numerator, &without(&b.denominator, &a.denominator))?;
            self.times(&Function { numerator: a.numerator.clone(), denominator }, &inverse)
        };
        Some(a.as_ref().zip(b.as_ref()).and_then(|(a, b)| quotient(a, b)))
    }

    fn is_zero(&self, a: &Option<Function>) -> bool {
        a.as_ref().is_some_and(|a| a.numerator.is_zero())
    }
}
