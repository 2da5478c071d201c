//! Affine level sets with formulas for the constants that define them.

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::maps::affine_subspace::{AffineSubspace, Coordinate};
use crate::maps::search_field::SearchField;
use crate::modular::subspace::FormulaVariables;

const SUBSTITUTION_WORK: u64 = 20_000_000;

/// A level set with formulas for the constants that define it.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The level set.
    pub leaf: AffineSubspace,
    /// The formulas of the constants, in order. If the search is on the level set of a further
    /// integral, the formula of this integral comes last.
    pub coordinates: Vec<Coordinate>,
}

impl Chart {
    fn variable(&self, symbols: &Symbols, j: usize) -> Variable {
        symbols.variable(Symbol::SecondState(j))
    }

    /// Returns the variables that occur in formulas on the level set.
    #[must_use]
    pub fn names(&self, searched: &SearchField) -> FormulaVariables {
        let symbols = searched.family().symbols();
        let mut names = FormulaVariables::of(searched);
        names.unknowns.extend((0..self.coordinates.len()).map(|j| self.variable(symbols, j)));
        names.states = self.leaf.order().iter().map(|&state| symbols.state(state)).collect();
        if let Some((weights, unknowns)) = &mut names.weights {
            unknowns.extend(self.coordinates.iter().map(|coordinate| coordinate.weight(weights)));
        }
        names
    }

    /// Returns P/Q in lowest terms with the formulas in place of the constants. Returns `None` if Q
    /// becomes 0, or if the computation has too many terms or takes too much work.
    #[must_use]
    pub fn substituted(
        &self,
        symbols: &Symbols,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Option<(Polynomial, Polynomial)> {
        if self.coordinates.is_empty() {
            return Some((numerator.clone(), denominator.clone()));
        }
        let mut budget = Budget::new(20_000, SUBSTITUTION_WORK);
        let mut quotient = [numerator.clone(), denominator.clone()];
        for (j, coordinate) in self.coordinates.iter().enumerate() {
            let variable = self.variable(symbols, j);
            let highest = quotient.iter().map(|side| side.degree_in(variable)).max()?;
            for side in &mut quotient {
                let value = (&coordinate.numerator, &coordinate.denominator);
                *side = side.homogenised_at(variable, value, highest, &mut budget).ok()?;
            }
        }
        let [above, below] = quotient;
        let reduced = RationalFunction::new_within(above, below, &mut budget).ok()??;
        Some((reduced.numerator().clone(), reduced.denominator().clone()))
    }
}
