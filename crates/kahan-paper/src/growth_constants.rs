//! Computes the limit C₁ of h(yₙ)/n on orbits of dE7 and dE8, where h is the logarithmic height.

use kahan_algebra::rational::Rational;

use kahan_systems::special::{Float256, Real, digamma};

use super::formula::Formula;

/// Replaces the calls `C1_e7(xi, tau)` and `C1_e8(tau)` in a formula by their values.
pub(super) fn put_into(formula: &Formula) -> Result<Formula, String> {
    formula.replaced(&|name, arguments| {
        let numbers: Vec<Rational> = arguments.iter().filter_map(Formula::as_number).collect();
        Ok(match (name, numbers.as_slice()) {
            ("C1_e7", [xi, tau]) => c1_of_de7(xi, tau),
            ("C1_e8", [tau]) => c1_of_de8(tau),
            _ => None,
        })
    })
}

/// Computes the limit C₁ for dE7. Returns `None` if a = τ + 1 − ξ/2 and b = τ + ξ/2 have different
/// denominators.
///
/// Let M be the common denominator. For r coprime to M, let a_r = s/M with 1 ≤ s ≤ M and r·s ≡ M·a
/// modulo M. Let b_r be defined likewise. By the prime number theorem for arithmetic progressions,
/// C₁ is the mean of max(0, ψ(b_r) − ψ(a_r)) over all r, where ψ is the digamma function.
fn c1_of_de7(xi: &Rational, tau: &Rational) -> Option<Rational> {
    let half = Rational::new(1, 2);
    let b = tau + &(xi * &half);
    let a = &(tau + &Rational::from(1)) - &(xi * &half);
    let (modulus, above_a, above_b) =
        (integer(&b.denominator())?, integer(&a.numerator())?, integer(&b.numerator())?);
    if integer(&a.denominator())? != modulus {
        return None;
    }
    let mut sum = Float256::from(0);
    let units: Vec<i64> = (1..=modulus).filter(|&r| gcd(r, modulus) == 1).collect();
    for &r in &units {
        let inverse = (1..=modulus).find(|&s| (r * s).rem_euclid(modulus) == 1 % modulus)?;
        let residue = |above: i64| {
            let residue = (above.rem_euclid(modulus) * inverse).rem_euclid(modulus);
            Float256::from_ratio(if residue == 0 { modulus } else { residue }, modulus)
        };
        let difference = digamma(&residue(above_b)) - digamma(&residue(above_a));
        if difference.is_positive() {
            sum += difference;
        }
    }
    let mean = sum / Float256::from(i64::try_from(units.len()).ok()?);
    Rational::parse(&mean.to_digits(50))
}

/// Computes the limit C₁ for the orbit of dE8 with x₀ = 1/(2ετ). C₁ is M/φ(M) times the sum of 1/m
/// over all m ≤ M coprime to M, where M is the denominator of τ + 1/2 and φ is Euler's function.
fn c1_of_de8(tau: &Rational) -> Option<Rational> {
    let modulus = integer(&(tau + &Rational::new(1, 2)).denominator())?;
    let units: Vec<i64> = (1..=modulus).filter(|&m| gcd(m, modulus) == 1).collect();
    let sum = units.iter().fold(Rational::zero(), |sum, &m| &sum + &Rational::new(1, m));
    Some(&Rational::new(modulus, i64::try_from(units.len()).ok()?) * &sum)
}

fn integer(value: &impl ToString) -> Option<i64> {
    value.to_string().parse().ok()
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
