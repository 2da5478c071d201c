//! Finds invariant densities of the map that are products of powers of given polynomials.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use crate::densities::darboux::random_step;
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;

/// Finds the simplest density P that is a product of powers of `factors`. A density satisfies P(x̃)
/// det(∂x̃/∂x) = P(x). The exponents have the given `signs`, and Σ |exponent|·degree equals
/// `degree`. P is tested at two random points modulo 2⁶¹ − 1. The caller must prove it.
pub(crate) fn product(
    searched: &SearchField,
    factors: &[Polynomial],
    degree: u32,
    signs: &[i32],
    random: &mut SplitMix64,
) -> Option<Vec<(Polynomial, i32)>> {
    let symbols = searched.family().symbols();
    let degrees: Vec<u32> = factors.iter().map(|factor| symbols.degree(factor)).collect();
    let modulus = Modulus::mersenne_61();
    // For each of two points: P(x̃)/P(x) and its inverse for each factor P, and det ∂x̃/∂x.
    let mut samples: Vec<(Vec<[u64; 2]>, u64)> = Vec::new();
    for _ in 0..2 {
        let sample = searched.sample(modulus, random)?;
        let (point, step) = random_step(&sample.map, random)?;
        let cofactors: Option<Vec<[u64; 2]>> = factors
            .iter()
            .map(|factor| {
                let here = searched.evaluate(factor, &sample, &point)?;
                let there = searched.evaluate(factor, &sample, &step.next)?;
                let cofactor = |above, below| Some(modulus.times(above, modulus.inverse(below)?));
                Some([cofactor(there, here)?, cofactor(here, there)?])
            })
            .collect();
        samples.push((cofactors?, step.jacobian));
    }
    let candidates = exponents(&degrees, degree, signs);
    let has_cofactor = |exponents: &Vec<i32>| {
        samples.iter().all(|(cofactors, jacobian)| {
            let powers = cofactors.iter().zip(exponents).map(|(bases, &exponent)| {
                modulus.power(bases[usize::from(exponent < 0)], exponent.unsigned_abs())
            });
            powers.fold(*jacobian, |product, power| modulus.times(product, power)) == modulus.one()
        })
    };
    let terms = |exponents: &Vec<i32>| -> usize {
        let each = exponents.iter().zip(factors);
        each.map(|(exponent, factor)| exponent.unsigned_abs() as usize * (factor.len() + 1)).sum()
    };
    // If the flow preserves volume, densities that are constant at ε = 0 come first.
    let is_of_flow = |exponents: &Vec<i32>| {
        let mut used = exponents.iter().zip(factors).filter(|(exponent, _)| **exponent != 0);
        used.all(|(_, factor)| !symbols.has_state(&factor.substitute(symbols.epsilon(), &Rational::zero())))
    };
    let key = |exponents: &Vec<i32>| (!is_of_flow(exponents), terms(exponents));
    let best = candidates.into_iter().filter(has_cofactor).min_by_key(key)?;
    let used = factors.iter().cloned().zip(best).filter(|(_, exponent)| *exponent != 0);
    Some(used.collect())
}

/// Returns all exponents with these signs and Σ |exponent|·degree = `total`. The list is incomplete
/// if the enumeration takes more than half a million steps, or finds more than 20 000 entries.
pub(crate) fn exponents(degrees: &[u32], total: u32, signs: &[i32]) -> Vec<Vec<i32>> {
    const MOST_STEPS: usize = 500_000;
    let mut found = Vec::new();
    extend(degrees, total, signs, &mut Vec::new(), &mut found, &mut { MOST_STEPS });
    found
}

fn extend(
    degrees: &[u32],
    total: u32,
    signs: &[i32],
    begun: &mut Vec<i32>,
    found: &mut Vec<Vec<i32>>,
    steps: &mut usize,
) {
    const MOST: usize = 20_000;
    if *steps == 0 || found.len() == MOST {
        return;
    }
    *steps -= 1;
    let Some((&first, rest)) = degrees.split_first() else {
        found.extend((total == 0).then(|| begun.clone()));
        return;
    };
    for size in 0..=total.checked_div(first).unwrap_or(0) {
        for &sign in if size == 0 { &signs[..1] } else { signs } {
            begun.push(sign * size as i32);
            extend(rest, total - size * first, signs, begun, found, steps);
            begun.pop();
        }
    }
}
