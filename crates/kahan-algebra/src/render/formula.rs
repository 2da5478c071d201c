//! Prints the formulas of a field, of its map, and of its matrices.

use crate::field::Field;
use crate::kahan::{RationalMap, TERM_BUDGET, bilinear_form, field_jacobian, scaled_matrix, scaled_rhs};
use crate::poly::{Budget, Polynomial};
use crate::rational_function::RationalFunction;
use kahan_syntax::rational::Rational;

use super::notation::Notation;

/// A field and its map, with a notation for their formulas.
#[derive(Clone, Copy, Debug)]
pub struct Formulas<'a> {
    /// The field.
    pub field: &'a Field,
    /// The map of the field. `None` if the budget is exceeded.
    pub map: Option<&'a RationalMap>,
    /// The notation of the formulas.
    pub notation: &'a dyn Notation,
}

/// A matrix of formulas.
pub type MatrixText = Vec<Vec<String>>;

impl Formulas<'_> {
    fn polynomial(&self, polynomial: &Polynomial) -> String {
        self.notation.polynomial(&self.field.symbols, polynomial)
    }

    fn over(&self, polynomial: &Polynomial, component: &RationalFunction) -> String {
        if component.denominator().is_one() || polynomial.is_zero() {
            return self.polynomial(polynomial);
        }
        self.notation.fraction(&self.field.symbols, polynomial, component.denominator())
    }

    fn over_each(&self, polynomials: &[Polynomial]) -> Vec<String> {
        let pairs = polynomials.iter().zip(&self.field.components);
        pairs.map(|(polynomial, component)| self.over(polynomial, component)).collect()
    }

    /// Returns the field f(x).
    #[must_use]
    pub fn field(&self) -> Vec<String> {
        let components = self.field.components.iter();
        components.map(|component| self.notation.function(&self.field.symbols, component)).collect()
    }

    /// Returns the Jacobian f′(x).
    #[must_use]
    pub fn field_jacobian(&self) -> MatrixText {
        self.matrix_over(&field_jacobian(self.field))
    }

    /// Returns the matrix A(x,ε).
    #[must_use]
    pub fn matrix(&self) -> MatrixText {
        self.matrix_over(&scaled_matrix(self.field))
    }

    /// Returns the right-hand side b(x,ε) of the equation A(x,ε) x̃ = b(x,ε).
    #[must_use]
    pub fn rhs(&self) -> Vec<String> {
        self.over_each(&scaled_rhs(self.field))
    }

    /// Returns the bilinear form Q(x,y). A name with a prime is a component of y.
    #[must_use]
    pub fn bilinear(&self) -> Vec<String> {
        self.over_each(&bilinear_form(self.field))
    }

    /// Returns the components of the map in lowest terms. Returns `None` if the budget is exceeded.
    #[must_use]
    pub fn map(&self) -> Option<Vec<String>> {
        let map = self.map?;
        let symbols = &self.field.symbols;
        let rows = map.reduced.increments.iter().zip(&symbols.states).map(|(increment, state)| {
            if increment.is_zero() {
                return self.notation.name(state);
            }
            self.notation.moved(symbols, state, increment, &map.reduced.denominator)
        });
        Some(rows.collect())
    }

    /// Returns ∂x̃/∂x with every entry in lowest terms. Returns `None` if the budget is exceeded.
    #[must_use]
    pub fn jacobian(&self) -> Option<MatrixText> {
        /// The most multiplications of terms for an entry. They take some tenths of a second.
        const MAX_TERM_PRODUCTS: u64 = 1 << 20;

        let map = &self.map?.reduced;
        let symbols = &self.field.symbols;
        let two_eps = Polynomial::variable(symbols.epsilon()).scale(&Rational::from(2));
        let entry = |i: usize, j: usize| {
            let budget = &mut Budget::new(TERM_BUDGET, MAX_TERM_PRODUCTS);
            let increment = two_eps.mul_within(&map.increments[i], budget).ok()?;
            let moved = RationalFunction::new_within(increment, map.denominator.clone(), budget).ok()??;
            let slope = moved.derivative_within(symbols.state(j), budget).ok()?;
            let identity = if i == j { RationalFunction::one() } else { RationalFunction::zero() };
            Some(self.notation.function(symbols, &identity.add_within(&slope, budget).ok()?))
        };
        let variables = 0..map.increments.len();
        variables.clone().map(|i| variables.clone().map(|j| entry(i, j)).collect()).collect()
    }

    /// Returns det A(x,ε). Returns `None` if the budget is exceeded.
    #[must_use]
    pub fn determinant(&self) -> Option<String> {
        let map = self.map?;
        Some(if map.divisor.is_one() {
            self.polynomial(&map.denominator)
        } else {
            self.notation.fraction(&self.field.symbols, &map.denominator, &map.divisor)
        })
    }

    /// Returns the common factor that was divided out of the map, unless it is constant.
    #[must_use]
    pub fn removed_factor(&self) -> Option<String> {
        let map = self.map?;
        let factor = &map.reduced.common_factor;
        factor.as_constant().is_none().then(|| self.polynomial(factor))
    }

    fn matrix_over(&self, rows: &[Vec<Polynomial>]) -> MatrixText {
        let rows = rows.iter().zip(&self.field.components);
        rows.map(|(row, component)| row.iter().map(|entry| self.over(entry, component)).collect()).collect()
    }
}
