//! Linear equations over the functions of a few parameters, met one after the other.

use crate::rational_function::RationalFunction;

/// Equations Σ aₖuₖ = r, each reduced by those before it.
#[derive(Default)]
pub(super) struct Equations {
    /// The place of the leading coefficient, which is 1; all coefficients, and behind them the
    /// right side.
    rows: Vec<(usize, Vec<RationalFunction>)>,
}

impl Equations {
    /// Adds an equation, its coefficients and its right side; `false` if it contradicts those
    /// before it.
    pub(super) fn add(&mut self, mut equation: Vec<RationalFunction>) -> bool {
        for (place, row) in &self.rows {
            subtract_multiple(&mut equation, *place, row);
        }
        let Some(place) = equation.iter().position(|value| !value.is_zero()) else { return true };
        if place + 1 == equation.len() {
            return false;
        }
        let inverse = equation[place].recip().expect("it is not zero");
        equation.iter_mut().for_each(|value| *value = &*value * &inverse);
        for (_, row) in &mut self.rows {
            subtract_multiple(row, place, &equation);
        }
        self.rows.push((place, equation));
        true
    }

    /// A solution in `count` unknowns, zero where the equations leave one free.
    pub(super) fn solution(&self, count: usize) -> Vec<RationalFunction> {
        let mut solution = vec![RationalFunction::zero(); count];
        for (place, row) in &self.rows {
            solution[*place] = row[count].clone();
        }
        solution
    }
}

/// Takes so much of `row`, which has 1 at `place`, from another row that 0 is left there.
fn subtract_multiple(from: &mut [RationalFunction], place: usize, row: &[RationalFunction]) {
    let factor = -&from[place];
    if !factor.is_zero() {
        for (value, other) in from.iter_mut().zip(row) {
            *value = &*value + &(&factor * other);
        }
    }
}
