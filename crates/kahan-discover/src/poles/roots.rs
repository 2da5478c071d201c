//! A root of a polynomial in one variable modulo a prime, by the splitting of Cantor and Zassenhaus
//! (Math. Comp. 36, 1981).
//!
//! A polynomial is the list of its coefficients, lowest first, the last one not 0.

use kahan_algebra::prime_field::SplitMix64;

use crate::modulus::Modulus;

/// How often a random element may fail to split the polynomial; each fails with probability about
/// one half.
const MOST_DRAWS: usize = 64;

/// Some root; `None` where there is none, or the polynomial is constant.
pub(crate) fn root(modulus: &Modulus, coefficients: &[u64], random: &mut SplitMix64) -> Option<u64> {
    let polynomial = monic(modulus, coefficients.to_vec())?;
    // The product of x − r over the roots r: what the polynomial shares with xᵖ − x.
    let x = vec![0, modulus.one()];
    let power = power(modulus, &x, modulus.prime(), &polynomial);
    let mut roots = gcd(modulus, &polynomial, &sum(modulus, &power, &x, modulus.opposite(modulus.one())));
    for _ in 0..MOST_DRAWS {
        match roots.len() {
            0 | 1 => return None,
            2 => return Some(modulus.opposite(roots[0])),
            _ => {}
        }
        // (x + s)^((p−1)/2) is 1 at about half of the roots.
        let shifted = vec![modulus.sample(random), modulus.one()];
        let half = self::power(modulus, &shifted, (modulus.prime() - 1) / 2, &roots);
        let part =
            gcd(modulus, &roots, &sum(modulus, &half, &[modulus.one()], modulus.opposite(modulus.one())));
        if part.len() > 1 && part.len() < roots.len() {
            roots = part;
        }
    }
    None
}

fn trimmed(mut polynomial: Vec<u64>) -> Vec<u64> {
    while polynomial.last() == Some(&0) {
        polynomial.pop();
    }
    polynomial
}

/// The polynomial over its leading coefficient; `None` for 0.
fn monic(modulus: &Modulus, polynomial: Vec<u64>) -> Option<Vec<u64>> {
    let polynomial = trimmed(polynomial);
    let inverse = modulus.inverse(*polynomial.last()?)?;
    Some(polynomial.iter().map(|coefficient| modulus.times(*coefficient, inverse)).collect())
}

/// a + factor · b
fn sum(modulus: &Modulus, a: &[u64], b: &[u64], factor: u64) -> Vec<u64> {
    let mut sum = a.to_vec();
    sum.resize(a.len().max(b.len()), 0);
    for (entry, other) in sum.iter_mut().zip(b) {
        *entry = modulus.plus(*entry, modulus.times(factor, *other));
    }
    trimmed(sum)
}

/// The remainder modulo a monic polynomial.
fn remainder(modulus: &Modulus, mut a: Vec<u64>, divisor: &[u64]) -> Vec<u64> {
    while a.len() >= divisor.len() {
        let (start, leading) = (a.len() - divisor.len(), a[a.len() - 1]);
        for (entry, other) in a[start..].iter_mut().zip(divisor) {
            *entry = modulus.minus(*entry, modulus.times(leading, *other));
        }
        a.pop();
    }
    trimmed(a)
}

/// The monic greatest common divisor; empty where both are 0.
fn gcd(modulus: &Modulus, a: &[u64], b: &[u64]) -> Vec<u64> {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    while let Some(divisor) = monic(modulus, b) {
        b = remainder(modulus, a, &divisor);
        a = divisor;
    }
    a
}

/// base^exponent modulo a monic polynomial.
fn power(modulus: &Modulus, base: &[u64], exponent: u64, divisor: &[u64]) -> Vec<u64> {
    let times = |a: &[u64], b: &[u64]| {
        let mut product = vec![0; (a.len() + b.len()).saturating_sub(1)];
        for (i, left) in a.iter().enumerate() {
            for (entry, right) in product[i..].iter_mut().zip(b) {
                *entry = modulus.plus(*entry, modulus.times(*left, *right));
            }
        }
        remainder(modulus, product, divisor)
    };
    let mut power = remainder(modulus, vec![modulus.one()], divisor);
    for bit in (0..u64::BITS).rev() {
        power = times(&power, &power);
        if exponent >> bit & 1 == 1 {
            power = times(&power, base);
        }
    }
    power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_found_where_there_is_one() {
        let (modulus, mut random) = (Modulus::mersenne_61(), SplitMix64::new(2));
        let number = |value: i64| {
            let size = modulus.integer(value.unsigned_abs());
            if value < 0 { modulus.opposite(size) } else { size }
        };
        let of = |coefficients: &[i64]| coefficients.iter().map(|&c| number(c)).collect::<Vec<_>>();
        // (x − 2)(x − 3)(x + 5)(x² + 1), and −1 is no square modulo 2⁶¹ − 1.
        let found = root(&modulus, &of(&[30, -19, 30, -18, 0, 1]), &mut random).unwrap();
        assert!([2, 3, -5].map(number).contains(&found));
        assert_eq!(root(&modulus, &of(&[1, 0, 1]), &mut random), None);
        assert_eq!(root(&modulus, &of(&[9, -6, 1]), &mut random), Some(number(3)));
        assert_eq!(root(&modulus, &of(&[7, 0]), &mut random), None);
        assert_eq!(root(&modulus, &of(&[0, 0, 0]), &mut random), None);
    }
}
