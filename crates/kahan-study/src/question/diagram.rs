//! Orbit diagrams (bifurcation diagrams): long-term values of orbits over a parameter or ε.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::observe::{Direction, Visit};
use kahan_core::{Composition, Step};
use kahan_discover::Watch;
use kahan_runtime::{End, Follow};
use serde::{Deserialize, Serialize};

use crate::axes;
use crate::count::WorkCount;
use crate::error::StudyError;
use crate::numbers::exact;
use crate::range::Axis;
use crate::rows::{Column, Rows, Values};
use crate::study::Study;

use super::over::AxisOver;
use super::section::{Crossed, Section, name_of, of_name};
use super::usual_order;

/// A request for the values of one variable, in doubles, over a parameter or ε. Values are taken
/// after a transient, at each step or at each crossing of a section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Diagram {
    /// ε, half the time step; ignored if `over` is ε.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// The first point of each orbit, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The axis: a parameter, or `eps`.
    #[serde(with = "axes")]
    pub over: Axis,
    /// The variable to show, by default the first.
    #[serde(default)]
    pub variable: Option<String>,
    /// The number of steps before the first shown point.
    #[serde(default = "usual_transient")]
    pub transient: u64,
    /// The number of steps after the transient; optional if `plane` and `crossings` are given.
    #[serde(default)]
    pub steps: Option<u64>,
    /// The formula that vanishes on the section; without a formula, all steps are shown.
    #[serde(default)]
    pub plane: Option<String>,
    /// Whether rising, falling or all sign changes of the formula are crossings.
    #[serde(default, serialize_with = "name_of", deserialize_with = "of_name")]
    pub direction: Direction,
    /// The largest number of crossings to show at each value on the axis.
    #[serde(default)]
    pub crossings: Option<u64>,
    /// The order of the method.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// Whether each orbit starts at the last point of the orbit for the previous value on the axis.
    #[serde(default)]
    pub carry: bool,
    /// Whether each step is projected, so that a lift's relations such as sin_x = sin(x) hold.
    #[serde(default)]
    pub reembed: bool,
}

fn usual_transient() -> u64 {
    1000
}

/// The points of an orbit diagram.
#[derive(Clone, Debug, Serialize)]
pub struct DiagramFound {
    /// The name of the system.
    pub system: String,
    /// The name of the axis.
    pub axis: String,
    /// The name of the shown variable.
    pub variable: String,
    /// The values on the axis; fewer than requested if the caller's [`Watch`] stopped the work.
    #[serde(with = "exact")]
    pub values: Vec<Rational>,
    /// The shown numbers at each value on the axis, fewer than requested if the orbit ends early.
    pub points: Vec<Vec<f64>>,
    /// The number of values on the axis at which fewer numbers are shown than requested.
    pub ended: usize,
    /// Whether the caller's [`Watch`] stopped the work.
    pub stopped: bool,
}

impl Diagram {
    /// Asks for the values of the first variable, after a transient of 1000 steps.
    #[must_use]
    pub fn new(eps: Option<Rational>, at: Vec<Rational>, over: Axis, steps: u64) -> Self {
        Diagram {
            eps,
            at,
            over,
            variable: None,
            transient: usual_transient(),
            steps: Some(steps),
            plane: None,
            direction: Direction::default(),
            crossings: None,
            order: usual_order(),
            carry: false,
            reembed: false,
        }
    }

    /// Follows an orbit at each value of the axis.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, missing values, an unknown axis or variable, or a
    /// mistake in the formula `plane`.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<DiagramFound, StudyError> {
        study.proved()?;
        study.can_reembed(self.reembed)?;
        let found = DiagramFound {
            system: study.name().to_owned(),
            axis: self.over.name.clone(),
            variable: self.variable.clone().unwrap_or_else(|| study.variables()[0].clone()),
            values: Vec::new(),
            points: Vec::new(),
            ended: 0,
            stopped: false,
        };
        match &self.plane {
            Some(plane) => self.of_section(plane, found, study, watch),
            None => self.of_steps(found, study, watch),
        }
    }

    /// Returns the question [`Section`] about the orbits of this diagram, with the formula `plane`.
    #[must_use]
    pub fn section(&self, plane: &str) -> Section {
        let Diagram { eps, at, over, transient, steps, direction, crossings, order, carry, reembed, .. } =
            self.clone();
        let plain = Section::new(Rational::zero(), at, 0, plane);
        let over = vec![AxisOver::from(over)];
        Section { eps, over, transient, steps, direction, crossings, order, carry, reembed, ..plain }
    }

    fn of_section(
        &self,
        plane: &str,
        mut found: DiagramFound,
        study: &Study,
        watch: &dyn Watch,
    ) -> Result<DiagramFound, StudyError> {
        study.axis(&self.over)?;
        let shown = study.shown().iter().position(|name| *name == found.variable);
        let shown = shown.map_or_else(|| study.variable(&found.variable), Ok)?;
        let asked = self.section(plane);
        let columns = asked.columns(study)?.len();
        let mut shown = ColumnCollector { column: columns - study.shown().len() + shown, values: Vec::new() };
        let orbits = asked.find(study, &mut shown, watch)?;
        let mut left = shown.values.into_iter();
        found.points =
            orbits.iter().map(|one| left.by_ref().take(one.crossings as usize).collect()).collect();
        found.values = self.over.range.values().take(orbits.len()).collect();
        found.ended = orbits.iter().filter(|one| one.end.is_early()).count();
        let has_all = |one: &Crossed| Some(one.crossings) == self.crossings;
        let is_stopped = |one: &Crossed| matches!(one.end, End::Stopped(_)) && !has_all(one);
        found.stopped = orbits.len() < self.over.range.count() || orbits.iter().any(is_stopped);
        Ok(found)
    }

    fn of_steps(
        &self,
        mut found: DiagramFound,
        study: &Study,
        watch: &dyn Watch,
    ) -> Result<DiagramFound, StudyError> {
        let place = study.axis(&self.over)?;
        let (shown, steps) = (study.variable(&found.variable)?, self.steps.ok_or(StudyError::MissingSteps)?);
        let composition = Composition::of_order(self.order).ok_or(StudyError::Order(self.order))?;
        let mut parameters = study.values_but(|k| Some(k) == place)?;
        let fixed = if place.is_none() { Some(self.over.range.value(0)) } else { self.eps.clone() };
        let mut eps = fixed.ok_or(StudyError::MissingStep)?;
        study.has_coordinates(&self.at)?;
        let start: Vec<f64> = self.at.iter().map(Rational::to_f64).collect();
        let each = self.transient.saturating_add(steps);
        let total = each.saturating_mul(self.over.range.count() as u64);
        let count = WorkCount::new("steps", total, watch);
        let tell = |steps| count.tell(steps);
        let mut last = None::<Vec<f64>>;
        for value in self.over.range.values() {
            match place {
                Some(place) => parameters[place] = value.clone(),
                None => eps = value.clone(),
            }
            let at = study.map_at(&parameters).map(|map| map.at(eps.to_f64()).composed(composition));
            let at = at.filter(|at| at.eps().is_finite());
            let mut points = Vec::new();
            if let Some(at) = at {
                let values: Vec<f64> = parameters.iter().map(Rational::to_f64).collect();
                let carried = last.take().filter(|_| self.carry);
                let mut x = carried.unwrap_or_else(|| study.embed(&start, &values));
                let mut take = |_, x: &[f64]| points.push(x[shown]);
                let step = study.steps(&at, self.reembed);
                let at: &dyn Step<Scalar = f64> = step.as_ref().map_or(&at, |step| step);
                let mut end = at.follow(&mut x, self.transient, tell).expect("the start is of the field").end;
                if end == End::Complete && x.iter().all(|x| x.is_finite()) {
                    let followed = at.observe(&mut x, steps, Visit::by(&mut take), tell);
                    end = followed.expect("the point is of the field").end;
                }
                found.stopped = matches!(end, End::Stopped(_));
                last = (end == End::Complete).then_some(x);
            }
            found.ended += usize::from(points.len() as u64 <= steps);
            found.values.push(value);
            found.points.push(points);
            if found.stopped {
                break;
            }
        }
        Ok(found)
    }
}

/// A consumer of rows that collects one column.
struct ColumnCollector {
    column: usize,
    values: Vec<f64>,
}

impl Rows for ColumnCollector {
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        if let Values::F64(values) = values[self.column] {
            self.values.extend_from_slice(values);
        }
        ControlFlow::Continue(())
    }
}
