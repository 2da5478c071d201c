//! Reconstructs polynomials over ℤ from polynomials modulo several primes, by the Chinese remainder
//! theorem.

use std::collections::BTreeMap;

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::PrimeField;
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;
use num_integer::Integer;

use super::hensel;
use super::sparse::Residues;

#[derive(Default)]
pub(super) struct CrtFactors {
    modulus: BigInt,
    factors: Vec<BTreeMap<Vec<u32>, BigInt>>,
}

impl CrtFactors {
    /// Combines the known factors with the factors modulo one more prime. Returns whether a
    /// coefficient changed.
    pub(super) fn combine(&mut self, field: PrimeField, residues: Vec<Residues>) -> bool {
        let prime = BigInt::from(field.prime());
        if self.factors.is_empty() {
            let symmetric = |(exponents, value): (Vec<u32>, u64)| {
                (exponents, hensel::symmetric_residue(&BigInt::from(value), &prime))
            };
            self.factors =
                residues.into_iter().map(|factor| factor.into_iter().map(symmetric).collect()).collect();
            self.modulus = prime;
            return true;
        }
        let inverse = self.modulus.extended_gcd(&prime).x;
        let modulus = &self.modulus * &prime;
        let mut is_news = false;
        for (known, residues) in self.factors.iter_mut().zip(residues) {
            for exponents in residues.keys() {
                known.entry(exponents.clone()).or_default();
            }
            for (exponents, value) in known {
                let residue = BigInt::from(residues.get(exponents).copied().unwrap_or(0));
                let digit = hensel::symmetric_residue(&((residue - &*value) * &inverse), &prime);
                is_news |= digit != BigInt::default();
                *value = hensel::symmetric_residue(&(&*value + &self.modulus * digit), &modulus);
            }
        }
        self.modulus = modulus;
        is_news
    }

    pub(super) fn factors(&self, order: &[Variable]) -> Vec<Polynomial> {
        let polynomial = |factor: &BTreeMap<Vec<u32>, BigInt>| {
            Polynomial::from_terms(factor.iter().map(|(exponents, value)| {
                let monomial: Monomial = order.iter().copied().zip(exponents.iter().copied()).collect();
                (monomial, Rational::from(value.clone()))
            }))
        };
        self.factors.iter().map(polynomial).collect()
    }
}
