//! Chooses a candidate for a lift, and one of its quadratic fields, perhaps with damping.

use std::collections::BTreeSet;

use kahan_algebra::modified_integrals::ModifiedIntegral;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::candidates::{Candidate, field_of, modified_quadratic};
use crate::laurent::{Laurent, Monomial};
use crate::quadratic::Quadratic;
use crate::ring::{CoordinateDefinition, Function};
use crate::stability::{ErrorGrowth, Orbit};

/// The criterion by which a lift is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LiftCriterion {
    /// An energy lift if there is one, otherwise a lift whose relations the map preserves. If there
    /// is neither, the lift whose relation errors grow least along the orbit. Without an orbit, the
    /// smallest lift.
    #[default]
    Automatic,
    /// An energy lift of a mechanical system.
    Energy,
    /// A lift with the most relations that the map preserves exactly.
    Relations,
    /// A lift whose relation errors do not grow along the orbit.
    Stable,
    /// A lift with the fewest new variables.
    Smallest,
}

impl LiftCriterion {
    /// All criteria.
    pub const ALL: [LiftCriterion; 5] = [
        LiftCriterion::Automatic,
        LiftCriterion::Energy,
        LiftCriterion::Relations,
        LiftCriterion::Stable,
        LiftCriterion::Smallest,
    ];

    /// Returns the name of the criterion in `--lift=NAME`.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["automatic", "energy", "relations", "stable", "smallest"][self as usize]
    }

    /// Returns a description of the lift that the criterion chooses.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        [
            "The first of the others that exists",
            "The energy lift of a mechanical system",
            "As many exactly preserved relations as possible",
            "Relations that do not grow along the orbit",
            "As few new variables as possible",
        ][self as usize]
    }
}

/// The maximum number of quadratic fields that are rated, over all candidates.
const MOST_FOLLOWED: usize = 32;

/// A candidate with one of its quadratic fields, and the relations that the map preserves.
#[derive(Debug)]
pub(crate) struct RatedCandidate<'a> {
    pub(crate) candidate: &'a Candidate,
    pub(crate) form: Vec<Quadratic>,
    pub(crate) kept: Vec<(Quadratic, ModifiedIntegral)>,
    pub(crate) growth: Option<ErrorGrowth>,
}

/// Returns the best candidate with its best quadratic field, and the reason for the choice.
pub(crate) fn choose<'a>(
    candidates: &'a [Candidate],
    which: LiftCriterion,
    orbit: Option<&Orbit>,
) -> Option<(RatedCandidate<'a>, String)> {
    let mut judged: Vec<RatedCandidate<'_>> = Vec::new();
    // The preferred fields of all candidates come before the alternative fields.
    let most = candidates.iter().map(|candidate| candidate.forms.len()).max()?;
    for place in 0..most {
        for candidate in candidates {
            let Some(form) = candidate.forms.get(place) else { continue };
            if judged.len() < MOST_FOLLOWED {
                judged.push(RatedCandidate::new(candidate, form.clone()));
            }
        }
    }
    let exponent = |one: &RatedCandidate<'_>| one.growth.map_or(0.0, |growth| growth.exponent);
    // Among equal lifts, those whose new variables depend on few states are preferred: x² to x·p.
    let spread = |one: &RatedCandidate<'_>| {
        let new = one.candidate.new.iter().flat_map(Laurent::terms);
        new.map(|(monomial, _)| monomial.powers().count()).sum::<usize>()
    };
    let best = |judged: Vec<RatedCandidate<'a>>| {
        judged.into_iter().min_by(|a, b| {
            let key = |one: &RatedCandidate<'_>| (one.order(), usize::MAX - one.kept.len());
            let by_exponent = exponent(a).total_cmp(&exponent(b));
            key(a).cmp(&key(b)).then(by_exponent).then(spread(a).cmp(&spread(b)))
        })
    };
    if candidates[0].energy.is_some() {
        judged = with_error_growth(judged, orbit);
        let class = |one: &RatedCandidate<'_>| match one.growth {
            Some(growth) if !growth.is_stable() => 1 + usize::from(!growth.is_polynomial()),
            _ => 0,
        };
        let least = judged.iter().map(class).min()?;
        judged.retain(|one| class(one) == least);
        return Some((best(judged)?, "its map keeps the energy exactly".to_owned()));
    }
    if matches!(which, LiftCriterion::Automatic | LiftCriterion::Relations) {
        let (kept, others): (Vec<_>, Vec<_>) = judged.into_iter().partition(RatedCandidate::keeps_all);
        if !kept.is_empty() {
            let chosen = "its map keeps every relation between its variables exactly".to_owned();
            return Some((best(with_error_growth(kept, orbit))?, chosen));
        }
        judged = others;
        if which == LiftCriterion::Relations {
            let most = judged.iter().map(|one| one.kept.len()).max()?;
            judged.retain(|one| one.kept.len() == most);
            let chosen = format!("its map keeps {most} of the relations exactly, and no other one more");
            return Some((best(with_error_growth(judged, orbit))?, chosen));
        }
    }
    if which == LiftCriterion::Smallest || orbit.is_none() {
        let least = judged.iter().map(RatedCandidate::order).min()?;
        judged.retain(|one| one.order() == least);
        let why =
            if which == LiftCriterion::Smallest { "" } else { "; without a start, no orbit was followed" };
        return Some((
            best(with_error_growth(judged, orbit))?,
            format!("no other lift has fewer new variables{why}"),
        ));
    }
    let (stable, others): (Vec<_>, Vec<_>) =
        with_error_growth(judged, orbit).into_iter().partition(RatedCandidate::is_stable);
    if !stable.is_empty() {
        let chosen = "errors of its relations do not grow along the orbit";
        return Some((best(stable)?, chosen.to_owned()));
    }
    for one in &others {
        for damped in one.with_damping(orbit) {
            if damped.is_stable() {
                let chosen = "multiples of its relations in its equations make their errors decay";
                return Some((damped, chosen.to_owned()));
            }
        }
    }
    let least = others.into_iter().min_by(|a, b| exponent(a).total_cmp(&exponent(b)))?;
    let rate = exponent(&least);
    let chosen = format!("errors of its relations grow least along the orbit, yet at the rate {rate:.3}");
    Some((least, chosen))
}

/// Computes the growth of errors, first for lifts with few new variables. After a stable lift is
/// found, lifts with more variables are dropped.
fn with_error_growth<'a>(judged: Vec<RatedCandidate<'a>>, orbit: Option<&Orbit>) -> Vec<RatedCandidate<'a>> {
    let Some(orbit) = orbit else { return judged };
    let orders: BTreeSet<usize> = judged.iter().map(RatedCandidate::order).collect();
    let mut judged = judged;
    for order in orders {
        judged.iter_mut().filter(|one| one.order() == order).for_each(|one| one.follow(orbit));
        if judged.iter().any(RatedCandidate::is_stable) {
            break;
        }
    }
    judged.retain(|one| one.growth.is_some());
    judged
}

impl<'a> RatedCandidate<'a> {
    pub(crate) fn new(candidate: &'a Candidate, form: Vec<Quadratic>) -> Self {
        let field = field_of(&candidate.ring, &form);
        let kept = candidate
            .relations
            .iter()
            .filter_map(|relation| Some((relation.clone(), modified_quadratic(&field, relation)?)))
            .collect();
        RatedCandidate { candidate, form, kept, growth: None }
    }

    pub(crate) fn follow(&mut self, orbit: &Orbit) {
        let Candidate { ring, new, .. } = self.candidate;
        // Entries 0 of `new` stand for the work done by the forces, which has no relation.
        let known = new.iter().filter(|value| !value.is_zero()).count();
        self.growth = Some(orbit.growth(ring, &new[..known], &self.form));
    }

    fn order(&self) -> usize {
        self.candidate.new.len()
    }

    fn is_stable(&self) -> bool {
        self.growth.is_some_and(|growth| growth.is_stable())
    }

    /// Returns fields with damping, which makes errors decay.
    ///
    /// For a relation R = 0 that is linear in a new variable w, κR is subtracted from w′. The
    /// factor κ exceeds the growth rate of errors without damping.
    fn with_damping(&self, orbit: Option<&Orbit>) -> Vec<RatedCandidate<'a>> {
        let states = self.candidate.ring.field.len();
        let rate = self.growth.map_or(1.0, |growth| growth.exponent.clamp(1e-3, 1e3));
        let damped = |factor: f64| {
            let damping = Rational::from_f64(libm::exp2(libm::log2(factor * rate).ceil()))?;
            let mut form = self.form.clone();
            for (variable, equation) in form.iter_mut().enumerate().skip(states) {
                let own = Monomial::power(variable, 1);
                let others = |relation: &Quadratic| {
                    let new = |(index, _): (usize, i16)| index >= states && index != variable;
                    relation.terms().filter(|(monomial, _)| monomial.powers().any(new)).count()
                };
                let relations = self.candidate.relations.iter().filter(|one| one.contains(&own));
                // Variables without an algebraic relation keep their equations.
                let Some(relation) = relations.min_by_key(|relation| others(relation)) else { continue };
                let scale = RationalFunction::constant(-&damping).checked_div(&relation.coefficient(&own))?;
                equation.add_scaled(relation, &scale);
            }
            let mut damped = RatedCandidate::new(self.candidate, form);
            orbit.into_iter().for_each(|orbit| damped.follow(orbit));
            Some(damped)
        };
        [2.0, 8.0, 32.0].into_iter().filter_map(damped).collect()
    }

    /// Returns whether the map preserves one relation for each new variable. A sine and its cosine
    /// need only one relation together, sin² + cos² = 1.
    fn keeps_all(&self) -> bool {
        let Candidate { ring, new, .. } = self.candidate;
        let single = new.iter().filter_map(Laurent::as_monomial).filter(|one| one.size() == 1);
        let meanings = single.flat_map(Monomial::powers).map(|(index, _)| &ring.coordinates[index].meaning);
        let is_cosine = |one: &&CoordinateDefinition| {
            matches!(one, CoordinateDefinition::Function(Function::Cos | Function::Cosh, _))
        };
        self.kept.len() + meanings.filter(is_cosine).count() >= new.len()
    }
}
