//! A variable replaced by a rational function.

use super::RationalFunction;
use crate::poly::{Budget, OverBudget, Polynomial, Variable};

impl RationalFunction {
    /// The function with `variable` replaced by `value`, within a budget; `None` where its
    /// denominator then vanishes identically.
    pub fn compose_within(
        &self,
        variable: Variable,
        value: &Self,
        budget: &mut Budget,
    ) -> Result<Option<Self>, OverBudget> {
        if !self.numerator.contains(variable) && !self.denominator.contains(variable) {
            return Ok(Some(self.clone()));
        }
        let (above, above_by) = compose(&self.numerator, variable, value, budget)?;
        let (below, below_by) = compose(&self.denominator, variable, value, budget)?;
        Self::new_within(above.mul_within(&below_by, budget)?, below.mul_within(&above_by, budget)?, budget)
    }
}

/// Σ cₖ vᵏ at v = n/d as a quotient: Σ cₖ nᵏ d^(D−k) over d^D.
fn compose(
    polynomial: &Polynomial,
    variable: Variable,
    value: &RationalFunction,
    budget: &mut Budget,
) -> Result<(Polynomial, Polynomial), OverBudget> {
    let degree = polynomial.degree_in(variable);
    let mut sum = Polynomial::zero();
    for (exponent, coefficient) in polynomial.coefficients_in(variable) {
        let above = value.numerator.pow_within(exponent, budget)?;
        let below = value.denominator.pow_within(degree - exponent, budget)?;
        let term = coefficient.mul_within(&above, budget)?.mul_within(&below, budget)?;
        sum = sum.add_within(&term, budget)?;
    }
    Ok((sum, value.denominator.pow_within(degree, budget)?))
}
