//! Verifies claims of a field or of Hone and Petrera's paper, and checks that changed claims fail.

use kahan_algebra::render::claim_text;
use kahan_discover::Watch;
use kahan_paper::formula::mutations;
use kahan_paper::{
    Claim, OPEN, Outcome, Paper, Verdict, Verdicts, establish_block_claim, failing_mutation, in_one_line,
};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::study::Study;

use super::seconds_since;

/// A request to check the claims of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Verify {
    /// Whether to change a coefficient or sign of each claim; the changed claims must fail.
    pub mutate: bool,
}

/// The results for all claims.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Verified {
    /// The results for the unchanged claims.
    Claims(#[serde(serialize_with = "object")] Verdicts),
    /// The results for changed claims.
    Mutations(Mutations),
}

/// The results of changing each claim.
#[derive(Clone, Debug, Serialize)]
pub struct Mutations {
    /// The results for each claim.
    pub mutations: Vec<Mutated>,
    /// The number of claims that no tried change of a coefficient or sign made false.
    pub survived: usize,
    /// The duration of the check in seconds; `None` without a clock.
    #[serde(skip)]
    pub seconds: Option<f64>,
}

/// The results of changing one claim.
#[derive(Clone, Debug, Serialize)]
pub struct Mutated {
    /// The name of the claim, preceded by the name of its system.
    pub id: String,
    /// The number of changes that were tried until the claim failed.
    pub tried: usize,
    /// The first change after which the claim failed; `None` if all changed claims hold.
    pub failed: Option<String>,
}

impl Verify {
    /// Verifies the claims of a field. For an unchanged system of the catalog, these are the claims
    /// of Hone and Petrera's paper. Takes milliseconds for each claim; claims about an orbit take
    /// some hundred times as long.
    ///
    /// # Errors
    /// [`StudyError::UndefinedField`]; with `mutate`, also a claim that does not hold.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Verified, StudyError> {
        if let Some(name) = study.as_it_stands() {
            return Ok(self.of_paper(Some(name), watch));
        }
        let begun = watch.now();
        if self.mutate {
            study.proved()?;
        }
        let system = study.specialised()?;
        let count = WorkCount::new("claims", system.claims.len() as u64, watch);
        let id = |name: &str| format!("{}.{name}", study.name());
        let claims = system.claims.iter().enumerate().take_while(|_| !count.is_stopped());
        Ok(if self.mutate {
            let mutated = claims.map(|(index, claim)| {
                let (tried, failed) = failing_mutation(&system, index);
                count.add(1);
                Mutated { id: id(&claim.name.text), tried, failed }
            });
            Mutations::of(mutated.collect(), seconds_since(begun, watch))
        } else {
            let verdicts = claims.map(|(_, claim)| {
                let begun = watch.now();
                let (outcome, detail) = establish_block_claim(&system, claim, study.seed());
                count.add(1);
                Verdict {
                    id: id(&claim.name.text),
                    system: study.name().to_owned(),
                    source: study.source(&claim.name.text).unwrap_or_default().to_owned(),
                    statement: in_one_line(&claim_text(&system, claim)),
                    outcome,
                    detail,
                    seconds: seconds_since(begun, watch),
                    claim: None,
                }
            });
            Verified::Claims(Verdicts::of(verdicts.collect(), &[], seconds_since(begun, watch)))
        })
    }

    /// Verifies the paper's claims about one system. The name `general` selects the claims about
    /// every field, and `None` selects all claims, which take about a minute on one processor.
    #[must_use]
    pub fn of_paper(&self, system: Option<&str>, watch: &dyn Watch) -> Verified {
        let begun = watch.now();
        let paper = Paper::new();
        let is_meant = |claim: &&Claim| system.is_none_or(|system| claim.system == system);
        let claims: Vec<&Claim> = paper.claims().iter().filter(is_meant).collect();
        let count = WorkCount::new("claims", claims.len() as u64, watch);
        if self.mutate {
            let mutations = for_each_claim(&paper, &claims, &count, |claim| mutated(&paper, claim));
            return Mutations::of(mutations, seconds_since(begun, watch));
        }
        let claims = for_each_claim(&paper, &claims, &count, |claim| {
            let begun = watch.now();
            let verdict = paper.verdict(claim);
            Verdict { seconds: seconds_since(begun, watch), ..verdict }
        });
        let open = if system.is_none() { OPEN } else { &[] };
        Verified::Claims(Verdicts::of(claims, open, seconds_since(begun, watch)))
    }
}

/// Applies a function to the claims in parallel, until the watch cancels the work.
fn for_each_claim<R: Send>(
    paper: &Paper,
    claims: &[&Claim],
    count: &WorkCount<'_>,
    work: impl Fn(&Claim) -> R + Sync,
) -> Vec<R> {
    let each = |claim: &Claim| {
        let done = (!count.is_stopped()).then(|| work(claim));
        count.add(1);
        done
    };
    paper.for_all(claims, Some(count.threads()), each).into_iter().flatten().collect()
}

fn mutated(paper: &Paper, claim: &Claim) -> Mutated {
    let mut tried = 0;
    let failed = mutations(&claim.statement).into_iter().find(|mutation| {
        tried += 1;
        paper.establish_as(claim, mutation).outcome == Outcome::Failed
    });
    Mutated { id: claim.id.to_string(), tried, failed }
}

impl Mutations {
    fn of(mutations: Vec<Mutated>, seconds: Option<f64>) -> Verified {
        let survived = mutations.iter().filter(|mutated| mutated.failed.is_none()).count();
        Verified::Mutations(Mutations { mutations, survived, seconds })
    }
}

fn object<S: Serializer>(verdicts: &Verdicts, serializer: S) -> Result<S::Ok, S::Error> {
    let claim = |verdict: &Verdict| {
        let time = verdict.seconds.map(|seconds| format!(" ({:.1} ms)", 1000.0 * seconds));
        json!({
            "id": verdict.id,
            "system": verdict.system,
            "source": verdict.source,
            "statement": verdict.statement,
            "outcome": verdict.outcome.key(),
            "detail": verdict.detail.clone() + &time.unwrap_or_default(),
        })
    };
    let claims: Vec<Value> = verdicts.claims.iter().map(claim).collect();
    let open = verdicts.open.iter().map(|open| json!({"statement": open.statement, "detail": open.detail}));
    let open: Vec<Value> = open.collect();
    json!({"claims": claims, "failed": verdicts.failed, "open": open}).serialize(serializer)
}
