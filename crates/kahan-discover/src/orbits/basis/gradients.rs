//! Computes the gradients of a basis's coefficients as functions of the start, modulo a prime.

use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::orbits::relations::monomial_gradient;

use super::Basis;

/// Returns the gradient of every coefficient at a point. The coefficient 1 has the gradient 0.
///
/// Let M be the values of the monomials along the orbit, and c the coefficients. Then M c = 0
/// implies M dc = −dM c.
pub(super) fn of_coefficients(basis: &Basis, map: &ModularMap, start: &[u64]) -> Option<Vec<Vec<u64>>> {
    let modulus = map.modulus();
    let n = start.len();
    let size = basis.monomials.len();
    let mut point = start.to_vec();
    let mut tangent: Vec<Vec<u64>> =
        (0..n).map(|i| (0..n).map(|j| if i == j { modulus.one() } else { 0 }).collect()).collect();
    let mut values: Vec<Vec<u64>> = Vec::new();
    let mut slopes: Vec<Vec<Vec<u64>>> = Vec::new();
    // The relation has `size` − 1 unknown coefficients, and one more point checks that it holds.
    for _ in 0..size {
        let (own, gradients): (Vec<u64>, Vec<Vec<u64>>) =
            basis.monomials.iter().map(|exponents| monomial_at(modulus, exponents, &point)).unzip();
        values.push(own);
        slopes.push(gradients.iter().map(|gradient| times_matrix(modulus, gradient, &tangent)).collect());
        let next = map.next(&point)?;
        let jacobian = map.jacobian(&point, &next)?;
        tangent = jacobian.iter().map(|row| times_matrix(modulus, row, &tangent)).collect();
        point = next;
    }
    let others: Vec<usize> = (0..size).filter(|&place| place != basis.unit).collect();
    let solve = |right: &[Vec<u64>]| -> Option<Vec<Vec<u64>>> {
        let row = |(k, right): (usize, &Vec<u64>)| {
            others.iter().map(|&place| values[k][place]).chain(right.iter().copied()).collect()
        };
        let width = others.len() + right[0].len();
        let echelon = Echelon::of(modulus, right.iter().enumerate().map(row).collect(), width);
        let is_unique = echelon.pivots == (0..others.len()).collect::<Vec<_>>();
        is_unique.then(|| echelon.rows.iter().map(|row| row[others.len()..].to_vec()).collect())
    };
    let unit: Vec<Vec<u64>> = values.iter().map(|row| vec![modulus.opposite(row[basis.unit])]).collect();
    let mut coefficients = vec![modulus.one(); size];
    for (&place, value) in others.iter().zip(solve(&unit)?) {
        coefficients[place] = value[0];
    }
    let right: Vec<Vec<u64>> = slopes
        .iter()
        .map(|gradients| {
            let moved = |j: usize| {
                let products = coefficients.iter().zip(gradients);
                products.fold(0, |sum, (c, gradient)| modulus.minus(sum, modulus.times(*c, gradient[j])))
            };
            (0..n).map(moved).collect()
        })
        .collect();
    let mut gradients = vec![vec![0; n]; size];
    for (&place, gradient) in others.iter().zip(solve(&right)?) {
        gradients[place] = gradient;
    }
    Some(gradients)
}

fn monomial_at(modulus: &Modulus, exponents: &[u32], point: &[u64]) -> (u64, Vec<u64>) {
    (modulus.monomial(exponents, point), monomial_gradient(modulus, exponents, point))
}

fn times_matrix(modulus: &Modulus, row: &[u64], matrix: &[Vec<u64>]) -> Vec<u64> {
    let mut sum = vec![0; row.len()];
    for (factor, own) in row.iter().zip(matrix).filter(|(factor, _)| **factor != 0) {
        for (entry, value) in sum.iter_mut().zip(own) {
            *entry = modulus.plus(*entry, modulus.times(*factor, *value));
        }
    }
    sum
}
