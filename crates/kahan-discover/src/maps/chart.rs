//! A leaf together with the formulas of what chooses it, by which formulas on the leaf become
//! formulas everywhere.

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::maps::affine_subspace::{AffineSubspace, Coordinate};
use crate::maps::search_field::SearchField;
use crate::modular::subspace::Names;

/// The work that putting the formulas of a leaf's coordinates in may take, in products of terms.
const SUBSTITUTION_WORK: u64 = 20_000_000;

/// A leaf with the formulas of what chooses it: its entries, and perhaps the value of an integral
/// on it.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The leaf.
    pub leaf: AffineSubspace,
    /// The formulas, in the order of the entries; the value of an integral last.
    pub coordinates: Vec<Coordinate>,
}

impl Chart {
    fn variable(&self, symbols: &Symbols, j: usize) -> Variable {
        symbols.variable(Symbol::SecondState(j))
    }

    /// Which variables of formulas on the leaf stand for what.
    #[must_use]
    pub fn names(&self, searched: &SearchField) -> Names {
        let symbols = searched.family().symbols();
        let mut names = Names::of(searched);
        names.unknowns.extend((0..self.coordinates.len()).map(|j| self.variable(symbols, j)));
        names.states = self.leaf.order().iter().map(|&state| symbols.state(state)).collect();
        if let Some((weights, unknowns)) = &mut names.weights {
            unknowns.extend(self.coordinates.iter().map(|coordinate| coordinate.weight(weights)));
        }
        names
    }

    /// P/Q in lowest terms with every coordinate replaced by its formula; `None` beyond the budget,
    /// and where Q becomes 0.
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
