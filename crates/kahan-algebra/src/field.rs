//! The checked quadratic field. Mistakes in the equations are reported before it is built, those in
//! claims afterwards.
//!
//! Each component is ẋᵢ = pᵢ/qᵢ in lowest terms. The numerator pᵢ has degree at most 2 in the
//! states, and qᵢ contains no state. Coefficients may depend on ε². The map approximates the flow
//! of the field at ε = 0. [`crate::kahan`] derives the objects of Kahan's method.

use crate::poly::{Monomial, Polynomial};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

/// A quadratic vector field ẋ = Q(x) + Bx + c with exact coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// The names of states and parameters.
    pub symbols: Symbols,
    /// The components p/q of the states. The numerator p has degree at most 2 in the states. The
    /// denominator q contains no state and is nonzero at ε = 0. Both contain ε in even powers only.
    pub components: Vec<RationalFunction>,
}

impl Field {
    /// Returns the number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.components.len()
    }

    /// Returns the numerator p of each component.
    pub fn numerators(&self) -> impl Iterator<Item = &Polynomial> {
        self.components.iter().map(RationalFunction::numerator)
    }

    /// Returns the denominator q of each component.
    pub fn denominators(&self) -> impl Iterator<Item = &Polynomial> {
        self.components.iter().map(RationalFunction::denominator)
    }

    /// Returns whether a coefficient depends on ε.
    #[must_use]
    pub fn depends_on_eps(&self) -> bool {
        let eps = self.symbols.epsilon();
        self.components.iter().any(|component| component.contains(eps))
    }

    /// Returns the terms of a numerator with this degree in the states.
    #[must_use]
    pub fn homogeneous_part(&self, component: usize, degree: u32) -> Polynomial {
        let is_in = |monomial: &Monomial| monomial.degree_where(|v| self.symbols.is_state(v)) == degree;
        let numerator = self.components[component].numerator();
        numerator.map_monomials(|monomial| is_in(monomial).then(|| monomial.clone()))
    }

    /// Returns whether all terms are quadratic.
    #[must_use]
    pub fn is_homogeneous(&self) -> bool {
        (0..self.dimension())
            .all(|i| self.homogeneous_part(i, 0).is_zero() && self.homogeneous_part(i, 1).is_zero())
    }

    /// Returns the indices of the states in a monomial. The k-th power of a state is listed k
    /// times.
    #[must_use]
    pub fn states_of(&self, monomial: &Monomial) -> Vec<usize> {
        let mut states = Vec::new();
        for &(variable, exponent) in monomial.powers() {
            if self.symbols.is_state(variable) {
                states.extend(std::iter::repeat_n(usize::from(variable.0), exponent as usize));
            }
        }
        states
    }
}
