//! How many points prove a claim: a degree and size bound of its residuals, computed, not assumed.
//!
//! Let F/G be one residual (left − right) as the formal fraction that the evaluation forms, F and G
//! integer polynomials in the states, parameters and ε. If the claim is false, some F is not the
//! zero polynomial. A point is a fresh random prime p between 2⁶⁰ and 2⁶¹ and random residues for
//! all variables. The claim passes it wrongly only if
//!
//! * p divides every coefficient of F: at most b/60 primes do, b = log₂ ‖F‖₁, out of more than 2⁵⁴
//!   primes in that range (there are about 2⁶⁰/ln 2^60.5 ≈ 2^54.6), or
//! * F is not zero modulo p but vanishes at the point: at most deg F / p < deg F · 2⁻⁶⁰ (Schwartz
//!   and Zippel).
//!
//! So one draw passes wrongly with probability at most e = b/60 · 2⁻⁵⁴ + deg F · 2⁻⁶⁰.
//!
//! Where something divides by zero, another point is drawn, in two loops of r = 16 turns
//! (`MOST_DRAWS`). A step is drawn up to r times until it has a value, so it passes wrongly with
//! probability at most r·e. A claim that has no value at a step goes on to the next, and less than
//! r steps are passed over in all. A false claim with k points is proved only if k of its first k +
//! r − 1 steps pass wrongly. Steps are independent, and there are binomial(k + r − 1, k) ≤ rᵏ ways
//! to choose the k, so that happens with probability at most (r²·e)ᵏ.
//!
//! k is chosen such that (r²·e)ᵏ < 2⁻¹⁰⁰; it is never below 3. "Random" is SHAKE256 of the block's
//! text, 256 bits of it: more than any such bound needs, builds are reproducible, and whoever
//! writes a block cannot aim at its primes except by trial. deg F and b come from running the very
//! same residuals in the arithmetic of sizes ([`Sizes`]).

use crate::arithmetic::{Arithmetic, Length, Size, Sizes};
use crate::system::Claim;

use super::residual::Test;
use super::sample::{MOST_DRAWS, Sample, Scheme, impose, rows, run};

/// The error of a proof is below 2 to minus this.
pub const ERROR_EXPONENT: u32 = 100;

/// Beyond this degree the exact point alone, with its numbers of millions of digits, would take too
/// long.
pub(super) const HIGHEST_DEGREE: u64 = 1 << 20;

/// The number of points that proves a claim; `None` if no reasonable number does.
pub(super) fn points_for(scheme: &Scheme, claim: &Claim) -> Option<u32> {
    let residuals = Test { claim, arithmetic: &Sizes, sample: &sample(scheme, claim)? }.pairs()?;
    let lengths = residuals.iter().map(|pair| Sizes.subtract(&pair.left, &pair.right).above);
    let worst = lengths.fold(Length::default(), Length::max);
    points_needed(worst.degree, worst.bits).filter(|_| worst.degree <= HIGHEST_DEGREE)
}

/// The number of points for residuals of this degree and size: a k with (r²·e)ᵏ < 2⁻¹⁰⁰, the
/// least for r²·e rounded up to a power of two.
#[must_use]
pub fn points_needed(degree: u64, bits: u64) -> Option<u32> {
    // r²·e in units of 2⁻⁶⁰, where e·2⁶⁰ ≤ 64·(b/60 + 1) + deg F.
    let draws = const { MOST_DRAWS as u64 * MOST_DRAWS as u64 };
    let units = (bits / 60 + 1).checked_mul(64)?.checked_add(degree)?.checked_mul(draws)?;
    let lost = u64::BITS - units.leading_zeros();
    let gained = 60u32.checked_sub(lost).filter(|&gained| gained > 0)?;
    Some(ERROR_EXPONENT.div_ceil(gained))
}

/// One step in the arithmetic of sizes: x̃ by Cramer's rule, determinants by their expansion.
fn sample(scheme: &Scheme, claim: &Claim) -> Option<Sample<Size>> {
    let n = scheme.dimension();
    let mut here = vec![Size::variable(); scheme.variables];
    // A name that a relation is solved for is a quotient of polynomials in the others, of their
    // degrees.
    impose(&claim.conditions, &Sizes, &mut here)?;
    let eps = here[usize::from(scheme.symbols.epsilon().0)];
    let matrix = rows(&run(&Sizes, &scheme.matrix, &here)?, n);
    let right = run(&Sizes, &scheme.numerators, &here)?;
    let mut extended = matrix.clone();
    for (row, right) in extended.iter_mut().zip(&right) {
        row.push(*right);
    }
    // A bound for every n×n minor of (Â | p), so for n̂ⱼ and D̂ alike.
    let minor = Sizes.determinant(&extended);
    let increment = Sizes.multiply(&Sizes.add(&eps, &eps), &Sizes.divide(&minor, &minor)?);
    let mut there = here.clone();
    for value in &mut there[..n] {
        *value = Sizes.add(value, &increment);
    }
    let back_matrix = rows(&run(&Sizes, &scheme.matrix, &there)?, n);
    let jacobian_determinant = Sizes.divide(&Sizes.determinant(&back_matrix), &minor)?;
    Some(Sample { here, there, matrix, back_matrix, jacobian_determinant })
}
