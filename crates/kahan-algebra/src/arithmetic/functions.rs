//! Rational functions over ℚ with factored denominators: numerators in normal form (expanded), so
//! that a value is zero exactly when its numerator has no terms. No gcd is taken; common
//! denominators and quotients share their factors.
//!
//! Work is bounded: once the budget is spent every further value is [`Function::TooLarge`], and
//! nothing can be said.

use std::cell::RefCell;

use kahan_syntax::rational::Rational;

use crate::poly::{Budget, Polynomial};

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

/// A numerator, and the factors below it.
type Fraction<'a> = (&'a Polynomial, &'a [(Polynomial, u32)]);

impl Function {
    fn fraction(&self) -> Option<Fraction<'_>> {
        match self {
            Function::Known { numerator, denominator } => Some((numerator, denominator)),
            Function::TooLarge => None,
        }
    }

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

    /// What comes of two functions that are known, within the budget.
    fn of_both(
        a: &Function,
        b: &Function,
        result: impl FnOnce(Fraction<'_>, Fraction<'_>) -> Option<Function>,
    ) -> Function {
        let fractions = a.fraction().zip(b.fraction());
        fractions.and_then(|(a, b)| result(a, b)).unwrap_or(Function::TooLarge)
    }

    fn sum(&self, a: &Function, b: &Function, sign: i64) -> Function {
        Self::of_both(a, b, |(a, below_a), (b, below_b)| {
            let mut denominator = below_a.to_vec();
            for (factor, exponent) in below_b {
                let known = exponent_in(&mut denominator, factor);
                *known = (*known).max(*exponent);
            }
            let a = self.expand_to(a, below_a, &denominator)?;
            let b = self.expand_to(b, below_b, &denominator)?.scale(&Rational::from(sign));
            let numerator = a.add_within(&b, &mut self.budget.borrow_mut()).ok()?;
            Some(Function::Known { numerator, denominator })
        })
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
                *exponent_in(denominator, factor) += exponent;
            }
        }
        Some(())
    }

    /// 1/b as numerator ∏ factorᵏ over the numerator of b; `None` over budget. b is not zero.
    fn inverted(&self, numerator: &Polynomial, denominator: &[(Polynomial, u32)]) -> Option<Function> {
        let above = self.expand_to(&Polynomial::one(), &[], denominator)?;
        let primitive = numerator.primitive_part();
        let above = above.scale(&numerator.content().recip()?);
        let denominator = if primitive.as_constant().is_some() { Vec::new() } else { vec![(primitive, 1)] };
        Some(Function::Known { numerator: above, denominator })
    }
}

/// The exponent of a factor, which is made one with the exponent 0 where it is none.
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
    type Value = Function;

    fn constant(&self, value: &Rational) -> Option<Function> {
        Some(Function::polynomial(Polynomial::constant(value.clone())))
    }

    fn add(&self, a: &Function, b: &Function) -> Function {
        self.sum(a, b, 1)
    }

    fn subtract(&self, a: &Function, b: &Function) -> Function {
        self.sum(a, b, -1)
    }

    fn multiply(&self, a: &Function, b: &Function) -> Function {
        Self::of_both(a, b, |(a, below_a), (b, below_b)| {
            let (mut a, mut b) = (a.clone(), b.clone());
            let mut denominator = Vec::new();
            self.cancel(&mut a, below_b, &mut denominator)?;
            self.cancel(&mut b, below_a, &mut denominator)?;
            Some(Function::Known { numerator: self.product(&a, &b)?, denominator })
        })
    }

    fn negate(&self, a: &Function) -> Function {
        self.multiply(a, &Function::polynomial(Polynomial::constant(Rational::from(-1))))
    }

    fn divide(&self, a: &Function, b: &Function) -> Option<Function> {
        if self.is_zero(b) {
            return None;
        }
        // (a/A) / (b/B) with the factors that A and B share left out: they cancel.
        let without = |own: &[(Polynomial, u32)], other: &[(Polynomial, u32)]| -> Vec<(Polynomial, u32)> {
            let left = own
                .iter()
                .map(|(factor, exponent)| (factor, exponent.saturating_sub(exponent_of(other, factor))));
            left.filter(|(_, exponent)| *exponent > 0).map(|(factor, e)| (factor.clone(), e)).collect()
        };
        Some(Self::of_both(a, b, |(numerator, below_a), (divisor, below_b)| {
            let denominator = without(below_a, below_b);
            let inverse = self.inverted(divisor, &without(below_b, below_a))?;
            Some(self.multiply(&Function::Known { numerator: numerator.clone(), denominator }, &inverse))
        }))
    }

    fn is_zero(&self, a: &Function) -> bool {
        matches!(a, Function::Known { numerator, .. } if numerator.is_zero())
    }
}
