//! Linear equations over the functions of a few parameters, met one after the other.

use kahan_syntax::table::Table;

use crate::poly::{Budget, OverBudget, Polynomial};
use crate::rational_function::RationalFunction;

/// Coefficients by the number of their unknown; the right side has the number behind all.
type Row = Table<usize, RationalFunction>;

/// Equations Σ aₖuₖ = r, each reduced by those before it.
pub(super) struct Equations {
    unknowns: usize,
    /// By the first unknown that occurs, whose coefficient is 1.
    rows: Table<usize, Row>,
}

impl Equations {
    pub(super) fn new(unknowns: usize) -> Self {
        Equations { unknowns, rows: Table::new() }
    }

    /// Adds an equation, whose terms of one unknown are added up; `false` if it contradicts those
    /// before it.
    pub(super) fn add<'a>(
        &mut self,
        terms: impl Iterator<Item = (usize, &'a Polynomial)>,
        budget: &mut Budget,
    ) -> Result<bool, OverBudget> {
        let mut equation = Row::new();
        for (unknown, coefficient) in terms {
            let sum = equation.or_insert_with(unknown, |_| RationalFunction::zero());
            *sum = sum.add_within(&RationalFunction::from(coefficient.clone()), budget)?;
        }
        let mut from = 0;
        loop {
            let first = equation.iter().find(|(unknown, value)| **unknown >= from && !value.is_zero());
            let Some((&unknown, value)) = first else { return Ok(true) };
            if unknown == self.unknowns {
                return Ok(false);
            }
            let Some(row) = self.rows.get(&unknown) else {
                let inverse = value.recip().expect("it is not zero");
                let mut row = Row::new();
                for (&unknown, value) in equation.iter().filter(|(_, value)| !value.is_zero()) {
                    row.insert(unknown, value.mul_within(&inverse, budget)?);
                }
                self.rows.insert(unknown, row);
                return Ok(true);
            };
            let factor = value.clone();
            for (&unknown, value) in row.iter() {
                let product = factor.mul_within(value, budget)?;
                let rest = equation.or_insert_with(unknown, |_| RationalFunction::zero());
                *rest = rest.sub_within(&product, budget)?;
            }
            from = unknown + 1;
        }
    }
}
