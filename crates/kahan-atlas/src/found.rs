//! The data for the page: claims with their outcomes, and the heights along the paper's orbits.

use std::collections::BTreeMap;

use kahan_paper::figures::{Figure, Measurement};
use kahan_paper::{Claim, Established, Id, Outcome, Paper};

/// A claim with its outcome.
#[derive(Clone, Debug)]
pub struct CheckedClaim<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// The outcome of the claim, with the evidence for it.
    pub established: Established,
}

/// The heights along orbits. The keys are the [names](Figure::name) of the orbits.
pub type Orbits<'a> = BTreeMap<&'static str, &'a Measurement>;

/// The data from which the page is written.
#[derive(Debug)]
pub struct AtlasContent<'a> {
    /// The registry of the paper's claims.
    pub paper: &'a Paper,
    /// All claims in the order of the paper.
    pub claims: Vec<CheckedClaim<'a>>,
    /// The measured orbits of [`Figure::all`]. A figure without its orbit is left out of the page.
    pub orbits: Orbits<'a>,
}

impl<'a> AtlasContent<'a> {
    /// Establishes every claim and computes every orbit. Calls `each` after each claim and orbit.
    ///
    /// Cost: about half a minute on two cores.
    #[must_use]
    pub fn compute(paper: &'a Paper, each: impl Fn() + Sync) -> Self {
        let claims: Vec<&Claim> = paper.claims().iter().collect();
        // `measurement` below returns results that `establish` has stored.
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
        let claims = claims.map(|(claim, established)| CheckedClaim { claim, established }).collect();
        AtlasContent { paper, claims, orbits }
    }

    /// Returns how many times [`compute`](Self::compute) calls `each`.
    #[must_use]
    pub fn steps(paper: &Paper) -> usize {
        paper.claims().len() + Figure::all().count()
    }

    /// Returns the number of failed claims.
    #[must_use]
    pub fn failed(&self) -> usize {
        self.counts()[Outcome::Failed.place()]
    }

    pub(super) fn counts(&self) -> [usize; Outcome::KINDS] {
        Outcome::counts(self.claims.iter().map(|checked| checked.established.outcome))
    }

    pub(super) fn claim(&self, id: &Id) -> Option<&CheckedClaim<'a>> {
        self.claims.iter().find(|checked| checked.claim.id == *id)
    }

    pub(super) fn claims_of(&self, parts: &[&str]) -> impl Iterator<Item = &CheckedClaim<'a>> {
        self.claims.iter().filter(move |checked| checked.claim.id.begins_with(parts))
    }
}
