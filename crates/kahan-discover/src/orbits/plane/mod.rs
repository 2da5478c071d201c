//! Maps of the plane: proofs that degrees grow exponentially, and growth as the end of a search.
//!
//! Let φ be Kahan's map in two variables, over K = ℚ(parameters, ε) or ℚ. A(x)x̃ is affine in x, so
//! three quadratic forms Φ on ℙ² give φ, and dₖ = deg φᵏ ≤ 2ᵏ.
//!
//! **A bound on degrees.** Suppose that φ preserves a pencil of curves: it keeps each curve (as it
//! does if there is a rational integral) or permutes the curves. Let w be the class of these curves
//! in the Picard–Manin space, and ℓ the class of a line. Then w² = 0, w·ℓ > 0 and φ∗w = w. The
//! classes uⱼ = φʲ∗ℓ satisfy uⱼ·w = ℓ·w and uᵢ·uⱼ = d₍ᵢ₋ⱼ₎. So uᵢ − uⱼ lies in w^⊥, on which the
//! form is negative semidefinite (Hodge), and −(uᵢ − uⱼ)² = 2(d₍ᵢ₋ⱼ₎ − 1). The triangle inequality
//! gives
//!
//! dₖ − 1 ≤ k²(d₁ − 1) ≤ k².
//!
//! If degrees do not grow exponentially, then there is a class w with w² ≥ 0, w·ℓ > 0 and φ∗w = w
//! (Gizatullin; Diller and Favre, "Dynamics of bimeromorphic maps of surfaces", Amer. J. Math.
//! 2001; Cantat 2011), and the inequality holds as well. So a single degree dₖ > k² + 1 proves that
//! growth is exponential and that φ preserves no pencil of curves: no rational integral exists.
//!
//! **Degrees modulo a prime are lower bounds.** Let R be ℤ[parameters, ε] localised at the prime
//! ideal of the prime and the sampled values; R is factorial. By Gauss's lemma Φᵏ = HΨ with forms
//! over R, where Ψ has degree dₖ. If a point of a line has a k-th image modulo the prime, then the
//! reduced Φᵏ is not zero there, nor is H, so the reduced Ψ gives this image. On the line these
//! images are rational functions of degree at most dₖ. Thiele's continued fraction of a function of
//! degree d ends after at most 2d coefficients. Hence each of
//! [`degrees`](crate::orbits::degrees::degrees) is at most the true degree, whatever was sampled.
//!
//! **Stability** (dₖ = 2ᵏ for all k) is proved in `stability`.
//!
//! **Linear growth.** The map permutes the curves of exactly one pencil (Diller and Favre). It acts
//! on the parameter t of this pencil by a Möbius map μ. A [drift](crate::drift) F and an integral
//! are both constant on the curves, so both are functions of t. If the next value of F has infinite
//! order as a Möbius map of F, then so has μ, and every integral is constant. The order of F + c is
//! infinite, and so is that of c·F unless c = −1. At generic ε, and for a field with a value at
//! ε = 0, the order of the map of F with the matrix M is infinite, too: for order n > 1 the
//! function (tr M)²/det M is 4 cos²(πk/n) < 4 at all ε, but the map is the identity at ε = 0, where
//! the function is 4. Linear growth is an observation, and sentences must say so.

mod stability;

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::drift::{Drift, DriftKind};
use crate::maps::map::ModularMap;
use crate::maps::search_field::SearchField;
use crate::orbits::degrees::{self, DegreeLimits};
use crate::orbits::growth::{Growth, GrowthVerdict};

/// A proof that degrees grow exponentially.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GrowthProof {
    /// dₖ = 2ᵏ for all k, because the map is algebraically stable modulo this prime.
    Stable {
        /// The prime.
        prime: u64,
    },
    /// One degree dₖ > k² + 1.
    Degree {
        /// k
        iterate: usize,
        /// A lower bound of dₖ.
        degree: usize,
    },
}

/// The numbers of iterates that are tried in turn if growth seems exponential and the given degrees
/// do not prove it. With k iterates, degrees up to k² + 1 are computed.
const ITERATES: [usize; 4] = [8, 16, 32, 64];

/// The growth class of the degrees of a map, with a proof if growth is exponential in the plane.
/// `map` is a sample of `searched`.
pub(crate) fn growth(
    searched: &SearchField,
    map: &ModularMap,
    degrees: &[usize],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> GrowthVerdict {
    let mut verdict = GrowthVerdict::of(degrees);
    if searched.dimension() != 2 {
        return verdict;
    }
    let exceeding = |degrees: &[usize]| {
        let mut numbered = degrees.iter().copied().enumerate();
        numbered.find(|&(k, degree)| degree > k * k + 1)
    };
    let shows = verdict.growth.entropy() > 0.0;
    let mut further = ITERATES.iter().filter(|_| shows).filter_map(|&iterates| {
        let limits = DegreeLimits { iterates, degree: iterates * iterates + 1, deadline };
        exceeding(&degrees::degrees(map, random, limits))
    });
    let seen = exceeding(degrees).or_else(|| further.next());
    let Some((iterate, degree)) = seen else { return verdict };
    let is_doubled = degrees.windows(2).all(|pair| pair[1] == 2 * pair[0]);
    let stable = is_doubled.then(|| stability::prime_of_stability(searched, random, deadline)).flatten();
    let entropy = match (stable, verdict.growth, degrees) {
        (Some(_), ..) => std::f64::consts::LN_2,
        (None, Growth::Exponential { entropy }, _) => entropy,
        (None, _, [.., before, last]) => (*last as f64 / (*before).max(1) as f64).ln(),
        (None, ..) => 0.0,
    };
    verdict.growth = Growth::Exponential { entropy };
    verdict.proof =
        Some(stable.map_or(GrowthProof::Degree { iterate, degree }, |prime| GrowthProof::Stable { prime }));
    verdict
}

/// The number of iterates over which growth must be linear to count as linear.
const LINEAR_ITERATES: usize = 200;

/// Returns the number of iterates over which growth is linear, if linear growth excludes integrals:
/// the next value of the first drift has infinite order. `None` otherwise.
pub(crate) fn linear(
    searched: &SearchField,
    map: &ModularMap,
    growth: &GrowthVerdict,
    drifts: &[Drift],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<usize> {
    let is_generic = searched.eps().is_none() && searched.family().has_limit();
    let is_infinite =
        |drift: &Drift| drift.kind.has_infinite_order() || drift.kind == DriftKind::Image && is_generic;
    if searched.dimension() != 2
        || growth.growth != Growth::Linear
        || !drifts.first().is_some_and(is_infinite)
    {
        return None;
    }
    let limits = DegreeLimits { iterates: LINEAR_ITERATES, degree: 10 * LINEAR_ITERATES, deadline };
    let degrees = degrees::degrees(map, random, limits);
    let is_linear = degrees.len() > LINEAR_ITERATES && GrowthVerdict::of(&degrees).growth == Growth::Linear;
    is_linear.then_some(LINEAR_ITERATES)
}

#[cfg(test)]
mod tests;
