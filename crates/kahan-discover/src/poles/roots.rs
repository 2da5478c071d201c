//! Roots of polynomials in one variable modulo a prime.

use kahan_algebra::prime_field::SplitMix64;

use crate::modular::modulus::Modulus;

/// Returns a root of a polynomial whose constant term comes first.
pub(crate) fn root(modulus: &Modulus, coefficients: &[u64], random: &mut SplitMix64) -> Option<u64> {
    let residues: Vec<u64> = coefficients.iter().map(|entry| modulus.residue(*entry)).collect();
    let sample = || modulus.residue(modulus.sample(random));
    kahan_factor::root(modulus.field(), &residues, sample).map(|root| modulus.integer(root))
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
        let found = root(&modulus, &of(&[30, -19, 30, -18, 0, 1]), &mut random).unwrap();
        assert!([2, 3, -5].map(number).contains(&found));
        assert_eq!(root(&modulus, &of(&[1, 0, 1]), &mut random), None);
        assert_eq!(root(&modulus, &of(&[9, -6, 1]), &mut random), Some(number(3)));
        assert_eq!(root(&modulus, &of(&[7, 0]), &mut random), None);
        assert_eq!(root(&modulus, &of(&[0, 0, 0]), &mut random), None);
    }
}
