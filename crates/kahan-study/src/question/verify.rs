//! Whether claims hold: those of the paper, or those that a field brings along; and whether each
//! would fail if a coefficient or a sign of it were another.

use kahan_algebra::render::claim_text;
use kahan_discover::Watch;
use kahan_paper::formula::mutations;
use kahan_paper::{Claim, OPEN, Outcome, Paper, establish_block_claim, failing_mutation};
use serde::{Deserialize, Serialize, Serializer};

use crate::count::Count;
use crate::error::StudyError;
use crate::study::Study;

use super::seconds_since;

/// Asks whether the claims of a field hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Verify {
    /// Asks instead whether each claim fails once it is changed.
    pub mutate: bool,
}

/// What came of the claims.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Verified {
    /// Each as it stands.
    Claims(Verdicts),
    /// Each as it is changed.
    Mutations(Mutations),
}

/// Claims with their outcomes.
#[derive(Clone, Debug, Serialize)]
pub struct Verdicts {
    /// The claims, those of the paper in its order.
    pub claims: Vec<Verdict>,
    /// How many of them do not hold.
    pub failed: usize,
    /// What the paper leaves open.
    pub open: Vec<Open>,
    /// The seconds that it took; `None` without a clock.
    #[serde(skip)]
    pub seconds: Option<f64>,
}

/// What the paper leaves open.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Open {
    /// What may hold.
    pub statement: &'static str,
    /// Why it is not decided.
    pub detail: &'static str,
}

/// A claim with its outcome.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Its name, that of its system first: `table3.e4.P23`.
    pub id: String,
    /// The system that it is about.
    pub system: String,
    /// Where it stands, in words; empty where nobody says.
    pub source: String,
    /// What is claimed, in one line.
    pub statement: String,
    /// How it came out.
    pub outcome: Outcome,
    /// What that rests on, or what is wrong; of a misprint also what is printed.
    pub detail: String,
    /// The seconds that it took; `None` without a clock.
    pub seconds: Option<f64>,
    /// The claim of the paper, where it is one.
    pub claim: Option<Claim>,
}

/// What became of the changes of each claim.
#[derive(Clone, Debug, Serialize)]
pub struct Mutations {
    /// The claims.
    pub mutations: Vec<Mutated>,
    /// How many hold however they are changed, so that they say nothing.
    pub survived: usize,
    /// The seconds that it took; `None` without a clock.
    #[serde(skip)]
    pub seconds: Option<f64>,
}

/// What became of the changes of one claim.
#[derive(Clone, Debug, Serialize)]
pub struct Mutated {
    /// The claim's name, that of its system first.
    pub id: String,
    /// How many changes were tried until one failed.
    pub tried: usize,
    /// The first that failed, if one did.
    pub failed: Option<String>,
}

impl Verify {
    /// Decides the claims of a field; of a system of the catalog as it stands the paper's claims
    /// about it are meant. Parameters that are given are put in. Costs milliseconds a claim, of the
    /// paper's some hundred times as much where they are measured on orbits.
    ///
    /// # Errors
    /// [`StudyError::UndefinedField`]; with `mutate` also a claim that does not hold, of which
    /// there is nothing to change.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Verified, StudyError> {
        if let Some(name) = study.as_it_stands() {
            return Ok(self.of_paper(Some(name), watch));
        }
        let begun = watch.now();
        if self.mutate {
            study.proved()?;
        }
        let system = study.specialised()?;
        let count = Count::new("claims", system.claims.len() as u64, watch);
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
            Verdicts::of(verdicts.collect(), &[], seconds_since(begun, watch))
        })
    }

    /// Decides the claims of the paper, on the watch's threads: those about one system (`general`
    /// for what holds for every field), or all of them, which costs some ten seconds.
    #[must_use]
    pub fn of_paper(&self, system: Option<&str>, watch: &dyn Watch) -> Verified {
        let begun = watch.now();
        let paper = Paper::new();
        let is_meant = |claim: &&Claim| system.is_none_or(|system| claim.system == system);
        let claims: Vec<&Claim> = paper.claims().iter().filter(is_meant).collect();
        let count = Count::new("claims", claims.len() as u64, watch);
        if self.mutate {
            let mutations = of_each(&paper, &claims, &count, |claim| mutated(&paper, claim));
            return Mutations::of(mutations, seconds_since(begun, watch));
        }
        let claims = of_each(&paper, &claims, &count, |claim| verdict(&paper, claim, watch));
        let open = if system.is_none() { OPEN } else { &[] };
        Verdicts::of(claims, open, seconds_since(begun, watch))
    }
}

/// What is made of each claim, until the watch ends it.
fn of_each<R: Send>(
    paper: &Paper,
    claims: &[&Claim],
    count: &Count<'_>,
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

fn verdict(paper: &Paper, claim: &Claim, watch: &dyn Watch) -> Verdict {
    let begun = watch.now();
    let established = paper.establish(claim);
    let printed = claim.printed().filter(|_| established.outcome == Outcome::Misprint);
    Verdict {
        id: claim.id.to_string(),
        system: claim.system.to_owned(),
        source: claim.source(),
        statement: in_one_line(&claim.statement),
        outcome: established.outcome,
        detail: match printed {
            Some(printed) => format!("printed: {}; {}", in_one_line(printed), established.detail),
            None => established.detail,
        },
        seconds: seconds_since(begun, watch),
        claim: Some(claim.clone()),
    }
}

/// The words of a statement, one space apart.
fn in_one_line(statement: &str) -> String {
    statement.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl Verdicts {
    fn of(claims: Vec<Verdict>, open: &[(&'static str, &'static str)], seconds: Option<f64>) -> Verified {
        let failed = claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed).count();
        let open = open.iter().map(|&(statement, detail)| Open { statement, detail }).collect();
        Verified::Claims(Verdicts { claims, failed, open, seconds })
    }
}

impl Mutations {
    fn of(mutations: Vec<Mutated>, seconds: Option<f64>) -> Verified {
        let survived = mutations.iter().filter(|mutated| mutated.failed.is_none()).count();
        Verified::Mutations(Mutations { mutations, survived, seconds })
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Object<'a> {
            id: &'a str,
            system: &'a str,
            source: &'a str,
            statement: &'a str,
            outcome: &'static str,
            detail: String,
        }
        let time = self.seconds.map(|seconds| format!(" ({:.1} ms)", 1000.0 * seconds));
        let object = Object {
            id: &self.id,
            system: &self.system,
            source: &self.source,
            statement: &self.statement,
            outcome: self.outcome.key(),
            detail: self.detail.clone() + &time.unwrap_or_default(),
        };
        object.serialize(serializer)
    }
}
