//! `kahan verify`: the claims of the catalog, or of a field of one's own, proved again from their text.
//!
//! The macro proves a claim modulo primes. Here a claim must pass that proof and a second one that shares no step with
//! it: both sides expanded over ℚ (`proved`). Where the expansion would be too large, the first proof stands alone
//! (`proved mod p`), and the table says so.

use std::time::{Duration, Instant};

use clap::Args;
use kahan_algebra::prove::{ERROR_EXPONENT, Verdict, prove_all, prove_by_normal_form};
use kahan_algebra::render::{Notation, claim_statement, claim_text, condition_text};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_systems::registry::SYSTEMS;
use serde_json::{Value, json};

use super::input::{Block, Source};
use super::output::{Answer, Refusal, columns, shorten, widths};

/// Proves every claim of the catalog, of one system, or of a field of your own.
///
/// Each claim is proved modulo primes, as the macro does it, and then by expanding both sides over the rational numbers.
/// The exit status is 1 if a claim does not hold.
#[derive(Args, Debug, Default)]
#[command(after_long_help = EXAMPLES)]
pub(crate) struct Verify {
    #[command(flatten)]
    source: Source,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan verify
  kahan verify e6 --json
  kahan verify e9 --param xi=1
  kahan verify --field 'xdot = y; ydot = -x; integral H = x^2 + y^2;'";

/// What is known of a claim.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Proved,
    ProvedModP,
    Failed,
}

/// A claim and its outcome.
struct Verified {
    id: String,
    system: String,
    source: String,
    /// The claim in the language of `kahan!`.
    statement: String,
    /// Keyword and name, formula, place, outcome, milliseconds.
    row: Vec<String>,
    outcome: Outcome,
    detail: String,
    elapsed: Duration,
}

/// The claims of one system under its title.
struct Group {
    title: String,
    claims: Vec<Verified>,
}

impl Verify {
    /// The table, or `claims` and `failed`; a complaint if a claim fails.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let start = Instant::now();
        let blocks = match self.source.block()? {
            Some(block) => vec![block],
            None => SYSTEMS.iter().map(Block::of_catalog).collect(),
        };
        let groups = blocks
            .iter()
            .map(|block| verify_block(block, &self.source))
            .collect::<Result<Vec<Group>, Refusal>>()?;
        let claims: Vec<&Verified> = groups.iter().flat_map(|group| &group.claims).collect();
        let failed: Vec<&str> =
            with_outcome(&claims, Outcome::Failed).map(|claim| claim.id.as_str()).collect();
        let complaint = (!failed.is_empty())
            .then(|| format!("{} of {} claims failed: {}", failed.len(), claims.len(), failed.join(", ")));
        let answer = if self.json {
            let objects: Vec<Value> = claims.iter().map(|claim| claim.json()).collect();
            Answer::json(&json!({ "claims": objects, "failed": failed.len() }))
        } else {
            Answer::text(table(&groups) + &totals(&claims, start.elapsed()))
        };
        Ok(Answer { complaint, ..answer })
    }
}

fn verify_block(block: &Block, source: &Source) -> Result<Group, Refusal> {
    let system = block.unproved_system()?;
    let name = block.name(&system);
    let system = source.specialised(system, &name)?;
    let title = block.entry.map_or_else(|| name.clone(), |entry| format!("{name}: {}", entry.title));
    let claims = system.claims.iter().map(|claim| verify_claim(block, &system, &name, claim)).collect();
    Ok(Group { title, claims })
}

fn verify_claim(block: &Block, system: &System, name: &str, claim: &Claim) -> Verified {
    let start = Instant::now();
    let (outcome, how) = decide(system, claim, block.seed());
    let elapsed = start.elapsed();
    let milliseconds = format!("{:.1}", elapsed.as_secs_f64() * 1000.0);
    let source = block.entry.and_then(|entry| entry.source(&claim.name.text)).unwrap_or_default().to_owned();
    let row = vec![
        format!("{} {}", claim.kind.keyword(), claim.name.text),
        short_statement(system, claim),
        source.clone(),
        outcome.words(),
        format!("{milliseconds:>6} ms"),
    ];
    Verified {
        id: format!("{name}.{}", claim.name.text),
        system: name.to_owned(),
        source,
        statement: claim_text(system, claim),
        row,
        outcome,
        detail: how,
        elapsed,
    }
}

/// Both proofs of one claim.
fn decide(system: &System, claim: &Claim, seed: u64) -> (Outcome, String) {
    let alone = System { claims: vec![claim.clone()], ..system.clone() };
    let points = match prove_all(&alone, seed).pop().flatten() {
        Some(Verdict::Proved(proof)) => proof.points,
        Some(Verdict::Refuted(refutation)) => {
            return (Outcome::Failed, refutation.describe(&system.field.symbols));
        }
        Some(Verdict::Vacuous) => return (Outcome::Failed, "it says nothing".to_owned()),
        Some(Verdict::NoMap) => {
            return (Outcome::Failed, "det A is 0 everywhere there: there is no map".to_owned());
        }
        Some(Verdict::Undefined) => return (Outcome::Failed, "it divides by zero identically".to_owned()),
        Some(Verdict::TooLarge) | None => {
            return (Outcome::Failed, "its degree is too high to be proved".to_owned());
        }
    };
    match prove_by_normal_form(system, claim) {
        Some(true) => (Outcome::Proved, "by normal forms over Q, and modulo primes".to_owned()),
        None => (
            Outcome::ProvedModP,
            format!("at {points} random points modulo primes, error < 2^-{ERROR_EXPONENT}"),
        ),
        Some(false) => (Outcome::Failed, "the normal forms of its two sides differ".to_owned()),
    }
}

/// The formula, cut to a column's width, with its condition whole.
fn short_statement(system: &System, claim: &Claim) -> String {
    const WIDTH: usize = 46;
    let statements = claim_statement(claim, Notation::Text).into_iter();
    let formula: Vec<String> = match claim.kind {
        ClaimKind::Bracket => statements.map(|(pair, value)| format!("{pair} = {value}")).collect(),
        _ => statements.map(|(_, value)| value).collect(),
    };
    let condition = condition_text(system, claim);
    let when = if condition.is_empty() { String::new() } else { format!(" when {condition}") };
    shorten(&formula.join(", "), WIDTH.saturating_sub(when.chars().count())) + &when
}

impl Outcome {
    fn words(self) -> String {
        match self {
            Outcome::Proved => "proved".to_owned(),
            Outcome::ProvedModP => format!("proved mod p (error < 2^-{ERROR_EXPONENT})"),
            Outcome::Failed => "FAILED".to_owned(),
        }
    }

    fn key(self) -> &'static str {
        match self {
            Outcome::Proved => "proved",
            Outcome::ProvedModP => "proved-mod-p",
            Outcome::Failed => "failed",
        }
    }
}

impl Verified {
    fn json(&self) -> Value {
        json!({
            "id": self.id,
            "system": self.system,
            "source": self.source,
            "statement": self.statement,
            "outcome": self.outcome.key(),
            "detail": format!("{} ({:.1} ms)", self.detail, self.elapsed.as_secs_f64() * 1000.0),
        })
    }
}

fn with_outcome<'a>(claims: &'a [&Verified], outcome: Outcome) -> impl Iterator<Item = &'a Verified> {
    claims.iter().copied().filter(move |claim| claim.outcome == outcome)
}

fn table(groups: &[Group]) -> String {
    let widths = widths(groups.iter().flat_map(|group| &group.claims).map(|claim| &claim.row));
    let mut text = String::new();
    for group in groups {
        text.push_str(&format!("{}\n", group.title));
        for claim in &group.claims {
            text.push_str(&format!("  {}\n", columns(&claim.row, &widths)));
            if claim.outcome == Outcome::Failed {
                text.push_str(&format!("    {}\n", claim.detail));
            }
        }
        text.push('\n');
    }
    text
}

fn totals(claims: &[&Verified], elapsed: Duration) -> String {
    let count = |outcome: Outcome| with_outcome(claims, outcome).count();
    format!(
        "{} claims: {} proved by normal forms over Q, {} proved mod p (error < 2^-{ERROR_EXPONENT}), {} failed; {:.2} s\n",
        claims.len(),
        count(Outcome::Proved),
        count(Outcome::ProvedModP),
        count(Outcome::Failed),
        elapsed.as_secs_f64()
    )
}
