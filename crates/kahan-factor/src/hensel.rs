//! Lifts factors modulo a prime p to factors modulo a power of p (Hensel's lemma).

use kahan_algebra::poly::{Budget, OverBudget};
use kahan_algebra::prime_field::PrimeField;
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

use super::dense::{self, Dense};
use super::univariate::Integers;

/// Monic polynomials whose product, times a constant, equals a given polynomial modulo `modulus`.
pub(super) struct HenselLift {
    pub(super) modulus: BigInt,
    pub(super) factors: Vec<Integers>,
}

/// Lifts monic factors of `whole`, pairwise coprime modulo p, to factors modulo some p^k > `bound`.
pub(super) fn lift(
    field: PrimeField,
    factors: &[Dense],
    whole: &Integers,
    bound: &BigInt,
    budget: &mut Budget,
) -> Result<HenselLift, OverBudget> {
    let prime = BigInt::from(field.prime());
    let inverses = dense::partial_fractions(field, factors).expect("the image is square-free");
    let mut next = prime.clone();
    while next <= *bound {
        next *= &prime;
    }
    let last = next;
    let unit = whole[whole.len() - 1].extended_gcd(&last).x.mod_floor(&last);
    let whole: Integers = whole.iter().map(|c| (c * &unit).mod_floor(&last)).collect();
    let mut lifted: Vec<Integers> =
        factors.iter().map(|factor| factor.iter().map(|&c| BigInt::from(c)).collect()).collect();
    let mut modulus = prime.clone();
    while modulus < last {
        let next = &modulus * &prime;
        budget.charge((whole.len() * whole.len()) as u64 * (next.bits() / 64 + 1))?;
        let so_far = lifted.iter().fold(vec![BigInt::one()], |so_far, f| product(&so_far, f, &next));
        let error = dense::trimmed(
            whole.iter().zip(&so_far).map(|(a, b)| residue(field, &((a - b) / &modulus))).collect(),
        );
        for ((factor, image), inverse) in lifted.iter_mut().zip(factors).zip(&inverses) {
            let step = dense::remainder(field, &dense::product(field, &error, inverse), image);
            for (coefficient, &digit) in factor.iter_mut().zip(&step) {
                *coefficient += &modulus * digit;
            }
        }
        modulus = next;
    }
    Ok(HenselLift { modulus, factors: lifted })
}

fn residue(field: PrimeField, value: &BigInt) -> u64 {
    field.reduce(&Rational::from(value.clone())).expect("integers have residues")
}

pub(super) fn product(a: &Integers, b: &Integers, modulus: &BigInt) -> Integers {
    let mut product = vec![BigInt::zero(); a.len() + b.len() - 1];
    for (shift, left) in a.iter().enumerate() {
        for (index, right) in b.iter().enumerate() {
            product[shift + index] += left * right;
        }
    }
    product.iter().map(|coefficient| coefficient.mod_floor(modulus)).collect()
}

/// Returns the residue of `value` modulo `modulus` with the least absolute value.
pub(super) fn symmetric_residue(value: &BigInt, modulus: &BigInt) -> BigInt {
    let residue = value.mod_floor(modulus);
    if &residue * 2 > *modulus { residue - modulus } else { residue }
}
