//! The invariant densities that a report lists.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::claims::proved::{Claims, Formula};
use crate::claims::writing::{factors_of, state_factors};
use crate::deadline::Deadline;
use crate::densities::darboux::measure;
use crate::densities::determinant::determinant;
use crate::maps::search_field::SearchField;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::primitive_in_states;
use crate::poisson::brackets::PoissonTensor;
use crate::report::DensitySearch;

const MOST_DENSITY_COEFFICIENTS: usize = 1000;

const MOST_DENSITY_TERMS: usize = 300;

const DETERMINANT_WORK: u64 = 1_000_000;

fn density_degree(n: usize) -> u32 {
    (1..=8).take_while(|&degree| Monomials::count(n, degree) <= MOST_DENSITY_COEFFICIENTS).last().unwrap_or(1)
}

/// Returns the density 1/Pf(P), where Pf(P) is the Pfaffian of a bracket's tensor P.
pub(crate) fn pfaffian_density(
    tensor: &PoissonTensor,
    claims: &Claims<'_>,
    symbols: &Symbols,
    integrals: &[Formula],
) -> Option<Formula> {
    let mut budget = Budget::new(MOST_DENSITY_TERMS, DETERMINANT_WORK);
    let pfaffian = primitive_in_states(symbols, &tensor.pfaffian(symbols.dimension(), &mut budget)?);
    claims.density(symbols, None, &[(pfaffian, -1)], &factors_of(integrals))
}

/// Finds the density of least degree. If the search finds no density and det(I − t f′) is even in t
/// (`is_even`), returns 1/det(I − ε f′), which is then a density of the map of the field f.
pub(crate) fn densities(
    searched: &SearchField,
    claims: &Claims<'_>,
    integrals: &[Formula],
    field: &Field,
    is_even: bool,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> (Vec<Formula>, DensitySearch) {
    let symbols = searched.family().symbols();
    let mut factors = factors_of(integrals);
    for factor in invariant_hyperplanes(field) {
        if !factors.contains(&factor) {
            factors.push(factor);
        }
    }
    let highest = density_degree(searched.dimension());
    let (found, search) = measure(searched, &factors, highest, random, deadline);
    let mut densities = Vec::new();
    densities.extend(found.and_then(|found| claims.density(symbols, None, &found.factors, &factors)));
    if is_even
        && densities.is_empty()
        && let Some(written) = written_determinant(searched, field)
    {
        densities.extend(claims.density(symbols, None, &[(written, -1)], &factors));
    }
    (densities, search)
}

/// Returns each linear factor P of a component of the field f such that P divides ∇P·f. The flow
/// and the map preserve the hyperplane P = 0.
fn invariant_hyperplanes(field: &Field) -> Vec<Polynomial> {
    let symbols = &field.symbols;
    let mut found: Vec<Polynomial> = Vec::new();
    for component in &field.components {
        for factor in state_factors(symbols, component.numerator()) {
            if symbols.degree(&factor) != 1 || found.contains(&factor) {
                continue;
            }
            let rise = (0..).zip(&field.components).fold(RationalFunction::zero(), |sum, (i, own)| {
                &sum + &(&RationalFunction::from(factor.derivative(symbols.state(i))) * own)
            });
            if rise.numerator().checked_div(&factor).is_some() {
                found.push(factor);
            }
        }
    }
    found
}

/// Returns det(I − ε f′) for the field f, divided by factors without states. A fixed ε is inserted.
fn written_determinant(searched: &SearchField, field: &Field) -> Option<Polynomial> {
    let mut budget = Budget::new(MOST_DENSITY_TERMS, DETERMINANT_WORK);
    let fixed = searched.at_eps(determinant(field, &mut budget).ok()?);
    Some(primitive_in_states(&field.symbols, &fixed)).filter(|fixed| !fixed.is_zero())
}
