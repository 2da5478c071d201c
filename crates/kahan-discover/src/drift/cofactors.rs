//! The cofactors that a space of polynomials can have under the map.
//!
//! In homogeneous coordinates the map is F = (N₁ … Nₙ, D) of degree δ, with the denominator D for
//! the coordinate x₀ = 1. Where P∘F = C·Q with P and Q of degree d, the polynomial C has degree
//! d(δ − 1) and vanishes only on what F contracts: it is a product of factors of the Jacobian
//! determinant of F, which has degree (n + 1)(δ − 1) and may contain x₀.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_factor::factors;

use crate::poles::curves::{components, jacobian};
use crate::products::exponents;
use crate::search_field::SearchField;

/// What writing out and factoring the Jacobian determinant may cost.
const MOST_TERMS: usize = 5_000;
const MOST_WORK: u64 = 2_000_000;

/// The factors that a cofactor is made of, and the degree of the map.
pub(super) struct Cofactors {
    /// N₁ … Nₙ, D
    pub(super) components: Vec<Polynomial>,
    /// Factors of the Jacobian determinant that depend on states.
    pub(super) factors: Vec<Polynomial>,
    /// Their degrees in the states, and 1 for x₀ where that is a factor, too.
    degrees: Vec<u32>,
    /// δ
    degree: u32,
}

impl Cofactors {
    /// `None` where the map or its Jacobian determinant is beyond the budget.
    pub(super) fn of(field: &Field, searched: &SearchField) -> Option<Self> {
        let symbols = &field.symbols;
        let components = components(field, searched)?;
        let jacobian = jacobian(field, &components, &mut Budget::new(MOST_TERMS, MOST_WORK))?;
        let degree = components.iter().map(|component| symbols.degree(component)).max()?;
        let found = factors(&jacobian, &mut Budget::new(MOST_TERMS, MOST_WORK)).factors;
        let factors: Vec<Polynomial> =
            found.into_iter().map(|(factor, _)| factor).filter(|factor| symbols.has_state(factor)).collect();
        let full = (field.dimension() as u32 + 1) * (degree - 1);
        let at_infinity = (symbols.degree(&jacobian) < full).then_some(1);
        let degrees = factors.iter().map(|factor| symbols.degree(factor)).chain(at_infinity).collect();
        Some(Cofactors { components, factors, degrees, degree })
    }

    /// D
    pub(super) fn denominator(&self) -> &Polynomial {
        self.components.last().expect("a map has a denominator")
    }

    /// The exponents of the factors in each cofactor of polynomials of degree `degree`.
    pub(super) fn of_degree(&self, degree: u32) -> Vec<Vec<i32>> {
        exponents(&self.degrees, degree * (self.degree - 1), &[1])
    }
}
