//! Computes how many points prove a claim.
//!
//! # Proof
//!
//! Let F/G be the left side minus the right side of an equation of the claim, with integer
//! polynomials F and G in states, parameters and ε. If a claim is false, some F is nonzero. A point
//! is a random prime p between 2⁶⁰ and 2⁶¹ with random residues. A false claim passes only if
//!
//! * the prime p divides every coefficient of F. At most b/60 primes do so, where b = log₂ ‖F‖₁,
//!   and there are more than 2⁵⁴ primes (about 2⁶⁰/ln 2^60.5 ≈ 2^54.6); or
//! * the value of F is zero at the point modulo p, which has probability at most deg F · 2⁻⁶⁰
//!   (Schwartz and Zippel).
//!
//! A false claim thus passes at one point with probability at most e = b/60 · 2⁻⁵⁴ + deg F · 2⁻⁶⁰.
//! If a step divides by zero, another point is drawn, up to r = 16 times (`MOST_DRAWS`). A step
//! then passes with probability at most r·e. Steps at which the claim is undefined are skipped, at
//! most r − 1 of them.
//!
//! With k points, a false claim is proved only if k of its first k + r − 1 independent steps pass.
//! The probability is at most binomial(k + r − 1, k)·(r·e)ᵏ ≤ (r²·e)ᵏ. The number k ≥ 3 is chosen
//! such that (r²·e)ᵏ < 2⁻¹⁰⁰. Evaluating F/G in [`SizeArithmetic`] bounds deg F and b.
//!
//! The points come from SHAKE256 of the block's text, so builds are reproducible.

use crate::arithmetic::{Arithmetic, FractionSize, PolynomialSize, SizeArithmetic};
use crate::system::Claim;

use super::residual::SampledClaim;
use super::sample::{FieldPlans, MOST_DRAWS, Sample, evaluate_conditions, rows, run};

/// The bound on the error probability of a proof is 2 to the power −`ERROR_EXPONENT`.
pub const ERROR_EXPONENT: u32 = 100;

/// The largest degree of a claim that is proved. At higher degrees, numbers would have millions of
/// digits.
pub(super) const HIGHEST_DEGREE: u64 = 1 << 20;

/// Returns the number of points that prove a claim. Returns `None` if the claim is too large.
pub(super) fn points_for(scheme: &FieldPlans, claim: &Claim) -> Option<u32> {
    let residuals =
        SampledClaim { claim, arithmetic: &SizeArithmetic, sample: &sample(scheme, claim)? }.pairs()?;
    let lengths = residuals.iter().map(|pair| SizeArithmetic.subtract(&pair.left, &pair.right).above);
    let worst = lengths.fold(PolynomialSize::default(), PolynomialSize::max);
    points_needed(worst.degree, worst.bits).filter(|_| worst.degree <= HIGHEST_DEGREE)
}

/// Returns the number of random points at which a quotient F/G of polynomials must be 0 to prove
/// F = 0. The degree of F is `degree`, and the absolute values of its coefficients sum to at most 2
/// to the power `bits`. Returns `None` if the numbers are too large.
#[must_use]
pub fn points_needed(degree: u64, bits: u64) -> Option<u32> {
    let draws = const { MOST_DRAWS as u64 * MOST_DRAWS as u64 };
    let units = (bits / 60 + 1).checked_mul(64)?.checked_add(degree)?.checked_mul(draws)?;
    let lost = u64::BITS - units.leading_zeros();
    let gained = 60u32.checked_sub(lost).filter(|&gained| gained > 0)?;
    Some(ERROR_EXPONENT.div_ceil(gained))
}

/// Takes one step with bounds on sizes in place of values. Cramer's rule bounds the size of x̃.
fn sample(scheme: &FieldPlans, claim: &Claim) -> Option<Sample<FractionSize>> {
    let n = scheme.dimension();
    let mut here = vec![FractionSize::variable(); scheme.variables];
    evaluate_conditions(&claim.conditions, &SizeArithmetic, &mut here)?;
    let eps = here[usize::from(scheme.symbols.epsilon().0)];
    let matrix = rows(&run(&SizeArithmetic, &scheme.matrix, &here)?, n);
    let right = run(&SizeArithmetic, &scheme.numerators, &here)?;
    let mut extended = matrix.clone();
    for (row, right) in extended.iter_mut().zip(&right) {
        row.push(*right);
    }
    // `minor` bounds all minors of `extended`: the denominator and the numerators of the map.
    let minor = SizeArithmetic.determinant(&extended);
    let increment =
        SizeArithmetic.multiply(&SizeArithmetic.add(&eps, &eps), &SizeArithmetic.divide(&minor, &minor)?);
    let mut there = here.clone();
    for value in &mut there[..n] {
        *value = SizeArithmetic.add(value, &increment);
    }
    let back_matrix = rows(&run(&SizeArithmetic, &scheme.matrix, &there)?, n);
    let jacobian_determinant = SizeArithmetic.divide(&SizeArithmetic.determinant(&back_matrix), &minor)?;
    Some(Sample { here, there, matrix, back_matrix, jacobian_determinant })
}
