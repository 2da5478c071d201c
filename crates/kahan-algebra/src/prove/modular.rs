//! Proves claims at random points modulo random primes and at one exact point. [`super::sizes`]
//! bounds the error. A claim that is undefined at 16 exact points is proved by primes alone, unless
//! a counterexample is found.

use kahan_syntax::syntax::ClaimKind;

use crate::arithmetic::{Exact, OverRationals};
use crate::system::Claim;

use super::Verdict;
use super::refute::{Refutation, refute};
use super::residual::SampledClaim;
use super::sample::{FieldPlans, MOST_DRAWS, Samples};
use super::sizes::points_for;

/// The result of a successful proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Proof {
    /// The number of points. Each point has its own prime. The error probability is below 2⁻¹⁰⁰.
    pub points: u32,
}

struct Evidence {
    holds: bool,
    /// Whether the gradient, density or bracket of the claim is nonzero at the point.
    says_something: bool,
}

pub(super) fn decide(scheme: &FieldPlans, claim: &Claim, samples: &mut Samples<'_>) -> Verdict {
    let Some(needed) = points_for(scheme, claim) else { return Verdict::TooLarge };
    let (mut accepted, mut drawn, mut says_something) = (0, 0, false);
    while accepted < needed {
        if drawn >= accepted as usize + MOST_DRAWS {
            return Verdict::Undefined;
        }
        let Some((arithmetic, sample)) = samples.modular(scheme, drawn) else {
            return Verdict::NoMap;
        };
        drawn += 1;
        let Some(evidence) = examine(&SampledClaim { claim, arithmetic, sample }) else { continue };
        if !evidence.holds {
            return Verdict::Refuted(refute(scheme, claim));
        }
        accepted += 1;
        says_something |= evidence.says_something;
    }
    if !says_something {
        return Verdict::Vacuous;
    }
    match exact_check(scheme, claim, samples) {
        Some(true) => Verdict::Proved(Proof { points: needed }),
        Some(false) => Verdict::Refuted(refute(scheme, claim)),
        None => Verdict::Undefined,
    }
}

/// Returns whether the claim holds at a point of small rational numbers. Returns `None` if no step
/// from such a point is found.
fn exact_check(scheme: &FieldPlans, claim: &Claim, samples: &mut Samples<'_>) -> Option<bool> {
    for index in 0..MOST_DRAWS {
        let sample = samples.exact(scheme, index)?;
        if let Some(evidence) = examine(&SampledClaim { claim, arithmetic: &Exact, sample }) {
            return Some(evidence.holds);
        }
    }
    // The claim is undefined at all points above. Unless `refute` finds a counterexample, the proof
    // modulo primes stands.
    Some(refute(scheme, claim) == Refutation::NoPoint)
}

fn examine<A: OverRationals>(test: &SampledClaim<'_, A>) -> Option<Evidence> {
    let (pairs, arithmetic) = (test.pairs()?, test.arithmetic);
    let holds = pairs.iter().all(|pair| arithmetic.is_zero(&arithmetic.subtract(&pair.left, &pair.right)));
    let says_something = test.gradients()?.iter().any(|value| match test.claim.kind {
        ClaimKind::Integral | ClaimKind::Drift => {
            value.gradient.iter().any(|slope| !arithmetic.is_zero(slope))
        }
        ClaimKind::Density | ClaimKind::Bracket => !arithmetic.is_zero(&value.value),
    });
    Some(Evidence { holds, says_something })
}
