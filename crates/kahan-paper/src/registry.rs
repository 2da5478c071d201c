//! The list of all claims of the paper and of further systems, and the check of each claim by its
//! method.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::prove::ERROR_EXPONENT;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::claim_statement;
use kahan_latex::Latex;

use kahan_runtime::threads;
use kahan_systems::registry::{all, find};

use super::block::establish_statement;
use super::claim::{Claim, Established, Outcome, ProofMethod};
use super::evaluate::Models;
use super::figures::{Figure, Measurement, Measurements};
use super::formula::{Definition, Formula, Item, Relation, inline, parse, statement_latex};
use super::growth_constants;
use super::identity::{Evidence, Identity};
use super::model::Model;
use super::sections;

/// The claims of the paper and of further systems of the catalog.
#[derive(Debug)]
pub struct Paper {
    models: Models,
    claims: Vec<Claim>,
    measurements: Measurements,
}

impl Default for Paper {
    fn default() -> Self {
        Paper::new()
    }
}

impl Paper {
    /// Reads the catalog and lists the claims in a few milliseconds, without checking any claim.
    #[must_use]
    pub fn new() -> Self {
        let mut models: Models = all().map(|entry| (entry.command, Model::of_catalog(entry))).collect();
        models.insert("general", Model::new("general", sections::GENERAL_FIELD));
        models.insert("homogeneous", Model::new("homogeneous", sections::HOMOGENEOUS_FIELD));
        let claims = sections::claims(&models);
        let measurements = Figure::all().map(|figure| (figure.name, OnceLock::new())).collect();
        Paper { models, claims, measurements }
    }

    /// Returns all claims, those of the paper first and in order.
    #[must_use]
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }

    /// Returns the items of a claim's statement in LaTeX, definitions first.
    #[must_use]
    pub fn latex(&self, claim: &Claim) -> Vec<String> {
        match &claim.basis {
            ProofMethod::Formula { .. } => {
                parse(&claim.statement).map_or_else(|why| vec![why], |statement| statement_latex(&statement))
            }
            ProofMethod::Block { index } => {
                let system = self.models.get(claim.system).map(Model::system);
                let declared = system.and_then(|system| system.claims.get(*index));
                let statements =
                    declared.map(|declared| claim_statement(declared, &Latex)).unwrap_or_default();
                statements.into_iter().map(|(left, right)| format!("{left} = {right}")).collect()
            }
        }
    }

    /// Establishes a claim by the method that the claim prescribes.
    #[must_use]
    pub fn establish(&self, claim: &Claim) -> Established {
        self.establish_as(claim, &claim.statement)
    }

    /// Applies `work` to every claim on `threads` threads, and keeps the order of results.
    pub fn for_all<R: Send>(
        &self,
        claims: &[&Claim],
        threads: Option<usize>,
        work: impl Fn(&Claim) -> R + Sync,
    ) -> Vec<R> {
        // Claims about long orbits are slow. They come first, so that threads end together.
        let mut order: Vec<usize> = (0..claims.len()).collect();
        order.sort_by_key(|&index| !claims[index].is_measured());
        let mut results = threads::map(order.len(), threads, |turn| (order[turn], work(claims[order[turn]])));
        results.sort_by_key(|(index, _)| *index);
        results.into_iter().map(|(_, result)| result).collect()
    }

    /// Establishes a claim with another statement in place of the claim's own.
    #[must_use]
    pub fn establish_as(&self, claim: &Claim, statement: &str) -> Established {
        let (outcome, detail) = match &claim.basis {
            ProofMethod::Block { .. } => {
                let block = find(claim.system).map_or("", kahan_systems::entry::Entry::text);
                establish_statement(block, statement)
            }
            ProofMethod::Formula { misprint, orbit, .. } => match self.relations(claim, statement) {
                Err(why) => (Outcome::Failed, why),
                Ok(evidence) => match (misprint, orbit) {
                    (Some(misprint), _) => self.misprint(claim, misprint, &evidence),
                    (None, Some(figure)) => measured(&evidence, figure),
                    (None, None) => outcome(&evidence),
                },
            },
        };
        Established { outcome, detail }
    }

    /// Collects the definitions of the field, of all claims, of this claim, and those in `own`.
    pub(super) fn definitions(
        &self,
        claim: &Claim,
        own: &str,
    ) -> Result<(BTreeMap<String, Definition>, Vec<Item>), String> {
        let ProofMethod::Formula { given, .. } = &claim.basis else {
            return Ok((BTreeMap::new(), Vec::new()));
        };
        let mut definitions = BTreeMap::new();
        let mut relations = Vec::new();
        let field = self.model(claim)?.field_definitions();
        for text in [field.as_str(), sections::DEFINITIONS, given.as_str(), own] {
            for item in parse(text)?.items {
                match item {
                    Item::Definition(definition) => {
                        definitions.insert(definition.name.clone(), definition);
                    }
                    relation @ Item::Relation { .. } => relations.push(relation),
                }
            }
        }
        Ok((definitions, relations))
    }

    fn relations(&self, claim: &Claim, statement: &str) -> Result<Evidence, String> {
        let ProofMethod::Formula { domain, .. } = &claim.basis else {
            return Err("a claim of a block".to_owned());
        };
        let (definitions, relations) = self.definitions(claim, statement)?;
        let mut weakest = None;
        for item in &relations {
            let Item::Relation { left, relation, right, digit } = item else { continue };
            let [left, right] = self.sides(claim, left, right, &definitions)?;
            let identity = Identity {
                domain,
                seed: SplitMix64::from_bytes(claim.id.to_string().as_bytes()).next_u64(),
                ..self.identity(claim, [&left, &right], *relation, digit.as_ref())?
            };
            let evidence = identity.establish()?;
            weakest = Some(weakest.map_or(evidence.clone(), |weakest: Evidence| weakest.weaker(evidence)));
        }
        weakest.ok_or_else(|| "it says nothing".to_owned())
    }

    pub(super) fn identity<'a>(
        &'a self,
        claim: &Claim,
        [left, right]: [&'a Formula; 2],
        relation: Relation,
        digit: Option<&'a Rational>,
    ) -> Result<Identity<'a>, String> {
        let model = self.model(claim)?;
        Ok(Identity { models: &self.models, model, left, relation, right, digit, domain: &[], seed: 0 })
    }

    fn model(&self, claim: &Claim) -> Result<&Model, String> {
        self.models.get(claim.system).ok_or_else(|| format!("there is no system {}", claim.system))
    }

    /// Substitutes definitions and measured quantities in both sides of a relation.
    pub(super) fn sides(
        &self,
        claim: &Claim,
        left: &Formula,
        right: &Formula,
        definitions: &BTreeMap<String, Definition>,
    ) -> Result<[Formula; 2], String> {
        let mut sides = [
            growth_constants::put_into(&inline(left, definitions)?)?,
            growth_constants::put_into(&inline(right, definitions)?)?,
        ];
        if let ProofMethod::Formula { orbit: Some(figure), .. } = &claim.basis {
            let measurement = self.measurement(figure)?;
            for side in &mut sides {
                *side = measurement.put_into(side)?;
            }
        }
        Ok(sides)
    }

    /// Returns the measured heights along the figure's orbit, which is computed at the first call.
    /// Fails if [`Figure::all`] lacks the figure.
    pub fn measurement(&self, figure: &'static Figure) -> Result<&Measurement, String> {
        let cell = self.measurements.get(figure.name).ok_or("no such figure")?;
        Ok(cell.get_or_init(|| figure.measure()))
    }
}

pub(super) fn outcome(evidence: &Evidence) -> (Outcome, String) {
    match evidence {
        Evidence::NormalForm => (Outcome::Proved, "by normal forms over Q, and modulo primes".to_owned()),
        Evidence::Modular(points) => (
            Outcome::ProvedModP,
            format!("at {points} random points modulo primes, error < 2^-{ERROR_EXPONENT}"),
        ),
        Evidence::Exact(points) => (Outcome::Exact(*points), format!("at {points} exact points")),
        Evidence::Numerical(decimals) => {
            (Outcome::Numerical(*decimals), "both sides in 256-bit arithmetic".to_owned())
        }
    }
}

/// Returns the outcome of a claim that was checked only at the points of the figure's orbit.
fn measured(evidence: &Evidence, figure: &Figure) -> (Outcome, String) {
    let detail = format!("measured on the exact orbit {} of {} iterates", figure.name, figure.steps);
    match evidence {
        Evidence::Numerical(decimals) => (Outcome::Numerical(*decimals), detail),
        _ => (Outcome::Exact(u32::try_from(figure.steps).expect("an orbit of a figure is short")), detail),
    }
}

impl Evidence {
    fn weaker(self, other: Evidence) -> Evidence {
        match (&self, &other) {
            (Evidence::Numerical(a), Evidence::Numerical(b)) => Evidence::Numerical(*a.min(b)),
            _ => self.max(other),
        }
    }
}
