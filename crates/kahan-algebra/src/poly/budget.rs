//! Sums, products and powers that fail if they take too much work or become too large.
//!
//! A [`Budget`] limits the number of terms in each result, and the total work. Work counts
//! multiplications weighted by the lengths of coefficients, and most additions of terms. Powers
//! with too many predicted terms are refused before any work. Every `Ok` is exact.

use std::error::Error;
use std::fmt;

use super::Polynomial;

/// The largest total degree within any budget, which prevents overflow of exponents.
const MAX_DEGREE: u64 = 1 << 24;

/// A limit on the size and the work of computations with polynomials.
#[derive(Clone, Debug)]
pub struct Budget {
    max_terms: usize,
    work: u64,
}

/// The error of a computation that exceeds its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OverBudget;

/// The result of a computation within a budget.
pub type WithinBudget<T> = Result<T, OverBudget>;

impl Budget {
    /// Returns a budget of `max_terms` terms in each result and `work` multiplications of terms in
    /// total.
    pub fn new(max_terms: usize, work: u64) -> Self {
        Self { max_terms, work }
    }

    /// Returns a budget that limits only degrees.
    pub fn unlimited() -> Self {
        Self::new(usize::MAX, u64::MAX)
    }

    /// Returns the number of remaining multiplications of terms.
    pub fn work_left(&self) -> u64 {
        self.work
    }

    /// Subtracts `work` from the budget.
    pub fn charge(&mut self, work: u64) -> WithinBudget<()> {
        match self.work.checked_sub(work) {
            Some(rest) => {
                self.work = rest;
                Ok(())
            }
            None => {
                self.work = 0;
                Err(OverBudget)
            }
        }
    }

    /// Returns an error if a result with this number of terms is too long.
    pub fn admit(&self, terms: usize) -> WithinBudget<()> {
        if terms <= self.max_terms { Ok(()) } else { Err(OverBudget) }
    }
}

impl fmt::Display for OverBudget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the expansion exceeds its budget of terms or of work")
    }
}

impl Error for OverBudget {}

impl Polynomial {
    /// Returns the sum, or an error if it exceeds the budget.
    pub fn add_within(&self, other: &Self, budget: &mut Budget) -> WithinBudget<Self> {
        budget.charge((self.len() + other.len()) as u64)?;
        let sum = self + other;
        budget.admit(sum.len())?;
        Ok(sum)
    }

    /// Returns the sum of all summands, or an error if it exceeds the budget. Summands with the
    /// flag `true` are subtracted. Additions of coefficients are charged to the budget, too.
    pub fn sum_within<'a>(
        summands: impl IntoIterator<Item = (bool, &'a Self)>,
        budget: &mut Budget,
    ) -> WithinBudget<Self> {
        let sum = Self::sum_with(summands, |a, b| {
            let words = a.bits() / 64 + b.bits() / 64;
            budget.charge(words.saturating_mul(words))?;
            Ok(a + b)
        })?;
        budget.admit(sum.len())?;
        Ok(sum)
    }

    /// Returns the product, or an error if it exceeds the budget.
    pub fn mul_within(&self, other: &Self, budget: &mut Budget) -> WithinBudget<Self> {
        if u64::from(self.degree()) + u64::from(other.degree()) > MAX_DEGREE {
            return Err(OverBudget);
        }
        let words = self.coefficient_words() * other.coefficient_words();
        budget.charge((self.len() as u64).saturating_mul(other.len() as u64).saturating_mul(words))?;
        let product = self * other;
        budget.admit(product.len())?;
        Ok(product)
    }

    /// Returns the power, or an error if it exceeds the budget. The zeroth power is 1. Two bounds
    /// predict the number of terms. For a base of t terms and the exponent e, one bound is
    /// C(e+t−1,t−1). The other counts the monomials whose degree in each variable is at most e
    /// times that of the base.
    pub fn pow_within(&self, exponent: u32, budget: &mut Budget) -> WithinBudget<Self> {
        if u64::from(self.degree()) * u64::from(exponent) > MAX_DEGREE {
            return Err(OverBudget);
        }
        if exponent == 0 || self.is_one() {
            return Ok(Self::one());
        }
        if exponent == 1 || self.is_zero() {
            return Ok(self.clone());
        }
        if let [(monomial, coefficient)] = self.terms.as_slice() {
            let words = coefficient.bits().saturating_mul(u64::from(exponent)) / 64 + 1;
            budget.charge(words.saturating_mul(words))?;
            let exponent = i32::try_from(exponent).map_err(|_| OverBudget)?;
            let coefficient = coefficient.pow(exponent).expect("the exponent is not negative");
            return Ok(Self::term(monomial.pow(exponent.unsigned_abs()), coefficient));
        }
        budget.admit(self.power_size(exponent))?;
        // For sparse bases, repeated multiplication takes fewer multiplications of terms than
        // squaring.
        let mut power = self.clone();
        for _ in 1..exponent {
            power = power.mul_within(self, budget)?;
        }
        Ok(power)
    }

    fn power_size(&self, exponent: u32) -> usize {
        // C(e+t−1, t−1) is the product of (e+k)/k over 1 ≤ k < t. Partial products are integers.
        let mut choices: u128 = 1;
        for k in 1..self.len() as u128 {
            choices = choices * (u128::from(exponent) + k) / k;
            if choices > usize::MAX as u128 {
                break;
            }
        }
        let mut grid: u128 = 1;
        for variable in self.variables() {
            let points = u128::from(self.degree_in(variable)) * u128::from(exponent) + 1;
            grid = grid.saturating_mul(points);
        }
        usize::try_from(choices.min(grid)).unwrap_or(usize::MAX)
    }

    /// Returns the number of machine words of the longest coefficient.
    pub fn coefficient_words(&self) -> u64 {
        let mut bits = 0;
        for (_, coefficient) in &self.terms {
            bits = bits.max(coefficient.bits());
        }
        bits / 64 + 1
    }
}
