//! Claims with their outcomes.

use super::claim::{Claim, Outcome};
use super::registry::Paper;

/// A claim with its outcome.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The identifier of the claim, for example `table3.e4.P23`.
    pub id: String,
    /// The name of the system in commands.
    pub system: String,
    /// The place in the paper, in words; empty if the place is unknown.
    pub source: String,
    /// The statement of the claim, in one line.
    pub statement: String,
    /// The outcome of checking the claim.
    pub outcome: Outcome,
    /// The evidence, or the reason of a failure. For a misprint, also the printed form.
    pub detail: String,
    /// The duration of the check in seconds; `None` on platforms without a clock.
    pub seconds: Option<f64>,
    /// The claim of the paper; `None` if the statement is not from the paper.
    pub claim: Option<Claim>,
}

/// A question that the paper leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenQuestion {
    /// The subject of the question.
    pub statement: &'static str,
    /// The reason why the question is open.
    pub detail: &'static str,
}

/// Claims with their outcomes, and the totals over all claims.
#[derive(Clone, Debug)]
pub struct Verdicts {
    /// The claims with their outcomes, in the order of the paper.
    pub claims: Vec<Verdict>,
    /// The number of failed claims.
    pub failed: usize,
    /// The open questions, if the whole paper was asked for.
    pub open: &'static [OpenQuestion],
    /// The total time in seconds; `None` on platforms without a clock.
    pub seconds: Option<f64>,
}

impl Verdicts {
    /// Collects claims with their outcomes, and counts the failed claims.
    #[must_use]
    pub fn of(claims: Vec<Verdict>, open: &'static [OpenQuestion], seconds: Option<f64>) -> Self {
        let failed = claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed).count();
        Verdicts { claims, failed, open, seconds }
    }

    /// Lists the failed claims in one line; `None` if all claims hold.
    #[must_use]
    pub fn complaint(&self) -> Option<String> {
        let failed = self.claims.iter().filter(|verdict| verdict.outcome == Outcome::Failed);
        let names: Vec<&str> = failed.map(|verdict| &*verdict.id).collect();
        let (failed, claims) = (names.len(), self.claims.len());
        (failed > 0).then(|| format!("{failed} of {claims} claims failed: {}", names.join(", ")))
    }
}

impl Paper {
    /// Establishes a claim of the paper in milliseconds. Claims measured on an orbit take about a
    /// hundred times longer.
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

/// Joins the words of a statement with single spaces.
#[must_use]
pub fn in_one_line(statement: &str) -> String {
    statement.split_whitespace().collect::<Vec<_>>().join(" ")
}
