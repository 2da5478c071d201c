//! Invariant Poisson brackets with polynomial entries, of any rank.
//!
//! A bracket {xᵢ, xⱼ} = Pᵢⱼ(x) is invariant where J P(x) Jᵀ = P(x̃) with J = ∂x̃/∂x, which is
//! linear in the coefficients of P. Jacobi's identity is quadratic in them: where the invariant
//! tensors form a space of more than one dimension, the elements of a reduced basis and the sums of
//! two of them are tried.

use std::cmp::Reverse;

use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::system::upper_index;

use crate::darboux::random_step;
use crate::deadline::Deadline;
use crate::map::ModularMap;
use crate::matrix::{Echelon, SPARE};
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::reconstruct::reconstruct;
use crate::relations::{gradient, monomial_gradients};
use crate::search_field::SearchField;
use crate::space::{Form, Space, combination, over_common};
use crate::stepping::Stepping;

/// The highest degree of the entries, and the most coefficients of all of them.
const HIGHEST_DEGREE: u32 = 4;
const MOST_COEFFICIENTS: usize = 600;

/// The most coefficients up to degree 2: those in eight variables.
const MOST_QUADRATIC_COEFFICIENTS: usize = 1300;

/// The most sums of two basis elements that are tried.
const MOST_SUMS: usize = 100;

/// The most tensors that are given.
const MOST_TENSORS: usize = 3;

/// The monomials of the entries above the diagonal; coefficient m·pairs + k belongs to monomial m
/// of entry k.
struct Shape {
    monomials: Monomials,
    /// The places (i, j) above the diagonal, row by row.
    pairs: Vec<(usize, usize)>,
}

/// The tensor of an invariant bracket.
#[derive(Clone, Debug)]
pub(crate) struct PoissonTensor {
    /// Its rank at a general point.
    pub(crate) rank: usize,
    /// The entries above the diagonal, row by row.
    pub(crate) entries: Vec<Polynomial>,
}

impl PoissonTensor {
    /// The Pfaffian of a tensor of full rank: 1/Pf(P) is an invariant density. `None` for a lower
    /// rank, and beyond the budget.
    pub(crate) fn pfaffian(&self, n: usize, budget: &mut Budget) -> Option<Polynomial> {
        (self.rank == n).then(|| self.pfaffian_of(n, &(0..n).collect::<Vec<_>>(), budget))?
    }

    /// The Pfaffian of the rows and columns of these indices, by expansion along the first row.
    fn pfaffian_of(&self, n: usize, indices: &[usize], budget: &mut Budget) -> Option<Polynomial> {
        let Some((&first, others)) = indices.split_first() else { return Some(Polynomial::one()) };
        let mut sum = Polynomial::zero();
        for (place, &other) in others.iter().enumerate() {
            let entry = &self.entries[upper_index(n, first, other)];
            if entry.is_zero() {
                continue;
            }
            let left: Vec<usize> = others.iter().copied().filter(|&index| index != other).collect();
            let term = entry.mul_within(&self.pfaffian_of(n, &left, budget)?, budget).ok()?;
            sum = if place % 2 == 0 { sum + term } else { sum - term };
        }
        Some(sum)
    }
}

/// A bracket modulo a prime: its rank at a general point, and its coefficients.
struct Candidate {
    rank: usize,
    coefficients: Vec<u64>,
}

/// Returns at most three independent invariant brackets, all of the least degree that has one. The
/// highest rank comes first, and among equal ranks the fewest terms. The degree is at most 4, and
/// all entries together have at most 600 coefficients, or 1300 up to degree 2. The list is empty if
/// no bracket is found before the deadline.
pub(crate) fn polynomial_tensors(
    searched: &SearchField,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<PoissonTensor> {
    let n = searched.dimension();
    let Some(sample) = searched.sample(Modulus::mersenne_61(), random) else { return Vec::new() };
    for degree in 0..=HIGHEST_DEGREE {
        let shape = Shape::new(n, degree);
        if shape.len() > if degree > 2 { MOST_COEFFICIENTS } else { MOST_QUADRATIC_COEFFICIENTS } {
            break;
        }
        let all: Vec<usize> = (0..shape.len()).collect();
        let Some(vectors) = shape.invariant(&sample.map, &all, random, deadline) else { break };
        let space = Space::spanned(sample.map.modulus(), vectors);
        let chosen = shape.chosen(&sample.map, &space, random);
        if !chosen.is_empty() {
            let over_the_rationals =
                |candidate: Candidate| shape.reconstructed(searched, &candidate, random, deadline);
            return chosen.into_iter().filter_map(over_the_rationals).collect();
        }
    }
    Vec::new()
}

impl Shape {
    fn new(n: usize, degree: u32) -> Self {
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect();
        Shape { monomials: Monomials::new(n, degree), pairs }
    }

    /// The number of coefficients.
    fn len(&self) -> usize {
        self.monomials.len() * self.pairs.len()
    }

    /// A basis of the tensors with coefficients at the places of `support` that the map keeps;
    /// `None` where the map has no value, or the deadline passes.
    fn invariant(
        &self,
        map: &ModularMap,
        support: &[usize],
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Vec<Vec<u64>>> {
        let modulus = map.modulus();
        let mut rows = Vec::new();
        while rows.len() < support.len() + SPARE {
            let (point, step) = random_step(map, random)?;
            let jacobian = map.jacobian(&point, &step.next)?;
            let (here, there) =
                (self.monomials.values(modulus, &point), self.monomials.values(modulus, &step.next));
            let minor = |(i, j): (usize, usize), (a, b): (usize, usize)| {
                let (left, right) = (
                    modulus.times(jacobian[i][a], jacobian[j][b]),
                    modulus.times(jacobian[i][b], jacobian[j][a]),
                );
                modulus.minus(left, right)
            };
            for (row, &entry) in self.pairs.iter().enumerate() {
                let coefficient = |&place: &usize| {
                    let (monomial, pair) = (place / self.pairs.len(), place % self.pairs.len());
                    let moved = modulus.times(minor(entry, self.pairs[pair]), here[monomial]);
                    if pair == row { modulus.minus(moved, there[monomial]) } else { moved }
                };
                rows.push(support.iter().map(coefficient).collect());
            }
        }
        Echelon::null_vectors(modulus, rows, support.len(), deadline)
    }

    /// Independent brackets among the elements of a space, the highest rank and the fewest terms
    /// first.
    fn chosen(&self, map: &ModularMap, space: &Space, random: &mut SplitMix64) -> Vec<Candidate> {
        let modulus = map.modulus();
        let elements: Vec<Vec<u64>> =
            (0..space.dimension()).map(|index| space.element(index, self.len())).collect();
        let sum = |a: &[u64], b: &[u64]| a.iter().zip(b).map(|(a, b)| modulus.plus(*a, *b)).collect();
        let pairs = (0..elements.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
        let sums: Vec<Vec<u64>> =
            pairs.take(MOST_SUMS).map(|(a, b)| sum(&elements[a], &elements[b])).collect();
        let points = [map.point(random), map.point(random)];
        let mut found: Vec<Candidate> = Vec::new();
        for coefficients in elements.into_iter().chain(sums) {
            let tensors: Vec<Tensor> =
                points.iter().map(|point| self.tensor(modulus, &coefficients, point)).collect();
            if tensors.iter().all(|tensor| tensor.satisfies_jacobi(modulus)) {
                found.push(Candidate { rank: tensors[0].rank(modulus), coefficients });
            }
        }
        found.sort_by_key(|candidate| (Reverse(candidate.rank), terms(&candidate.coefficients)));
        let mut rows = Vec::new();
        found.retain(|candidate| {
            rows.push(candidate.coefficients.clone());
            let is_independent = Echelon::of(modulus, rows.clone(), self.len()).rank() == rows.len();
            if !is_independent {
                rows.pop();
            }
            is_independent && rows.len() <= MOST_TENSORS
        });
        found
    }

    /// The tensor and its derivatives at a point.
    fn tensor(&self, modulus: &Modulus, coefficients: &[u64], point: &[u64]) -> Tensor {
        let n = point.len();
        let values = self.monomials.values(modulus, point);
        let slopes = monomial_gradients(modulus, &self.monomials, point);
        let mut tensor = Tensor { entries: vec![vec![0; n]; n], slopes: vec![vec![vec![0; n]; n]; n] };
        for (pair, &(i, j)) in self.pairs.iter().enumerate() {
            let own: Vec<u64> = coefficients.iter().skip(pair).step_by(self.pairs.len()).copied().collect();
            let products = own.iter().zip(&values).map(|(a, b)| modulus.times(*a, *b));
            let value = products.fold(0, |sum, product| modulus.plus(sum, product));
            let slope = gradient(modulus, &slopes, &own);
            tensor.entries[i][j] = value;
            tensor.entries[j][i] = modulus.opposite(value);
            tensor.slopes[j][i] = slope.iter().map(|value| modulus.opposite(*value)).collect();
            tensor.slopes[i][j] = slope;
        }
        tensor
    }

    /// The entries over ℚ with all unknowns, with coprime integer coefficients.
    fn reconstructed(
        &self,
        searched: &SearchField,
        candidate: &Candidate,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<PoissonTensor> {
        let support: Vec<usize> =
            (0..self.len()).filter(|&place| candidate.coefficients[place] != 0).collect();
        // The candidate is the only tensor on its support, or it is left out.
        let form = Form { support: support.clone(), pivots: vec![0] };
        let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let map = searched.at(modulus, unknowns)?;
            let vectors = self.invariant(&map, &support, random, deadline)?;
            Some(Space::of_form(&modulus, &form, vectors)?.rows.concat())
        };
        let entries = reconstruct(&mut oracle, &searched.unknown_variables(), random, deadline)?;
        let (coefficients, _) = over_common(&entries);
        let symbols = searched.family().symbols();
        let states: Vec<_> = (0..searched.dimension()).map(|i| symbols.state(i)).collect();
        let entry = |pair: usize| {
            let own: Vec<usize> =
                (0..support.len()).filter(|&k| support[k] % self.pairs.len() == pair).collect();
            let monomials: Vec<usize> = own.iter().map(|&k| support[k] / self.pairs.len()).collect();
            let factors: Vec<_> = own.iter().map(|&k| coefficients[k].clone()).collect();
            combination(&states, &self.monomials, &monomials, &factors)
        };
        let entries = (0..self.pairs.len()).map(entry).collect();
        Some(PoissonTensor { rank: candidate.rank, entries })
    }
}

/// The number of coefficients that are not zero.
fn terms(coefficients: &[u64]) -> usize {
    coefficients.iter().filter(|&&value| value != 0).count()
}

/// An antisymmetric tensor at a point modulo a prime.
struct Tensor {
    entries: Vec<Vec<u64>>,
    /// The gradient of each entry.
    slopes: Vec<Vec<Vec<u64>>>,
}

impl Tensor {
    fn rank(&self, modulus: &Modulus) -> usize {
        Echelon::of(modulus, self.entries.clone(), self.entries.len()).rank()
    }

    /// Whether Σₗ Pᵢₗ ∂ₗPⱼₖ, summed over the cyclic permutations of (i, j, k), is 0 for all of
    /// them.
    fn satisfies_jacobi(&self, modulus: &Modulus) -> bool {
        let n = self.entries.len();
        let along = |i: usize, j: usize, k: usize| {
            let products = self.entries[i].iter().zip(&self.slopes[j][k]).map(|(a, b)| modulus.times(*a, *b));
            products.fold(0, |sum, product| modulus.plus(sum, product))
        };
        let triples = (0..n).flat_map(|k| (0..k).flat_map(move |j| (0..j).map(move |i| (i, j, k))));
        triples.into_iter().all(|(i, j, k)| {
            let sum = modulus.plus(modulus.plus(along(i, j, k), along(j, k, i)), along(k, i, j));
            sum == 0
        })
    }
}
