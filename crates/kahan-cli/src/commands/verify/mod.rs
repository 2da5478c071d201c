//! `kahan verify`: every formula of the paper established again, or the claims of a field of one's
//! own.

mod lines;
mod mutate;
mod summary;
mod table;

use clap::Args;
use kahan_paper::Outcome;
use kahan_study::{Study, Verdict, Verdicts, Verified, Verify as Question};
use serde_json::json;

use super::line::Asking;
use crate::printing::{Answer, Prompt, Refusal};
use crate::reading::Source;

/// Proves the formulas of the paper, or the claims of a field.
///
/// A SYSTEM alone stands for the paper's formulas that are about it. Rational formulas are expanded
/// over the rational numbers and tested modulo primes; what is not rational is compared in 256-bit
/// arithmetic; what the paper misprints is refuted as printed and established as corrected. With a
/// field of your own, or with --param, the claims of that block are proved. The exit status is 1 if
/// a claim does not hold.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Verify {
    #[command(flatten)]
    source: Source,

    /// The same as SYSTEM; `general` for what holds for every field.
    #[arg(long = "system", value_name = "SYSTEM", conflicts_with_all = ["system", "field", "file"])]
    about: Option<String>,

    /// Show every claim with its statement, its source and its time.
    #[arg(long, conflicts_with = "mutate")]
    all: bool,

    /// Change one coefficient or sign of every claim: each must then fail. The exit status is 1 if
    /// one survives. Of a field of your own the claims must hold to begin with.
    #[arg(long)]
    mutate: bool,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan verify
  kahan verify --all
  kahan verify e6
  kahan verify e6 --json
  kahan verify --system general
  kahan verify --mutate
  kahan verify e9 --param xi=1
  kahan verify --field 'xdot = y; ydot = -x; integral H = x^2 + y^2;'
  kahan verify --file field.txt --mutate";

impl Asking for Verify {
    const COMMAND: &str = "verify";
    type Question = Question;

    fn asked(&self) -> Result<(Study, Question), Refusal> {
        Ok((self.source().study()?, Question { mutate: self.mutate }))
    }
}

impl Verify {
    fn source(&self) -> Source {
        self.about.clone().map_or_else(|| self.source.clone(), Source::of_system)
    }

    /// One screen, a line a claim, the table, or one object; a complaint if a claim fails.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let source = self.source();
        let prompt = Prompt::of("claims");
        let (asked, is_all) = (Question { mutate: self.mutate }, source == Source::default());
        let verified = if is_all {
            asked.of_paper(None, &prompt)
        } else if source == Source::of_system("general".to_owned()) {
            asked.of_paper(Some("general"), &prompt)
        } else {
            asked.ask(&source.study()?, &prompt)?
        };
        let answer = match &verified {
            _ if self.json => Answer::json(&json!(verified)),
            Verified::Mutations(mutations) => Answer::text(mutate::text(mutations)),
            Verified::Claims(verdicts) if verdicts.claims.is_empty() => {
                Answer::text(format!("{NO_CLAIMS}\n"))
            }
            Verified::Claims(verdicts) if self.all => Answer::text(table::text(verdicts)),
            Verified::Claims(verdicts) if is_all => Answer::text(summary::text(verdicts)),
            Verified::Claims(verdicts) => Answer::text(lines::text(verdicts)),
        };
        let complaint = match &verified {
            Verified::Mutations(mutations) => mutate::complaint(mutations),
            Verified::Claims(verdicts) => complaint(verdicts),
        };
        Ok(Answer { complaint, ..answer })
    }
}

/// What there is to say of a block without claims.
const NO_CLAIMS: &str = "0 claims: the block claims nothing; add `integral NAME = …;`, `density NAME = …;` or `bracket NAME { … }`";

/// How many claims came out how, in one line without its end.
fn totals(verdicts: &Verdicts) -> String {
    let words = ["proved over Q", "proved mod p", "exact at points", "numerical", "misprinted"];
    let counts = Outcome::counts(verdicts.claims.iter().map(|verdict| verdict.outcome));
    let found = counts.iter().zip(words).filter(|(count, _)| **count > 0);
    let found = found.map(|(count, what)| format!("{count} {what}, "));
    let claims = if verdicts.claims.len() == 1 { "claim" } else { "claims" };
    format!("{} {claims}: {}{} failed", verdicts.claims.len(), found.collect::<String>(), verdicts.failed)
}

/// The claims that do not hold.
fn failed(verdicts: &Verdicts) -> impl Iterator<Item = &Verdict> {
    verdicts.claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed)
}

fn complaint(verdicts: &Verdicts) -> Option<String> {
    let names: Vec<&str> = failed(verdicts).map(|verdict| verdict.id.as_str()).collect();
    let (failed, claims) = (verdicts.failed, verdicts.claims.len());
    (failed > 0).then(|| format!("{failed} of {claims} claims failed: {}", names.join(", ")))
}
