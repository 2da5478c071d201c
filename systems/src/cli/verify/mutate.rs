//! `kahan verify --mutate`: no claim may survive the change of a coefficient or a sign.

use std::time::Instant;

use kahan_systems::paper::formula::mutations;
use kahan_systems::paper::{Claim, Outcome, Paper};
use serde_json::{Value, json};

use super::super::output::Answer;
use super::super::progress::Progress;

/// What became of the mutations of one claim.
struct Trial<'a> {
    claim: &'a Claim,
    /// How many mutations were tried until one failed.
    tried: usize,
    /// The first that failed, if one did.
    failed: Option<String>,
}

/// Tries the mutations of each claim until one fails.
pub(super) fn run(paper: &Paper, claims: &[&Claim], as_json: bool) -> Answer {
    let start = Instant::now();
    let progress = Progress::new(claims.len() as u64, "claims");
    let failures = paper.for_all(claims, |claim| {
        let mut tried = 0;
        let failed = mutations(&claim.statement).into_iter().find(|mutation| {
            tried += 1;
            paper.establish_as(claim, mutation).outcome == Outcome::Failed
        });
        progress.advance(1);
        (tried, failed)
    });
    progress.finish();
    let trials: Vec<Trial<'_>> =
        claims.iter().zip(failures).map(|(claim, (tried, failed))| Trial { claim, tried, failed }).collect();
    let survivors: Vec<&str> =
        trials.iter().filter(|trial| trial.failed.is_none()).map(|trial| trial.claim.id.as_str()).collect();
    let complaint = (!survivors.is_empty()).then(|| {
        format!(
            "{} of {} claims survive every mutation: {}",
            survivors.len(),
            trials.len(),
            survivors.join(", ")
        )
    });
    let at_once = trials.iter().filter(|trial| trial.failed.is_some() && trial.tried == 1).count();
    let answer = if as_json {
        let objects: Vec<Value> = trials
            .iter()
            .map(|trial| json!({ "id": trial.claim.id, "tried": trial.tried, "failed": trial.failed }))
            .collect();
        Answer::json(&json!({ "mutations": objects, "survived": survivors.len() }))
    } else {
        Answer::text(format!(
            "{} claims mutated: {} failed, {at_once} of them at their first mutation; {} survived; {:.2} s\n",
            trials.len(),
            trials.len() - survivors.len(),
            survivors.len(),
            start.elapsed().as_secs_f64()
        ))
    };
    Answer { complaint, ..answer }
}
