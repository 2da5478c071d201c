//! Factors a polynomial in one variable over ℤ.
//!
//! The method is that of Zassenhaus ("On Hensel factorization I", J. Number Theory 1, 1969).
//! Factors modulo a small prime are lifted to a power of the prime. Products of a few lifted
//! factors are then tried as true factors. Before any lift, the degrees of factors modulo several
//! primes prove most irreducible polynomials irreducible.

use kahan_algebra::poly::{Budget, Monomial, OverBudget, Polynomial, RESIDUES_PER_TERM, Variable};
use kahan_algebra::prime_field::{PrimeField, SplitMix64, is_prime_u64};
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::dense::{self, Dense};
use super::hensel::{self, HenselLift};
use super::{modular, square_free};

/// The coefficients of a polynomial, ordered by exponent. The last coefficient is positive.
pub(super) type Integers = Vec<BigInt>;

/// The number of primes that are tried. The lift uses the prime that gives the fewest factors.
const COMPARED_PRIMES: usize = 5;
/// The search for primes begins here. Modulo a prime this large, different factors of a polynomial
/// rarely have a common root.
const FIRST_PRIME: u64 = 1009;

/// Factors a primitive polynomial in `main`.
pub(super) fn factors(
    polynomial: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> Result<Vec<(Polynomial, u32)>, OverBudget> {
    let mut all = Vec::new();
    for (part, exponent) in square_free::square_free_by_yun(polynomial, main, budget)? {
        let degree = part.degree() as usize;
        budget.charge(separation_work(degree))?;
        let coefficient = |power: usize| part.coefficient(&Monomial::power(main, power as u32)).numerator();
        for factor in irreducible((0..=degree).map(coefficient).collect(), budget)? {
            let terms = factor.into_iter().enumerate();
            let terms = terms.map(|(power, c)| (Monomial::power(main, power as u32), Rational::from(c)));
            all.push((Polynomial::from_terms(terms), exponent));
        }
    }
    Ok(all)
}

/// Factors a primitive square-free polynomial with positive leading coefficient.
fn irreducible(polynomial: Integers, budget: &mut Budget) -> Result<Vec<Integers>, OverBudget> {
    let degree = polynomial.len() - 1;
    if degree < 2 {
        return Ok(vec![polynomial]);
    }
    let mut possible = DegreeSet::all(degree);
    let mut best: Option<(PrimeField, Vec<modular::EqualDegree>, usize)> = None;
    let mut tried = 0;
    for prime in (FIRST_PRIME..).step_by(2).filter(|&n| is_prime_u64(n)) {
        budget.charge(separation_work(degree))?;
        let Some((field, image)) = good_image(&polynomial, prime) else { continue };
        let parts = modular::by_degree(field, &image);
        let count = parts.iter().map(modular::EqualDegree::count).sum();
        possible.intersect(&DegreeSet::sums(degree, &parts));
        if possible.is_trivial() {
            return Ok(vec![polynomial]);
        }
        if best.as_ref().is_none_or(|(_, _, least)| count < *least) {
            best = Some((field, parts, count));
        }
        tried += 1;
        if tried == COMPARED_PRIMES {
            break;
        }
    }
    let (field, parts, _) = best.expect("all but finitely many primes are good");
    let mut rng = SplitMix64::new(field.prime());
    let images: Vec<Dense> =
        parts.into_iter().flat_map(|part| modular::irreducible(field, part, &mut rng)).collect();
    let lifted = hensel::lift(field, &images, &polynomial, &(coefficient_bound(&polynomial) * 2), budget)?;
    recombine(polynomial, lifted, budget)
}

/// Returns the work that separating factors by degree takes modulo one small prime.
fn separation_work(degree: usize) -> u64 {
    (degree as u64).saturating_pow(3).saturating_mul(8) / RESIDUES_PER_TERM + degree as u64
}

/// Returns the polynomial modulo the prime, divided by its leading coefficient. Returns `None` if
/// the degree is smaller there or a factor is repeated.
fn good_image(polynomial: &Integers, prime: u64) -> Option<(PrimeField, Dense)> {
    let field = PrimeField::new(prime)?;
    let image: Dense =
        polynomial.iter().map(|c| field.reduce(&Rational::from(c.clone()))).collect::<Option<_>>()?;
    let keeps_degree = image.last() != Some(&0);
    let derivative = dense::derivative(field, &image);
    (keeps_degree && dense::gcd(field, &image, &derivative).len() == 1)
        .then(|| (field, dense::monic(field, &image)))
}

struct DegreeSet(Vec<bool>);

impl DegreeSet {
    fn all(degree: usize) -> Self {
        Self(vec![true; degree + 1])
    }

    fn sums(degree: usize, parts: &[modular::EqualDegree]) -> Self {
        let mut possible = vec![false; degree + 1];
        possible[0] = true;
        for part in parts {
            for _ in 0..part.count() {
                for sum in (part.degree..=degree).rev() {
                    possible[sum] |= possible[sum - part.degree];
                }
            }
        }
        Self(possible)
    }

    fn intersect(&mut self, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            *own &= other;
        }
    }

    fn is_trivial(&self) -> bool {
        self.0.iter().filter(|possible| **possible).count() == 2
    }
}

/// Bounds the coefficients of lc(f)/lc(g)·g for all factors g of f, where lc is the leading
/// coefficient. The bound is |lc(f)|·2^n·‖f‖₂ with n = deg f (Mignotte, Math. Comp. 28, 1974).
fn coefficient_bound(polynomial: &Integers) -> BigInt {
    let squares: BigInt = polynomial.iter().map(|c| c * c).sum();
    ((squares.sqrt() + 1_u32) << (polynomial.len() - 1)) * polynomial[polynomial.len() - 1].abs()
}

/// Finds the true factors as products of lifted factors. Products of few factors are tried first.
fn recombine(
    mut whole: Integers,
    lifted: HenselLift,
    budget: &mut Budget,
) -> Result<Vec<Integers>, OverBudget> {
    let HenselLift { modulus, mut factors } = lifted;
    let words = modulus.bits() / 64 + 1;
    let mut found = Vec::new();
    let mut chosen = vec![0];
    while 2 * chosen.len() <= factors.len() {
        budget.charge((whole.len() * whole.len()) as u64 * words)?;
        let candidate = candidate(&whole, chosen.iter().map(|&index| &factors[index]), &modulus);
        if let Some(quotient) = exact_quotient(&whole, &candidate) {
            found.push(candidate);
            whole = quotient;
            for &index in chosen.iter().rev() {
                factors.remove(index);
            }
            // No smaller set of these factors gives a factor, so continue with this size.
            chosen = (0..chosen.len()).collect();
        } else if !next_subset(&mut chosen, factors.len()) {
            chosen = (0..=chosen.len()).collect();
        }
    }
    if whole.len() > 1 {
        found.push(whole);
    }
    Ok(found)
}

/// Advances to the next subset of equal size. Returns `false` after the last subset.
fn next_subset(chosen: &mut [usize], count: usize) -> bool {
    let size = chosen.len();
    let Some(place) = (0..size).rev().find(|&place| chosen[place] < count - size + place) else {
        return false;
    };
    chosen[place] += 1;
    for next in place + 1..size {
        chosen[next] = chosen[next - 1] + 1;
    }
    true
}

/// Multiplies the chosen factors by the leading coefficient of `whole`, and takes residues of least
/// absolute value modulo `modulus`. Returns the primitive part of the result.
fn candidate<'a>(
    whole: &Integers,
    factors: impl Iterator<Item = &'a Integers>,
    modulus: &BigInt,
) -> Integers {
    let lead = vec![whole[whole.len() - 1].clone()];
    let mut product = factors.fold(lead, |so_far, factor| hensel::product(&so_far, factor, modulus));
    let mut content = BigInt::zero();
    for coefficient in &mut product {
        *coefficient = hensel::symmetric_residue(coefficient, modulus);
        content = content.gcd(coefficient);
    }
    for coefficient in &mut product {
        *coefficient = &*coefficient / &content;
    }
    product
}

fn exact_quotient(whole: &Integers, divisor: &Integers) -> Option<Integers> {
    let divides = |a: &BigInt, b: &BigInt| if b.is_zero() { a.is_zero() } else { (a % b).is_zero() };
    if !divides(&whole[0], &divisor[0]) {
        return None;
    }
    let lead = &divisor[divisor.len() - 1];
    let mut rest = whole.clone();
    let mut quotient = vec![BigInt::zero(); (whole.len() + 1).checked_sub(divisor.len())?];
    for shift in (0..quotient.len()).rev() {
        let (factor, remainder) = rest[shift + divisor.len() - 1].div_rem(lead);
        if !remainder.is_zero() {
            return None;
        }
        for (own, other) in rest[shift..].iter_mut().zip(divisor) {
            *own -= &factor * other;
        }
        quotient[shift] = factor;
    }
    rest.iter().all(Zero::is_zero).then_some(quotient)
}
