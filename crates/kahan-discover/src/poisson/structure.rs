//! Structure of the field f: divergence, linear and quadratic integrals, evenness of det(I − t f′).

use kahan_algebra::field::Field;
use kahan_algebra::modified_integrals::{ModifiedIntegral, Rule, modified_integrals};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;

use crate::claims::proved::{Claims, Formula};
use crate::deadline::Deadline;
use crate::integrals::independence::IndependentGradients;
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::matrix::sampled_null_vectors;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::{FormulaVariables, PolynomialSpace, primitive_in_states, reconstruct_space};
use crate::orbits::relations::monomial_gradients;

/// Returns div f = Σ ∂fᵢ/∂xᵢ.
#[must_use]
pub fn divergence(field: &Field) -> RationalFunction {
    field.components.iter().enumerate().fold(RationalFunction::zero(), |sum, (i, component)| {
        &sum + &component.derivative(field.symbols.state(i))
    })
}

/// Returns whether det(I − t f′(x)) is even in t, at three random points modulo a prime.
///
/// If it is even for all x, dx/det A(x,ε) with A = I − ε f′ is an invariant measure. The reason is
/// det ∂x̃/∂x = det A(x̃,−ε)/det A(x,ε).
pub fn is_even(searched: &SearchField, random: &mut SplitMix64) -> bool {
    (0..3).all(|_| {
        let modulus = Modulus::mersenne_61();
        searched.sample(modulus, random).is_some_and(|sample| {
            let (point, t) = (sample.map.point(random), modulus.sample(random));
            sample.map.determinant(&point, t) == sample.map.determinant(&point, modulus.opposite(t))
        })
    })
}

/// The most variables for which the search finds all integrals of degree 2 within seconds.
const FEW_VARIABLES: usize = 10;

/// Integrals P/Q of the map that follow from the field by linear algebra.
#[derive(Default)]
pub(crate) struct IntegralsByRules {
    /// Integrals that are accepted before the search for other integrals.
    pub(crate) at_once: Vec<(Polynomial, Polynomial)>,
    /// Integrals that are accepted only after the search for integrals of their degree. That search
    /// may find equivalent ones with a common denominator.
    pub(crate) later: Vec<(Polynomial, Polynomial)>,
}

/// Returns the integrals of the map by the theorems of [`Rule`], at the fixed ε if there is one.
pub(crate) fn integrals_by_rules(searched: &SearchField, field: &Field) -> IntegralsByRules {
    let has_few = field.dimension() <= FEW_VARIABLES;
    let is_linear = (0..field.dimension()).all(|i| field.homogeneous_part(i, 2).is_zero());
    let is_later = |found: &ModifiedIntegral| {
        has_few
            && (is_linear && field.symbols.degree(&found.of_flow) == 2 || found.rule != Rule::Polarisation)
    };
    let (later, at_once): (Vec<_>, Vec<_>) = modified_integrals(field).into_iter().partition(is_later);
    let sides = |found: ModifiedIntegral| {
        let [above, below] = [found.of_map.numerator(), found.of_map.denominator()];
        (searched.at_eps(above.clone()), searched.at_eps(below.clone()))
    };
    let [at_once, later] = [at_once, later].map(|found| found.into_iter().map(sides).collect());
    IntegralsByRules { at_once, later }
}

impl IntegralsByRules {
    pub(crate) fn proved(
        &self,
        searched: &SearchField,
        claims: &Claims<'_>,
        random: &mut SplitMix64,
    ) -> Vec<Formula> {
        let symbols = searched.family().symbols();
        let mut independent = IndependentGradients::new(searched, random);
        let mut proved: Vec<Formula> = Vec::new();
        for (above, below) in &self.at_once {
            if independent.admits(above, below) {
                let [above, below] = [above, below].map(|side| primitive_in_states(symbols, side));
                if let Some(formula) = claims.integral_by_theorem(symbols, proved.len() + 1, &above, &below) {
                    independent.keep(&above, &below);
                    proved.push(formula);
                }
            }
        }
        proved
    }
}

/// Polynomial integrals of the flow of the field.
#[derive(Clone, Debug, Default)]
pub struct FlowIntegrals {
    /// Independent integrals by ascending degree.
    pub found: Vec<Polynomial>,
    /// The degree up to which the list is complete, perhaps lower than requested.
    pub degree: u32,
}

impl FlowIntegrals {
    /// Returns the integrals of the flow that the map preserves unchanged, as tested at one point
    /// modulo a prime.
    #[must_use]
    pub fn kept(&self, searched: &SearchField, random: &mut SplitMix64) -> Vec<Polynomial> {
        let Some(step) = searched.step(random) else { return Vec::new() };
        self.found.iter().filter(|found| step.keeps(searched, found)).cloned().collect()
    }
}

/// The most monomials of an integral. The cost grows with the cube of their number.
const MOST_MONOMIALS: usize = 900;

/// Finds independent polynomial integrals P of the flow up to a degree from ∇P·f = 0. The equation
/// is solved modulo primes at random parameters.
pub fn flow_integrals(
    searched: &SearchField,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> FlowIntegrals {
    let symbols = searched.family().symbols();
    let mut independent = IndependentGradients::new(searched, random);
    let mut integrals = FlowIntegrals::default();
    for degree in 1..=degree {
        let Some(space) = flow_space(searched, degree, random, deadline) else { break };
        for polynomial in space {
            let polynomial = primitive_in_states(symbols, &polynomial);
            if independent.admits(&polynomial, &Polynomial::one()) {
                independent.keep(&polynomial, &Polynomial::one());
                integrals.found.push(polynomial);
            }
        }
        integrals.degree = degree;
    }
    integrals
}

fn flow_space(
    searched: &SearchField,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<Polynomial>> {
    if Monomials::count(searched.dimension(), degree) > MOST_MONOMIALS {
        return None;
    }
    let monomials = Monomials::new(searched.dimension(), degree);
    let sample = searched.sample(Modulus::mersenne_61(), random)?;
    let all: Vec<usize> = (1..monomials.len()).collect();
    let vectors = flow_null_vectors(&sample.map, &monomials, &all, random, deadline)?;
    if vectors.is_empty() {
        return Some(Vec::new());
    }
    let spread = vectors.into_iter().map(|vector| [vec![0], vector].concat()).collect();
    let form = PolynomialSpace::spanned(sample.map.modulus(), spread).form;
    let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
        let map = searched.at(modulus, unknowns)?;
        let vectors = flow_null_vectors(&map, &monomials, &form.support, random, deadline)?;
        PolynomialSpace::of_form(&modulus, &form, vectors)
    };
    reconstruct_space(&FormulaVariables::of(searched), &monomials, &form, at, random, deadline)
}

fn flow_null_vectors(
    map: &ModularMap,
    monomials: &Monomials,
    support: &[usize],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<Vec<u64>>> {
    let modulus = map.modulus();
    sampled_null_vectors(modulus, support.len(), deadline, || {
        let point = map.point(random);
        let (value, _) = map.field(&point);
        let slopes = monomial_gradients(modulus, monomials, &point);
        Some(support.iter().map(|&index| modulus.dot(&slopes[index], &value)).collect())
    })
}
