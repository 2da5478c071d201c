//! `kahan verify --mutate`: no claim may survive the change of a coefficient or a sign.

use std::time::Instant;

use kahan_algebra::system::System;
use kahan_paper::formula::mutations;
use kahan_paper::{Claim, Outcome, Paper, failing_mutation};
use serde_json::{Value, json};

use super::report::NO_CLAIMS;
use crate::printing::{Answer, Prompt};

/// What became of the mutations of one claim.
struct Trial {
    id: String,
    /// How many mutations were tried until one failed.
    tried: usize,
    /// The first that failed, if one did.
    failed: Option<String>,
}

/// Tries the mutations of each claim of the paper until one fails.
pub(super) fn run(paper: &Paper, claims: &[&Claim], as_json: bool) -> Answer {
    let start = Instant::now();
    let progress = Prompt::new(claims.len() as u64, "claims");
    let trials = paper.for_all(claims, |claim| {
        let mut tried = 0;
        let failed = mutations(&claim.statement).into_iter().find(|mutation| {
            tried += 1;
            paper.establish_as(claim, mutation).outcome == Outcome::Failed
        });
        progress.advance(1);
        Trial { id: claim.id.to_string(), tried, failed }
    });
    progress.finish();
    answer(&trials, start, as_json)
}

/// Tries the mutations of each claim of a block until one fails.
pub(super) fn run_block(name: &str, system: &System, as_json: bool) -> Answer {
    let start = Instant::now();
    let progress = Prompt::new(system.claims.len() as u64, "claims");
    let trials = system.claims.iter().enumerate().map(|(index, claim)| {
        let (tried, failed) = failing_mutation(system, index);
        progress.advance(1);
        Trial { id: format!("{name}.{}", claim.name.text), tried, failed }
    });
    let trials: Vec<Trial> = trials.collect();
    progress.finish();
    answer(&trials, start, as_json)
}

fn answer(trials: &[Trial], start: Instant, as_json: bool) -> Answer {
    let survivors: Vec<&str> =
        trials.iter().filter(|trial| trial.failed.is_none()).map(|trial| trial.id.as_str()).collect();
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
            .map(|trial| json!({ "id": trial.id, "tried": trial.tried, "failed": trial.failed }))
            .collect();
        Answer::json(&json!({ "mutations": objects, "survived": survivors.len() }))
    } else if trials.is_empty() {
        Answer::text(format!("{NO_CLAIMS}\n"))
    } else {
        Answer::text(format!(
            "{} {} mutated: {} failed, {at_once} of them at their first mutation; {} survived; {:.2} s\n",
            trials.len(),
            if trials.len() == 1 { "claim" } else { "claims" },
            trials.len() - survivors.len(),
            survivors.len(),
            start.elapsed().as_secs_f64()
        ))
    };
    Answer { complaint, ..answer }
}
