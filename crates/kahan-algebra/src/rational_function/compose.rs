//! A variable replaced by a rational function.

use super::RationalFunction;
use crate::poly::{Budget, Variable, Within};

impl RationalFunction {
    /// The function with `variable` replaced by `value`, within a budget; `None` where its
    /// denominator then vanishes identically.
    pub fn compose_within(
        &self,
        variable: Variable,
        value: &Self,
        budget: &mut Budget,
    ) -> Within<Option<Self>> {
        if !self.contains(variable) {
            return Ok(Some(self.clone()));
        }
        let degree = self.numerator.degree_in(variable).max(self.denominator.degree_in(variable));
        let at = (&value.numerator, &value.denominator);
        let above = self.numerator.homogenised_at(variable, at, degree, budget)?;
        let below = self.denominator.homogenised_at(variable, at, degree, budget)?;
        Self::new_within(above, below, budget)
    }
}
