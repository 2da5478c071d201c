//! Curves (surfaces in three variables) that a map may send to infinity or contract: factors of the
//! map's denominator and Jacobian determinant.

use kahan_algebra::field::Field;
use kahan_algebra::kahan::{RationalMap, maximal_minors};
use kahan_algebra::poly::{Budget, Polynomial, gcd_all};

use crate::claims::writing::state_factors;
use crate::maps::search_field::SearchField;

const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 20_000_000;

/// The map in lowest terms, and the curves to follow.
pub(crate) struct Curves {
    pub(crate) components: Vec<Polynomial>,
    pub(crate) factors: Vec<Polynomial>,
    /// Whether the factors of the Jacobian determinant are included. A very long determinant is not
    /// factored.
    pub(crate) has_jacobian: bool,
}

impl Curves {
    /// Returns the map in lowest terms, with the curves that it may send to infinity or contract.
    pub(crate) fn of(field: &Field, searched: &SearchField) -> Option<Self> {
        let symbols = &field.symbols;
        let components = components(field, searched)?;
        let mut factors = state_factors(symbols, &components[field.dimension()]);
        let jacobian = jacobian(field, &components, &mut Budget::new(MOST_TERMS, MOST_WORK));
        let has_jacobian = jacobian.is_some();
        for factor in jacobian.iter().flat_map(|jacobian| state_factors(symbols, jacobian)) {
            if !factors.contains(&factor) {
                factors.push(factor);
            }
        }
        Some(Curves { components, factors, has_jacobian })
    }
}

/// Returns the map N₁/D … Nₙ/D in lowest terms as N₁ … Nₙ, D.
pub(crate) fn components(field: &Field, searched: &SearchField) -> Option<Vec<Polynomial>> {
    let reduced = RationalMap::of(field)?.reduced;
    let mut components = reduced.numerators(&field.symbols);
    components.push(reduced.denominator);
    let mut components: Vec<Polynomial> =
        components.into_iter().map(|component| searched.at_eps(component)).collect();
    // At special values of ε the components may have a common factor, which is divided out.
    let common = gcd_all(&components);
    components.iter_mut().for_each(|one| *one = one.checked_div(&common).unwrap_or_default());
    Some(components)
}

/// Returns Dⁿ⁺¹ det ∂x̃/∂x for the map x̃ = (N₁, …, Nₙ)/D. This is the determinant of the matrix
/// with a row (∂F/∂x₁, …, ∂F/∂xₙ, F) for F = N₁, …, Nₙ and D.
pub(crate) fn jacobian(field: &Field, components: &[Polynomial], budget: &mut Budget) -> Option<Polynomial> {
    let row = |component: &Polynomial| {
        let slopes = (0..field.dimension()).map(|i| component.derivative(field.symbols.state(i)));
        slopes.chain([component.clone()]).collect()
    };
    let rows: Vec<Vec<Polynomial>> = components.iter().map(row).collect();
    maximal_minors(&rows, budget).ok()?.into_values().next()
}
