//! Darboux polynomials of the map φ: polynomials P with P(φ(x)) = C(x) P(x) for a given cofactor C.
//!
//! If C = det ∂x̃/∂x, then dx/P is an invariant measure. If C = 1, then P is an integral. If two
//! polynomials have equal cofactors, their quotient is an integral.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::densities::products::product;
use crate::maps::map::{ModularMap, Step};
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::matrix::sampled_null_vectors;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::{
    Form, FormulaVariables, PolynomialSpace, primitive_in_states, reconstruct_space,
};
use crate::report::DensitySearch;

const MOST_SAMPLES: usize = 16;

/// The density ρ of an invariant measure ρ dx, as a product of factors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measure {
    /// The factors of ρ with their exponents.
    pub factors: Vec<(Polynomial, i32)>,
    /// The sum of |exponent|·degree over all factors of ρ.
    pub degree: u32,
}

pub(crate) fn random_step(map: &ModularMap, random: &mut SplitMix64) -> Option<(Vec<u64>, Step)> {
    (0..MOST_SAMPLES).find_map(|_| {
        let point = map.point(random);
        let step = map.step(&point)?;
        Some((point, step))
    })
}

/// Returns the solutions P of P(φ(x)) = det(∂x̃/∂x) P(x) that are linear combinations of the
/// monomials with the indices `support`.
fn null_vectors(
    map: &ModularMap,
    monomials: &Monomials,
    support: &[usize],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<Vec<u64>>> {
    let modulus = map.modulus();
    sampled_null_vectors(modulus, support.len(), deadline, || {
        let (point, step) = random_step(map, random)?;
        let (here, there) = (monomials.values(modulus, &point), monomials.values(modulus, &step.next));
        let difference =
            |&index: &usize| modulus.minus(there[index], modulus.times(step.jacobian, here[index]));
        Some(support.iter().map(difference).collect())
    })
}

/// Returns the space of all polynomials P up to a degree with P(φ(x)) = det(∂x̃/∂x) P(x).
///
/// Returns `None` if the map φ is undefined at the sampled points, or if the deadline passes.
pub fn measure_space(
    map: &ModularMap,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<PolynomialSpace> {
    let monomials = Monomials::new(map.dimension(), degree);
    let all: Vec<usize> = (0..monomials.len()).collect();
    let vectors = null_vectors(map, &monomials, &all, random, deadline)?;
    Some(PolynomialSpace::spanned(map.modulus(), vectors))
}

/// The highest degree of a product in a density 1/∏ factors.
const HIGHEST_PRODUCT: u32 = 12;

/// For quotients of two products, the highest sum of the degrees of numerator and denominator.
const HIGHEST_QUOTIENT: u32 = 16;

/// Finds an invariant density of least degree, and tells which degrees were searched.
///
/// For each degree in turn, it tries 1/P. Here P is a product of `factors` up to degree 12, or any
/// polynomial up to degree `highest`. Then it tries quotients of two products of `factors`.
pub fn measure(
    searched: &SearchField,
    factors: &[Polynomial],
    highest: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> (Option<Measure>, DensitySearch) {
    let mut search = DensitySearch::default();
    let found = |measure: Measure| {
        let search = DensitySearch { seen: Some(measure.degree), none_up_to: None };
        (Some(measure), search)
    };
    let Some(sample) = searched.sample(Modulus::mersenne_61(), random) else { return (None, search) };
    for degree in 0..=highest.max(HIGHEST_PRODUCT) {
        if deadline.passed() {
            break;
        }
        if let Some(factors) = product(searched, factors, degree, &[-1], random) {
            return found(Measure { factors, degree });
        }
        if degree > highest {
            continue;
        }
        let Some(space) = measure_space(&sample.map, degree, random, deadline) else { break };
        if space.dimension() > 0 {
            let measure = reconstructed(searched, &sample.map, &space, degree, random, deadline);
            return (measure, DensitySearch { seen: Some(degree), none_up_to: None });
        }
        search.none_up_to = Some(degree);
    }
    let quotient = (0..=HIGHEST_QUOTIENT).find_map(|degree| {
        let factors = product(searched, factors, degree, &[-1, 1], random)?;
        Some(Measure { factors, degree })
    });
    quotient.map_or((None, search), found)
}

fn reconstructed(
    searched: &SearchField,
    map: &ModularMap,
    space: &PolynomialSpace,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Measure> {
    let monomials = Monomials::new(searched.dimension(), degree);
    let simplest = (0..space.dimension()).min_by_key(|&index| space.terms(index))?;
    let places = space.form.support.iter().zip(&space.rows[simplest]).filter(|(_, value)| **value != 0);
    let support: Vec<usize> = places.map(|(&index, _)| index).collect();
    let is_unique = null_vectors(map, &monomials, &support, random, deadline)?.len() == 1;
    let (form, row) =
        if is_unique { (Form { support, pivots: vec![0] }, 0) } else { (space.form.clone(), simplest) };
    let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
        let map = searched.at(modulus, unknowns)?;
        let vectors = null_vectors(&map, &monomials, &form.support, random, deadline)?;
        PolynomialSpace::of_form(&modulus, &form, vectors)
    };
    let symbols = searched.family().symbols();
    let polynomials =
        reconstruct_space(&FormulaVariables::of(searched), &monomials, &form, at, random, deadline)?;
    Some(Measure { factors: vec![(primitive_in_states(symbols, &polynomials[row]), -1)], degree })
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::{lexer, read};

    #[test]
    fn a_density_may_be_a_quotient_of_factors() {
        let field = read(&lexer::lex("xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;").tokens)
            .system()
            .expect("a system")
            .field;
        let searched = SearchField::new(&field, None);
        let symbols = &field.symbols;
        let variable = Polynomial::variable;
        let (x, y, eps) =
            (variable(symbols.state(0)), variable(symbols.state(1)), variable(symbols.epsilon()));
        let square = |polynomial: &Polynomial| polynomial * polynomial;
        let long = &(&square(&y) * &y) * &(Polynomial::one() - &square(&eps) * &square(&x));
        let factors = [long.clone(), y.clone()];
        let far = Deadline::never();
        let found = measure(&searched, &factors, 2, &mut SplitMix64::new(1), &far);
        assert_eq!(found.0, Some(Measure { factors: vec![(long, -1), (y, 1)], degree: 6 }));
    }
}
