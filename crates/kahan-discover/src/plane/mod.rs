//! Maps of the plane: exponential growth of degrees that is proved, and that ends the search for
//! integrals.
//!
//! Let φ be Kahan's map in two variables, over K = ℚ(parameters, ε) or ℚ. As A(x)x̃ is affine in
//! x, φ is given by three quadratic forms Φ on ℙ², and dₖ = deg φᵏ ≤ 2ᵏ.
//!
//! **A bound on degrees.** Let φ keep each curve of a pencil, as it does where there is a rational
//! integral, or only permute them. The class w of the curves in the Picard–Manin space has w² = 0,
//! w·ℓ > 0 for the class ℓ of a line, and φ∗w = w. The classes uⱼ = φʲ∗ℓ have uⱼ·w = ℓ·w and
//! uᵢ·uⱼ = d₍ᵢ₋ⱼ₎, so that uᵢ − uⱼ lies in w^⊥, where the form is negative semidefinite (Hodge), and
//! −(uᵢ − uⱼ)² = 2(d₍ᵢ₋ⱼ₎ − 1). By the triangle inequality
//!
//! dₖ − 1 ≤ k²(d₁ − 1) ≤ k².
//!
//! Where degrees do not grow exponentially there is a class w with w² ≥ 0, w·ℓ > 0 and φ∗w = w
//! (Gizatullin; Diller and Favre, "Dynamics of bimeromorphic maps of surfaces", Amer. J. Math. 2001;
//! Cantat 2011), and the inequality holds as well. So one degree dₖ > k² + 1 proves exponential
//! growth, and that φ preserves no pencil of curves: no rational integral exists.
//!
//! **Degrees modulo a prime are lower bounds.** Let R be ℤ[parameters, ε] localised at the prime
//! and the values that were sampled, a factorial ring. By Gauss's lemma Φᵏ = HΨ with forms over R,
//! those of Ψ of degree dₖ. Points of a line that have a k-th image modulo the prime are no zeros of
//! the reduced Φᵏ, nor then of H, and the reduced Ψ gives their images: rational functions on the
//! line, of degree dₖ at most. Thiele's continued fraction of a function of degree d has ended after
//! 2d coefficients. Hence each of [`degrees`](crate::degrees::degrees) is at most the true one,
//! whatever was sampled.
//!
//! **Stability** (dₖ = 2ᵏ for all k) is proved in `stability`.
//!
//! **Linear growth.** The map permutes the curves of one pencil and of no other (Diller and Favre).
//! A [drift](crate::drift) F is constant on them, and so is an integral: it is a function of F, and a
//! constant where the Möbius map of F has infinite order. A finite order n is excluded for F + c, for
//! c·F unless c = −1, and at generic ε: the map with the matrix M, of which (tr M)²/det M is 4
//! cos²(πk/n), would be the identity at ε = 0, where that is 4. Linear growth is an observation, and
//! words must say so.

mod stability;

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::degrees::{DegreeLimits, degrees};
use crate::drift::{Drift, DriftKind};
use crate::growth::{Growth, GrowthVerdict};
use crate::map::ModularMap;
use crate::search_field::SearchField;

/// A proof that degrees grow exponentially.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GrowthProof {
    /// dₖ = 2ᵏ: modulo this prime the map is algebraically stable.
    Stable {
        /// The prime.
        prime: u64,
    },
    /// dₖ > k² + 1.
    Degree {
        /// k
        iterate: usize,
        /// A lower bound of dₖ.
        degree: usize,
    },
}

/// Numbers of iterates that are looked at in turn where growth seems exponential and is not proved;
/// with each number, degrees up to what a proof takes.
const ITERATES: [usize; 4] = [8, 16, 32, 64];

/// The growth class of the degrees of a map, proved exponential where that is possible; `map` is a
/// sample.
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
        exceeding(&crate::degrees::degrees(map, random, limits))
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

/// The number of iterates that are looked at before growth counts as linear.
const LINEAR_ITERATES: usize = 200;

/// The number of iterates over which growth was seen to be linear, where that excludes integrals:
/// one of the drifts has infinite order.
pub(crate) fn linear(
    searched: &SearchField,
    map: &ModularMap,
    growth: &GrowthVerdict,
    drifts: &[Drift],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<usize> {
    let is_infinite = |drift: &Drift| match &drift.kind {
        DriftKind::Sum(_) => true,
        DriftKind::Multiple(factor) => factor != "-1",
        DriftKind::Image => searched.eps().is_none(),
        DriftKind::Link => false,
    };
    if searched.dimension() != 2
        || growth.growth != Growth::Linear
        || !drifts.first().is_some_and(is_infinite)
    {
        return None;
    }
    let limits = DegreeLimits { iterates: LINEAR_ITERATES, degree: 10 * LINEAR_ITERATES, deadline };
    let degrees = degrees(map, random, limits);
    let is_linear = degrees.len() > LINEAR_ITERATES && GrowthVerdict::of(&degrees).growth == Growth::Linear;
    is_linear.then_some(LINEAR_ITERATES)
}

#[cfg(test)]
mod tests;
