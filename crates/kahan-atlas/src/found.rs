//! What the page shows: claims with their outcomes, and the heights of the paper's orbits.

use std::collections::BTreeMap;

use kahan_paper::figures::{Figure, Measurement};
use kahan_paper::{Claim, Established, Id, Outcome, Paper};

/// A claim and how it came out.
#[derive(Clone, Debug)]
pub struct Checked<'a> {
    /// What is claimed.
    pub claim: &'a Claim,
    /// How it came out.
    pub established: Established,
}

/// The heights along orbits, by the [name](Figure::name) of the orbit.
pub type Orbits<'a> = BTreeMap<&'static str, &'a Measurement>;

/// Everything that the page shows.
#[derive(Debug)]
pub struct Found<'a> {
    /// The registry, which writes statements in LaTeX.
    pub paper: &'a Paper,
    /// The claims in the order of the paper.
    pub claims: Vec<Checked<'a>>,
    /// The orbits of [`Figure::all`]; a drawing whose orbit is missing says so.
    pub orbits: Orbits<'a>,
}

impl<'a> Found<'a> {
    /// Establishes every claim and follows every orbit; `each` hears of every claim and of every
    /// orbit as it is done. Costs half a minute on two cores.
    #[must_use]
    pub fn compute(paper: &'a Paper, each: impl Fn() + Sync) -> Self {
        let claims: Vec<&Claim> = paper.claims().iter().collect();
        // The claims measure the orbits, many at once; what is left is to look them up.
        let established = paper.for_all(&claims, None, |claim| {
            let established = paper.establish(claim);
            each();
            established
        });
        let orbits = Figure::all().filter_map(|figure| {
            let measurement = paper.measurement(figure).ok();
            each();
            Some((figure.name, measurement?))
        });
        let orbits = orbits.collect();
        let claims = claims.into_iter().zip(established);
        let claims = claims.map(|(claim, established)| Checked { claim, established }).collect();
        Found { paper, claims, orbits }
    }

    /// How often [`compute`](Self::compute) calls `each`.
    #[must_use]
    pub fn steps(paper: &Paper) -> usize {
        paper.claims().len() + Figure::all().count()
    }

    /// How many claims failed.
    #[must_use]
    pub fn failed(&self) -> usize {
        self.counts()[Outcome::Failed.place()]
    }

    /// How many claims came out how.
    pub(super) fn counts(&self) -> [usize; Outcome::KINDS] {
        Outcome::counts(self.claims.iter().map(|checked| checked.established.outcome))
    }

    /// The claim of this name.
    pub(super) fn claim(&self, id: &Id) -> Option<&Checked<'a>> {
        self.claims.iter().find(|checked| checked.claim.id == *id)
    }

    /// The claims whose names begin with these parts.
    pub(super) fn claims_of(&self, parts: &[&str]) -> impl Iterator<Item = &Checked<'a>> {
        self.claims.iter().filter(move |checked| checked.claim.id.begins_with(parts))
    }
}
