//! Searches for a counterexample of small rationals.

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::ClaimKind;

use crate::arithmetic::{Arithmetic, Exact, solve};
use crate::prime_field::SplitMix64;
use crate::symbols::Symbols;
use crate::system::{Claim, upper_index};

use super::residual::{Identity, SampledClaim};
use super::sample::{FieldPlans, run, small_point, take_step};

/// The largest numerator or denominator in the points of the search.
const MAX_HEIGHT: u64 = 24;
const POINTS_PER_HEIGHT: usize = 48;

/// The reason why a claim is false.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refutation {
    /// The two sides of an identity differ at a point.
    At {
        /// The kind of claim.
        kind: ClaimKind,
        /// The identity that fails.
        place: Identity,
        /// The values of states, parameters and ε.
        point: Vec<Rational>,
        /// The value of the left side.
        left: Rational,
        /// The value of the right side.
        right: Rational,
    },
    /// The claim fails modulo a prime, but no small counterexample was found.
    NoPoint,
}

pub(super) fn refute(scheme: &FieldPlans, claim: &Claim) -> Refutation {
    let mut random = SplitMix64::from_bytes(claim.name.text.as_bytes());
    for height in 1..=MAX_HEIGHT {
        for _ in 0..POINTS_PER_HEIGHT {
            let here = small_point(scheme, &claim.conditions, height, &mut random);
            let Some(sample) = here.and_then(|here| take_step(scheme, &Exact, here)) else { continue };
            if let Some(refutation) = at(&SampledClaim { claim, arithmetic: &Exact, sample: &sample }) {
                return refutation;
            }
        }
    }
    Refutation::NoPoint
}

fn at(test: &SampledClaim<'_, Exact>) -> Option<Refutation> {
    let SampledClaim { claim, sample, .. } = *test;
    let failing = test.pairs()?.into_iter().find(|pair| pair.left != pair.right)?;
    let (left, right) = match failing.place {
        Identity::Entry(i, j) => bracket_entries_at(test, i, j)?,
        Identity::Value | Identity::Jacobi(..) => (failing.left, failing.right),
    };
    Some(Refutation::At { kind: claim.kind, place: failing.place, point: sample.here.clone(), left, right })
}

/// Returns the entries (J P(x) Jᵀ)ᵢⱼ and Pᵢⱼ(x̃) with J = ∂x̃/∂x. Both are equal for an invariant
/// bracket P.
fn bracket_entries_at(test: &SampledClaim<'_, Exact>, i: usize, j: usize) -> Option<(Rational, Rational)> {
    let SampledClaim { claim, sample, .. } = *test;
    let jacobian = solve(&Exact, &sample.matrix, &sample.back_matrix)?.solution;
    let entry = upper_index(jacobian.len(), i, j);
    let here = run(&Exact, &claim.plan, &sample.here)?;
    let left = test.congruence(&jacobian, &here).into_iter().nth(entry)?;
    let right = run(&Exact, &claim.plan, &sample.there)?.into_iter().nth(entry)?;
    (!Exact.is_zero(&Exact.subtract(&left, &right))).then_some((left, right))
}

impl Refutation {
    /// Describes the counterexample in words.
    #[must_use]
    pub fn describe(&self, symbols: &Symbols) -> String {
        let Refutation::At { kind, place, point, left, right } = self else {
            return "it fails modulo a prime".to_owned();
        };
        let names = symbols.states.iter().chain(&symbols.parameters).map(String::as_str).chain(["eps"]);
        let at: Vec<String> = names.zip(point).map(|(name, value)| format!("{name} = {value}")).collect();
        let at = at.join(", ");
        let (left, right) = (shorten(left), shorten(right));
        let state = |i: &usize| symbols.states[*i].as_str();
        match (place, kind) {
            (Identity::Entry(i, j), _) => {
                let entry = format!("{{{},{}}}", state(i), state(j));
                format!("at {at} the map carries {entry} to {left}, but {entry} at the next point is {right}")
            }
            (Identity::Jacobi(i, j, k), _) => {
                let [i, j, k] = [i, j, k].map(state);
                format!("at {at} the Jacobi sum of {i}, {j}, {k} is {left}, not 0")
            }
            (Identity::Value, ClaimKind::Density) => {
                format!("at {at} it is {right}, but its next value times the Jacobian determinant is {left}")
            }
            (Identity::Value, ClaimKind::Drift) => {
                format!("at {at} its next value is {left}, and the formula behind `by` gives {right}")
            }
            (Identity::Value, _) => format!("at {at} it is {right}, and at the next point {left}"),
        }
    }
}

fn shorten(value: &Rational) -> String {
    let text = value.to_string();
    if text.len() <= 80 {
        return text;
    }
    let start: String = text.chars().take(24).collect();
    let size = match value.to_f64() {
        float if float.is_normal() => format!(", about {float:e}"),
        _ => String::new(),
    };
    format!("{start}… ({} characters{size})", text.len())
}
