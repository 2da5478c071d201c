//! Common denominators and rows of linear equations.

use super::{RationalFunction, divide, unlimited};
use crate::poly::{Budget, Polynomial, WithinBudget, gcd_within};

/// A sparse row of a matrix: pairs (column, nonzero entry) in ascending order of columns.
pub(crate) type Row = Vec<(usize, RationalFunction)>;

/// Reducing a fraction of long integers costs as much as this many products of these integers.
const COST_OF_FRACTIONS: u64 = 50;

impl RationalFunction {
    /// Returns the numerators over the least common denominator, and this denominator.
    pub fn over_common(functions: &[Self]) -> (Vec<Polynomial>, Polynomial) {
        unlimited(|budget| Self::over_common_within(functions.iter(), budget))
    }

    /// Computes [`over_common`](Self::over_common) within a budget.
    pub fn over_common_within<'a>(
        functions: impl Iterator<Item = &'a Self> + Clone,
        budget: &mut Budget,
    ) -> WithinBudget<(Vec<Polynomial>, Polynomial)> {
        let mut common = Polynomial::one();
        for function in functions.clone() {
            let shared = gcd_within(&common, &function.denominator, budget)?;
            common = common.mul_within(&divide(&function.denominator, &shared, budget)?, budget)?;
        }
        let over = |function: &Self| {
            function.numerator.mul_within(&divide(&common, &function.denominator, budget)?, budget)
        };
        Ok((functions.map(over).collect::<Result<_, _>>()?, common))
    }
}

pub(crate) fn with_leading_one(row: &Row, budget: &mut Budget) -> WithinBudget<Row> {
    let inverse = row[0].1.recip().expect("entries are not zero");
    row.iter().map(|(column, entry)| Ok((*column, entry.mul_within(&inverse, budget)?))).collect()
}

/// Returns the row minus `factor` times the pivot row.
pub(crate) fn reduced(
    row: &Row,
    factor: &RationalFunction,
    pivot: &Row,
    budget: &mut Budget,
) -> WithinBudget<Row> {
    let words = factor.numerator().coefficient_words();
    let mut difference = Row::with_capacity(row.len() + pivot.len());
    let mut own = row.iter().peekable();
    for (column, entry) in pivot {
        while let Some(before) = own.next_if(|(other, _)| other < column) {
            difference.push(before.clone());
        }
        let long = entry.numerator().coefficient_words().max(words) - 1;
        budget.charge(long.saturating_mul(long).saturating_mul(COST_OF_FRACTIONS))?;
        let product = entry.mul_within(factor, budget)?;
        let entry = match own.next_if(|(other, _)| other == column) {
            Some((_, known)) => known.sub_within(&product, budget)?,
            None => -&product,
        };
        if !entry.is_zero() {
            difference.push((*column, entry));
        }
    }
    difference.extend(own.cloned());
    Ok(difference)
}
