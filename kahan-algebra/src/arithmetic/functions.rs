//! Rational functions over ℚ with factored denominators: numerators in normal form (expanded), so
//! that a value is zero exactly when its numerator has no terms. No gcd is taken; common
//! denominators and quotients share their factors.
//!
//! Work is bounded: once the budget is spent every further value is [`Function::TooLarge`], and
//! nothing can be said.

use std::cell::RefCell;

use crate::poly::{Budget, Polynomial};
use crate::rational::Rational;

use super::Arithmetic;

/// A rational function, or the statement that it was too large to expand.
#[derive(Clone, Debug)]
pub enum Function {
    /// numerator / ∏ factorᵏ
    Known {
        /// Expanded.
        numerator: Polynomial,
        /// Distinct non-constant primitive polynomials with their exponents.
        denominator: Vec<(Polynomial, u32)>,
    },
    /// The budget did not suffice.
    TooLarge,
}

impl Function {
    /// A polynomial.
    #[must_use]
    pub fn polynomial(numerator: Polynomial) -> Self {
        Function::Known { numerator, denominator: Vec::new() }
    }
}

/// The field of rational functions, with a budget of work.
#[derive(Debug)]
pub struct Functions {
    budget: RefCell<Budget>,
}

impl Functions {
    /// The field, with this budget for everything that is computed in it.
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

    /// numerator · ∏ factorᵏ over the factors by which `target` exceeds `have`.
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

    fn try_add(&self, a: &Function, b: &Function, sign: i64) -> Option<Function> {
        let (
            Function::Known { numerator: a, denominator: below_a },
            Function::Known { numerator: b, denominator: below_b },
        ) = (a, b)
        else {
            return None;
        };
        let mut denominator = below_a.clone();
        for (factor, exponent) in below_b {
            match denominator.iter_mut().find(|(known, _)| known == factor) {
                Some((_, known)) => *known = (*known).max(*exponent),
                None => denominator.push((factor.clone(), *exponent)),
            }
        }
        let a = self.expand_to(a, below_a, &denominator)?;
        let b = self.expand_to(b, below_b, &denominator)?.scale(&Rational::from(sign));
        let numerator = a.add_within(&b, &mut self.budget.borrow_mut()).ok()?;
        Some(Function::Known { numerator, denominator })
    }

    fn try_multiply(&self, a: &Function, b: &Function) -> Option<Function> {
        let (
            Function::Known { numerator: a, denominator: below_a },
            Function::Known { numerator: b, denominator: below_b },
        ) = (a, b)
        else {
            return None;
        };
        let (mut a, mut b) = (a.clone(), b.clone());
        let mut denominator = Vec::new();
        self.cancel(&mut a, below_b, &mut denominator)?;
        self.cancel(&mut b, below_a, &mut denominator)?;
        Some(Function::Known { numerator: self.product(&a, &b)?, denominator })
    }

    /// Moves the factors of `below` into `denominator`, except where one equals `numerator`, which
    /// it then cancels.
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
                match denominator.iter_mut().find(|(known, _)| known == factor) {
                    Some((_, known)) => *known += exponent,
                    None => denominator.push((factor.clone(), exponent)),
                }
            }
        }
        Some(())
    }

    /// 1/b as numerator ∏ factorᵏ over the numerator of b; `None` over budget. b is not zero.
    fn try_invert(&self, b: &Function) -> Option<Function> {
        let Function::Known { numerator, denominator } = b else { return None };
        let mut above = Polynomial::one();
        for (factor, exponent) in denominator {
            above = self.product(&above, &self.power(factor, *exponent)?)?;
        }
        let primitive = numerator.primitive_part();
        let above = above.scale(&numerator.content().recip()?);
        let denominator = if primitive.as_constant().is_some() { Vec::new() } else { vec![(primitive, 1)] };
        Some(Function::Known { numerator: above, denominator })
    }
}

fn exponent_of(denominator: &[(Polynomial, u32)], factor: &Polynomial) -> u32 {
    denominator.iter().find(|(known, _)| known == factor).map_or(0, |(_, exponent)| *exponent)
}

impl Arithmetic for Functions {
    type Value = Function;

    fn constant(&self, value: &Rational) -> Option<Function> {
        Some(Function::polynomial(Polynomial::constant(value.clone())))
    }

    fn add(&self, a: &Function, b: &Function) -> Function {
        self.try_add(a, b, 1).unwrap_or(Function::TooLarge)
    }

    fn subtract(&self, a: &Function, b: &Function) -> Function {
        self.try_add(a, b, -1).unwrap_or(Function::TooLarge)
    }

    fn multiply(&self, a: &Function, b: &Function) -> Function {
        self.try_multiply(a, b).unwrap_or(Function::TooLarge)
    }

    fn negate(&self, a: &Function) -> Function {
        self.multiply(a, &Function::polynomial(Polynomial::constant(Rational::from(-1))))
    }

    fn divide(&self, a: &Function, b: &Function) -> Option<Function> {
        if self.is_zero(b) {
            return None;
        }
        let (
            Function::Known { numerator, denominator: below_a },
            Function::Known { numerator: divisor, denominator: below_b },
        ) = (a, b)
        else {
            return Some(Function::TooLarge);
        };
        // (a/A) / (b/B) with the factors that A and B share left out: they cancel.
        let without = |own: &[(Polynomial, u32)], other: &[(Polynomial, u32)]| -> Vec<(Polynomial, u32)> {
            own.iter()
                .map(|(factor, exponent)| {
                    (factor.clone(), exponent.saturating_sub(exponent_of(other, factor)))
                })
                .filter(|(_, exponent)| *exponent > 0)
                .collect()
        };
        let dividend =
            Function::Known { numerator: numerator.clone(), denominator: without(below_a, below_b) };
        let divisor = Function::Known { numerator: divisor.clone(), denominator: without(below_b, below_a) };
        let inverse = self.try_invert(&divisor).unwrap_or(Function::TooLarge);
        Some(self.multiply(&dividend, &inverse))
    }

    fn is_zero(&self, a: &Function) -> bool {
        matches!(a, Function::Known { numerator, .. } if numerator.is_zero())
    }
}
