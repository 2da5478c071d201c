//! What a proof computes: a step over whatever field it is tested in.

use crate::field::Field;
use crate::kahan::scaled_matrix;
use crate::plan::{Plan, plan_of};
use crate::symbols::Symbols;

/// The numerators p of the field and the matrix Â. Over ℚ and in prime fields the expanded forms
/// lose nothing and divide by nothing.
pub(crate) struct Scheme {
    pub(crate) symbols: Symbols,
    pub(crate) numerators: Plan,
    pub(crate) matrix: Plan,
    /// The number of variables: states, parameters and ε.
    pub(crate) variables: usize,
}

impl Scheme {
    pub(crate) fn of(field: &Field) -> Self {
        let numerators = plan_of(field.numerators());
        let matrix = plan_of(scaled_matrix(field).iter().flatten());
        let variables = usize::from(field.symbols.epsilon().0) + 1;
        Scheme { symbols: field.symbols.clone(), numerators, matrix, variables }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.symbols.dimension()
    }
}
