//! A root in a prime field of a polynomial in one variable, by the splitting of Cantor and
//! Zassenhaus (Math. Comp. 36, 1981).

use kahan_algebra::prime_field::PrimeField;

use super::dense;

/// Maximal number of random splits; each fails with probability about 1/2.
const MOST_DRAWS: usize = 64;

/// Returns a root of the polynomial with these coefficients by exponent; `None` if the polynomial
/// is constant or no root is found. `draw` returns random elements of the field.
pub fn root(field: PrimeField, coefficients: &[u64], mut draw: impl FnMut() -> u64) -> Option<u64> {
    let polynomial = dense::trimmed(coefficients.to_vec());
    if polynomial.is_empty() {
        return None;
    }
    let common = |polynomial: &[u64], base: &[u64], exponent: u64, less: &[u64]| {
        let power = dense::power(field, base, exponent, polynomial);
        dense::gcd(field, polynomial, &dense::difference(field, &power, less))
    };
    // The product of x − r over the roots r divides xᵖ − x.
    let mut roots = common(&polynomial, &[0, 1], field.prime(), &[0, 1]);
    for _ in 0..MOST_DRAWS {
        match roots.len() {
            0 | 1 => return None,
            2 => return Some(field.neg(roots[0])),
            _ => {}
        }
        // (x + s)^((p−1)/2) is 1 at about half of the roots.
        let part = common(&roots, &[draw(), 1], (field.prime() - 1) / 2, &[1]);
        if part.len() > 1 && part.len() < roots.len() {
            roots = part;
        }
    }
    None
}
