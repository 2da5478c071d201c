//! A cycle of the map near a point, how stable it is, and where it goes when something changes.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_discover::Watch;
use kahan_dynamics::periodic::{Branch, BranchPoint, PeriodicPoint, Turn, branch, periodic_point};
use kahan_runtime::{Map, MapAt, RationalCycle};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

use crate::axes;
use crate::count::Count;
use crate::error::StudyError;
use crate::numbers::exact::{self, Exactly};
use crate::range::Axis;
use crate::study::Study;

use super::one;

/// The most unknowns of Newton's method: where it finds no cycle, sixty decompositions take some
/// five seconds.
const MOST_UNKNOWNS: usize = 250;

/// Asks for a cycle near a point, and for its branch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Periodic {
    /// ε, half the time step; the first value of `over` where that is of ε.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// A point near the cycle, a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// A multiple of the period.
    #[serde(default = "one")]
    pub period: usize,
    /// The parameter that changes along the branch, or `eps`.
    #[serde(default, with = "axes")]
    pub over: Option<Axis>,
}

/// A cycle, and what becomes of it.
#[derive(Clone, Debug)]
pub struct CycleFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The cycle, in doubles.
    pub cycle: PeriodicPoint,
    /// The cycle over ℚ, where its points are fractions of a few digits and nothing changes.
    pub exact: Option<RationalCycle>,
    /// What changes along the branch, and the branch.
    pub branch: Option<(String, Branch)>,
}

impl Periodic {
    /// Fixed points, with nothing that changes.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>) -> Self {
        Periodic { eps: Some(eps), at, period: one(), over: None }
    }

    /// Looks for the cycle of a system whose claims hold, by Newton's method. Costs at each of its
    /// steps the elimination of a dense matrix with a row for each number of the cycle.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a cycle that is too long, an axis of nothing that the field has, or no cycle there.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<CycleFound, StudyError> {
        study.proved()?;
        let family = Family::of(self, study)?;
        let unknowns = self.period.saturating_mul(self.at.len());
        if unknowns > MOST_UNKNOWNS {
            return Err(StudyError::LongCycle { unknowns, most: MOST_UNKNOWNS });
        }
        let begin = self.over.as_ref().map_or(f64::NAN, |axis| axis.range.value(0).to_f64());
        let cycle = periodic_point(&family.at(begin), &family.start, self.period);
        let cycle = cycle.map_err(|why| StudyError::NoCycle { system: study.name().to_owned(), why })?;
        Ok(CycleFound {
            system: study.name().to_owned(),
            variables: study.variables().to_vec(),
            exact: family.exact(&cycle),
            branch: self.over.as_ref().map(|axis| (axis.name.clone(), family.branch(&cycle, axis, watch))),
            cycle,
        })
    }
}

/// The map at each value of what changes.
struct Family {
    study: Study,
    eps: Rational,
    start: Vec<f64>,
    /// The index of the parameter that changes; `None` for ε, or for nothing.
    parameter: Option<usize>,
    changes: bool,
}

impl Family {
    fn of(asked: &Periodic, study: &Study) -> Result<Self, StudyError> {
        let axis = asked.over.as_ref();
        let parameter = axis.map(|axis| study.axis(axis)).transpose()?.flatten();
        let of_axis = axis.filter(|_| parameter.is_none()).map(|axis| axis.range.value(0));
        let eps = asked.eps.clone().or(of_axis).ok_or(StudyError::MissingStep)?;
        let study = match (axis, parameter) {
            (Some(axis), Some(place)) if study.given()[place].is_none() => {
                study.with(place, axis.range.value(0))
            }
            _ => study.clone(),
        };
        // A mistake in what is given is told before the search.
        let (_, start) = study.in_floats(&asked.at, &eps)?;
        Ok(Family { study, eps, start, parameter, changes: axis.is_some() })
    }

    /// The map where what changes has this value; where the field divides by zero, that of no
    /// value.
    fn at(&self, value: f64) -> MapAt<f64> {
        let mut parameters = self.own().parameters().to_vec();
        if let Some(place) = self.parameter {
            parameters[place] = Rational::from_f64(value).unwrap_or_default();
        }
        let eps = match (self.changes, self.parameter) {
            (true, None) => value,
            _ => self.eps.to_f64(),
        };
        match self.study.map_at(&parameters) {
            Some(map) => map.at(eps),
            None => self.own().at(f64::NAN),
        }
    }

    /// The branch that begins with a cycle.
    fn branch(&self, cycle: &PeriodicPoint, axis: &Axis, watch: &dyn Watch) -> Branch {
        let (ends, steps) = (axis.range.ends().map(|end| end.to_f64()), axis.range.count() - 1);
        let map = |value| self.at(value).by(self.parameter);
        // A branch that winds has more.
        let count = Count::new("cycles", steps as u64, watch);
        branch(map, cycle, ends, steps, |_| count.tell(1))
    }

    /// The map at the values that were given, at which there is one.
    fn own(&self) -> &Map {
        self.study.map().expect("the family was made where its field is defined")
    }

    /// The cycle over ℚ, where nothing changes.
    fn exact(&self, cycle: &PeriodicPoint) -> Option<RationalCycle> {
        if self.changes { None } else { self.own().rational_cycle(&self.eps, cycle) }
    }
}

/// The characteristic polynomial of a cycle's derivative, in z.
#[must_use]
pub fn characteristic_polynomial(exact: &RationalCycle) -> String {
    let symbols = Symbols { states: vec!["z".to_owned()], parameters: Vec::new() };
    Text.polynomial(&symbols, &exact.polynomial)
}

/// A cycle as an object of JSON.
fn object_of(cycle: &PeriodicPoint) -> Value {
    json!({
        "period": cycle.points.len(),
        "points": cycle.points,
        "residual": cycle.residual,
        "multipliers": cycle.multipliers.iter().map(|one| [one.re, one.im]).collect::<Vec<_>>(),
        "stability": cycle.stability().to_string(),
        "family": cycle.family,
    })
}

impl Serialize for CycleFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let exact = |exact: &RationalCycle| {
            json!({
                "points": exact.points.to_json(),
                "polynomial": characteristic_polynomial(exact),
                "stability": exact.stability.to_string(),
            })
        };
        let place = |point: &BranchPoint| {
            let mut place = object_of(&point.cycle);
            place["parameter"] = json!(point.parameter);
            place
        };
        let turn = |turn: &Turn| json!({"change": turn.change.to_string(), "parameter": turn.parameter});
        let mut object = object_of(&self.cycle);
        object["system"] = json!(self.system);
        object["variables"] = json!(self.variables);
        object["exact"] = self.exact.as_ref().map_or(Value::Null, exact);
        if let Some((over, branch)) = &self.branch {
            object["branch"] = json!({
                "over": over,
                "points": branch.points.iter().map(place).collect::<Vec<_>>(),
                "turns": branch.turns.iter().map(turn).collect::<Vec<_>>(),
                "cut": branch.is_cut,
            });
        }
        object.serialize(serializer)
    }
}
