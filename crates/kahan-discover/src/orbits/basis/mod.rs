//! Hirota–Kimura bases: sets of monomials with one linear relation along every orbit.
//!
//! The coefficients of the relation are constant along an orbit, so their quotients are integrals
//! (Petrera, Pfadler, Suris, "On integrability of Hirota–Kimura type discretizations", 2011).
//! Values of the monomials at consecutive points determine the coefficients, even where a formula
//! would have thousands of terms. `candidates` finds bases, and [`prove`] proves them.
//! [`Basis::evaluate`] computes the integrals in floats, and [`Basis::evaluate_exact`] exactly.

mod evaluate;
mod gradients;
mod proof;
#[cfg(test)]
mod tests;

use kahan_algebra::poly::{Monomial, Polynomial};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text, push_term};

use crate::deadline::Deadline;
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{SampledStep, SearchField};
use crate::modular::matrix::{Echelon, NullVector};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::spread_to_monomials;
use crate::orbits::hilbert::random_relations;
use crate::orbits::relations::Relations;

pub use evaluate::{BasisError, BasisValues};
pub use proof::prove;

/// A sum Σ fₖmₖ of monomials mₖ with integer factors fₖ, as pairs (index of mₖ, fₖ) sorted by
/// index. The first factor is 1. The relation multiplies the sum by one coefficient.
pub type Term = Vec<(usize, i64)>;

/// Monomials mₖ with one relation Σ cₖ mₖ(x) = 0 along every orbit.
///
/// The coefficients cₖ differ between orbits. They are scaled so that one monomial, the unit, has
/// the coefficient 1. Then each cₖ is an integral of the map. Monomials whose coefficients have
/// constant integer quotients form one term.
///
/// ```
/// use kahan_algebra::rational::Rational;
/// use kahan_discover::Basis;
///
/// // Orbits of ẋ = y, ẏ = −x lie on circles 1 + c₁ y² + c₂ x² = 0; two points determine c₁ = c₂ = −1/25.
/// let monomials = vec![vec![0, 0], vec![0, 2], vec![2, 0]];
/// let terms = vec![vec![(0, 1)], vec![(1, 1)], vec![(2, 1)]];
/// let basis = Basis { monomials, terms, unit: 0, integrals: vec![1], proof: None };
/// let found = basis.evaluate(&[vec![5.0, 0.0], vec![3.0, 4.0]])?;
/// assert!((found.coefficients[1] + 0.04).abs() <= found.condition * f64::EPSILON);
///
/// let orbit = [[5, 0], [3, 4]].map(|point| point.map(Rational::from).to_vec());
/// assert_eq!(basis.evaluate_exact(&orbit)?[1], Rational::new(-1, 25));
///
/// // Joined to 1 + c₁ (y² + x²) = 0, one point is enough.
/// let joined = Basis { terms: vec![vec![(0, 1)], vec![(1, 1), (2, 1)]], ..basis };
/// assert_eq!(joined.evaluate_exact(&orbit[1..])?[2], Rational::new(-1, 25));
/// # Ok::<(), kahan_discover::orbits::basis::BasisError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Basis {
    /// The exponents of the states in each monomial, by ascending degree.
    pub monomials: Vec<Vec<u32>>,
    /// The terms of the relation.
    pub terms: Vec<Term>,
    /// The index of the unit, the monomial with coefficient 1.
    pub unit: usize,
    /// The indices of the coefficients that are independent integrals without a known formula.
    pub integrals: Vec<usize>,
    /// The number of random points at which the relation was checked, each modulo a random prime,
    /// or `None` if the relation was only observed. The probability of an error is below 2⁻¹⁰⁰.
    pub proof: Option<u32>,
}

impl Basis {
    /// Writes the monomials in the language of `kahan!`.
    #[must_use]
    pub fn monomial_texts(&self, states: &[String]) -> Vec<String> {
        self.monomials.iter().map(|exponents| monomial_text(states, exponents, &Text)).collect()
    }

    /// Writes the terms of the relation in the given notation.
    #[must_use]
    pub fn term_texts(&self, states: &[String], notation: &dyn Notation) -> Vec<String> {
        let text = |term: &Term| {
            let mut text = String::new();
            let mut places = term.clone();
            if places.last().is_some_and(|&(_, factor)| factor > 0) {
                places.reverse();
            }
            for (place, factor) in places {
                let size = factor.unsigned_abs();
                let monomial = monomial_text(states, &self.monomials[place], notation);
                let term = if size == 1 { monomial } else { notation.product(&[size.to_string(), monomial]) };
                push_term(&mut text, factor < 0, &term);
            }
            text
        };
        self.terms.iter().map(text).collect()
    }

    /// Writes the relation, for example `c0 + c1*(x^2 + y^2) = 0`, with one coefficient for each
    /// term.
    #[must_use]
    pub fn relation(&self, states: &[String], notation: &dyn Notation) -> String {
        let texts = self.term_texts(states, notation).into_iter();
        let summand = |(number, text): (usize, String)| {
            let text = if self.terms[number].len() > 1 { format!("({text})") } else { text };
            let coefficient = notation.name(&format!("c{number}"));
            if text == "1" { coefficient } else { notation.product(&[coefficient, text]) }
        };
        let summands: Vec<String> = texts.enumerate().map(summand).collect();
        format!("{} = 0", summands.join(" + "))
    }

    /// Returns the index of the term that contains a monomial.
    #[must_use]
    pub fn term_of(&self, place: usize) -> Option<usize> {
        self.terms.iter().position(|term| term.iter().any(|&(own, _)| own == place))
    }

    /// Returns independent integrals as quotients of coefficients: pairs (numerator, denominator)
    /// of terms, numbered as in [`relation`](Self::relation).
    #[must_use]
    pub fn quotients(&self) -> Vec<(usize, usize)> {
        let unit = self.term_of(self.unit);
        let quotients = self.integrals.iter().filter_map(|&place| Some((self.term_of(place)?, unit?)));
        quotients.collect()
    }

    /// Returns the integral t₁/t₀ of a basis with the relation c₀t₀ + c₁t₁ = 0 and at most eight
    /// monomials. Returns `None` for any other basis.
    pub(crate) fn quotient_of_terms(
        &self,
        searched: &SearchField,
        random: &mut SplitMix64,
    ) -> Option<(Polynomial, Polynomial)> {
        if self.monomials.len() > MOST_IN_TWO_TERMS {
            return None;
        }
        let mut joined = self.clone();
        joined.join_terms(searched, random);
        let [below, above] = &joined.terms[..] else { return None };
        let symbols = searched.family().symbols();
        let summand = |&(place, factor): &(usize, i64)| {
            let powers = self.monomials[place].iter().enumerate().map(|(state, &exponent)| {
                Polynomial::term(Monomial::power(symbols.state(state), exponent), Rational::one())
            });
            powers.fold(Polynomial::constant(Rational::from(factor)), |product, power| &product * &power)
        };
        let sum =
            |term: &Term| term.iter().map(summand).fold(Polynomial::zero(), |sum, summand| &sum + &summand);
        Some((sum(above), sum(below)))
    }

    /// Joins monomials into one term if their coefficients have the same integer quotient on three
    /// orbits.
    pub(crate) fn join_terms(&mut self, searched: &SearchField, random: &mut SplitMix64) {
        let mut sampled: Vec<(Modulus, Vec<u64>)> = Vec::new();
        for modulus in [Modulus::mersenne_61(), Modulus::random(random), Modulus::random(random)] {
            let found = searched.sample(modulus, random).and_then(|sample| {
                let start = sample.map.point(random);
                self.coefficients(&sample.map, &start)
            });
            let Some(coefficients) = found else { return };
            sampled.push((modulus, coefficients));
        }
        let factor = |of: usize, at: usize| {
            (1..=LARGEST_FACTOR).flat_map(|size| [size, -size]).find(|&factor| {
                sampled.iter().all(|(modulus, coefficients)| {
                    let size = modulus.integer(factor.unsigned_abs());
                    let signed = if factor < 0 { modulus.opposite(size) } else { size };
                    coefficients[at] == modulus.times(signed, coefficients[of])
                })
            })
        };
        let mut terms: Vec<Term> = Vec::new();
        for place in 0..self.monomials.len() {
            let known = terms.iter_mut().find_map(|term| Some((factor(term[0].0, place)?, term)));
            match known {
                Some((factor, term)) => term.push((place, factor)),
                None => terms.push(vec![(place, 1)]),
            }
        }
        self.terms = terms;
    }

    /// Returns the coefficients of the relation along the orbit of a point, up to a common factor.
    fn coefficients(&self, map: &ModularMap, start: &[u64]) -> Option<Vec<u64>> {
        let modulus = map.modulus();
        let orbit = map.orbit(start.to_vec(), self.monomials.len());
        let values = |point: &Vec<u64>| {
            self.monomials.iter().map(|exponents| modulus.monomial(exponents, point)).collect()
        };
        let rows = orbit.iter().map(values).collect();
        let null = Echelon::of(modulus, rows, self.monomials.len()).null_space(modulus);
        let [only] = &null[..] else { return None };
        Some(only.entries.clone())
    }

    pub(crate) fn gradients(&self, map: &ModularMap, start: &[u64]) -> Option<Vec<Vec<u64>>> {
        let all = gradients::of_coefficients(self, map, start)?;
        Some(self.integrals.iter().map(|&place| all[place].clone()).collect())
    }

    /// Returns the number of consecutive points that determine the coefficients.
    #[must_use]
    pub fn points(&self) -> usize {
        self.terms.len() - 1
    }
}

const MOST_IN_TWO_TERMS: usize = 8;

const LARGEST_FACTOR: i64 = 4;

fn monomial_text(states: &[String], exponents: &[u32], notation: &dyn Notation) -> String {
    let powers: Vec<String> = states
        .iter()
        .zip(exponents)
        .filter(|(_, exponent)| **exponent > 0)
        .map(|(name, exponent)| notation.power(&notation.name(name), i64::from(*exponent)))
        .collect();
    if powers.is_empty() { "1".to_owned() } else { notation.product(&powers) }
}

/// Takes `candidates` in order until `wanted` integrals are independent. `gradients` holds the
/// gradients of known integrals at the point `place`, and receives those of new ones.
pub(crate) fn choose_bases(
    candidates: &[Basis],
    wanted: usize,
    place: &SampledStep,
    gradients: &mut Vec<Vec<u64>>,
    deadline: &Deadline<'_>,
) -> Vec<Basis> {
    let mut found = Vec::new();
    let map = &place.sample.map;
    let rank = |rows: &[Vec<u64>]| Echelon::of(map.modulus(), rows.to_vec(), map.dimension()).rank();
    for candidate in candidates {
        if rank(gradients) >= wanted || deadline.passed() {
            break;
        }
        let Some(own) = gradients::of_coefficients(candidate, map, &place.here) else { continue };
        let mut integrals = Vec::new();
        for (coefficient, gradient) in own.into_iter().enumerate() {
            gradients.push(gradient);
            if rank(gradients) == gradients.len() {
                integrals.push(coefficient);
            } else {
                gradients.pop();
            }
        }
        if !integrals.is_empty() {
            found.push(Basis { integrals, ..candidate.clone() });
        }
    }
    found
}

/// The number of monomials above which only two orders of the variables are tried.
const MANY_MONOMIALS: usize = 250;

/// Returns sets of monomials up to a degree with one relation along an orbit, the smallest first.
/// In n variables the cost is 2n + 1 echelon forms of N columns, where N = C(n + degree, n).
pub(crate) fn candidates(
    searched: &SearchField,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<Basis> {
    let monomials = Monomials::new(searched.dimension(), degree);
    let Some(sample) = searched.sample(Modulus::mersenne_61(), random) else { return Vec::new() };
    let Some(relations) = random_relations(&sample.map, &monomials, random, deadline) else {
        return Vec::new();
    };
    let mut found: Vec<Basis> = Vec::new();
    let most = if monomials.len() > MANY_MONOMIALS { 2 } else { usize::MAX };
    for order in orders(&monomials, searched.dimension()).into_iter().take(most) {
        if deadline.passed() {
            break;
        }
        let Some(vectors) = reduced_in(sample.map.modulus(), &relations, &order, deadline) else { break };
        for vector in vectors {
            let support: Vec<usize> =
                (0..monomials.len()).filter(|&index| vector.entries[index] != 0).collect();
            let Some(candidate) = of_support(&monomials, &support) else { continue };
            if !found.iter().any(|known| known.monomials == candidate.monomials) {
                found.push(candidate);
            }
        }
    }
    found.sort_by_key(|basis| (basis.monomials.len(), basis.monomials.last().map(|m| m.iter().sum::<u32>())));
    found
}

/// Returns orders of the monomials, by degree and then lexicographically, for every cyclic order of
/// the variables and its reverse.
fn orders(monomials: &Monomials, n: usize) -> Vec<Vec<usize>> {
    let mut orders = Vec::new();
    for shift in 0..n {
        for is_backward in [false, true] {
            let key = |&index: &usize| {
                let exponents = monomials.exponents(index);
                let mut rotated: Vec<u32> = (0..n).map(|i| exponents[(i + shift) % n]).collect();
                if is_backward {
                    rotated.reverse();
                }
                (exponents.iter().sum::<u32>(), rotated)
            };
            let mut order: Vec<usize> = (0..monomials.len()).collect();
            order.sort_by_key(key);
            orders.push(order);
        }
    }
    orders
}

/// Reduces the relations. The leading monomial of each is the one that comes last in `order`.
fn reduced_in(
    modulus: &Modulus,
    relations: &Relations,
    order: &[usize],
    deadline: &Deadline<'_>,
) -> Option<Vec<NullVector>> {
    let permuted = |vector: &NullVector| order.iter().rev().map(|&index| vector.entries[index]).collect();
    let rows = relations.vectors.iter().map(permuted).collect();
    let echelon = Echelon::within(modulus, rows, order.len(), deadline)?;
    let restored = |(row, &pivot): (&Vec<u64>, &usize)| NullVector {
        free: order[order.len() - 1 - pivot],
        entries: spread_to_monomials(order.iter().rev(), row, order.len()),
    };
    Some(echelon.rows.iter().zip(&echelon.pivots).map(restored).collect())
}

/// Returns the basis of these monomials, with coefficient 1 for the lowest one. Returns `None` if a
/// state divides all monomials, because the quotients give a basis of lower degree.
fn of_support(monomials: &Monomials, support: &[usize]) -> Option<Basis> {
    let n = monomials.variables();
    if support.len() < 2 {
        return None;
    }
    let exponents: Vec<&[u32]> = support.iter().map(|&index| monomials.exponents(index)).collect();
    let is_multiple = (0..n).any(|state| exponents.iter().all(|own| own[state] > 0));
    (!is_multiple).then(|| Basis {
        monomials: exponents.into_iter().map(<[u32]>::to_vec).collect(),
        terms: (0..support.len()).map(|place| vec![(place, 1)]).collect(),
        unit: 0,
        integrals: Vec::new(),
        proof: None,
    })
}
