//! Finds real roots of univariate polynomials with exact coefficients, to any number of bits.
//!
//! Signs of values are exact, so an interval with a change of sign contains a root. Roots without a
//! change of sign are not found.

use std::cmp::Ordering;

use kahan_algebra::prime_field::SplitMix64;

use super::dyadic::Dyadic;

/// Returns a random real root of Σ coefficients[k]·v^k with a relative error of at most 2^−bits.
/// At a root the terms cancel, so roots are near points where two terms have equal absolute values.
/// The search compares signs near these points, and returns `None` if the sign never changes.
pub(crate) fn root(coefficients: &[Dyadic], bits: i64, random: &mut SplitMix64) -> Option<Dyadic> {
    let mut binades: Vec<i64> = balanced_exponents(coefficients).flat_map(|b| b - 3..=b + 3).collect();
    binades.sort_unstable();
    binades.dedup();
    let negative = binades.iter().rev().map(|&b| Dyadic::new(-1, b));
    let positive = binades.iter().map(|&b| Dyadic::new(1, b));
    let places: Vec<(Dyadic, bool)> =
        negative.chain(positive).map(|v| (v.clone(), sign(coefficients, &v) == Ordering::Less)).collect();
    // No relative width is defined for the interval that contains 0, so this interval is skipped.
    let brackets: Vec<usize> =
        (1..places.len()).filter(|&i| places[i - 1].1 != places[i].1 && i != binades.len()).collect();
    if brackets.is_empty() {
        return None;
    }
    let chosen = brackets[random.below(brackets.len() as u64) as usize];
    let ((mut low, is_negative), (mut high, _)) = (places[chosen - 1].clone(), places[chosen].clone());
    for _ in 0..bits + 6 {
        let middle = (&low + &high).scaled(-1);
        match sign(coefficients, &middle) {
            Ordering::Equal => return Some(middle),
            at_middle if (at_middle == Ordering::Less) == is_negative => low = middle,
            _ => high = middle,
        }
    }
    Some((&low + &high).scaled(-1))
}

fn sign(coefficients: &[Dyadic], v: &Dyadic) -> Ordering {
    sign_of_leading_bits(coefficients, v).unwrap_or_else(|| {
        let value = coefficients.iter().rev().fold(Dyadic::zero(), |sum, c| &(&sum * v) + c);
        value.compare(&Dyadic::zero())
    })
}

/// Returns the sign of the polynomial; `None` if terms cancel to less than 2⁻⁴⁰ of their sizes.
fn sign_of_leading_bits(coefficients: &[Dyadic], v: &Dyadic) -> Option<Ordering> {
    let (significand, binade) = v.leading();
    let term = |(k, c): (i32, &Dyadic)| {
        let (leading, at) = c.leading();
        (leading * significand.powi(k), at + i64::from(k) * binade)
    };
    let terms = || (0..).zip(coefficients).filter(|(_, c)| !c.is_zero()).map(term);
    let largest = terms().map(|(_, at)| at).max()?;
    let scaled = |(term, at): (f64, i64)| libm::ldexp(term, (at - largest).max(-2000) as i32);
    let (sum, sizes) =
        terms().map(scaled).fold((0.0, 0.0), |(sum, sizes), term| (sum + term, sizes + term.abs()));
    if sum.abs() > sizes * 2_f64.powi(-40) { sum.partial_cmp(&0.0) } else { None }
}

/// Returns the exponents e such that two terms have about equal sizes at 2^e.
fn balanced_exponents(coefficients: &[Dyadic]) -> impl Iterator<Item = i64> + '_ {
    let sizes = coefficients.iter().enumerate().filter_map(|(k, c)| Some((k as i64, c.binade()?)));
    let sizes: Vec<(i64, i64)> = sizes.collect();
    let count = sizes.len();
    let pairs = (0..count).flat_map(move |i| (i + 1..count).map(move |j| (i, j)));
    pairs.map(move |(i, j)| (sizes[i].1 - sizes[j].1).div_euclid(sizes[j].0 - sizes[i].0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_over_the_whole_range() {
        let mut random = SplitMix64::new(1);
        let linear = [Dyadic::new(-1, 3000), Dyadic::new(3, 0)];
        let third = root(&linear, 60, &mut random).unwrap();
        assert!((&(&third * &Dyadic::new(3, 0)) - &Dyadic::new(1, 3000)).ratio(&third) < 1e-18);
        let quadratic = [Dyadic::new(-2, -2000), Dyadic::zero(), Dyadic::new(1, 0)];
        for _ in 0..8 {
            let v = root(&quadratic, 60, &mut random).unwrap();
            assert!((&(&v * &v) - &Dyadic::new(2, -2000)).ratio(&Dyadic::new(2, -2000)) < 1e-17);
        }
        assert!(root(&[Dyadic::new(1, 0), Dyadic::zero(), Dyadic::new(5, 0)], 60, &mut random).is_none());
        assert!(root(&[Dyadic::new(1, 0)], 60, &mut random).is_none());
    }

    #[test]
    fn leading_bits_tell_no_wrong_sign() {
        let (mut told, mut silent) = (0, 0);
        for power in 0..120 {
            for offset in [1, -1] {
                let v = &Dyadic::new(3, 0) + &Dyadic::new(offset, -power / 2);
                let lowered = &Dyadic::new(9, 0) - &Dyadic::new(5, -power);
                let coefficients = [lowered, Dyadic::new(-6, 0), Dyadic::new(1, 0)];
                // The polynomial (v − 3)² − 5·2^(−power) is negative at v = 3 ± 2^(−⌊power/2⌋).
                assert_eq!(sign(&coefficients, &v), Ordering::Less);
                match sign_of_leading_bits(&coefficients, &v) {
                    Some(sign) => told += usize::from(sign == Ordering::Less),
                    None => silent += 1,
                }
            }
        }
        assert_eq!(told + silent, 240);
        assert!(told > 60 && silent > 100, "{told} told, {silent} not");
    }

    #[test]
    fn a_root_of_few_bits_is_met_exactly() {
        let mut random = SplitMix64::new(2);
        let v = root(&[Dyadic::new(-5, 40), Dyadic::new(8, 0)], 60, &mut random).unwrap();
        assert!((&v - &Dyadic::new(5, 37)).is_zero());
    }
}
