//! Finds roots of polynomials over prime fields by the method of Cantor and Zassenhaus (Math. Comp.
//! 36, 1981).

use kahan_algebra::prime_field::PrimeField;

use super::dense;

/// Limits the random splits. Each split fails with probability about 1/2.
const MOST_DRAWS: usize = 64;

/// Returns a root of the polynomial with these coefficients, ordered by exponent. Returns `None` if
/// no root is found. `draw` must return random elements of the field.
pub fn root(field: PrimeField, coefficients: &[u64], mut draw: impl FnMut() -> u64) -> Option<u64> {
    let polynomial = dense::trimmed(coefficients.to_vec());
    if polynomial.is_empty() {
        return None;
    }
    let common = |polynomial: &[u64], base: &[u64], exponent: u64, less: &[u64]| {
        let power = dense::power(field, base, exponent, polynomial);
        dense::gcd(field, polynomial, &dense::difference(field, &power, less))
    };
    // For the prime p, each field element is a simple root of xᵖ − x. The gcd keeps these roots.
    let mut roots = common(&polynomial, &[0, 1], field.prime(), &[0, 1]);
    for _ in 0..MOST_DRAWS {
        match roots.len() {
            0 | 1 => return None,
            2 => return Some(field.neg(roots[0])),
            _ => {}
        }
        // For a random s, (x + s)^((p−1)/2) is 1 at about half of the roots x.
        let part = common(&roots, &[draw(), 1], (field.prime() - 1) / 2, &[1]);
        if part.len() > 1 && part.len() < roots.len() {
            roots = part;
        }
    }
    None
}
