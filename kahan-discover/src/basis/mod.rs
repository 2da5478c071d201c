//! Hirota–Kimura bases: sets of monomials with one linear relation along every orbit.
//!
//! The coefficients of the relation are constant along an orbit, so their quotients are integrals
//! of the map (Petrera, Pfadler, Suris, "On integrability of Hirota–Kimura type discretizations",
//! 2011). They are known without a formula: the values of the monomials at as many consecutive
//! points as there are coefficients to solve for give them. Where a formula of an integral has
//! thousands of terms, the basis says the same in one line.
//!
//! `candidates` finds them, [`prove`] proves them, [`Basis::evaluate`] gives the integrals along an
//! orbit in floats, [`Basis::evaluate_exact`] exactly.

mod evaluate;
mod gradients;
mod proof;
#[cfg(test)]
mod tests;

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::hilbert::random_relations;
use crate::matrix::{Echelon, NullVector};
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::relations::Relations;
use crate::setting::{DrawnStep, Setting};
use crate::stepping::Stepping;

pub use evaluate::{BasisError, BasisValues};
pub use proof::prove;

/// Monomials m₀, …, m_r with one relation Σ cₖ mₖ(x) = 0 along every orbit; the cₖ differ from
/// orbit to orbit.
///
/// Normalised by c_b = 1, b the place of the unit, each cₖ is an integral of the map.
///
/// ```
/// use kahan_algebra::rational::Rational;
/// use kahan_discover::Basis;
///
/// // Orbits of ẋ = y, ẏ = −x lie on circles 1 + c₁ y² + c₂ x² = 0; two points determine c₁ = c₂ = −1/25.
/// let monomials = vec![vec![0, 0], vec![0, 2], vec![2, 0]];
/// let basis = Basis { monomials, unit: 0, integrals: vec![1], proof: None };
/// let found = basis.evaluate(&[vec![5.0, 0.0], vec![3.0, 4.0]])?;
/// assert!((found.coefficients[1] + 0.04).abs() <= found.condition * f64::EPSILON);
///
/// let orbit = [[5, 0], [3, 4]].map(|point| point.map(Rational::from).to_vec());
/// assert_eq!(basis.evaluate_exact(&orbit)?[1], Rational::new(-1, 25));
/// # Ok::<(), kahan_discover::basis::BasisError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Basis {
    /// The exponents of the states in each monomial, ascending by degree.
    pub monomials: Vec<Vec<u32>>,
    /// The place of the monomial whose coefficient is 1.
    pub unit: usize,
    /// The places of coefficients that are functionally independent integrals, of each other and of
    /// what was known.
    pub integrals: Vec<usize>,
    /// The number of random points and primes at which the relation was checked so that the error
    /// is below 2⁻¹⁰⁰; `None` where no such number is reasonable, and the basis is only what was
    /// seen.
    pub proof: Option<u32>,
}

impl Basis {
    /// The monomials in the language of `kahan!`, for states of these names.
    #[must_use]
    pub fn monomial_texts(&self, states: &[String]) -> Vec<String> {
        self.monomials.iter().map(|exponents| monomial_text(states, exponents)).collect()
    }

    /// The number of consecutive points of an orbit that determine the coefficients: one less than
    /// there are monomials.
    #[must_use]
    pub fn points(&self) -> usize {
        self.monomials.len() - 1
    }
}

fn monomial_text(states: &[String], exponents: &[u32]) -> String {
    let power = |(name, exponent): (&String, &u32)| match exponent {
        0 => None,
        1 => Some(name.clone()),
        _ => Some(format!("{name}^{exponent}")),
    };
    let powers: Vec<String> = states.iter().zip(exponents).filter_map(power).collect();
    if powers.is_empty() { "1".to_owned() } else { powers.join("*") }
}

/// Of bases found by [`candidates`] those that give, together with integrals whose gradients at
/// `place` are `known`, as many independent integrals as are `wanted`, the shortest first, and none
/// that brings nothing; fewer where they give fewer.
pub(crate) fn completing(
    candidates: &[Basis],
    wanted: usize,
    place: &DrawnStep,
    known: Vec<Vec<u64>>,
    deadline: &Deadline,
) -> Vec<Basis> {
    let mut found = Vec::new();
    let mut gradients = known;
    let map = &place.draw.map;
    let rank = |rows: &[Vec<u64>]| Echelon::of(map.modulus(), rows.to_vec(), map.dimension()).rank();
    for candidate in candidates {
        if rank(&gradients) >= wanted || deadline.passed() {
            break;
        }
        let Some(own) = gradients::of_coefficients(candidate, map, &place.here) else { continue };
        let mut integrals = Vec::new();
        for (coefficient, gradient) in own.into_iter().enumerate() {
            gradients.push(gradient);
            if rank(&gradients) == gradients.len() {
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

/// So many monomials are reduced in two orders only.
const MANY: usize = 250;

/// Sets of monomials up to a degree with one relation, the smallest first, each once; as many as
/// the deadline allows.
///
/// Cost: 2n + 1 echelon forms of N columns, N = C(n + degree, n).
pub(crate) fn candidates(
    setting: &Setting,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Vec<Basis> {
    let monomials = Monomials::new(setting.dimension(), degree);
    let Some(draw) = setting.draw(Modulus::mersenne_61(), random) else { return Vec::new() };
    let Some(relations) = random_relations(&draw.map, &monomials, random, deadline) else {
        return Vec::new();
    };
    let mut found: Vec<Basis> = Vec::new();
    let most = if monomials.len() > MANY { 2 } else { usize::MAX };
    for order in orders(&monomials, setting.dimension()).into_iter().take(most) {
        if deadline.passed() {
            break;
        }
        for vector in reduced_in(draw.map.modulus(), &relations, &order) {
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

/// Orders of the monomials: ascending by degree, with the variables in all rotations, and
/// backwards.
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

/// The relations, each with its highest monomial in this order expressed by others that lead no
/// relation.
fn reduced_in(modulus: &Modulus, relations: &Relations, order: &[usize]) -> Vec<NullVector> {
    // The highest monomials are to lead, so they stand first.
    let permuted = |vector: &NullVector| order.iter().rev().map(|&index| vector.entries[index]).collect();
    let rows = relations.vectors.iter().map(permuted).collect();
    let echelon = Echelon::of(modulus, rows, order.len());
    let restored = |(row, &pivot): (&Vec<u64>, &usize)| {
        let mut entries = vec![0; order.len()];
        for (&index, &value) in order.iter().rev().zip(row) {
            entries[index] = value;
        }
        NullVector { free: order[order.len() - 1 - pivot], entries }
    };
    echelon.rows.iter().zip(&echelon.pivots).map(restored).collect()
}

/// The candidate on these monomials, what divides all of them left out; the constant, else the
/// lowest, is the unit.
fn of_support(monomials: &Monomials, support: &[usize]) -> Option<Basis> {
    let n = monomials.variables();
    if support.len() < 2 {
        return None;
    }
    let exponents: Vec<&[u32]> = support.iter().map(|&index| monomials.exponents(index)).collect();
    // A multiple of a relation says nothing new.
    let is_multiple = (0..n).any(|state| exponents.iter().all(|own| own[state] > 0));
    (!is_multiple).then(|| Basis {
        monomials: exponents.into_iter().map(<[u32]>::to_vec).collect(),
        unit: 0,
        integrals: Vec::new(),
        proof: None,
    })
}
