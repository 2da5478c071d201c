//! The invariant density of a report: found by degree, or read off det A.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::prime_field::SplitMix64;

use crate::claims::{Claims, Formula};
use crate::darboux::{MeasureSearch, measure};
use crate::deadline::Deadline;
use crate::determinant::determinant;
use crate::monomials::Monomials;
use crate::report::DensitySearch;
use crate::setting::Setting;
use crate::space::tidy;
use crate::writing::state_factors_of;

/// The most coefficients of the polynomial of a density.
const MOST_DENSITY_COEFFICIENTS: usize = 220;

/// A density of more terms than this is not written.
const MOST_DENSITY_TERMS: usize = 300;

/// The work that writing det A out may take, in products of terms.
const DETERMINANT_WORK: u64 = 1_000_000;

/// The degree up to which densities are looked for.
fn density_degree(n: usize) -> u32 {
    (1..=8).take_while(|&degree| Monomials::count(n, degree) <= MOST_DENSITY_COEFFICIENTS).last().unwrap_or(1)
}

/// The density of least degree; or 1/det A where det(I − t f′) is even and that is the only one.
pub(crate) fn densities(
    setting: &Setting,
    claims: &Claims<'_>,
    integrals: &[Formula],
    field: &Field,
    is_even: bool,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> (Vec<Formula>, DensitySearch) {
    let symbols = setting.family().symbols();
    let factors = state_factors_of(symbols, integrals);
    let highest = density_degree(setting.dimension());
    let mut densities = Vec::new();
    let mut search = DensitySearch::default();
    match measure(setting, &factors, highest, random, deadline) {
        MeasureSearch::Found(found) => {
            search.seen = Some(found.degree);
            densities.extend(claims.density(symbols, None, &found.factors, &factors));
        }
        MeasureSearch::Seen(degree) => search.seen = Some(degree),
        MeasureSearch::NoneUpTo(degree) => search.none_up_to = degree,
    }
    if is_even
        && densities.is_empty()
        && let Some(written) = written_determinant(setting, field)
    {
        densities.extend(claims.density(symbols, None, &[(written, -1)], &factors));
    }
    (densities, search)
}

/// det A(x,ε) up to factors free of states, ε put in where it is fixed, if that has few terms.
fn written_determinant(setting: &Setting, field: &Field) -> Option<Polynomial> {
    let mut budget = Budget::new(MOST_DENSITY_TERMS, DETERMINANT_WORK);
    let written = determinant(field, &mut budget).ok()?;
    let fixed = match setting.eps() {
        Some(eps) => written.substitute(field.symbols.epsilon(), eps),
        None => written,
    };
    Some(tidy(&field.symbols, &fixed)).filter(|fixed| !fixed.is_zero())
}
