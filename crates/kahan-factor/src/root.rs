//! Finds a root in a prime field of a polynomial in one variable, by the method of Cantor and
//! Zassenhaus (Math. Comp. 36, 1981).

use kahan_algebra::prime_field::PrimeField;

use super::dense;

/// The most random splits. Each one fails with probability about 1/2.
const MOST_DRAWS: usize = 64;

/// Returns a root of the polynomial with these coefficients, ordered by exponent. Returns `None` if
/// the polynomial is constant or no root is found. `draw` must return random elements of the field.
pub fn root(field: PrimeField, coefficients: &[u64], mut draw: impl FnMut() -> u64) -> Option<u64> {
    let polynomial = dense::trimmed(coefficients.to_vec());
    if polynomial.is_empty() {
        return None;
    }
    let common = |polynomial: &[u64], base: &[u64], exponent: u64, less: &[u64]| {
        let power = dense::power(field, base, exponent, polynomial);
        dense::gcd(field, polynomial, &dense::difference(field, &power, less))
    };
    // In the field with p elements, xᵖ − x is the product of x − r over all elements r. The gcd of
    // xᵖ − x and the polynomial has the polynomial's roots.
    let mut roots = common(&polynomial, &[0, 1], field.prime(), &[0, 1]);
    for _ in 0..MOST_DRAWS {
        match roots.len() {
            0 | 1 => return None,
            2 => return Some(field.neg(roots[0])),
            _ => {}
        }
        // With p elements in the field, (x + s)^((p−1)/2) is 1 at about half of the roots x for a
        // random s.
        let part = common(&roots, &[draw(), 1], (field.prime() - 1) / 2, &[1]);
        if part.len() > 1 && part.len() < roots.len() {
            roots = part;
        }
    }
    None
}
