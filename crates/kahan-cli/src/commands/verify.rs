//! The command `kahan verify`, which checks the formulas of the paper, or the claims of a field.

use clap::Args;
use kahan_study::{Mutations, Study, Verified, Verify as Question};

use super::command_line::QuestionCommand;
use crate::printing::layout::{page_width, screen_width};
use crate::printing::{Answer, ProgressDisplay, UsageError};
use crate::reading::Source;

/// Proves the formulas of the paper, or the claims of a field.
///
/// With a SYSTEM alone, the paper's formulas about this system are proved. Rational formulas are
/// expanded over the rational numbers and tested modulo primes. Other formulas are compared in
/// 256-bit arithmetic. A formula that the paper misprints is disproved as printed and proved as
/// corrected. With a field of your own, or with --param, the claims of that field are proved. The
/// exit status is 1 if a claim does not hold.
#[derive(Args, Debug)]
#[command(mut_arg("all", |all| all.help(ALL).conflicts_with("mutate")))]
#[command(after_help = "\
Examples:
  kahan verify
  kahan verify --all
  kahan verify e6
  kahan verify e6 --json
  kahan verify --system general
  kahan verify --mutate
  kahan verify e9 --param xi=1
  kahan verify --field 'xdot = y; ydot = -x; integral H = x^2 + y^2;'
  kahan verify --file field.txt --mutate")]
pub(crate) struct Verify {
    #[command(flatten)]
    source: Source,

    /// Like SYSTEM; `general` proves the formulas that hold for every field.
    #[arg(long = "system", value_name = "SYSTEM", conflicts_with_all = ["system", "field", "file"])]
    about: Option<String>,

    /// Test the proofs: change one coefficient or sign of every claim, which must then fail. The
    /// exit status is 1 if a changed claim passes. The claims of a field of your own must hold at
    /// first.
    #[arg(long)]
    mutate: bool,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

impl QuestionCommand for Verify {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        Ok((self.source().study()?, Question { mutate: self.mutate }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let source = self.source();
        let prompt = ProgressDisplay::of("claims");
        let (asked, is_all) = (Question { mutate: self.mutate }, source == Source::default());
        let verified = if is_all {
            asked.of_paper(None, &prompt)
        } else if source == Source::of_system("general".to_owned()) {
            asked.of_paper(Some("general"), &prompt)
        } else {
            asked.ask(&source.study()?, &prompt)?
        };
        let text = |verified: &Verified| match verified {
            Verified::Mutations(mutations) => mutated(mutations),
            Verified::Claims(verdicts) if verdicts.claims.is_empty() => format!("{NO_CLAIMS}\n"),
            Verified::Claims(verdicts) if self.source.clone().without_all().1 => {
                verdicts.in_full(screen_width())
            }
            Verified::Claims(verdicts) if is_all => verdicts.summary(page_width()),
            Verified::Claims(verdicts) => verdicts.lines(screen_width()),
        };
        Ok(Answer::of(&verified, self.json, text).with_complaint(complaint(&verified)))
    }
}

impl Verify {
    fn source(&self) -> Source {
        self.about.clone().map_or_else(|| self.source.clone().without_all().0, Source::of_system)
    }
}

const ALL: &str = "Show every claim with its statement, its source and the time of its proof";

const NO_CLAIMS: &str = "0 claims: the block claims nothing; add `integral NAME = …;`, `density NAME = …;`, `drift NAME = … by …;` or `bracket NAME { … }`";

fn mutated(answer: &Mutations) -> String {
    let claims = answer.mutations.len();
    if claims == 0 {
        return format!("{NO_CLAIMS}\n");
    }
    let at_once = answer.mutations.iter().filter(|one| one.failed.is_some() && one.tried == 1).count();
    let (survived, seconds) = (answer.survived, answer.seconds.unwrap_or_default());
    let (failed, noun) = (claims - survived, if claims == 1 { "claim" } else { "claims" });
    format!(
        "{claims} {noun} mutated: {failed} failed, {at_once} of them at their first mutation; {survived} survived; {seconds:.2} s\n"
    )
}

fn complaint(verified: &Verified) -> Option<String> {
    match verified {
        Verified::Claims(verdicts) => verdicts.complaint(),
        Verified::Mutations(Mutations { mutations, .. }) => {
            let survivors = mutations.iter().filter(|mutated| mutated.failed.is_none());
            let names: Vec<&str> = survivors.map(|mutated| &*mutated.id).collect();
            let (survived, claims) = (names.len(), mutations.len());
            (survived > 0).then(|| {
                format!("{survived} of {claims} claims survive every mutation: {}", names.join(", "))
            })
        }
    }
}
