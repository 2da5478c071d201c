//! Invariant Poisson brackets of the form (I − ε² f′²)K for fields f = K∇H with a constant K.
//!
//! The map has the Jacobian matrix A(x,ε)⁻¹ A(x̃,−ε) for A(x,ε) = I − ε f′(x), and f′K is
//! symmetric. So P(x) = (I − ε² f′²)K = A(x,ε) K A(x,ε)ᵀ = A(x,−ε) K A(x,−ε)ᵀ. In the plane P = det
//! A · K is invariant. P is also invariant for direct sums of planar systems, and for the canonical
//! systems of Petrera and Suris (planar fields over a commutative algebra), but not in general.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::upper_index;

use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{SampledStep, SearchField};
use crate::poisson::hamiltonian::Hamiltonian;

use super::polynomial::{PoissonTensor, Tensor};

const MOST_TERMS: usize = 3_000;
const MOST_WORK: u64 = 4_000_000;

/// Computes (I − ε² f′²)K for the constant matrix K in `structure`. Returns the result if it is an
/// invariant bracket modulo a prime.
pub(crate) fn bracket_of_structure(
    searched: &SearchField,
    field: &Field,
    structure: (usize, &Hamiltonian),
    random: &mut SplitMix64,
) -> Option<PoissonTensor> {
    let n = field.dimension();
    let (number, Hamiltonian { tensor, .. }) = structure;
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
    let slopes: Vec<Vec<RationalFunction>> = field
        .components
        .iter()
        .map(|component| (0..n).map(|l| component.derivative(field.symbols.state(l))).collect())
        .collect();
    let once = product(&slopes, tensor, &mut budget)?;
    let twice = product(&slopes, &once, &mut budget)?;
    let square = RationalFunction::variable(field.symbols.epsilon());
    let square = &square * &square;
    let mut upper = Vec::with_capacity(n * (n - 1) / 2);
    for i in 0..n {
        for j in i + 1..n {
            let moved = twice[i][j].mul_within(&square, &mut budget).ok()?;
            upper.push(tensor[i][j].sub_within(&moved, &mut budget).ok()?);
        }
    }
    let entries =
        RationalFunction::over_common(&upper).0.into_iter().map(|entry| searched.at_eps(entry)).collect();
    let found = PoissonTensor { rank: 0, entries, structure: Some(number), is_implied: false };
    let place = searched.step(random)?;
    let rank = found.invariant_rank(searched, &place)?;
    Some(PoissonTensor { rank, ..found })
}

fn product(
    left: &[Vec<RationalFunction>],
    right: &[Vec<RationalFunction>],
    budget: &mut Budget,
) -> Option<Vec<Vec<RationalFunction>>> {
    let mut entry = |row: &[RationalFunction], column: usize| {
        let mut sum = RationalFunction::constant(Rational::zero());
        for (a, right) in row.iter().zip(right) {
            if !a.is_zero() && !right[column].is_zero() {
                sum = sum.add_within(&a.mul_within(&right[column], budget).ok()?, budget).ok()?;
            }
        }
        Some(sum)
    };
    left.iter().map(|row| (0..right.len()).map(|column| entry(row, column)).collect()).collect()
}

fn matrix_at(
    searched: &SearchField,
    place: &SampledStep,
    point: &[u64],
    entries: &[Polynomial],
) -> Option<Vec<Vec<u64>>> {
    let (n, modulus) = (point.len(), place.sample.map.modulus());
    let mut matrix = vec![vec![0; n]; n];
    for i in 0..n {
        for j in i + 1..n {
            let value = searched.evaluate(&entries[upper_index(n, i, j)], &place.sample, point)?;
            (matrix[i][j], matrix[j][i]) = (value, modulus.opposite(value));
        }
    }
    Some(matrix)
}

impl PoissonTensor {
    pub(super) fn at(
        &self,
        searched: &SearchField,
        place: &SampledStep,
        point: &[u64],
    ) -> Option<Vec<Vec<u64>>> {
        matrix_at(searched, place, point, &self.entries)
    }

    /// Returns the rank of the tensor P at a point. Returns `None` unless Jacobi's identity and J P
    /// Jᵀ = P(x̃) hold there, where J is the Jacobian of the map.
    fn invariant_rank(&self, searched: &SearchField, place: &SampledStep) -> Option<usize> {
        let map = &place.sample.map;
        let modulus = map.modulus();
        let jacobian = map.jacobian(&place.here, &place.there)?;
        let here = self.at(searched, place, &place.here)?;
        let there = self.at(searched, place, &place.there)?;
        // P is antisymmetric, so row i of J·P is −P times row i of J.
        let half: Vec<Vec<u64>> = jacobian
            .iter()
            .map(|row| here.iter().map(|own| modulus.opposite(modulus.dot(row, own))).collect())
            .collect();
        let moved = |row: &Vec<u64>| jacobian.iter().map(|own| modulus.dot(row, own)).collect();
        let moved: Vec<Vec<u64>> = half.iter().map(moved).collect();
        if moved != there {
            return None;
        }
        let symbols = searched.family().symbols();
        let slope = |k: usize| {
            let slopes = self.entries.iter().map(|entry| entry.derivative(symbols.state(k)));
            matrix_at(searched, place, &place.here, &slopes.collect::<Vec<_>>())
        };
        let slopes: Vec<Vec<Vec<u64>>> = (0..here.len()).map(slope).collect::<Option<_>>()?;
        let gradient = |i: usize, j: usize| slopes.iter().map(|slope| slope[i][j]).collect();
        let gradients = (0..here.len()).map(|i| (0..here.len()).map(|j| gradient(i, j)).collect()).collect();
        let tensor = Tensor { entries: here, slopes: gradients };
        tensor.satisfies_jacobi(modulus).then(|| tensor.rank(modulus))
    }
}
