//! Claims with their outcomes: those of the paper, or of a block.

use super::claim::{Claim, Outcome};
use super::registry::Paper;

/// A claim with its outcome.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Its name, that of its system first: `table3.e4.P23`.
    pub id: String,
    /// The system that it is about.
    pub system: String,
    /// Its place in the paper, in words; empty where nobody says.
    pub source: String,
    /// Its statement, in one line.
    pub statement: String,
    /// How it came out.
    pub outcome: Outcome,
    /// The evidence, or what is wrong; of a misprint also what is printed.
    pub detail: String,
    /// The seconds that it took; `None` without a clock.
    pub seconds: Option<f64>,
    /// The claim of the paper, where it is one.
    pub claim: Option<Claim>,
}

/// A question that the paper leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Open {
    /// The subject of the question.
    pub statement: &'static str,
    /// Why it is not decided.
    pub detail: &'static str,
}

/// Claims with their outcomes.
#[derive(Clone, Debug)]
pub struct Verdicts {
    /// The claims, those of the paper in its order.
    pub claims: Vec<Verdict>,
    /// How many of them do not hold.
    pub failed: usize,
    /// What the paper leaves open, where all of it was asked for.
    pub open: &'static [Open],
    /// The seconds that all of it took; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Verdicts {
    /// Counts the claims that failed.
    #[must_use]
    pub fn of(claims: Vec<Verdict>, open: &'static [Open], seconds: Option<f64>) -> Self {
        let failed = claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed).count();
        Verdicts { claims, failed, open, seconds }
    }

    /// Names the claims that failed, in one line; `None` if all hold.
    #[must_use]
    pub fn complaint(&self) -> Option<String> {
        let failed = self.claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed);
        let names: Vec<&str> = failed.map(|verdict| &*verdict.id).collect();
        let (failed, claims) = (names.len(), self.claims.len());
        (failed > 0).then(|| format!("{failed} of {claims} claims failed: {}", names.join(", ")))
    }
}

impl Paper {
    /// Establishes a claim of the paper. Costs milliseconds, and some hundred times as much where
    /// the claim is measured on an orbit.
    #[must_use]
    pub fn verdict(&self, claim: &Claim) -> Verdict {
        let established = self.establish(claim);
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
            seconds: None,
            claim: Some(claim.clone()),
        }
    }
}

/// Joins the words of a statement, one space apart.
#[must_use]
pub fn in_one_line(statement: &str) -> String {
    statement.split_whitespace().collect::<Vec<_>>().join(" ")
}
