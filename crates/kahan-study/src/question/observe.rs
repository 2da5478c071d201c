//! Observables of an orbit, such as exponents, chaos indicators, rotation, drift and escape.
//!
//! No orbit is stored. Rotation needs two runs; the first finds the midrange of each variable.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_core::{Composition, EmbedScalar};
use kahan_discover::Watch;
use kahan_runtime::{End, Followed, MapAt, ObservationRequest, ObservedFloat};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::lifted_step::LiftEnds;
use crate::numbers::exact;
use crate::rows::Column;
use crate::study::Study;

use super::{NoOrbit, usual_order};

pub use kahan_runtime::{Observable, ObservedValue};

/// The message of `expect` for calls that cannot fail, because lengths of arguments match.
pub(super) const ARGUMENTS_FIT: &str = "a column a variable, all of one length, and a map an orbit";
const LAST_POINT_REQUESTED: &str = "the last point was asked for";

/// A request for observations of the orbit of a point, in doubles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observe {
    /// ε, half the time step.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The number of steps before the observation.
    #[serde(default)]
    pub transient: u64,
    /// The number of observed steps.
    pub steps: u64,
    /// The order of the method: 2 is Kahan's map; 4, 6 and 8 compose steps of it.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// The number of steps between orthogonalisations of tangent vectors.
    #[serde(default = "usual_renormalize")]
    pub renormalize: u64,
    /// The number of exponents in the spectrum, largest first; `None` for all.
    #[serde(default)]
    pub spectrum: Option<usize>,
    /// If a variable exceeds this bound, the orbit has escaped and ends. With `None`, it goes on,
    /// and [`Observable::Escape`] reports the first step at which a variable exceeds a million.
    #[serde(default)]
    pub escape: Option<f64>,
    /// Whether each step is projected, so that a lift's relations such as sin_x = sin(x) hold.
    #[serde(default)]
    pub reembed: bool,
    /// The observables to compute, by default the [usual](Observable::usual) ones.
    #[serde(default = "Observable::usual", serialize_with = "names_of", deserialize_with = "of_names")]
    pub observe: Vec<Observable>,
}

fn usual_renormalize() -> u64 {
    10
}

fn names_of<S: Serializer>(of: &[Observable], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(of.iter().map(|one| one.name()))
}

fn of_names<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Observable>, D::Error> {
    let of_name = |name: &String| {
        Observable::named(name).ok_or_else(|| D::Error::unknown_variant(name, Observable::NAMES))
    };
    Vec::<String>::deserialize(deserializer)?.iter().map(of_name).collect()
}

/// The observations of an orbit. Exponents are growth rates in time; a step takes the time 2ε.
#[derive(Clone, Debug)]
pub struct Observed {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The integrals claimed without a condition.
    pub integrals: Vec<String>,
    /// The number of steps, including the transient.
    pub steps: u64,
    /// The reason why the orbit ended.
    pub end: End,
    /// A sentence that says why a step of a lifted field failed; `None` if no step failed.
    pub why: Option<String>,
    /// The observations, in the order of the observables.
    pub seen: Vec<(Observable, ObservedValue)>,
}

impl Observe {
    /// Asks for the usual observables of Kahan's map, without an escape bound.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64) -> Self {
        let (order, renormalize, observe) = (usual_order(), usual_renormalize(), Observable::usual());
        Observe {
            eps,
            at,
            transient: 0,
            steps,
            order,
            renormalize,
            spectrum: None,
            escape: None,
            reembed: false,
            observe,
        }
    }

    /// Asks for `steps` steps of orbits whose first points and ε are given separately.
    #[must_use]
    pub fn of(observe: Vec<Observable>, steps: u64) -> Self {
        Observe { observe, ..Observe::new(Rational::zero(), Vec::new(), steps) }
    }

    /// Observes the orbit of a system whose claims hold. Rotation costs a second run of the orbit.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, an unknown order, or a field that is undefined at its parameters.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Observed, StudyError> {
        let system = study.proved()?;
        let (at, start) = study.in_floats(&self.at, &self.eps)?;
        let at = at.composed(self.composition(study)?);
        let count = WorkCount::new("steps", self.steps_in_all(), watch);
        let of = self.observables();
        let tell = &|steps| count.tell(steps);
        let (Followed { report, end }, ends) = self.observe_one(study, &at, &start, &of, tell);
        let integrals = system.accessors(ClaimKind::Integral).map(|claim| claim.name.text.clone());
        let steps = end.steps(self.transient.saturating_add(self.steps));
        Ok(Observed {
            system: study.name().to_owned(),
            variables: study.shown().to_vec(),
            integrals: integrals.collect(),
            steps,
            end,
            why: ends.map(|ends| ends.in_words(study, steps)),
            seen: of
                .into_iter()
                .zip(report.into_iter().map(|seen| after(steps > self.transient, shown(study, seen))))
                .collect(),
        })
    }

    /// Returns the total number of steps, including second runs.
    #[must_use]
    pub fn steps_in_all(&self) -> u64 {
        let runs = self.observe.iter().map(|one| one.runs()).max();
        self.steps.saturating_mul(runs.unwrap_or(1)).saturating_add(self.transient)
    }

    /// Returns an error if drifts of integrals are requested explicitly, but none are claimed.
    pub fn has_integrals(&self, study: &Study) -> Result<(), StudyError> {
        let is_named = self.observe.contains(&Observable::Drift) && self.observe != Observable::usual();
        if is_named && study.field().integrals().is_empty() {
            return Err(StudyError::NoIntegral { system: study.name().to_owned() });
        }
        Ok(())
    }

    /// Returns the observables without duplicates.
    #[must_use]
    pub fn observables(&self) -> Vec<Observable> {
        let is_first = |(place, one): &(usize, &Observable)| !self.observe[..*place].contains(one);
        self.observe.iter().enumerate().filter(is_first).map(|(_, one)| *one).collect()
    }

    pub(super) fn observing<'a>(&self, study: &'a Study, of: &'a [Observable]) -> ObservationRequest<'a> {
        let relations = study.relations();
        let exponents = self.spectrum.unwrap_or(usize::MAX);
        ObservationRequest {
            of,
            steps: self.steps,
            renormalize: self.renormalize,
            exponents,
            escape: self.escape,
            relations,
        }
    }

    /// Returns the columns of the observations, for a table with a row for each orbit.
    #[must_use]
    pub fn columns(&self, study: &Study) -> Vec<Column> {
        let integrals = study.field().integrals();
        let columns = self.observables().into_iter().flat_map(|one| {
            // A lifted field has as many exponents as original variables.
            let of_vectors = one.is_of_tangent_vectors();
            let mut variables = if of_vectors { study.coordinates() } else { study.shown() };
            if one == Observable::Spectrum {
                variables = &variables[..variables.len().min(self.spectrum.unwrap_or(usize::MAX))];
            }
            one.columns(variables, integrals)
        });
        columns.map(|(name, meaning)| Column { name, meaning: meaning.to_owned() }).collect()
    }

    /// Observes many orbits, and returns the [numbers](Self::numbers) of the table's columns.
    /// `maps` holds a map for each orbit, and `starts` a column for each variable. `tell` receives
    /// the number of steps since the last call. If it returns `Break`, the results are meaningless.
    ///
    /// # Panics
    /// If `maps` and `starts` do not fit each other.
    pub fn of_orbits<T: ObservedFloat + EmbedScalar>(
        &self,
        study: &Study,
        maps: &[&MapAt<T>],
        starts: &[Vec<T>],
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Followed<Vec<f64>>> {
        let numbers = |found: Followed<Vec<ObservedValue>>| {
            let report = found.report.into_iter().map(|seen| shown(study, seen)).collect();
            let found = Followed { report, end: found.end };
            Followed { report: Self::numbers(&found), end: found.end }
        };
        self.observe_many(study, maps, starts, &self.observables(), tell).into_iter().map(numbers).collect()
    }

    /// Observes one orbit after its transient. If the lift ended the orbit, also returns a sentence
    /// that says why.
    pub(super) fn observe_one<T: ObservedFloat + EmbedScalar>(
        &self,
        study: &Study,
        at: &MapAt<T>,
        start: &[T],
        of: &[Observable],
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> (Followed<Vec<ObservedValue>>, Option<LiftEnds>) {
        let asked = self.observing(study, of);
        if self.transient == 0 {
            return self.one(study, at, start, &asked, tell);
        }
        let transient = ObservationRequest { of: &[Observable::Last], steps: self.transient, ..asked };
        let (mut before, why) = self.one(study, at, start, &transient, tell);
        let settled = before.report.pop().and_then(last_point::<T>).expect(LAST_POINT_REQUESTED);
        let steps = if before.end == End::Complete { self.steps } else { 0 };
        let (found, ends) = self.one(study, at, &settled, &ObservationRequest { steps, ..asked }, tell);
        let found = after_transient(found, before.end.steps(self.transient));
        if before.end == End::Complete { (found, ends) } else { (Followed { end: before.end, ..found }, why) }
    }

    /// Observes many orbits after their transients, in SIMD lanes where machine code supports this.
    pub(super) fn observe_many<T: ObservedFloat + EmbedScalar>(
        &self,
        study: &Study,
        maps: &[&MapAt<T>],
        starts: &[Vec<T>],
        of: &[Observable],
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Followed<Vec<ObservedValue>>> {
        let one = |orbit: usize| self.observe_one(study, maps[orbit], &start_of(starts, orbit), of, tell).0;
        if self.reembed {
            return (0..maps.len()).map(one).collect();
        }
        let asked = self.observing(study, of);
        if self.transient == 0 {
            return self.side_by_side(study, maps, starts, &asked, tell);
        }
        let transient = ObservationRequest { of: &[Observable::Last], steps: self.transient, ..asked };
        let mut settled = starts.to_vec();
        let before = self.side_by_side(study, maps, starts, &transient, tell).into_iter().enumerate();
        let ends: Vec<End> = before
            .map(|(orbit, mut found)| {
                let last = found.report.pop().and_then(last_point::<T>).expect(LAST_POINT_REQUESTED);
                settled.iter_mut().zip(last).for_each(|(column, x)| column[orbit] = x);
                found.end
            })
            .collect();
        let found = self.side_by_side(study, maps, &settled, &asked, tell).into_iter().zip(ends).enumerate();
        let found = found.map(|(orbit, (found, before))| match before {
            End::Complete => after_transient(found, self.transient),
            _ => one(orbit),
        });
        found.collect()
    }

    /// Observes one orbit from its start. If the lift ended the orbit, also returns a sentence that
    /// says why.
    fn one<T: ObservedFloat + EmbedScalar>(
        &self,
        study: &Study,
        at: &MapAt<T>,
        start: &[T],
        asked: &ObservationRequest<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> (Followed<Vec<ObservedValue>>, Option<LiftEnds>) {
        let Some(step) = study.steps(at, self.reembed) else {
            return (T::observe_one(None, at, start, asked, tell).expect(ARGUMENTS_FIT), None);
        };
        let with_last = ObservationRequest { of: &with_last(asked.of), ..*asked };
        let mut found = T::observe_one(Some(&step), at, start, &with_last, tell).expect(ARGUMENTS_FIT);
        let last = found.report.pop().and_then(last_point::<T>).expect(LAST_POINT_REQUESTED);
        let ends = matches!(found.end, End::Range(_)).then(|| step.ends(&last)).flatten();
        found.end = step.end(found.end, &last);
        (found, ends)
    }

    /// Observes many orbits from their starts. If an orbit leaves the domain of a lift, it is run
    /// again alone, to end at its last point in the domain.
    fn side_by_side<T: ObservedFloat + EmbedScalar>(
        &self,
        study: &Study,
        maps: &[&MapAt<T>],
        starts: &[Vec<T>],
        asked: &ObservationRequest<'_>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Followed<Vec<ObservedValue>>> {
        let is_lifted = maps.first().is_some_and(|at| study.lifted_step(at).is_some());
        let of = if is_lifted { with_last(asked.of) } else { asked.of.to_vec() };
        let mut found = T::observe_many(maps, starts, &ObservationRequest { of: &of, ..*asked }, tell)
            .expect(ARGUMENTS_FIT);
        for (orbit, found) in found.iter_mut().enumerate().filter(|_| is_lifted) {
            let last = found.report.pop().and_then(last_point::<T>).expect(LAST_POINT_REQUESTED);
            if study.lifted_step(maps[orbit]).is_some_and(|step| step.is_beyond(&last)) {
                *found = self.one(study, maps[orbit], &start_of(starts, orbit), asked, tell).0;
            }
        }
        found
    }

    /// Returns an orbit's observed values as the numbers of a table's columns. If the orbit ended
    /// early, every number except the step of its escape is NaN.
    #[must_use]
    pub fn numbers(found: &Followed<Vec<ObservedValue>>) -> Vec<f64> {
        let numbers = |seen: &ObservedValue| {
            let numbers = seen.numbers();
            match seen {
                ObservedValue::Step(_) => numbers,
                _ if found.end.is_early() => vec![f64::NAN; numbers.len()],
                _ => numbers,
            }
        };
        found.report.iter().flat_map(numbers).collect()
    }

    /// Returns the composition of the requested order, after checking the other options.
    ///
    /// # Errors
    /// [`StudyError`]: an unknown order, `renormalize` or `spectrum` = 0, projection for a field
    /// without a lift, or projection with an observable that requires unprojected steps.
    pub fn composition(&self, study: &Study) -> Result<Composition, StudyError> {
        if self.reembed {
            study.can_reembed(true)?;
            let refused = self.observe.iter().find(|one| !one.is_of_points());
            refused.map_or(Ok(()), |one| Err(StudyError::Orbit(NoOrbit::OfTheMap(one.name()))))?;
        }
        for (what, count) in
            [("renormalize", self.renormalize), ("spectrum", self.spectrum.map_or(1, |k| k as u64))]
        {
            if count == 0 {
                return Err(StudyError::NotPositive { what, value: Rational::zero() });
            }
        }
        Composition::of_order(self.order).ok_or(StudyError::Order(self.order))
    }
}

impl Observed {
    /// Returns the observation of one observable.
    #[must_use]
    pub fn of(&self, observable: Observable) -> Option<&ObservedValue> {
        self.seen.iter().find(|(own, _)| *own == observable).map(|(_, seen)| seen)
    }
}

fn with_last(of: &[Observable]) -> Vec<Observable> {
    of.iter().copied().chain([Observable::Last]).collect()
}

/// Adds the `before` steps of the transient to all step numbers in an observation.
fn after_transient(found: Followed<Vec<ObservedValue>>, before: u64) -> Followed<Vec<ObservedValue>> {
    let later = |seen| match seen {
        ObservedValue::Step(step) => ObservedValue::Step(step.map(|step| step + before)),
        seen => seen,
    };
    Followed { report: found.report.into_iter().map(later).collect(), end: found.end.after(before) }
}

fn start_of<T: Copy>(starts: &[Vec<T>], orbit: usize) -> Vec<T> {
    starts.iter().map(|column| column[orbit]).collect()
}

fn last_point<T: EmbedScalar>(seen: ObservedValue) -> Option<Vec<T>> {
    let ObservedValue::Point(point) = seen else { return None };
    Some(point.into_iter().map(T::narrowed).collect())
}

pub(super) fn shown(study: &Study, seen: ObservedValue) -> ObservedValue {
    match seen {
        ObservedValue::Point(point) => ObservedValue::Point(study.project(&point)),
        ObservedValue::Extrema(extrema) => ObservedValue::Extrema(study.project(&extrema)),
        ObservedValue::Turns(turns) => ObservedValue::Turns(study.project(&turns)),
        other => other,
    }
}

/// If no step was observed, replaces a chaos indicator or the mean of log |det ∂x̃/∂x| by NaN.
fn after(has_steps: bool, seen: ObservedValue) -> ObservedValue {
    match seen {
        ObservedValue::Number(_) if !has_steps => ObservedValue::Number(f64::NAN),
        seen => seen,
    }
}

/// Writes an observed value as JSON; values of all variables or integrals are listed by name.
fn json_of(seen: &ObservedValue, variables: &[String], integrals: &[String]) -> Value {
    fn named<T>(names: &[String], values: &[T], value: impl Fn(&T) -> Value) -> Value {
        names.iter().cloned().zip(values.iter().map(value)).collect()
    }
    match seen {
        ObservedValue::Point(point) => named(variables, point, |value| json!(value)),
        ObservedValue::Drift(drifts) => {
            named(integrals, drifts, |drift| json!({"max": drift.max, "final": drift.last}))
        }
        ObservedValue::Extrema(extrema) => {
            named(variables, extrema, |of| json!(of.map(|of| [of.least, of.greatest])))
        }
        ObservedValue::Exponent(one) => json!(one.value),
        ObservedValue::Spectrum(all) => json!(all.iter().map(|one| one.value).collect::<Vec<_>>()),
        ObservedValue::Number(number) => json!(number),
        ObservedValue::Turns(turns) => {
            named(variables, turns, |turns| json!({"value": turns.value, "error": turns.error}))
        }
        ObservedValue::Step(step) => json!(step),
        ObservedValue::Passed(passed) => json!(passed.steps),
    }
}

impl Serialize for Observed {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = json!({
            "system": self.system, "steps": self.steps, "ended": self.end.name(), "ended_step": self.steps,
        });
        for (observable, seen) in &self.seen {
            object[observable.key()] = json_of(seen, &self.variables, &self.integrals);
            match seen {
                ObservedValue::Exponent(one) => object["lyapunov_error"] = json!(one.error),
                ObservedValue::Spectrum(all) => {
                    object["spectrum_errors"] = all.iter().map(|one| one.error).collect();
                }
                ObservedValue::Passed(passed) => {
                    object["passed_poles_lower_bound"] = json!(passed.is_lower_bound);
                }
                _ => {}
            }
        }
        object.serialize(serializer)
    }
}
