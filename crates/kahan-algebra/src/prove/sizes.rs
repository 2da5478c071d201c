//! The number of points that proves a claim, from bounds on the degree and size of its residuals.
//!
//! # Proof
//!
//! Let F/G be a residual as formed by the evaluation, with integer polynomials F and G in states,
//! parameters and ε. For a false claim some F ≠ 0. A point is a random prime p between 2⁶⁰ and 2⁶¹
//! with random residues. A false claim passes only if
//!
//! * p divides every coefficient of F: at most b/60 primes do, b = log₂ ‖F‖₁, out of more than 2⁵⁴
//!   (about 2⁶⁰/ln 2^60.5 ≈ 2^54.6), or
//! * F vanishes at the point modulo p: probability at most deg F · 2⁻⁶⁰ (Schwartz and Zippel).
//!
//! So one point passes with probability at most e = b/60 · 2⁻⁵⁴ + deg F · 2⁻⁶⁰. If a step divides
//! by zero, another point is drawn, up to r = 16 times (`MOST_DRAWS`). So a step passes with
//! probability at most r·e. Fewer than r steps where the claim has no value are skipped. A false
//! claim is proved with k points only if k of its first k + r − 1 independent steps pass:
//! probability at most binomial(k + r − 1, k)·(r·e)ᵏ ≤ (r²·e)ᵏ. k ≥ 3 is chosen with (r²·e)ᵏ <
//! 2⁻¹⁰⁰. Points come from SHAKE256 of the block's text: builds are reproducible, and authors can
//! influence the primes only by trying texts. Evaluation of the residuals in [`SizeArithmetic`] bounds deg F
//! and b.

use crate::arithmetic::{Arithmetic, FractionSize, PolynomialSize, SizeArithmetic};
use crate::system::Claim;

use super::residual::SampledClaim;
use super::sample::{MOST_DRAWS, Sample, Scheme, evaluate_conditions, rows, run};

/// The error probability of a proof is below 2 to minus this.
pub const ERROR_EXPONENT: u32 = 100;

/// The largest degree to prove; numbers at the exact point would have millions of digits beyond.
pub(super) const HIGHEST_DEGREE: u64 = 1 << 20;

/// Returns the number of points that proves a claim; `None` if no reasonable number does.
pub(super) fn points_for(scheme: &Scheme, claim: &Claim) -> Option<u32> {
    let residuals =
        SampledClaim { claim, arithmetic: &SizeArithmetic, sample: &sample(scheme, claim)? }.pairs()?;
    let lengths = residuals.iter().map(|pair| SizeArithmetic.subtract(&pair.left, &pair.right).above);
    let worst = lengths.fold(PolynomialSize::default(), PolynomialSize::max);
    points_needed(worst.degree, worst.bits).filter(|_| worst.degree <= HIGHEST_DEGREE)
}

/// Returns the least k with (r²·e)ᵏ < 2⁻¹⁰⁰, after rounding r²·e up to a power of two.
#[must_use]
pub fn points_needed(degree: u64, bits: u64) -> Option<u32> {
    // r²·e in units of 2⁻⁶⁰, where e·2⁶⁰ ≤ 64·(b/60 + 1) + deg F.
    let draws = const { MOST_DRAWS as u64 * MOST_DRAWS as u64 };
    let units = (bits / 60 + 1).checked_mul(64)?.checked_add(degree)?.checked_mul(draws)?;
    let lost = u64::BITS - units.leading_zeros();
    let gained = 60u32.checked_sub(lost).filter(|&gained| gained > 0)?;
    Some(ERROR_EXPONENT.div_ceil(gained))
}

/// Takes one step in the arithmetic of sizes: x̃ by Cramer's rule, determinants by expansion.
fn sample(scheme: &Scheme, claim: &Claim) -> Option<Sample<FractionSize>> {
    let n = scheme.dimension();
    let mut here = vec![FractionSize::variable(); scheme.variables];
    // A name that a relation is solved for becomes a quotient of polynomials in the others.
    evaluate_conditions(&claim.conditions, &SizeArithmetic, &mut here)?;
    let eps = here[usize::from(scheme.symbols.epsilon().0)];
    let matrix = rows(&run(&SizeArithmetic, &scheme.matrix, &here)?, n);
    let right = run(&SizeArithmetic, &scheme.numerators, &here)?;
    let mut extended = matrix.clone();
    for (row, right) in extended.iter_mut().zip(&right) {
        row.push(*right);
    }
    // One bound serves every n×n minor of (Â | p), hence D̂ and each n̂ⱼ.
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
