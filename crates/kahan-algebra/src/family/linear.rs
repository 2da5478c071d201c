//! Linear equations over the functions of a few parameters, met one after the other.

use kahan_syntax::table::Table;

use crate::poly::{Budget, Polynomial, Within};
use crate::rational_function::{RationalFunction, Row, reduced, with_leading_one};

/// Equations Σ aₖuₖ = r, each reduced by those before it. The right side has the number behind all
/// unknowns.
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
    ) -> Within<bool> {
        let mut sums: Table<usize, RationalFunction> = Table::new();
        for (unknown, coefficient) in terms {
            let sum = sums.or_insert_with(unknown, |_| RationalFunction::zero());
            *sum = sum.add_within(&RationalFunction::from(coefficient.clone()), budget)?;
        }
        let mut equation: Row = sums.into_iter().filter(|(_, value)| !value.is_zero()).collect();
        loop {
            let Some((first, factor)) = equation.first() else { return Ok(true) };
            if *first == self.unknowns {
                return Ok(false);
            }
            let Some(row) = self.rows.get(first) else {
                self.rows.insert(*first, with_leading_one(&equation, budget)?);
                return Ok(true);
            };
            equation = reduced(&equation, factor, row, budget)?;
        }
    }
}
