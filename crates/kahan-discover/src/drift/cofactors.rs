//! Lists the possible cofactors of polynomials under the map.
//!
//! Let the map of n states have the numerators Nᵢ and the denominator D. In homogeneous coordinates
//! it is F = (N₁, …, Nₙ, D), of degree δ. Let homogeneous polynomials of degree d without a
//! common factor span a space V. Let P∘F = C·Q with Q in V for each P in V. Then C has degree
//! d(δ − 1), and F contracts C = 0 to common zeros of V. So factors of C divide the Jacobian
//! determinant of F, of degree (n + 1)(δ − 1). One may be x₀, which is 1 at finite points.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_factor::factors;

use crate::densities::products::exponents;
use crate::maps::search_field::SearchField;
use crate::poles::curves::{components, jacobian};

const MOST_TERMS: usize = 5_000;
const MOST_WORK: u64 = 2_000_000;

pub(super) struct Cofactors {
    pub(super) components: Vec<Polynomial>,
    pub(super) factors: Vec<Polynomial>,
    /// The degrees of the Jacobian determinant's factors. If the homogeneous coordinate x₀ is a
    /// factor, its degree 1 comes last.
    degrees: Vec<u32>,
    degree: u32,
}

impl Cofactors {
    /// Factors the Jacobian determinant of the map.
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

    pub(super) fn denominator(&self) -> &Polynomial {
        self.components.last().expect("a map has a denominator")
    }

    /// Returns the possible cofactors of polynomials of this degree, as exponents of `factors`.
    pub(super) fn of_degree(&self, degree: u32) -> Vec<Vec<i32>> {
        exponents(&self.degrees, degree * (self.degree - 1), &[1])
    }
}
