//! The ansatz N/D for a rational function, where N and D have the same monomials.

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use num_bigint::BigInt;
use num_integer::Integer;

use crate::modular::modulus::{Modulus, rational_from_residue};

const MOST_COEFFICIENTS: usize = 500;

/// The monomials of N and D in the ansatz N/D, as exponents of the unknowns.
#[derive(Clone, Debug)]
pub(crate) struct MonomialSupport {
    pub(crate) monomials: Vec<Vec<u32>>,
}

impl MonomialSupport {
    /// Returns all monomials with these bounds on the degree in each unknown and in total. Returns
    /// `None` if there are too many monomials.
    pub(crate) fn within(bounds: &[usize], total: usize) -> Option<Self> {
        let mut monomials: Vec<Vec<u32>> = vec![Vec::new()];
        for &bound in bounds {
            let extended = monomials.iter().flat_map(|monomial| {
                let used = monomial.iter().sum::<u32>() as usize;
                (0..=bound.min(total.saturating_sub(used))).map(move |exponent| {
                    let mut longer = monomial.clone();
                    longer.push(exponent as u32);
                    longer
                })
            });
            monomials = extended.take(MOST_COEFFICIENTS + 1).collect();
        }
        (2 * monomials.len() <= MOST_COEFFICIENTS).then_some(MonomialSupport { monomials })
    }

    pub(crate) fn values(&self, modulus: &Modulus, point: &[u64]) -> Vec<u64> {
        self.monomials.iter().map(|exponents| modulus.monomial(exponents, point)).collect()
    }

    /// Returns the function whose coefficients have these residues modulo several primes. Returns
    /// `None` if a coefficient is no small rational number.
    pub(crate) fn function(
        &self,
        primes: &[(Modulus, Vec<Vec<u64>>)],
        entry: usize,
        variables: &[Variable],
    ) -> Option<RationalFunction> {
        let count = self.monomials.len();
        let side = |offset: usize| -> Option<Polynomial> {
            let mut terms = Vec::new();
            for (index, exponents) in self.monomials.iter().enumerate() {
                let residues = primes
                    .iter()
                    .map(|(modulus, all)| (modulus.prime(), modulus.residue(all[entry][offset + index])));
                let coefficient = rational_from_residues(residues)?;
                let powers =
                    variables.iter().zip(exponents).map(|(variable, exponent)| (*variable, *exponent));
                terms.push((powers.collect::<Monomial>(), coefficient));
            }
            Some(Polynomial::from_terms(terms))
        };
        RationalFunction::new_within(side(0)?, side(count)?, &mut Budget::new(2000, 10_000_000)).ok()?
    }
}

/// Finds a rational number from pairs (prime, residue), by the Chinese remainder theorem.
fn rational_from_residues(residues: impl Iterator<Item = (u64, u64)>) -> Option<Rational> {
    let (mut value, mut product) = (BigInt::from(0), BigInt::from(1));
    for (prime, residue) in residues {
        let prime = BigInt::from(prime);
        let inverse = product.extended_gcd(&prime).x;
        let step = ((BigInt::from(residue) - &value) * inverse).mod_floor(&prime);
        value += &product * step;
        product *= prime;
    }
    rational_from_residue(&value, &product)
}
