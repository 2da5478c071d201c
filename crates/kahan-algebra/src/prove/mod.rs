//! Decides whether the claims of a block are true.
//!
//! A claim is an identity between rational functions of states, parameters and ε. `residual` turns
//! it into pairs of values that must agree at points from `sample`. `modular` evaluates the pairs
//! at random points modulo random primes, with error probability below 2⁻¹⁰⁰ ([`sizes`]).
//! `normal_form` expands the pairs over ℚ. `refute` searches for a small exact counterexample.

mod modular;
mod normal_form;
mod refute;
mod residual;
mod sample;
pub mod sizes;

pub use modular::Proof;
pub use normal_form::prove_by_normal_form;
pub use refute::Refutation;
use sizes::HIGHEST_DEGREE;
pub use sizes::{ERROR_EXPONENT, points_needed};

use kahan_syntax::diagnostics::{Diagnostics, Kind};
use kahan_syntax::syntax::ClaimKind;

use crate::poly::Polynomial;
use crate::prime_field::Shake256;
use crate::render::condition_text;
use crate::system::{Claim, Condition, System};

use sample::{FieldPlans, Samples};

/// The result for a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The claim holds.
    Proved(Proof),
    /// The claim is false, as the counterexample shows.
    Refuted(Refutation),
    /// The claim is trivially true, such as an integral without states or a zero bracket.
    Vacuous,
    /// The claim divides by zero at every point.
    Undefined,
    /// No map exists: the claim's conditions (such as ε = 1 if ẋ = x) make det(I − ε f′) zero.
    NoMap,
    /// A proof would take too many points.
    TooLarge,
}

/// Decides every claim of a system in order.
#[must_use]
pub fn prove_all(system: &System, seed: [u8; 32]) -> Vec<Verdict> {
    if system.claims.is_empty() {
        return Vec::new();
    }
    let scheme = FieldPlans::of(&system.field);
    let mut random = Shake256::new(&seed);
    // Claims with equal conditions are tested at the same points.
    let mut groups: Vec<Samples<'_>> = Vec::new();
    let mut verdicts = Vec::new();
    for claim in &system.claims {
        let known = groups.iter().position(|group| are_equal(group.conditions, &claim.conditions));
        let group = known.unwrap_or_else(|| {
            groups.push(Samples::new(&claim.conditions, random.next_seed()));
            groups.len() - 1
        });
        verdicts.push(modular::decide(&scheme, claim, &mut groups[group]));
    }
    verdicts
}

fn are_equal(a: &[Condition], b: &[Condition]) -> bool {
    let values = |conditions: &[Condition]| {
        conditions.iter().map(|condition| (condition.variable, condition.value.clone())).collect::<Vec<_>>()
    };
    a.len() == b.len() && values(a) == values(b)
}

/// The most operations that the claims of a block may take at each random point.
const MOST_OPERATIONS: usize = 1_500_000;

/// Estimates the number of operations at a point for all claims. An elimination of n unknowns
/// counts as n³/16 operations.
fn operations(system: &System) -> usize {
    let n = system.field.dimension();
    let terms: usize = system.field.numerators().map(Polynomial::len).sum();
    let one = |claim: &Claim| claim.plan.operations.len() + terms + n.saturating_pow(3) / 16;
    system.claims.iter().map(one).fold(0, usize::saturating_add)
}

/// Reports the claims that are false or too large to prove.
pub fn check_claims(system: &System, seed: [u8; 32], diagnostics: &mut Diagnostics) {
    if let Some(claim) = system.claims.last()
        && operations(system) > MOST_OPERATIONS
    {
        let count = system.claims.len();
        let message = format!(
            "the claims of this block, {count} in all, take more than {MOST_OPERATIONS} operations at a point to prove"
        );
        let help =
            "claim less in one block, or shorter formulas; of many equations that are alike write a family";
        diagnostics.report(Kind::TooLarge, claim.name.span, message, help);
        return;
    }
    for (claim, verdict) in system.claims.iter().zip(prove_all(system, seed)) {
        report(system, claim, &verdict, diagnostics);
    }
}

fn report(system: &System, claim: &Claim, verdict: &Verdict, diagnostics: &mut Diagnostics) {
    let name = &claim.name.text;
    let keyword = claim.kind.keyword();
    let (kind, message, help) = match verdict {
        Verdict::Proved(_) => return,
        Verdict::Refuted(refutation) => (
            Kind::FalseClaim,
            format!("does not hold: {}", refutation.describe(&system.field.symbols)),
            "correct the formula, or remove the claim; eps is half the time step, and `kahan discover` finds what the map keeps",
        ),
        Verdict::Vacuous => {
            let why = match claim.kind {
                ClaimKind::Integral | ClaimKind::Drift => "it depends on no state",
                ClaimKind::Density | ClaimKind::Bracket => "it is zero",
            };
            let help = "claim something that depends on the states, or remove the claim";
            (Kind::Claim, format!("says nothing: {why}"), help)
        }
        Verdict::Undefined => {
            let help = "no point gives it a value: correct its divisors";
            (Kind::Claim, "divides by zero identically".to_owned(), help)
        }
        Verdict::NoMap => {
            let conditions = condition_text(system, claim);
            let message = format!("is about no map: at {conditions} det A is 0 everywhere");
            (Kind::Claim, message, "choose other values behind `when`")
        }
        Verdict::TooLarge => {
            let why = "has too high a degree to be proved: with its map put in, more than";
            (Kind::TooLarge, format!("{why} {HIGHEST_DEGREE}"), "write the claim with smaller powers")
        }
    };
    diagnostics.report(kind, claim.name.span, format!("the {keyword} `{name}` {message}"), help);
}
