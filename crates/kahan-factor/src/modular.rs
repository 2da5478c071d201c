//! Irreducible factors of a square-free polynomial in one variable over a small prime field.
//!
//! The method is that of Cantor and Zassenhaus ("A new algorithm for factoring polynomials over
//! finite fields", Math. Comp. 36, 1981). Seeded random choices affect only the running time.

use kahan_algebra::prime_field::{PrimeField, SplitMix64};

use super::dense::{self, Dense};

/// The product of all irreducible factors of one degree.
pub(super) struct EqualDegree {
    pub(super) product: Dense,
    pub(super) degree: usize,
}

impl EqualDegree {
    pub(super) fn count(&self) -> usize {
        (self.product.len() - 1) / self.degree
    }
}

/// Splits a monic square-free polynomial into products of irreducible factors of equal degree.
///
/// Over the field with p elements, x^(p^d) − x is the product of all monic irreducible polynomials
/// whose degree divides d.
pub(super) fn by_degree(field: PrimeField, polynomial: &[u64]) -> Vec<EqualDegree> {
    let mut rest = polynomial.to_vec();
    let mut frobenius = vec![0, 1];
    let mut parts = Vec::new();
    let mut degree = 0;
    while rest.len() > 1 {
        degree += 1;
        if 2 * degree > rest.len() - 1 {
            parts.push(EqualDegree { degree: rest.len() - 1, product: rest });
            break;
        }
        frobenius = dense::power(field, &frobenius, field.prime(), &rest);
        let product = dense::gcd(field, &dense::difference(field, &frobenius, &[0, 1]), &rest);
        if product.len() > 1 {
            rest = dense::quotient_and_rest(field, &rest, &product).0;
            frobenius = dense::remainder(field, &frobenius, &rest);
            parts.push(EqualDegree { product, degree });
        }
    }
    parts
}

/// Returns the monic irreducible factors of `part.product`. The prime must be odd.
pub(super) fn irreducible(field: PrimeField, part: EqualDegree, rng: &mut SplitMix64) -> Vec<Dense> {
    let mut factors = Vec::new();
    let mut waiting = vec![part.product];
    while let Some(product) = waiting.pop() {
        if product.len() - 1 == part.degree {
            factors.push(product);
            continue;
        }
        let draw = dense::trimmed((1..product.len()).map(|_| field.sample(rng)).collect());
        // For random `draw`, its norm to the power (p − 1)/2 is 1 modulo about half of the factors.
        // The gcd with this power minus 1 splits them off.
        let (mut conjugate, mut norm) = (draw.clone(), draw);
        for _ in 1..part.degree {
            conjugate = dense::power(field, &conjugate, field.prime(), &product);
            norm = dense::remainder(field, &dense::product(field, &norm, &conjugate), &product);
        }
        let sign = dense::power(field, &norm, (field.prime() - 1) / 2, &product);
        let common = dense::gcd(field, &dense::difference(field, &sign, &[1]), &product);
        if common.len() > 1 && common.len() < product.len() {
            waiting.push(dense::quotient_and_rest(field, &product, &common).0);
            waiting.push(common);
        } else {
            waiting.push(product);
        }
    }
    factors
}
