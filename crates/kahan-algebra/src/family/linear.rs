//! Linear equations over the functions of a few parameters, met one after the other.

use crate::rational_function::RationalFunction;

/// Equations Σ aₖuₖ = r, each reduced by those before it.
#[derive(Default)]
pub(super) struct Equations {
    /// The place of the leading coefficient, which is 1, all coefficients, the right side.
    rows: Vec<(usize, Vec<RationalFunction>, RationalFunction)>,
}

impl Equations {
    /// Adds an equation; `false` if it contradicts those before it.
    pub(super) fn add(
        &mut self,
        mut coefficients: Vec<RationalFunction>,
        mut right: RationalFunction,
    ) -> bool {
        for (place, row, row_right) in &self.rows {
            let factor = -&coefficients[*place];
            if !factor.is_zero() {
                add_multiple(&mut coefficients, &mut right, &factor, row, row_right);
            }
        }
        let Some(place) = coefficients.iter().position(|value| !value.is_zero()) else {
            return right.is_zero();
        };
        let inverse = coefficients[place].recip().expect("it is not zero");
        coefficients.iter_mut().for_each(|value| *value = &*value * &inverse);
        right = &right * &inverse;
        for (_, row, row_right) in &mut self.rows {
            let factor = -&row[place];
            if !factor.is_zero() {
                add_multiple(row, row_right, &factor, &coefficients, &right);
            }
        }
        self.rows.push((place, coefficients, right));
        true
    }

    /// A solution in `count` unknowns, zero where the equations leave one free.
    pub(super) fn solution(&self, count: usize) -> Vec<RationalFunction> {
        let mut solution = vec![RationalFunction::zero(); count];
        for (place, _, right) in &self.rows {
            solution[*place] = right.clone();
        }
        solution
    }
}

fn add_multiple(
    to: &mut [RationalFunction],
    to_right: &mut RationalFunction,
    factor: &RationalFunction,
    row: &[RationalFunction],
    right: &RationalFunction,
) {
    for (value, other) in to.iter_mut().zip(row) {
        *value = &*value + &(factor * other);
    }
    *to_right = &*to_right + &(factor * right);
}
