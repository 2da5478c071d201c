//! Invariant Poisson brackets with polynomial entries, of any rank.
//!
//! A bracket {xᵢ, xⱼ} = Pᵢⱼ(x) is invariant if J P(x) Jᵀ = P(x̃) for J = ∂x̃/∂x. This condition is
//! linear in the coefficients of P, and Jacobi's identity is quadratic. If elements of a basis and
//! sums of two of them satisfy Jacobi's identity, so do all linear combinations. A sum may have a
//! higher rank than its summands. The search ends with the degree of the first new bracket of full
//! rank, and with degree 4 at the latest.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use kahan_algebra::poly::{Budget, Polynomial, gcd_all_within};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::upper_index;

use crate::deadline::Deadline;
use crate::densities::darboux::random_step;
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::grading::{Grading, reconstruct_graded};
use crate::modular::matrix::{Echelon, SPARE_EQUATIONS};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::{Form, PolynomialSpace, combination};
use crate::orbits::relations::{gradient, monomial_gradients};

/// The highest degree of the entries of a bracket.
const HIGHEST_DEGREE: u32 = 4;
/// The most coefficients of all entries together.
const MOST_COEFFICIENTS: usize = 600;

/// The most coefficients of all entries together up to degree 2, enough for eight variables.
const MOST_QUADRATIC_COEFFICIENTS: usize = 1300;

/// The search ends with this degree of entries if a bracket of full rank is already known.
const HIGHEST_BESIDE: u32 = 1;

/// The number of points at which tensors are compared and Jacobi's identity is checked.
const CHECK_POINTS: usize = 3;

/// Sums of basis elements are tried only if the basis has at most this many elements.
const MOST_ELEMENTS: usize = 40;

const MOST_TENSORS: usize = 4;

/// The monomials of the entries, and the index pairs (i, j) of the entries above the diagonal. The
/// coefficient of monomial m in the entry of pair k has the index m·pairs.len() + k.
struct TensorMonomials {
    monomials: Monomials,
    pairs: Vec<(usize, usize)>,
}

#[derive(Clone, Debug)]
pub(crate) struct PoissonTensor {
    pub(crate) rank: usize,
    pub(crate) entries: Vec<Polynomial>,
    /// The index of K among the matrices found with f = K∇H, if the tensor is (I − ε² f′²)K.
    pub(crate) structure: Option<usize>,
    /// Whether printed brackets imply this one, so that it is not printed.
    pub(crate) is_implied: bool,
}

impl PoissonTensor {
    /// Returns a polynomial p such that 1/p is a candidate for an invariant density, if the rank is
    /// full.
    ///
    /// In even dimension p is the Pfaffian of the tensor. In odd dimension let pᵢ be the Pfaffian
    /// of the tensor without row and column i. The pᵢ are, up to signs, the gradient of a
    /// polynomial Casimir function times a common factor, and p is their greatest common divisor.
    pub(crate) fn pfaffian(&self, n: usize, budget: &mut Budget) -> Option<Polynomial> {
        let all: Vec<usize> = (0..n).collect();
        if n.is_multiple_of(2) {
            return (self.rank == n).then(|| self.pfaffian_of(n, &all, budget))?;
        }
        if self.rank + 1 < n {
            return None;
        }
        let mut minors = Vec::with_capacity(n);
        for left_out in 0..n {
            let kept: Vec<usize> = all.iter().copied().filter(|&index| index != left_out).collect();
            minors.push(self.pfaffian_of(n, &kept, budget)?);
        }
        gcd_all_within(&minors, budget).ok()
    }

    /// Returns the Pfaffian of these rows and columns, by expansion along the first row.
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

struct Candidate {
    rank: usize,
    source: Source,
    values: Vec<u64>,
}

enum Source {
    Known(PoissonTensor),
    /// A sum of basis elements: the degree of its entries, and the coefficients of each summand.
    Sum(u32, Vec<Vec<u64>>),
}

impl Candidate {
    fn terms(&self, symbols: &Symbols) -> usize {
        let of_states = |entry: &Polynomial| {
            let monomials = entry.terms().map(|(monomial, _)| {
                (0..symbols.dimension()).map(|i| monomial.exponent(symbols.state(i))).collect::<Vec<_>>()
            });
            monomials.collect::<BTreeSet<_>>().len()
        };
        match &self.source {
            Source::Known(tensor) => tensor.entries.iter().map(of_states).sum(),
            Source::Sum(_, parts) => parts.iter().flatten().filter(|&&value| value != 0).count(),
        }
    }
}

/// Finds up to four brackets: independent brackets of the highest rank, and one bracket of each
/// lower rank. Entries have degrees up to `highest`, at most 4. The brackets in `known` are
/// candidates, too. Brackets of `known` that are not chosen are appended, and marked as implied.
///
/// The search ends at the first degree with a bracket of full rank, at the deadline, or if entries
/// need more than 600 coefficients (1300 up to degree 2).
pub(crate) fn polynomial_tensors(
    searched: &SearchField,
    known: Vec<PoissonTensor>,
    highest: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<PoissonTensor> {
    let n = searched.dimension();
    let Some(sample) = searched.sample(Modulus::mersenne_61(), random) else { return Vec::new() };
    let Some(place) = sample.step(random) else { return Vec::new() };
    let map = &place.sample.map;
    let points: [Vec<u64>; CHECK_POINTS] = std::array::from_fn(|_| map.point(random));
    let is_full = |rank: usize| rank + 1 >= n;
    let is_known = known.iter().any(|tensor| is_full(tensor.rank));
    let mut found: Vec<Candidate> = Vec::new();
    let mut dimension = 0;
    for degree in 0..=highest.min(if is_known { HIGHEST_BESIDE } else { HIGHEST_DEGREE }) {
        let shape = TensorMonomials::new(n, degree);
        if shape.len() > if degree > 2 { MOST_COEFFICIENTS } else { MOST_QUADRATIC_COEFFICIENTS } {
            break;
        }
        let all: Vec<usize> = (0..shape.len()).collect();
        let Some(vectors) = shape.invariant(map, &all, random, deadline) else { break };
        if vectors.len() > dimension {
            dimension = vectors.len();
            let space = PolynomialSpace::spanned(map.modulus(), vectors);
            let best = found.first().map_or(0, |candidate| candidate.rank);
            let mut higher = shape.higher(map, &points, &space, best, random);
            higher.append(&mut found);
            found = higher;
        }
        if found.first().is_some_and(|candidate| is_full(candidate.rank)) {
            break;
        }
    }
    let candidate = |tensor: &PoissonTensor| {
        let matrices = points.iter().map(|point| tensor.at(searched, &place, point));
        let values = matrices.collect::<Option<Vec<_>>>()?.iter().flat_map(|matrix| above(matrix)).collect();
        Some(Candidate { rank: tensor.rank, source: Source::Known(tensor.clone()), values })
    };
    found.extend(known.iter().filter_map(candidate));
    let symbols = searched.family().symbols();
    let is_known = |candidate: &Candidate| matches!(candidate.source, Source::Known(_));
    let least = found.iter().filter(|one| is_known(one)).map(|one| one.terms(symbols)).min();
    found.sort_by_cached_key(|candidate| {
        let terms = candidate.terms(symbols);
        let class = match &candidate.source {
            Source::Sum(_, parts) if parts.len() > 1 && least.is_some_and(|least| terms <= least) => 0,
            Source::Known(_) => 1,
            Source::Sum(..) => 2,
        };
        (Reverse(candidate.rank), class, terms)
    });
    let chosen = select_by_rank(map.modulus(), found);
    // Several sums may contain one basis element, so reconstructed elements are stored.
    let mut known_parts: Vec<(Vec<u64>, Option<Vec<Polynomial>>)> = Vec::new();
    let mut over_the_rationals = |Candidate { rank, source, .. }: Candidate| {
        let (degree, parts) = match source {
            Source::Known(tensor) => return Some(tensor),
            Source::Sum(degree, parts) => (degree, parts),
        };
        let shape = TensorMonomials::new(n, degree);
        let mut entries = vec![Polynomial::zero(); shape.pairs.len()];
        for part in parts {
            let known = known_parts.iter().find(|(known, _)| *known == part).map(|(_, own)| own.clone());
            let own = known.unwrap_or_else(|| {
                let own = shape.reconstructed(searched, &part, random, deadline);
                known_parts.push((part, own.clone()));
                own
            });
            entries = entries.into_iter().zip(own?).map(|(sum, own)| sum + own).collect();
        }
        let mut tensor = PoissonTensor { rank, entries, structure: None, is_implied: false };
        // Each summand was scaled separately to coprime integers. This changes the sum, so the rank
        // is computed again.
        let matrix = tensor.at(searched, &place, &points[0])?;
        tensor.rank = Echelon::of(map.modulus(), matrix, n).rank();
        Some(tensor)
    };
    let mut all: Vec<PoissonTensor> = chosen.into_iter().filter_map(&mut over_the_rationals).collect();
    let is_new = |tensor: &PoissonTensor| all.iter().all(|chosen| chosen.structure != tensor.structure);
    let implied: Vec<PoissonTensor> = known.into_iter().filter(is_new).collect();
    all.extend(implied.into_iter().map(|tensor| PoissonTensor { is_implied: true, ..tensor }));
    all
}

/// Chooses independent brackets of the highest rank, then the first bracket of each lower rank.
fn select_by_rank(modulus: &Modulus, found: Vec<Candidate>) -> Vec<Candidate> {
    let highest = found.first().map_or(0, |candidate| candidate.rank);
    let mut last = None;
    let (mut chosen, others): (Vec<Candidate>, Vec<Candidate>) =
        found.into_iter().partition(|candidate| last.replace(candidate.rank) != Some(candidate.rank));
    for candidate in others.into_iter().take_while(|candidate| candidate.rank == highest) {
        let mut rows: Vec<Vec<u64>> = chosen.iter().map(|chosen| chosen.values.clone()).collect();
        let rank = Echelon::of(modulus, rows.clone(), candidate.values.len()).rank();
        rows.push(candidate.values.clone());
        if Echelon::of(modulus, rows, candidate.values.len()).rank() > rank {
            chosen.push(candidate);
        }
    }
    chosen.sort_by_key(|candidate| Reverse(candidate.rank));
    chosen.truncate(MOST_TENSORS);
    chosen
}

fn above(matrix: &[Vec<u64>]) -> impl Iterator<Item = u64> {
    matrix.iter().enumerate().flat_map(|(i, row)| row[i + 1..].iter().copied())
}

impl TensorMonomials {
    fn new(n: usize, degree: u32) -> Self {
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect();
        TensorMonomials { monomials: Monomials::new(n, degree), pairs }
    }

    fn len(&self) -> usize {
        self.monomials.len() * self.pairs.len()
    }

    /// Returns a basis of the invariant tensors whose nonzero coefficients lie in `support`.
    fn invariant(
        &self,
        map: &ModularMap,
        support: &[usize],
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Vec<Vec<u64>>> {
        let modulus = map.modulus();
        let mut rows = Vec::new();
        while rows.len() < support.len() + SPARE_EQUATIONS {
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

    /// Returns basis elements and sums of them that are brackets of a rank above `best`. Those of
    /// the highest rank come first.
    fn higher(
        &self,
        map: &ModularMap,
        points: &[Vec<u64>; CHECK_POINTS],
        space: &PolynomialSpace,
        best: usize,
        random: &mut SplitMix64,
    ) -> Vec<Candidate> {
        let modulus = map.modulus();
        let places = points.each_ref().map(|point| TensorPoint::at(self, modulus, point));
        let mut generic = vec![0; self.len()];
        for index in 0..space.dimension() {
            let factor = modulus.sample(random);
            for (sum, own) in generic.iter_mut().zip(space.element(index, self.len())) {
                *sum = modulus.plus(*sum, modulus.times(factor, own));
            }
        }
        if self.tensor(modulus, &generic, &places[0]).rank(modulus) <= best {
            return Vec::new();
        }
        let mut elements: Vec<Element> = (0..space.dimension())
            .map(|index| space.element(index, self.len()))
            .filter_map(|part| {
                let tensors = places.each_ref().map(|place| self.tensor(modulus, &part, place));
                tensors.iter().all(|tensor| tensor.satisfies_jacobi(modulus)).then(|| Element {
                    rank: tensors[0].rank(modulus),
                    terms: part.iter().filter(|&&value| value != 0).count(),
                    part,
                    tensors,
                })
            })
            .collect();
        elements.sort_by_key(|element| (Reverse(element.rank), element.terms));
        elements.truncate(MOST_ELEMENTS);
        let candidate = |rank: usize, chosen: &[&Element], sums: &[Tensor; CHECK_POINTS]| {
            let parts = chosen.iter().map(|element| element.part.clone()).collect();
            let values = sums.iter().flat_map(|sum| above(&sum.entries)).collect();
            Candidate { rank, source: Source::Sum(self.monomials.degree(), parts), values }
        };
        let are_compatible = |one: &Element, other: &Element| {
            let mut sums = one.tensors.iter().zip(&other.tensors).map(|(a, b)| a.plus(modulus, b));
            sums.all(|sum| sum.satisfies_jacobi(modulus))
        };
        let mut found: Vec<Candidate> = Vec::new();
        for (index, first) in elements.iter().enumerate() {
            let mut chosen = vec![first];
            let mut sums = first.tensors.clone();
            let mut rank = first.rank;
            found.push(candidate(rank, &chosen, &sums));
            // Linear combinations of brackets are brackets if all sums of two of them are brackets.
            for other in &elements[index + 1..] {
                let next: [Tensor; CHECK_POINTS] =
                    std::array::from_fn(|k| sums[k].plus(modulus, &other.tensors[k]));
                let higher = next[0].rank(modulus);
                if higher > rank && chosen.iter().all(|one| are_compatible(one, other)) {
                    (rank, sums) = (higher, next);
                    chosen.push(other);
                    found.push(candidate(rank, &chosen, &sums));
                }
            }
        }
        found.retain(|candidate| candidate.rank > best);
        found.sort_by_key(|candidate| Reverse(candidate.rank));
        found
    }

    fn tensor(&self, modulus: &Modulus, coefficients: &[u64], place: &TensorPoint) -> Tensor {
        let n = place.slopes[0].len();
        let mut tensor = Tensor { entries: vec![vec![0; n]; n], slopes: vec![vec![vec![0; n]; n]; n] };
        for (pair, &(i, j)) in self.pairs.iter().enumerate() {
            let own: Vec<u64> = coefficients.iter().skip(pair).step_by(self.pairs.len()).copied().collect();
            let value = modulus.dot(&own, &place.values);
            let slope = gradient(modulus, &place.slopes, &own);
            tensor.entries[i][j] = value;
            tensor.entries[j][i] = modulus.opposite(value);
            tensor.slopes[j][i] = slope.iter().map(|value| modulus.opposite(*value)).collect();
            tensor.slopes[i][j] = slope;
        }
        tensor
    }

    fn reconstructed(
        &self,
        searched: &SearchField,
        part: &[u64],
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Vec<Polynomial>> {
        let support: Vec<usize> = (0..self.len()).filter(|&place| part[place] != 0).collect();
        // Only multiples of `part` have this support, because `part` belongs to a reduced basis.
        let form = Form { support: support.clone(), pivots: vec![0] };
        let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let map = searched.at(modulus, unknowns)?;
            let vectors = self.invariant(&map, &support, random, deadline)?;
            Some(PolynomialSpace::of_form(&modulus, &form, vectors)?.rows.concat())
        };
        let grading = self.grading(searched, &support);
        let unknowns = searched.unknown_variables();
        let entries = reconstruct_graded(&mut oracle, &unknowns, &grading, random, deadline)?;
        let (coefficients, _) = RationalFunction::over_common(&entries);
        let symbols = searched.family().symbols();
        let states: Vec<_> = (0..searched.dimension()).map(|i| symbols.state(i)).collect();
        let entry = |pair: usize| {
            let own: Vec<usize> =
                (0..support.len()).filter(|&k| support[k] % self.pairs.len() == pair).collect();
            let monomials: Vec<usize> = own.iter().map(|&k| support[k] / self.pairs.len()).collect();
            let factors: Vec<_> = own.iter().map(|&k| coefficients[k].clone()).collect();
            combination(&states, &self.monomials, &monomials, &factors)
        };
        Some((0..self.pairs.len()).map(entry).collect())
    }

    /// Returns for each coefficient in `support` its weight minus the weight of the first one.
    /// Entry (i, j) of an invariant tensor has the weight of xᵢxⱼ plus a weight that all entries
    /// share.
    fn grading(&self, searched: &SearchField, support: &[usize]) -> Grading {
        let symbols = searched.family().symbols();
        let weights = searched.weights();
        let own = |place: usize| -> Vec<Rational> {
            let (monomial, (i, j)) = (place / self.pairs.len(), self.pairs[place % self.pairs.len()]);
            let powers = self.monomials.exponents(monomial).iter().enumerate();
            let monomial =
                weights.of_monomial(&powers.map(|(k, &power)| (symbols.state(k), power)).collect());
            let [i, j] = [i, j].map(|state| weights.of_variable(symbols.state(state)));
            monomial.iter().zip(i.iter().zip(&j)).map(|(m, (i, j))| &(m - i) - j).collect()
        };
        let first = own(support[0]);
        let relative = |&place: &usize| first.iter().zip(own(place)).map(|(a, b)| a - &b).collect();
        Grading {
            unknowns: searched
                .unknown_variables()
                .iter()
                .map(|&unknown| weights.of_variable(unknown))
                .collect(),
            entries: support.iter().map(relative).collect(),
        }
    }
}

struct TensorPoint {
    values: Vec<u64>,
    slopes: Vec<Vec<u64>>,
}

impl TensorPoint {
    fn at(shape: &TensorMonomials, modulus: &Modulus, point: &[u64]) -> Self {
        TensorPoint {
            values: shape.monomials.values(modulus, point),
            slopes: monomial_gradients(modulus, &shape.monomials, point),
        }
    }
}

/// A basis element that is a bracket, with the values of its tensor at some points.
struct Element {
    rank: usize,
    terms: usize,
    part: Vec<u64>,
    tensors: [Tensor; CHECK_POINTS],
}

#[derive(Clone)]
pub(super) struct Tensor {
    pub(super) entries: Vec<Vec<u64>>,
    pub(super) slopes: Vec<Vec<Vec<u64>>>,
}

impl Tensor {
    fn plus(&self, modulus: &Modulus, other: &Tensor) -> Tensor {
        let sum = |a: &Vec<u64>, b: &Vec<u64>| a.iter().zip(b).map(|(a, b)| modulus.plus(*a, *b)).collect();
        let sums = |a: &Vec<Vec<u64>>, b: &Vec<Vec<u64>>| a.iter().zip(b).map(|(a, b)| sum(a, b)).collect();
        Tensor {
            entries: sums(&self.entries, &other.entries),
            slopes: self.slopes.iter().zip(&other.slopes).map(|(a, b)| sums(a, b)).collect(),
        }
    }

    pub(super) fn rank(&self, modulus: &Modulus) -> usize {
        Echelon::of(modulus, self.entries.clone(), self.entries.len()).rank()
    }

    /// Returns whether Jacobi's identity holds at the point: the sum of Pᵢₗ ∂ₗPⱼₖ over l and over
    /// cyclic permutations of (i, j, k) is 0 for all i, j, k.
    pub(super) fn satisfies_jacobi(&self, modulus: &Modulus) -> bool {
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
