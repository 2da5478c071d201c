//! Maps of the plane: proofs of exponential growth of degrees, and conclusions from linear growth.
//!
//! Let φ be Kahan's map in two variables. Three quadratic forms Φ on ℙ² define φ, so the iterates
//! have degrees dₖ = deg φᵏ ≤ 2ᵏ. The function `growth` proves exponential growth by one large
//! degree or by the module `stability`. The function `linear` excludes integrals by observed linear
//! growth and a drift of infinite order.

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
    /// The map is algebraically stable modulo a prime, so the iterates have the degrees 2ᵏ.
    Stable {
        /// The prime modulo which the map is stable.
        prime: u64,
    },
    /// Iterate k has a degree dₖ > k² + 1, which proves exponential growth.
    Degree {
        /// The number k of the iterate.
        iterate: usize,
        /// A lower bound of the degree dₖ.
        degree: usize,
    },
}

/// The numbers k of the iterates to try in turn. The proof needs a degree dₖ > k² + 1.
const TRIED_ITERATES: [usize; 4] = [8, 16, 32, 64];

/// Classifies the growth of the degrees of a sampled map, and proves exponential growth in the
/// plane.
///
/// **A bound on degrees.** Let dₖ = deg φᵏ for the map φ. Suppose that φ permutes the curves of a
/// pencil. Let w be the class of these curves in the Picard–Manin space, ℓ that of a line, and u·v
/// the intersection form. Then φ∗w = w, w² = 0 and w·ℓ > 0. The classes uⱼ = φʲ∗ℓ satisfy uⱼ·w =
/// ℓ·w and uᵢ·uⱼ = d_{|i−j|}. Therefore uᵢ − uⱼ lies in w^⊥, on which the intersection form is
/// negative semidefinite (Hodge), and −(uᵢ − uⱼ)² is 2(d_{|i−j|} − 1). The triangle inequality
/// gives
///
/// dₖ − 1 ≤ k²(d₁ − 1) ≤ k².
///
/// If degrees do not grow exponentially, a real class w with w² ≥ 0, w·ℓ > 0 and φ∗w = w exists
/// (Gizatullin; Diller and Favre, "Dynamics of bimeromorphic maps of surfaces", Amer. J. Math.
/// 2001; Cantat 2011), and the inequality follows in the same way. So a single degree dₖ > k² + 1
/// proves that growth is exponential and that no rational integral exists.
///
/// **Degrees modulo a prime are lower bounds.** Let R be ℤ[parameters, ε], localised at the ideal
/// of polynomials that vanish modulo the prime at the sampled values. R is factorial. Let Φ be the
/// homogeneous components of the map. By Gauss's lemma their k-th iterate is HΨ over R with a
/// common factor H, and Ψ has degree dₖ. Suppose that a point has an image under φᵏ modulo the
/// prime. Then Ψ modulo the prime gives this image. On a line these images are rational functions
/// of degree at most dₖ, and Thiele's continued fraction finds no higher degree.
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
    let mut further = TRIED_ITERATES.iter().filter(|_| shows).filter_map(|&iterates| {
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
        (None, _, [.., before, last]) => libm::log(*last as f64 / (*before).max(1) as f64),
        (None, ..) => 0.0,
    };
    verdict.growth = Growth::Exponential { entropy };
    verdict.proof =
        Some(stable.map_or(GrowthProof::Degree { iterate, degree }, |prime| GrowthProof::Stable { prime }));
    verdict
}

/// The number of iterates over which degrees must grow linearly before growth is called linear.
const LINEAR_ITERATES: usize = 200;

/// Returns the number of iterates over which degrees grow linearly, if this excludes integrals.
///
/// A map of linear growth permutes the curves of exactly one pencil (Diller and Favre). The
/// parameter t of the pencil changes by a Möbius map μ. A drift is a function F that a step changes
/// by a Möbius map. Integrals and drifts are functions of t. If a drift changes by a Möbius map of
/// infinite order, μ has infinite order, and every integral is constant.
///
/// The Möbius maps F + c with c ≠ 0, and c·F with c ≠ ±1, have infinite order. Any other one has
/// infinite order at generic ε if the field is defined at ε = 0. For the matrix M of the Möbius
/// map, a finite order n > 1 means (tr M)²/det M = 4 cos²(πk/n) < 4 at all ε. But at ε = 0 the map
/// is the identity, and this quotient is 4. Linear growth itself is observed, not proved.
pub(crate) fn linear(
    searched: &SearchField,
    map: &ModularMap,
    growth: &GrowthVerdict,
    drifts: &[Drift],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<usize> {
    let is_generic = searched.eps().is_none() && searched.family().has_limit_at_eps_zero();
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
